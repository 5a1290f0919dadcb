// The scene's regions over the pictures that are compared: frames, and handles to move, resize and remove them.
//
//     RegionShapes shapes{comparison.scopes_look, edited};
//     ui::compare_view(ui, ..., {.over = RegionShapes::build, .over_with = &shapes});
#pragma once

#include "app/reference/reference.h"
#include "panels/edited.h"
#include "ui/canvas/view.h"

namespace lapfx::panels {

struct RegionShapes {
    app::ScopesLook& look;  ///< which one is plotted: it stands out, and what is grabbed becomes it
    const Edited& edited;

    static void build(ui::Ui& ui, const ui::View& view, void* with);
};

}  // namespace lapfx::panels
