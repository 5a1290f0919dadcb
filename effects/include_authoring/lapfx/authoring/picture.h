// One still image: PNG, JPEG, WebP or BMP.
//
//     const lapfx::ImageFile picture = lapfx::read_image("skin.png");   // throws lapfx::Error
//
// Any thread.
#pragma once

#include <filesystem>

#include "lapfx/organ.h"

namespace lapfx {

struct ImageFile {
    Image image;       ///< 8-bit RGBA, rows from the top
    int channels = 0;  ///< of the file: 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha
    int bits = 0;      ///< of the file, for one value
};

/// Throws Error (bad_input): not a plain file, none of the four formats, broken, or more than 16,384 pixels a side.
ImageFile read_image(const std::filesystem::path& path);

/// Whether it is a PNG or a WebP of several frames: an animated PNG plays as a video, and read_image() gives its still
/// picture; an animated WebP is not read. False for what cannot be read.
bool is_animated_picture(const std::filesystem::path& path);

}  // namespace lapfx
