// JPEG through libjpeg itself: OpenCV's reader lets libjpeg write its messages to stderr.
#pragma once

#include "media/image.h"

namespace lapfx::media {

/// As decode_image(), for a file that begins as a JPEG does, shrunk by `factor`, a power of two. What is cut off at the
/// end is grey.
bool decode_jpeg(std::span<const std::uint8_t> file, Image& image, ImageFacts& facts, int factor = 1);

}  // namespace lapfx::media
