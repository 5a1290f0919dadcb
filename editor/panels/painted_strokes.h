// Strokes by which a person says what is blood in the reference and what is not (ReferenceMeasure::strokes): painted
// over the picture of the Measure panel, and listed in its settings.
#pragma once

#include "panels/panels.h"
#include "ui/canvas/view.h"

namespace lapfx::panels {

/// The strokes over the frame that is shown, and the one that is being painted; a brush is in hand. A drag paints and
/// holds the frame, Shift paints the other kind, Esc drops a stroke. For ImageViewOptions::over; `with`: MeasureParts.
void paint_strokes(ui::Ui& ui, const ui::View& view, void* with);

/// The size of the brush in hand, which frames were painted, and what cannot be learned from them.
void painted_strokes(ui::Ui& ui, const MeasureParts& on);

}  // namespace lapfx::panels
