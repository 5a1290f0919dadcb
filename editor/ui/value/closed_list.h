// Closed lists: an enum, and one table with all that belongs to each of its values. A row begins with its value:
//
//     constexpr struct { Tone value; std::string_view name; } tones[] = {{Tone::normal, "normal"}, {Tone::dim, "dim"}};
//     static_assert(is_whole(tones));
//
// A value without a row, a row too many and rows in another order do not compile. Values count up from 0.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace lapfx::ui {

/// Whether the enum of `value` has a name for it.
template <auto value>
consteval bool is_enumerator() {
    // GCC and Clang end the signature with "value = E::name]" or "value = (E)7]"; GCC may add other parameters.
    const std::string_view signature = __PRETTY_FUNCTION__;
    return signature[signature.find("value = ") + 8] != '(';
}

/// Row i is of the i-th value, and no value is without a row.
template <typename Row, std::size_t count>
consteval bool is_whole(const Row (&rows)[count]) {
    using E = decltype(Row::value);
    for (std::size_t i = 0; i < count; ++i) {
        if (rows[i].value != static_cast<E>(i)) return false;
    }
    return is_enumerator<static_cast<E>(count - 1)>() && !is_enumerator<static_cast<E>(count)>();
}

}  // namespace lapfx::ui
