// The topic `lapfx help tour`: what can be done in the editor, step by step. editor/TOUR.md is made of it.
#pragma once

#include <vector>

#include "commands/help_layout.h"

namespace lapfx::commands {

std::vector<HelpSection> tour_sections();

}  // namespace lapfx::commands
