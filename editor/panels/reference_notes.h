// What is told below the tools of the reference: a plate that is being made, an aspect and a look that are proposed.
#pragma once

#include "app/reference/reference_look.h"
#include "panels/edited.h"
#include "ui/core/ui.h"
#include "ui/shell/commands.h"

namespace lapfx::panels {

void reference_notes(ui::Ui& ui, app::ReferenceLook& look, const Edited& edited, ui::CommandTable& commands);

}  // namespace lapfx::panels
