// What of a scene's events touches nothing. Any thread.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lapfx/organ.h"
#include "lapfx/tool.h"

namespace lapfx {

/// A line for each event that must touch the organ to do anything, and whose tip is farther away all along its path:
/// "/events/2: touches nothing: its tip is 45.0 mm from the organ, 5 mm at most". After five of them one that counts
/// the others. Suction and irrigation work beside the tissue, too. Events without finite places are left out.
std::vector<std::string> touch_notes(const Organ& organ, std::span<const ToolContact> events);

}  // namespace lapfx
