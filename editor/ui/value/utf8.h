// Decodes UTF-8 from outside, which may be any bytes. The core has its own (lapfx/authoring/utf8.h): the toolkit stands
// alone.
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
void append(std::string& text, char32_t codepoint);  ///< what is no scalar value becomes U+FFFD
/// Whether a byte goes on with a code point that was begun before it.
constexpr bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}
/// The last place at or before `byte` where a code point begins or the text ends, so that a cut there cuts none. Bytes
/// that are no UTF-8 are cut at `byte`.
std::size_t code_point_at(std::string_view text, std::size_t byte);
bool valid_utf8(std::string_view text);
/// Bytes of the character before `byte` and at it, which need not be at the edge of one. A character is what a reader
/// takes for one: an extended grapheme cluster of Unicode (UAX 29), as utf8proc knows them; a byte that is no UTF-8
/// counts as U+FFFD. 0 at the ends.
std::size_t previous_character(std::string_view text, std::size_t byte);
std::size_t next_character(std::string_view text, std::size_t byte);

/// Finds where characters begin. It is given the code points in the order of the text, from the start of a character
/// on.
class CharacterBreaks {
  public:
    /// Whether `next` begins a character; the first one does.
    bool before(char32_t next);

  private:
    char32_t last_ = 0;       // a control character, which ends what is before it
    std::int32_t state_ = 0;  // utf8proc's: half a flag, a picture that a joiner may follow
};

}  // namespace lapfx::ui
