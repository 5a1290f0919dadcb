// Series over two axes: what was measured beside what is simulated.
//
//     PlotData speed;                                   // made once, when the samples change
//     speed.set(samples, 0, 1.0 / 60);
//     const ui::PlotSeries series[] = {{"Speed", &speed}};
//     ui::plot(u, "Bleeding", series, {.x_name = "Time", .x_unit = "s", .y_unit = "mm/s"});
//
// Pointer: drag or middle button pans, Shift+drag zooms to a box, Ctrl+drag asks for a range, the wheel zooms at the
// pointer; on an axis all that is of this axis alone. Double click, F and Home fit. Keys: arrows pan, + and - zoom, L
// turns log y on and off, Ctrl+C copies what is in sight as CSV, Esc drops the range. Names in the legend show and
// hide.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "ui/canvas/axis.h"
#include "ui/canvas/plot_data.h"
#include "ui/core/ui.h"

namespace lapfx::ui {

struct PlotSeries {
    std::string_view name;           ///< of the legend; none: not in it
    const PlotData* data = nullptr;  ///< not null; must outlive the frame
    int color = -1;                  ///< 0 to 7, of the theme's series; -1: the number of the series
    bool reference = false;          ///< a quiet line that others are compared with; no series of its own to snap to
    /// Both or none: samples at the same places as those of `data`; between them is a band, as of an interval.
    const PlotData *low = nullptr, *high = nullptr;
};

/// What is in sight; kept by the widget unless the program does, to link plots or to store it.
struct PlotState {
    Span x = {}, y = {};  ///< y: of decimal logarithms while `log_y`
    bool fitted = true;   ///< follows the data until it is moved
    bool log_y = false;
    std::uint64_t hidden = 0;  ///< a bit for each series; from the 64th on all are seen
    bool has_range = false;
    Span range = {};
};

struct PlotOptions {
    std::string_view x_name = {}, x_unit = {}, y_name = {}, y_unit = {};
    Size width = {SizeKind::grow, 1};
    Size height = {SizeKind::fit, 0};  ///< fit: 14 em
    std::string_view tip = {};
    PlotState* state = nullptr;
    double mark = std::numeric_limits<double>::quiet_NaN();  ///< an upright line there, as of a playhead; NaN: none
};

struct PlotResult {
    bool moved = false;     ///< what is in sight
    int series = -1;        ///< under the pointer; -1: none
    std::size_t index = 0;  ///< of its sample
    bool clicked = false;   ///< the left button was pressed and released in one place of the ground
    double x = 0;           ///< of that place
};

PlotResult plot(Ui& ui, std::string_view label, std::span<const PlotSeries> series, const PlotOptions& options = {});

}  // namespace lapfx::ui
