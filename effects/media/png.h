// PNG through libpng itself: OpenCV's reader lets libpng write its messages to stderr.
#pragma once

#include "media/image.h"

namespace lapfx::media {

/// As decode_image(), for a file that begins as a PNG does, shrunk by `factor`, at most 16.
bool decode_png(std::span<const std::uint8_t> file, Image& image, ImageFacts& facts, int factor = 1);

}  // namespace lapfx::media
