// Textures: PNG, JPEG, WebP and BMP through OpenCV, always as 8-bit RGBA.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "lapfx/organ.h"

namespace lapfx::media {

/// Limits on one image: what OpenGL drivers take, and a GiB of memory.
constexpr int maximum_image_side = 16384;
constexpr std::int64_t maximum_image_pixels = std::int64_t{256} << 20;

struct ImageSize {
    std::int64_t width = 0;
    std::int64_t height = 0;
};

/// Width and height from the file's header, without decoding; false when it has none of the four formats.
bool image_size(std::span<const std::uint8_t> file, ImageSize& size);

/// What the file itself has.
struct ImageFacts {
    int channels = 0;  ///< 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha (or four inks)
    int bits = 0;      ///< for one value
};

/// Decodes a whole image file into `image`, whose name stays. Returns the reason of a failure, or an empty string.
/// Writes nothing to stderr.
std::string decode_image(std::span<const std::uint8_t> file, Image& image, ImageFacts& facts);
std::string decode_image(std::span<const std::uint8_t> file, Image& image);

}  // namespace lapfx::media
