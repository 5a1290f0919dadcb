#include "match/report/markup.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "lapfx/authoring/utf8.h"

namespace lapfx::match {

namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";  // base64
constexpr std::size_t group = 3;  // bytes become four letters

constexpr std::string_view unshowable = "\xEF\xBF\xBD";  // U+FFFD in UTF-8

bool lies(char32_t code, char32_t from, char32_t to) {
    return code >= from && code <= to;
}

/// `code`: of first_character(), so that it is no half of a pair of UTF-16.
bool showable(char32_t code) {
    if (code == '\t' || code == '\n') return true;
    const bool control = code < 0x20 || lies(code, 0x7F, 0x9F);
    const bool no_letter = lies(code, 0xFDD0, 0xFDEF) || (code & 0xFFFEU) == 0xFFFE;
    // A name such as "cod.<U+202E>gpj" would read as another one.
    const bool turns = lies(code, 0x202A, 0x202E) || lies(code, 0x2066, 0x2069);
    return !control && !no_letter && !turns;
}

std::string_view reference_for(char32_t code) {
    switch (code) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        default:
            return {};
    }
}

std::string printed(const char* format, int precision, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, precision, value);
    return text;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const Utf8Character letter = first_character(text);
        const std::size_t bytes = std::max<std::size_t>(letter.bytes, 1);
        if (letter.bytes == 0 || !showable(letter.code))
            safe += unshowable;
        else if (const std::string_view reference = reference_for(letter.code); !reference.empty())
            safe += reference;
        else
            safe += text.substr(0, bytes);
        text.remove_prefix(bytes);
    }
    return safe;
}

std::string base64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + group - 1) / group * (group + 1));
    for (std::size_t i = 0; i < bytes.size(); i += group) {
        const std::size_t count = std::min(group, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t j = 0; j < group; ++j)
            bits = (bits << 8U) | (j < count ? static_cast<std::uint8_t>(bytes[i + j]) : 0U);
        for (std::size_t j = 0; j <= group; ++j)
            text += j <= count ? letters[(bits >> (6U * (group - j))) & 0x3FU] : '=';
    }
    return text;
}

std::string bytes_of_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t bits = 0;
    const std::size_t end = std::min(text.find('='), text.size());
    for (std::size_t i = 0; i < end; ++i) {
        const std::size_t value = letters.find(text[i]);
        if (value == std::string_view::npos) return {};
        bits = (bits << 6U) | static_cast<std::uint32_t>(value);
        // The first letter of a group holds six bits of a byte, each other one ends a byte.
        if (i % (group + 1) != 0) bytes += static_cast<char>((bits >> (2U * (group - i % (group + 1)))) & 0xFFU);
    }
    return base64(bytes) == text ? bytes : std::string{};
}

std::string digits(double value) {
    constexpr int counted = 3;
    constexpr double longer = 999.5;  // has more before the point
    if (std::abs(value) >= longer) return decimals(value, 0);
    return std::isfinite(value) ? printed("%.*g", counted, value) : "-";
}

std::string decimals(double value, int count) {
    if (!std::isfinite(value)) return "-";
    return printed("%.*f", count, value);
}

}  // namespace lapfx::match
