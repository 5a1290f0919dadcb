#include "gallery/gallery.h"
#include "gallery/parts.h"

namespace lapfx::gallery {

namespace {

void some_buttons(ui::Ui& ui, BasicState& state) {
    if (ui::button(ui, "Normal")) ++state.clicks;
    ui::button(ui, "Primary", {.tip = "What one came for", .primary = true});
    ui::button(ui, "Quiet", {.quiet = true});
    ui::button(ui, "With icon", {.icon = ui::Icon::folder});
    ui::button(ui, "Primary with icon", {.icon = ui::Icon::check, .primary = true});
    ui::icon_button(ui, ui::Icon::gear, "Settings");
    ui::icon_button(ui, ui::Icon::reset, "Reset", {.quiet = true});
}

void buttons(ui::Ui& ui, BasicState& state) {
    const Part part(ui, "Buttons");
    {
        const Line line(ui, "enabled");
        some_buttons(ui, state);
        ui::label(ui, ui.join({"clicked ", text_of(ui, state.clicks), " times"}), {.tone = ui::Tone::dim});
    }
    {
        const Line line(ui, "disabled", true);
        some_buttons(ui, state);
    }
    {
        const Line line(ui, "long and short");
        ui::button(ui, "A name that is too long for its place", {.width = ui::px(ui.em(10))});
        ui::button(ui, "å", {});
        ui::button(ui, "As wide as what is left", {.width = ui::grow()});
    }
    {
        const Line line(ui, "other scripts");
        ui::button(ui, "Größe übernehmen");
        ui::button(ui, "Сохранить");
        ui::button(ui, "Αποθήκευση");
        ui::button(ui, "保存");
    }
}

void some_switches(ui::Ui& ui, BasicState& state) {
    ui::toggle(ui, "Off", state.off);
    ui::toggle(ui, "On", state.on);
    ui::toggle(ui, "Loop", state.on, {.icon = ui::Icon::loop, .quiet = true});
    ui::toggle(ui, "Lock", state.quiet_on, {.icon = ui::Icon::lock, .tip = "Randomising leaves it unchanged"});
    ui::checkbox(ui, "Unchecked", state.off);
    ui::checkbox(ui, "Checked", state.on, "With a tooltip");
}

void switches(ui::Ui& ui, BasicState& state) {
    const Part part(ui, "Toggles and checkboxes");
    {
        const Line line(ui, "enabled");
        some_switches(ui, state);
    }
    {
        const Line line(ui, "disabled", true);
        some_switches(ui, state);
    }
}

void labels(ui::Ui& ui) {
    const Part part(ui, "Labels");
    {
        const Line line(ui, "tones");
        ui::label(ui, "normal");
        ui::label(ui, "dim", {.tone = ui::Tone::dim});
        ui::label(ui, "good", {.tone = ui::Tone::good});
        ui::label(ui, "warning", {.tone = ui::Tone::warning});
        ui::label(ui, "error", {.tone = ui::Tone::error});
    }
    {
        const Line line(ui, "disabled", true);
        ui::label(ui, "normal");
        ui::label(ui, "error", {.tone = ui::Tone::error});
    }
    {
        const Line line(ui, "in 12 em");
        const ui::Size width = ui::px(ui.em(12));
        ui::label(ui, "start", {.width = width});
        ui::label(ui, "centre", {.align = ui::Align::center, .width = width});
        ui::label(ui, "end", {.align = ui::Align::end, .width = width});
    }
    {
        const Line line(ui, "too long");
        ui::label(ui, "What does not fit ends in an ellipsis and is whole in the tooltip",
                  {.width = ui::px(ui.em(16))});
    }
    ui::separator(ui);
    ui::label(
        ui,
        "Wrapped: a label that may have as many lines as it needs is broken at spaces, or within a word where that is "
        "longer than the line, and asks for the height that its width makes necessary.",
        {.tone = ui::Tone::dim, .wrap = true});
}

}  // namespace

void basic_page(ui::Ui& ui, State& state) {
    buttons(ui, state.basic);
    switches(ui, state.basic);
    labels(ui);
}

}  // namespace lapfx::gallery
