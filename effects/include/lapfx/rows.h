// Tables with a row for each value of an enum, in the order of the enumerators, so that a value leads to its row.
//
//     static_assert(lapfx::rows_follow<&ToolActionRow::action>(tool_actions));
#pragma once

#include <cstddef>

namespace lapfx {

/// Whether row i is that of the i-th enumerator. `value`: the member of a row that says of which it is.
template <auto value>
constexpr bool rows_follow(const auto& rows) noexcept {
    std::size_t next = 0;
    for (const auto& row : rows)
        if (static_cast<std::size_t>(row.*value) != next++) return false;
    return true;
}

}  // namespace lapfx
