// What the entries of the core's closed lists are called, in the order of their enumerators: for choices among them.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace lapfx::panels {

/// The titles of a table's rows.
template <class Row, std::size_t Count>
constexpr std::array<std::string_view, Count> titles_of(const Row (&rows)[Count]) {
    std::array<std::string_view, Count> titles{};
    for (std::size_t i = 0; i < Count; ++i) titles[i] = rows[i].title;
    return titles;
}

std::span<const std::string_view> action_titles();
std::span<const std::string_view> overlay_titles();

}  // namespace lapfx::panels
