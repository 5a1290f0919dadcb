// Placing the reference under the preview: handles over the comparison that move, turn and scale it, and its values as
// numbers.
//
//     PlacementHandles handles{edited};
//     ui::compare_view(ui, ..., {.over = PlacementHandles::build, .over_with = &handles});
#pragma once

#include "app/reference/reference.h"
#include "panels/edited.h"
#include "ui/canvas/view.h"
#include "ui/shell/commands.h"

namespace lapfx::panels {

struct PlacementHandles {
    const Edited& edited;

    static void build(ui::Ui& ui, const ui::View& view, void* with);
};

/// `room`: px.
void placement_row(ui::Ui& ui, const Edited& edited, ui::CommandTable& commands, float room);

}  // namespace lapfx::panels
