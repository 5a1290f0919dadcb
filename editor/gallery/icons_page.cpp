#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"

namespace lapfx::gallery {

namespace {

/// In the order of ui::Icon, from check on.
constexpr std::array<std::string_view, 42> names = {
    "check",        "minus",  "plus",   "cross",        "chevron right", "chevron down", "chevron up",
    "chevron left", "search", "dot",    "menu",         "lock",          "unlock",       "play",
    "pause",        "stop",   "loop",   "step back",    "step forward",  "star",         "star filled",
    "undo",         "redo",   "folder", "file",         "eye",           "eye off",      "eyedropper",
    "warning",      "error",  "info",   "reset",        "grip",          "copy",         "dice",
    "link",         "gear",   "image",  "drag up down", "sort up",       "sort down",
};
constexpr std::size_t icon_count = static_cast<std::size_t>(ui::Icon::sort_down);
static_assert(names.size() >= icon_count && names[icon_count - 1] == "sort down");

struct IconLook {
    ui::Icon icon;
};

/// At three sizes, in three tones.
void draw_icon(ui::Painter& painter, const ui::Node& node, const IconLook& look) {
    const ui::Theme& t = painter.theme();
    ui::Rect rect = node.rect();
    const std::array<std::pair<float, ui::Color>, 3> sizes = {
        {{1.0F, t.text_dim}, {1.5F, t.text}, {2.5F, t.text_link}}};
    for (const auto& [size, color] : sizes) {
        const float side = painter.em(size);
        painter.icon(rect.cut_left(side), look.icon, color);
        rect.cut_left(painter.em(0.5F));
    }
}

}  // namespace

void icons_page(ui::Ui& ui, State&) {
    constexpr std::size_t columns = 4;
    const Part part(ui, "Icons");
    for (std::size_t first = 0; first < icon_count; first += columns) {
        const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        for (std::size_t i = first; i < std::min(first + columns, icon_count); ++i) {
            const ui::Row cell(ui, {.width = ui::px(ui.em(13)), .cross = ui::ChildAlign::center});
            ui::Node& node = ui.leaf(ui::Role::image, names[i], ui::Sense::hover);
            node.size[0] = ui::px(ui.em(6.2F));
            node.size[1] = ui::px(ui.em(2.7F));
            node.tip = names[i];
            ui.respond(node);
            ui.draw_with<draw_icon>(node, IconLook{static_cast<ui::Icon>(i + 1)});
            ui::label(ui, names[i], {.tone = ui::Tone::dim});
        }
    }
}

}  // namespace lapfx::gallery
