// How near the colours of the preview are to those of the reference, in the amounts panel under what is said of the
// amounts.
#pragma once

#include "panels/panels.h"

namespace lapfx::panels {

/// One line, in which each part leads to the row that mends it. Nothing while either is not measured as a whole.
void measured_colors(ui::Ui& ui, const AmountsParts& on);

}  // namespace lapfx::panels
