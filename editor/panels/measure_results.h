// What was measured, as figures and curves: parts of the Measure panel.
#pragma once

#include "match/frame/estimator.h"
#include "panels/panels.h"

namespace lapfx::panels {

/// Why nothing is measured in this frame; one line.
std::string_view not_measurable_text(const match::FrameAmounts& amounts);

/// Amounts of the frame that is shown, with their intervals, and what has to be known about it.
void frame_figures(ui::Ui& ui, const app::MeasureBench& bench);
/// Episodes, notes and export of the whole reference.
void whole_figures(ui::Ui& ui, const MeasureParts& on);
/// Blood and smoke over time. A click goes to that time. Something has been measured.
void amounts_plot(ui::Ui& ui, const MeasureParts& on, ui::Size height);

}  // namespace lapfx::panels
