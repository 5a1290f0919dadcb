// UTF-8 (RFC 3629) in text from outside, which may be any bytes. Overlong forms, surrogates and what is beyond U+10FFFF
// are none. Pure; any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lapfx {

struct Utf8Character {
    char32_t code = 0;
    std::size_t bytes = 0;  ///< 1 to 4; 0: the text is empty, or does not begin with a character of UTF-8
};

Utf8Character first_character(std::string_view text) noexcept;
bool is_utf8(std::string_view text) noexcept;
/// All bytes but those that go on with a character, as a terminal counts them.
std::size_t count_characters(std::string_view text) noexcept;
/// `code`: a scalar value of Unicode.
void append_utf8(std::string& text, char32_t code);

}  // namespace lapfx
