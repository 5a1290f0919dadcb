// The names of a plot's series, each a switch; and what all of its parts know of a series.
#pragma once

#include "ui/canvas/plot.h"

namespace lapfx::ui {

bool hidden(const PlotState& state, std::size_t series);
Color color_of(const Theme& theme, const PlotSeries& series, std::size_t number);

/// What the legend takes of `room` px, at its right end; names are cut where that is too little.
float legend_width(Ui& ui, std::span<const PlotSeries> series, float room);
/// Builds the legend at the upper right of the open node. Returns whether a series was shown or hidden with it.
bool legend(Ui& ui, std::span<const PlotSeries> series, PlotState& state, float room);

}  // namespace lapfx::ui
