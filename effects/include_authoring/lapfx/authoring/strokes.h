// Which contacts form one stroke, for the core's log (tool/log.h) and for programs that show strokes. Pure; any thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "lapfx/tool.h"

namespace lapfx {

/// The contact that contact `number` continues: the nearest one before it in time that it continues (goes_on) and that
/// no other contact continues yet. Only the last 16 are considered, because few tools work at once. `contact_of(i)`
/// gives a ToolContact; `is_continued(i)` says whether a contact between i and `number` continues it.
template <class ContactOf, class IsContinued>
std::optional<std::size_t> goes_on_from(std::size_t number, ContactOf contact_of, IsContinued is_continued) {
    constexpr std::size_t looked_at = 16;
    for (std::size_t back = 1; back <= std::min(number, looked_at); ++back)
        if (!is_continued(number - back) && goes_on(contact_of(number - back), contact_of(number)))
            return number - back;
    return std::nullopt;
}

}  // namespace lapfx
