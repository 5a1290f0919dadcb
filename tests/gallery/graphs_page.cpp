#include <algorithm>
#include <utility>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/canvas/curve_editor.h"
#include "ui/canvas/plot.h"

namespace lapfx::gallery {

namespace {

void speeds(ui::Ui& ui, GraphsState& s) {
    const ui::PlotSeries series[] = {{.name = "measured", .data = &s.measured, .reference = true},
                                     {.name = "simulated", .data = &s.simulated, .low = &s.least, .high = &s.most}};
    const Part part(ui, "Plot");
    ui::plot(ui, "Speed", series, {.x_name = "Time", .x_unit = "s", .y_name = "Speed", .y_unit = "mm/s"});
}

/// Moves the time while it plays: the timeline only shows it.
void play(ui::Ui& ui, ui::TimelineState& state, double length) {
    double& seen = ui.memory<double>(ui.id_of("clock"));
    const double passed = ui.time() - std::exchange(seen, ui.time());
    if (state.speed == 0) return;
    ui.wake_at(ui.time() + 1.0 / 60, "play");
    const double low = state.has_range ? state.range.low : 0, high = state.has_range ? state.range.high : length;
    state.time += state.speed * std::min(passed, 0.1);  // nothing passes in the frame that begins it
    if (state.speed > 0 ? state.time < high : state.time > low) return;
    state.time = (state.speed > 0) == state.loop ? low : high;
    if (!state.loop) state.speed = 0;
}

}  // namespace

void graphs_page(ui::Ui& ui, State& state) {
    GraphsState& s = state.graphs;
    speeds(ui, s);
    {
        const Part part(ui, "Curve");
        ui::curve_editor(ui, "Response", s.curve,
                         {.x = {},
                          .y = {},
                          .x_name = "Age",
                          .x_unit = "s",
                          .y_name = "Density",
                          .standard = &s.standard,
                          .live = 0.3});
    }
    const Part part(ui, "Timeline");
    play(ui, s.time, 12);
    ui::timeline(ui, "Time", s.time, s.tracks, {.length = 12, .rate = 25});
}

}  // namespace lapfx::gallery
