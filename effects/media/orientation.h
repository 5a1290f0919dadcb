// How a picture is to be turned, according to the EXIF data of a PNG, a WebP or a TIFF. FFmpeg reads it of JPEGs alone.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace lapfx::media {

/// Gives up to `size` bytes of a file from `offset` on; fewer, or none, where it ends.
using ReadAt = std::function<std::vector<std::uint8_t>(std::int64_t offset, std::size_t size)>;

/// EXIF's number, 1 to 8 (tag 0x0112); 1, upright, where the file does not say.
int exif_orientation(const ReadAt& file);

}  // namespace lapfx::media
