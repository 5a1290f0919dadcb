#include "ui/value/utf8.h"

#include <utf8proc.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace lapfx::ui {

namespace {

constexpr char32_t zero_width_joiner = 0x200D;

/// Where the code point begins that holds the byte before `byte`. A sequence cannot begin inside another one, so three
/// bytes back settle it.
std::size_t code_point_before(std::string_view text, std::size_t byte) {
    for (std::size_t back = 2; back <= 4 && back <= byte && continues(text[byte - back + 1]); ++back) {
        if (decode(text.substr(byte - back)).bytes >= back) return byte - back;
    }
    return byte - 1;
}

/// Whether a character ends between two code points whatever comes before them. Only a joiner and half a flag need more
/// to tell; the two halves of a flag are not parted here.
bool always_parted(char32_t before, char32_t after) {
    return before != zero_width_joiner &&
           utf8proc_grapheme_break(static_cast<utf8proc_int32_t>(before), static_cast<utf8proc_int32_t>(after));
}

}  // namespace

Decoded decode(std::string_view text) {
    assert(!text.empty());
    utf8proc_int32_t c = 0;
    const utf8proc_ssize_t bytes =
        utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                         static_cast<utf8proc_ssize_t>(std::min<std::size_t>(text.size(), 4)), &c);
    if (bytes <= 0) return {};
    return {static_cast<char32_t>(c), static_cast<std::uint8_t>(bytes), true};
}

void append(std::string& text, char32_t codepoint) {
    utf8proc_uint8_t bytes[4];
    const auto c = static_cast<utf8proc_int32_t>(codepoint);
    const utf8proc_ssize_t count =
        utf8proc_encode_char(utf8proc_codepoint_valid(c) ? c : static_cast<utf8proc_int32_t>(replacement), bytes);
    text.append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
}

std::size_t code_point_at(std::string_view text, std::size_t byte) {
    if (byte >= text.size()) return text.size();
    std::size_t begin = byte;
    while (begin > 0 && byte - begin < 4 && continues(text[begin])) --begin;
    return continues(text[begin]) ? byte : begin;
}

bool valid_utf8(std::string_view text) {
    while (!text.empty()) {
        const Decoded d = decode(text);
        if (!d.valid) return false;
        text.remove_prefix(d.bytes);
    }
    return true;
}

bool CharacterBreaks::before(char32_t next) {
    return utf8proc_grapheme_break_stateful(static_cast<utf8proc_int32_t>(std::exchange(last_, next)),
                                            static_cast<utf8proc_int32_t>(next), &state_);
}

std::size_t next_character(std::string_view text, std::size_t byte) {
    CharacterBreaks breaks;
    std::size_t at = byte;
    while (at < text.size()) {
        const Decoded here = decode(text.substr(at));
        if (breaks.before(here.codepoint) && at > byte) break;
        at += here.bytes;
    }
    return at - std::min(at, byte);
}

std::size_t previous_character(std::string_view text, std::size_t byte) {
    const std::size_t end = std::min(byte, text.size());
    if (end == 0) return 0;
    // Back to where a character begins for certain, and on from there.
    std::size_t begin = code_point_before(text, end);
    for (char32_t after = decode(text.substr(begin)).codepoint; begin > 0;) {
        const std::size_t at = code_point_before(text, begin);
        const char32_t before = decode(text.substr(at)).codepoint;
        if (always_parted(before, after)) break;
        begin = at;
        after = before;
    }
    for (std::size_t next = begin; next < end; next += next_character(text, next)) begin = next;
    return end - begin;
}

}  // namespace lapfx::ui
