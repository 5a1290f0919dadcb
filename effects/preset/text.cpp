#include "preset/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <vector>

#include "lapfx/authoring/letters.h"
#include "lapfx/authoring/utf8.h"

namespace lapfx::preset {

std::string number_text(double value) {
    if (value == 0.0) value = 0.0;  // "-0" would read back as 0 and be written differently
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

bool read_number(std::string_view text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
}

std::string shown(std::string_view text, std::size_t longest) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        if (out.size() >= longest) return out + "...";
        if (const std::size_t length = first_character(text.substr(i)).bytes; length > 0) {
            out += text.substr(i, length);
            i += length;
        } else {
            constexpr char digits[] = "0123456789abcdef";
            const auto byte = static_cast<unsigned char>(text[i++]);
            out += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
        }
    }
    return out;
}

std::string in_quotes(std::string_view text) {
    return '"' + shown(text, 60) + '"';
}

std::string_view nearest(std::string_view key, std::span<const std::string_view> candidates) {
    key = key.substr(0, 200);  // no known key is that long, and a hostile key must not cost minutes
    std::string_view best;
    std::size_t least = std::string_view::npos;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(key, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

std::string too_many(std::size_t size, std::size_t most) {
    return std::to_string(size) + " elements; at most " + std::to_string(most) + " are allowed";
}

std::string join_pointer(const std::string& pointer, std::string_view key) {
    std::string out = pointer + '/';
    for (const char c : shown(key, 120)) {
        if (c == '~') {
            out += "~0";
        } else if (c == '/') {
            out += "~1";
        } else {
            out += c;
        }
    }
    return out;
}

}  // namespace lapfx::preset

namespace lapfx {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

}  // namespace lapfx
