// Which tool contacts count: they come from files, haptic threads and hosts. Pure; any thread.
#pragma once

#include <optional>

#include "lapfx/tool.h"

namespace lapfx::tool {

inline constexpr double longest_stay = 600.0;  ///< s; only this much of a longer contact counts

/// The contact as it counts. Nothing for an unusable one: not finite, time beyond +-1e7 s, coordinates beyond +-1e5 mm,
/// a path longer than 1000 mm, negative duration or strength. Power is clamped to 0..1, strength to 1000.
std::optional<ToolContact> usable(const ToolContact& contact) noexcept;

}  // namespace lapfx::tool
