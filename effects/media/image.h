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

/// Whether a PNG or a WebP, of which this is the beginning, has several frames.
bool is_animated_png(std::span<const std::uint8_t> file);
bool is_animated_webp(std::span<const std::uint8_t> file);
constexpr const char* animated_webp =
    "is an animated WebP, which is not read; save it as a video, or as an animated PNG or GIF";

/// What the file itself has.
struct ImageFacts {
    int channels = 0;  ///< 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha (or four inks)
    int bits = 0;      ///< for one value
};

/// By how much an image is shrunk while it is read, so that no side is longer than `longest`: 1, or a power of two.
int shrink_factor(const ImageSize& size, int longest);

/// Decodes a whole image file into `image`, whose name stays. Returns the reason of a failure, or an empty string.
/// Writes nothing to stderr. An image with a side longer than `longest` is shrunk while it is read, to means over
/// squares of shrink_factor() pixels. Of a PNG, and of a JPEG that is not progressive, all pixels are never in memory
/// at once; WebP, BMP and progressive JPEG are decoded whole first, and the sums of an interlaced PNG take up to half
/// of the memory of its pixels.
std::string decode_image(std::span<const std::uint8_t> file, Image& image, ImageFacts& facts,
                         int longest = maximum_image_side);
std::string decode_image(std::span<const std::uint8_t> file, Image& image, int longest = maximum_image_side);

}  // namespace lapfx::media
