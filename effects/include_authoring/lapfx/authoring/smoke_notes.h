// Says which smoke of a preset will not look as expected. Smoke needs clips.
#pragma once

#include <string>
#include <vector>

#include "lapfx/smoke_parameters.h"

namespace lapfx {

/// A line each, lower case, without a full stop; empty when every kind of smoke that the parameters ask for has its
/// clip:
/// - no clips: cautery makes no smoke
/// - no clip has the role plume (with a weight above 0): no smoke at the tool tip
/// - no clip has the role haze: the haze is an even veil
/// Any thread.
std::vector<std::string> smoke_notes(const SmokeParameters& smoke);

}  // namespace lapfx
