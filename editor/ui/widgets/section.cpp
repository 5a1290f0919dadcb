#include "ui/widgets/section.h"

#include <charconv>

#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {

namespace {

struct Folding {
    bool known = false, open = false;
};

struct HeaderLook {
    std::string_view title, count;
    bool open;
};

void draw_header(Painter& painter, const Node& node, const HeaderLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled), hovered = has(node.is, Is::hovered) && !disabled;
    painter.fill(node.rect(), hovered ? t.control_hover : t.header, painter.em(t.radius));
    Rect rect = node.rect().inset(painter.em(0.5F), 0);
    painter.icon(rect.cut_left(painter.em(0.8F)), look.open ? Icon::chevron_down : Icon::chevron_right, t.text_dim);
    rect.cut_left(painter.em(0.5F));
    const TextStyle bold = painter.text_style(1, Weight::bold);
    const float width = painter.text(rect, look.title, bold, disabled ? t.text_disabled : t.text);
    if (look.count.empty()) return;
    rect.cut_left(width + painter.em(0.6F));
    const float dot = painter.em(0.45F);
    const Rect place = rect.cut_left(dot);
    painter.fill({place.x, std::round(place.center().y - dot / 2), dot, dot}, t.accent, dot / 2);
    rect.cut_left(painter.em(0.35F));
    painter.text(rect, look.count, painter.number_style(), t.text_dim);
}

std::string_view count_text(Ui& ui, int count) {
    char buffer[16];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, count).ptr;
    return ui.copy({buffer, static_cast<std::size_t>(end - buffer)});
}

/// Returns whether the section is open.
bool put_header(Ui& ui, std::string_view title, const SectionOptions& options) {
    Node& header = ui.leaf(Role::button, "##header",
                           Sense::hover | Sense::press | Sense::focus | Sense::activate | Sense::arrows_x);
    const Id id = header.id;  // two sections of the same name have different ids
    Folding& folding = ui.memory<Folding>(id);
    if (!folding.known) folding = {true, options.open};
    folding.open |= options.unfold;
    const std::string_view count = options.changed > 0 ? count_text(ui, options.changed) : std::string_view{};
    header.text = count.empty() ? title : ui.join({title, ", ", count, " changed"});
    header.tip = ui.copy(options.tip);
    header.size[0] = grow();
    header.size[1] = px(ui.row_height());
    const Response r = ui.respond(header);
    const bool disabled = has(header.is, Is::disabled);
    if (r.clicked) folding.open = !folding.open;
    ui.events_of(id, [&](const Event& event) {
        if (disabled || event.kind != EventKind::key) return;
        if (event.key == Key::left) folding.open = false;
        if (event.key == Key::right) folding.open = true;
    });
    header.is |= when(folding.open, Is::expanded) | when(options.changed > 0, Is::changed);
    ui.draw_with<draw_header>(header, HeaderLook{title, count, folding.open});
    return folding.open;
}

}  // namespace

Section::Section(Ui& ui, std::string_view label, const SectionOptions& options) : ui_(ui) {
    Node& outer = ui.open(Role::section, label, Axis::y);
    outer.gap = ui.em(ui.theme().gap);
    const std::string_view title = outer.shown;
    {
        const Row row(ui, {.gap = 0, .cross = ChildAlign::center});
        open_ = put_header(ui, title, options);
        for (std::size_t i = 0; i < options.buttons.size(); ++i) {
            const SectionButton& button = options.buttons[i];
            if (icon_button(ui, button.icon, button.label, {.quiet = true})) clicked_ = static_cast<int>(i);
        }
    }
    Node& node = ui.parent();
    node.is |= when(open_, Is::expanded) | when(options.changed > 0, Is::changed);
    if (!open_) return;
    Node& body = ui.open(Role::none, {}, Axis::y);
    body.gap = ui.em(ui.theme().gap);
    body.padding[0] = static_cast<std::uint8_t>(std::min(255.0F, ui.em(0.8F)));
    body.rigid = false;
}

Section::~Section() {
    if (open_) ui_.close();
    ui_.close();
}

}  // namespace lapfx::ui
