// A bit of everything on one screen; the golden pictures show this page.
#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/canvas/plot.h"
#include "ui/shell/progress.h"
#include "ui/widgets/color_field.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"
#include "ui/widgets/section.h"
#include "ui/widgets/text_field.h"

namespace lapfx::gallery {

namespace {

void buttons(ui::Ui& ui, BasicState& state) {
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
        ui::toggle(ui, "Loop", state.on, {.icon = ui::Icon::loop, .quiet = true});
        ui::icon_button(ui, ui::Icon::gear, "Settings");
        ui::icon_button(ui, ui::Icon::undo, "Undo", {.quiet = true});
    }
    ui::checkbox(ui, "Follow the tool", state.on);
    ui::checkbox(ui, "Only what has changed", state.off);
}

void fields(ui::Ui& ui, FieldsState& state) {
    constexpr std::array<std::string_view, 3> views = {"Matte", "Holdout", "Colour"};
    ui::segmented(ui, "View", state.view, views);
    ui::text_field(ui, "Name", state.name, {.caption = true});
    ui::search_field(ui, "Search", state.empty, {.placeholder = "Search"});
    ui::combo(ui, "Frame", state.frame, state.frames, {.caption = true});
    ui::color_field(ui, "Tissue", state.tissue, {.caption = true});
}

void params(ui::Ui& ui, ParamsState& state) {
    if (const ui::Section section(ui, "Bleeding", {.changed = 1}); section) {
        ui::param(ui, "Speed", state.speed, {.maximum = 60, .step = 0.5, .unit = "mm/s", .standard = 8});
        ui::param(ui, "Opacity", state.ratio, ui::percent());
        ui::range_param(ui, "Luma", state.low, state.high, {.maximum = 255, .step = 1});
        ui::vector_param(ui, "Flow", std::span(&state.flow[0], 2), {.minimum = -1, .maximum = 1, .step = 0.01});
    }
    if (const ui::Section section(ui, "Haze", {.changed = 0, .open = false}); section) ui::label(ui, "Nothing here");
}

void texts(ui::Ui& ui) {
    ui::label(ui, "Dim: units and hints", {.tone = ui::Tone::dim});
    ui::label(ui, "Outside the usual range", {.tone = ui::Tone::warning});
    ui::label(ui, "Not a number", {.tone = ui::Tone::error});
    ui::separator(ui);
    ui::label(ui, "Smoke rises from where the hook touches fat and spreads under the abdominal wall.", {.wrap = true});
}

void large_ones(ui::Ui& ui, State& state) {
    const ui::PlotSeries speeds[] = {{.name = "measured", .data = &state.graphs.measured, .reference = true},
                                     {.name = "simulated", .data = &state.graphs.simulated}};
    const ui::Row row(
        ui, {.width = ui::grow(), .height = ui::px(ui.em(11)), .gap = 1.2F, .cross = ui::ChildAlign::stretch});
    ui::plot(ui, "Speed", speeds, {.x_unit = "s", .y_unit = "mm/s", .height = ui::px(ui.em(11))});
    ui::compare_view(ui, "Compare", state.pictures.clean.picture(), state.pictures.smoky.picture(),
                     state.pictures.compare);
    constexpr std::array columns = {ui::TableColumn{"Clip", 8}, ui::TableColumn{"Length", 5, ui::Align::end}};
    ui::table(ui, "Clips", state.lists.table, columns, state.lists.clips.size(),
              [&](std::size_t i, std::size_t column) {
                  const Clip& clip = state.lists.clips[i];
                  return ui::TableCell{.text = column == 0 ? clip.name : clip.length, .number = column == 1};
              });
}

void small_ones(ui::Ui& ui, State& state) {
    const ui::Row row(ui, {.width = ui::grow(), .gap = 1.2F, .cross = ui::ChildAlign::start});
    {
        const ui::Column column(ui, {.width = ui::grow()});
        ui::heading(ui, "Buttons");
        buttons(ui, state.basic);
        ui::space(ui, 0.4F);
        ui::heading(ui, "Text");
        texts(ui);
    }
    {
        const ui::Column column(ui, {.width = ui::grow()});
        ui::heading(ui, "Fields");
        fields(ui, state.fields);
    }
    const ui::Column column(ui, {.width = ui::grow(1.2F)});
    params(ui, state.params);
    ui::progress(ui, "Rendering", 0.42, {.seconds_left = 80});
    ui::histogram(ui, "Histogram", {.bins = state.pictures.luma}, &state.pictures.levels, {.height = 8});
}

}  // namespace

void overview_page(ui::Ui& ui, State& state) {
    small_ones(ui, state);
    large_ones(ui, state);
}

}  // namespace lapfx::gallery
