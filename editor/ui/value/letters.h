// Letters of ASCII without regard to case, whatever the locale. The toolkit stands alone, so it has its own.
#pragma once

#include <algorithm>
#include <string_view>

namespace lapfx::ui {

/// The small letter of a large one; anything else stays as it is. `Letter`: char or char32_t.
template <typename Letter>
constexpr Letter lower(Letter c) noexcept {
    return c >= 'A' && c <= 'Z' ? static_cast<Letter>(c - 'A' + 'a') : c;
}

/// Whether they are equal but for the case of letters.
constexpr bool same_letters(std::string_view a, std::string_view b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char p, char q) { return lower(p) == lower(q); });
}

}  // namespace lapfx::ui
