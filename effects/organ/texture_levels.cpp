#include "organ/texture_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/color_space.hpp>

#include "media/opencv.h"

namespace lapfx::organ {

namespace {

/// An image and its bytes, which may be elsewhere.
std::shared_ptr<const Image> whole_image(const Organ& organ, const PixelList& pixels, std::size_t i) {
    const bool apart = organ.images[i].pixels.empty() && i < pixels.size() && pixels[i] != nullptr;
    return apart ? pixels[i]->get() : std::shared_ptr<const Image>(std::shared_ptr<const Image>(), &organ.images[i]);
}

bool has_bytes(const Image& image) {
    return image.width > 0 && image.height > 0 &&
           image.pixels.size() == 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

// Levels are made from 16 bits and of each other, so that rounding does not add up.
constexpr float whole = 65535.0F;
constexpr int of_byte = 257;  // 65535 / 255

/// From bytes to 16 bits: light of sRGB (IEC 61966-2-1), or the value.
cv::Mat wide_of_bytes(bool color) {
    cv::Mat table(1, 256, CV_16UC4);
    for (int i = 0; i < 256; ++i) {
        const glm::vec3 light = whole * glm::convertSRGBToLinear(glm::vec3(static_cast<float>(i) / 255.0F));
        const auto alpha = static_cast<std::uint16_t>(of_byte * i),
                   value = color ? static_cast<std::uint16_t>(std::lround(light.x)) : alpha;
        table.at<cv::Vec4w>(0, i) = {value, value, value, alpha};
    }
    return table;
}

std::vector<std::uint8_t> bytes_of_wide(bool color) {
    std::vector<std::uint8_t> table(65536);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float value = static_cast<float>(i) / whole;
        table[i] = static_cast<std::uint8_t>(
            std::lround(255.0F * (color ? glm::convertLinearToSRGB(glm::vec3(value)).x : value)));
    }
    return table;
}

/// Both are made once.
struct Tables {
    explicit Tables(bool color) : wide(wide_of_bytes(color)), bytes(bytes_of_wide(color)) {}
    cv::Mat wide;
    std::vector<std::uint8_t> bytes;
};
const Tables& tables(bool color) {
    static const Tables of_light(true), of_values(false);
    return color ? of_light : of_values;
}

Image image_of(const cv::Mat& level, const std::vector<std::uint8_t>& bytes) {
    const std::size_t values = 4 * level.total();
    Image image{.width = level.cols, .height = level.rows, .pixels = std::vector<std::uint8_t>(values), .name = ""};
    const auto* from = level.ptr<std::uint16_t>();  // resize() leaves no gaps
    for (std::size_t i = 0; i < values; i += 4) {
        for (std::size_t k = 0; k < 3; ++k) image.pixels[i + k] = bytes[from[i + k]];
        image.pixels[i + 3] = static_cast<std::uint8_t>((from[i + 3] + of_byte / 2) / of_byte);
    }
    return image;
}

}  // namespace

std::vector<TextureUse> texture_uses(const Organ& organ) {
    std::vector<TextureUse> uses;
    for (std::size_t i = 0; i < organ.images.size(); ++i) {
        const auto is_used = [&](int Material::*as) {
            return std::ranges::any_of(organ.materials,
                                       [&](const Material& m) { return m.*as == static_cast<int>(i); });
        };
        if (is_used(&Material::base_color_image)) uses.push_back({.image = i, .color = true});
        if (is_used(&Material::normal_image)) uses.push_back({.image = i, .color = false});
    }
    return uses;
}

std::vector<Image> smaller_levels(const Image& image, bool color) {
    const auto& [wide, bytes] = tables(color);
    std::vector<Image> levels;
    cv::Mat above;
    cv::LUT(media::pixels_of(image), wide, above);
    while (above.cols > 1 || above.rows > 1) {
        cv::Mat half;
        cv::resize(above, half, {std::max(above.cols / 2, 1), std::max(above.rows / 2, 1)}, 0.0, 0.0, cv::INTER_AREA);
        levels.push_back(image_of(half, bytes));
        above = half;
    }
    return levels;
}

TextureLevels texture_levels(const Organ& organ, const PixelList& pixels, const TextureUse& use) {
    TextureLevels levels{.use = use,
                         .whole = whole_image(organ, pixels, use.image),
                         .smaller = {},
                         .wrap_u = organ.images[use.image].wrap_u,
                         .wrap_v = organ.images[use.image].wrap_v};
    if (!has_bytes(*levels.whole)) return {.use = use, .whole = nullptr, .smaller = {}};
    levels.smaller = smaller_levels(*levels.whole, use.color);
    return levels;
}

}  // namespace lapfx::organ
