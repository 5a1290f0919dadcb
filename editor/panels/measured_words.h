// How close preview and reference are, in words: each part of the line is a link to what mends it.
#pragma once

#include "panels/panels.h"

namespace lapfx::panels {

/// Nothing before both are measured. Gives whether there were any.
bool measured_words(ui::Ui& ui, const AmountsParts& on);

}  // namespace lapfx::panels
