// The region that is measured and the parts that are left out, over the picture of the Measure panel: drawn, moved, and
// taken out again.
#pragma once

#include "app/measure/measure_bench.h"
#include "panels/edited.h"
#include "ui/canvas/view.h"

namespace lapfx::panels {

/// For ImageViewOptions::over. Arrows move a handle by a pixel, Shift by ten. Delete takes a corner or a part out, and
/// puts the region back to what was saved. While a part is drawn, clicks are its corners; a double click, Enter or a
/// click on the first corner closes it, Backspace takes the last corner back, Esc drops it.
struct MeasureShapes {
    app::MeasureBench& bench;
    const Edited& edited;
    /// `with`: a MeasureShapes.
    static void build(ui::Ui& ui, const ui::View& view, void* with);
};

}  // namespace lapfx::panels
