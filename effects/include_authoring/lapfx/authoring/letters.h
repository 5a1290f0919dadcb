// Words of names, keys and formats: letters of ASCII without regard to case, whatever the locale, and how far one word
// is from another. Pure; any thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace lapfx {

/// The small letter of a large one; anything else stays as it is.
constexpr char lower(char c) noexcept {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
inline std::string lower(std::string_view text) {
    std::string made(text);
    for (char& c : made) c = lower(c);
    return made;
}

/// "no smoke" as "No smoke": as a sentence begins.
inline std::string upper_first(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/// "Picture" as "picture": as it stands within a sentence.
inline std::string lower_first(std::string text) {
    if (!text.empty()) text[0] = lower(text[0]);
    return text;
}

/// Whether they are equal but for the case of letters.
constexpr bool same_letters(std::string_view a, std::string_view b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char p, char q) { return lower(p) == lower(q); });
}

/// Insertions, deletions and replacements of bytes that turn `a` into `b` (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace lapfx
