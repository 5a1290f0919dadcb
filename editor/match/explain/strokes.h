// Which of a scene's events form a stroke: what one tool does from press to release.
// Pure, any thread.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lapfx/tool.h"

namespace lapfx::match {

/// Numbers of the contacts of each stroke, in the order of time; only contacts for which `counts` holds.
std::vector<std::vector<std::size_t>> strokes_of(std::span<const ToolContact> events,
                                                 bool (*counts)(const ToolContact& contact));

}  // namespace lapfx::match
