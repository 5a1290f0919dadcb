// Videos and pictures: rows of the table of formats (lapfx/authoring/formats.h).
#pragma once

#include "lapfx/authoring/formats.h"

namespace lapfx::media {

std::span<const FileFormat> video_formats();
std::span<const FileFormat> picture_formats();

}  // namespace lapfx::media
