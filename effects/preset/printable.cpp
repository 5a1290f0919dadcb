#include "lapfx/authoring/printable.h"

#include <cstdint>
#include <cstdio>

#include "lapfx/authoring/utf8.h"

namespace lapfx {

namespace {

/// Controls, line and paragraph separators, and what turns the direction of the text behind it.
bool is_hidden(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x200e || code == 0x200f || code == 0x061c ||
           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0xfeff;
}

std::string escaped(const char* form, unsigned value) {
    char text[16];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const Utf8Character one = first_character(text);
        if (one.bytes == 0)
            out += escaped("\\x%02x", static_cast<unsigned char>(text.front()));
        else if (is_hidden(one.code))
            out += escaped(one.code < 0x80 ? "\\x%02x" : "\\u%04x", one.code);
        else
            out += text.substr(0, one.bytes);
        text.remove_prefix(one.bytes == 0 ? 1 : one.bytes);
    }
    return out;
}

}  // namespace lapfx
