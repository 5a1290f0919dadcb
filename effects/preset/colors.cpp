#include "preset/colors.h"

#include <charconv>
#include <cmath>

namespace lapfx::preset {

std::optional<glm::dvec3> read_hex_color(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return {};
    unsigned rgb = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
    if (error != std::errc{} || end != text.data() + 7) return {};
    return glm::dvec3(rgb >> 16, rgb >> 8 & 255, rgb & 255) / 255.0;
}

std::optional<std::string> hex_color(const glm::dvec3& color) {
    constexpr char digits[] = "0123456789abcdef";
    std::string out = "#";
    for (int i = 0; i < 3; ++i) {
        if (!(color[i] >= 0.0 && color[i] <= 1.0)) return {};
        const int code = static_cast<int>(std::lround(color[i] * 255.0));
        if (code / 255.0 != color[i]) return {};
        out += {digits[code >> 4], digits[code & 15]};
    }
    return out;
}

}  // namespace lapfx::preset
