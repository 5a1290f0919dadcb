#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/canvas/curve_editor.h"
#include "ui/canvas/plot.h"

namespace lapfx::gallery {

namespace {

void plots(ui::Ui& ui, GraphsState& s) {
    const ui::PlotSeries speeds[] = {{.name = "measured", .data = &s.measured, .reference = true},
                                     {.name = "simulated", .data = &s.simulated}};
    const ui::PlotSeries counts[] = {{.name = "wounds", .data = &s.counts, .kind = ui::PlotKind::bars}};
    const Part part(ui, "Plots");
    const ui::Row row(ui, {.width = ui::grow(), .gap = 1, .cross = ui::Place::stretch});
    ui::plot(ui, "Speed", speeds,
             {.x_name = "Time", .x_unit = "s", .y_name = "Speed", .y_unit = "mm/s", .residual = &s.residual});
    ui::plot(ui, "Counts", counts, {.x_name = "Size", .x_unit = "mm"});
}

}  // namespace

void graphs_page(ui::Ui& ui, State& state) {
    GraphsState& s = state.graphs;
    plots(ui, s);
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
    ui::timeline(ui, "Time", s.time, s.tracks, {.length = 12, .rate = 25});
}

}  // namespace lapfx::gallery
