// A bit of everything on one screen: what golden pictures are made of.
#include "gallery/gallery.h"
#include "gallery/parts.h"

namespace lapfx::gallery {

namespace {

void buttons(ui::Ui& ui, BasicState& state) {
    const Part part(ui, "Buttons");
    {
        const ui::Row row(ui);
        ui::button(ui, "Render", {.icon = ui::Icon::play, .primary = true});
        if (ui::button(ui, "Reset")) state.clicks = 0;
        ui::button(ui, "More", {.quiet = true});
    }
    {
        const ui::Row row(ui);
        ui.push_disabled(true);
        ui::button(ui, "Disabled");
        ui.pop_disabled();
        ui::icon_button(ui, ui::Icon::undo, "Undo");
        ui::icon_button(ui, ui::Icon::redo, "Redo", {.quiet = true});
        ui::toggle(ui, "Loop", state.on, {.icon = ui::Icon::loop, .quiet = true});
    }
    ui::checkbox(ui, "Follow the tool", state.on);
    ui::checkbox(ui, "Only what has changed", state.off);
    ui::checkbox(ui, "All clips", state.some);
}

void texts(ui::Ui& ui) {
    const Part part(ui, "Text");
    ui::label(ui, "Normal text 0123456789");
    ui::label(ui, "Dim: units and hints", {.tone = ui::Tone::dim});
    ui::label(ui, "Saved", {.tone = ui::Tone::good});
    ui::label(ui, "Outside of the usual range", {.tone = ui::Tone::warning});
    ui::label(ui, "Not a number", {.tone = ui::Tone::error});
    ui::separator(ui);
    ui::label(ui, "Smoke rises from where the hook touches fat and spreads under the abdominal wall.", {.wrap = true});
}

}  // namespace

void overview_page(ui::Ui& ui, State& state) {
    const ui::Row row(ui, {.width = ui::grow(), .gap = 1.2F, .cross = ui::Place::start});
    {
        const ui::Column column(ui, {.width = ui::grow()});
        buttons(ui, state.basic);
    }
    const ui::Column column(ui, {.width = ui::grow()});
    texts(ui);
}

}  // namespace lapfx::gallery
