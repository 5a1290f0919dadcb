// Figures of the scene's regions in the two pictures that are compared, and their curves over the reference's time.
#pragma once

#include "app/reference/reference.h"
#include "panels/edited.h"

namespace lapfx::panels {

/// Tools above the figures: add, remove, what is plotted.
void region_tools(ui::Ui& ui, app::ScopesLook& look, const Edited& edited, float room);
/// `names`: of the first and the second picture. `room`: px; 0: not known yet.
void region_figures(ui::Ui& ui, app::Reference& reference, const Edited& edited,
                    const std::array<std::string_view, 2>& names, float room);

}  // namespace lapfx::panels
