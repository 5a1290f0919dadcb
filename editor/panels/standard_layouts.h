// The layouts that come with the program: where the panels of the table in workspace.cpp stand, by their names.
#pragma once

#include <vector>

#include "app/base/layouts.h"

namespace lapfx::panels {

/// The first is shown to begin with.
std::vector<app::StandardLayout> standard_layouts();

}  // namespace lapfx::panels
