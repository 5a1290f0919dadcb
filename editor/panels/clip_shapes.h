// Places of the selected clip's frame: where its smoke starts, what is cropped, and its masks; as handles on the source
// picture of the keying bench, and as rows.
#pragma once

#include "app/clips/keying_bench.h"
#include "panels/edited.h"
#include "ui/canvas/view.h"
#include "ui/shell/commands.h"

namespace lapfx::panels {

/// For ImageViewOptions::over. Arrows move a handle by a pixel of the clip, Shift by ten; Delete, Backspace and a
/// double click put the source or an edge back to what was saved, and take a mask out.
struct ClipShapes {
    app::KeyingBench& bench;
    const Edited& edited;
    std::size_t number;  ///< the bench shows the clip with this number
    /// `with`: a ClipShapes.
    static void build(ui::Ui& ui, const ui::View& view, void* with);
};

/// Esc, or another clip, ends the drawing of a mask. Once a frame, by the keying panel.
void follow_mask_drawing(ui::Ui& ui, app::KeyingBench& bench, std::size_t number);

/// Crop, edge fade and masks as numbers, and what makes masks.
void frame_rows(ui::Ui& ui, app::KeyingBench& bench, const Edited& edited, std::size_t number,
                ui::CommandTable& commands);

}  // namespace lapfx::panels
