// Which tool contacts count: they come from files, haptic threads and hosts. Pure; any thread.
#pragma once

#include <optional>

#include "lapfx/tool.h"

namespace lapfx::tool {

inline constexpr double longest_stay = 600.0;  ///< s; of a longer contact only so much counts

/// The contact as it counts; nothing for one that cannot be: not finite, time beyond +-1e7 s, coordinates beyond
/// +-1e5 mm, a path longer than 1000 mm, negative duration or strength. Power is clamped to 0..1, strength to 1000.
std::optional<ToolContact> usable(const ToolContact& contact) noexcept;

}  // namespace lapfx::tool
