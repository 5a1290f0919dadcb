#include "gallery/gallery.h"

#include <algorithm>
#include <array>
#include <utility>

#include "commands/gallery_pages.h"
#include "gallery/parts.h"
#include "ui/core/node.h"
#include "ui/shell/key_editor.h"
#include "ui/shell/palette.h"
#include "ui/value/letters.h"
#include "ui/widgets/scroll.h"

namespace lapfx::gallery {

namespace {

constexpr std::array all_pages = {
    Page{"Overview", overview_page}, Page{"Basic", basic_page},    Page{"Fields", fields_page},
    Page{"Params", params_page},     Page{"Lists", lists_page},    Page{"Panels", panels_page},
    Page{"Pictures", pictures_page}, Page{"Graphs", graphs_page},  Page{"Shell", shell_page},
    Page{"Overlays", overlays_page}, Page{"Layout", layout_page},  Page{"Text", text_page},
    Page{"Icons", icons_page},       Page{"Colours", colors_page},
};
static_assert(std::ranges::equal(all_pages, commands::gallery_pages, {}, &Page::name),
              "the list of pages in commands/gallery_pages.h is another");

constexpr float least_page_width = 52, least_window_width = 62;  // em

struct PageLook {
    const ui::Run* run;
};

void draw_page_name(ui::Painter& painter, const ui::Node& node, const PageLook& look) {
    const ui::Theme& t = painter.theme();
    const bool chosen = has(node.is, ui::Is::selected), hovered = has(node.is, ui::Is::hovered);
    if (chosen || hovered) painter.fill(node.rect(), chosen ? t.accent_ground : t.control_hover, painter.em(t.radius));
    painter.text(node.rect().inset(painter.em(0.6F), 0), node.shown, *look.run, painter.text_style(), t.text);
}

void page_list(ui::Ui& ui, State& state) {
    ui::Panel panel(ui, "Pages", {.width = ui::px(ui.em(9)), .height = ui::grow(), .gap = 0.1F, .padding = 0.4F});
    const ui::ScrollArea list(ui, "List", {.padding = 0.15F, .role = ui::Role::list});
    for (std::size_t i = 0; i < all_pages.size(); ++i) {
        ui::Node& node = ui.leaf(ui::Role::list_item, all_pages[i].name,
                                 ui::Sense::hover | ui::Sense::press | ui::Sense::focus | ui::Sense::activate);
        node.size[1] = ui::px(ui.row_height());
        if (ui.respond(node).clicked) state.page = static_cast<int>(i);
        node.is |= when(state.page == static_cast<int>(i), ui::Is::selected);
        ui.draw_with<draw_page_name>(node, PageLook{&ui.fonts().run(node.shown, ui.text_style())});
    }
}

void switches(ui::Ui& ui, State& state) {
    ui::Panel panel(ui, "Switches", {.width = ui::grow(), .padding = 0.4F});
    ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::label(ui, "lapfx gallery", {.weight = ui::Weight::bold});
    ui::spacer(ui);
    ui::checkbox(ui, "Light", state.light, "The light theme");
    ui::checkbox(ui, "Reduced motion", state.reduced_motion, "Carets do not blink, progress does not run");
    ui::space(ui, 0.6F);
    if (ui::icon_button(ui, ui::Icon::minus, "Smaller", {.tip = "Smaller (Ctrl+-)"})) state.scale /= 1.25F;
    ui::label(ui, ui.join({text_of(ui, 100 * state.scale), " %"}),
              {.align = ui::Align::center, .number = true, .width = ui::px(ui.em(3.4F))});
    if (ui::icon_button(ui, ui::Icon::plus, "Larger", {.tip = "Larger (Ctrl+=)"})) state.scale *= 1.25F;
}

void shown_page(ui::Ui& ui, State& state) {
    const Page& page = all_pages[static_cast<std::size_t>(state.page)];
    ui::Panel panel(ui, "Page", {.width = ui::grow(), .height = ui::grow()});
    const bool narrow = ui.window().x < ui.em(least_window_width);
    const ui::ScrollArea area(ui, page.name, {.sideways = narrow});
    const ui::Column column(ui, {.width = ui::grow(), .gap = 1, .padding = 0.8F});
    if (narrow) ui.parent().minimum[0] = ui.em(least_page_width);
    page.build(ui, state);
}

void whole_window(ui::Ui& ui, State& state) {
    ui::Column window(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.15F});
    switches(ui, state);
    ui::Row row(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.15F, .cross = ui::ChildAlign::stretch});
    page_list(ui, state);
    shown_page(ui, state);
}

/// Overlays that every page can open.
void overlays(ui::Ui& ui, ShellState& state, ui::CommandTable& commands) {
    if (std::exchange(state.wants_palette, false)) ui::open_palette(ui);
    if (std::exchange(state.wants_keys, false)) ui::toggle_cheat_sheet(ui);
    ui::palette(ui, commands);
    ui::cheat_sheet(ui, commands);
    if (const auto chosen = state.files.build(ui)) state.answer = "a file";
    state.toasts.build(ui);
}

}  // namespace

std::span<const Page> pages() {
    return all_pages;
}

int page_named(std::string_view name) {
    for (std::size_t i = 0; i < all_pages.size(); ++i)
        if (ui::same_letters(name, all_pages[i].name)) return static_cast<int>(i);
    return -1;
}

void build(ui::Ui& ui, State& state) {
    state.page = std::clamp(state.page, 0, static_cast<int>(all_pages.size()) - 1);
    const int page = state.page;
    const bool light = state.light;
    ui.set_theme(state.light ? ui::light_theme() : ui::dark_theme());
    ui.set_reduced_motion(state.reduced_motion);
    if (state.bare) {
        shown_page(ui, state);
    } else {
        whole_window(ui, state);
    }
    overlays(ui, state.shell, state.commands);
    // What has just been chosen changes widgets that were built before.
    if (state.page != page || state.light != light || state.reduced_motion != ui.options().reduced_motion)
        ui.wake("gallery");
}

}  // namespace lapfx::gallery
