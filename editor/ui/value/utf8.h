// UTF-8 as it comes from outside: any bytes at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lapfx::ui {

inline constexpr char32_t replacement = 0xFFFD;

struct Decoded {
    char32_t codepoint = replacement;
    std::uint8_t bytes = 1;  ///< 1 to 4; of a byte that is no UTF-8: 1
    bool valid = false;
};

/// The code point at the front of `text`, which is not empty. Overlong forms, surrogates and what is beyond U+10FFFF
/// are not valid.
Decoded decode(std::string_view text);
void append(std::string& text, char32_t codepoint);  ///< not a scalar value: U+FFFD
bool valid_utf8(std::string_view text);
/// Bytes of the character before `byte` and at it: a code point together with the combining marks, joiners and
/// variation selectors that go with it. 0 at the ends.
std::size_t previous_character(std::string_view text, std::size_t byte);
std::size_t next_character(std::string_view text, std::size_t byte);
bool is_combining(char32_t codepoint);
/// Whether a character ends between two neighbouring code points.
bool parted(char32_t before, char32_t after);

}  // namespace lapfx::ui
