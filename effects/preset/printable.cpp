#include "lapfx/authoring/printable.h"

#include <cstdint>
#include <cstdio>

namespace lapfx {

namespace {

/// How many bytes the character at the beginning has, and what it is; 0 bytes: that is not UTF-8 (RFC 3629).
struct Character {
    std::size_t bytes = 0;
    std::uint32_t code = 0;
};

Character first_of(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {1, lead};
    const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0xffU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) return {};
        code = code << 6U | (byte(i) & 0x3fU);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (code < least[bytes] || code > 0x10ffff || surrogate) return {};
    return {bytes, code};
}

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
        const Character one = first_of(text);
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
