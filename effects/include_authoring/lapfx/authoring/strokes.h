// Which contacts are one stroke: what the core's log (tool/log.h) and tools that show strokes to people both go by.
// Pure; any thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "lapfx/tool.h"

namespace lapfx {

/// Which contact the one with this number goes on from: of those before it in the order of time, the nearest that it
/// goes on from (goes_on) and that no other does yet. Only the last 16 are looked at: few tools work at once.
/// `contact_of(i)`: a ToolContact; `is_continued(i)`: whether one between i and `number` goes on from it.
template <class ContactOf, class IsContinued>
std::optional<std::size_t> goes_on_from(std::size_t number, ContactOf contact_of, IsContinued is_continued) {
    constexpr std::size_t looked_at = 16;
    for (std::size_t back = 1; back <= std::min(number, looked_at); ++back)
        if (!is_continued(number - back) && goes_on(contact_of(number - back), contact_of(number)))
            return number - back;
    return std::nullopt;
}

}  // namespace lapfx
