// The report about a clip that is already open.
#pragma once

#include "lapfx/authoring/clip.h"
#include "media/decoder.h"

namespace lapfx::media {

ClipReport report_of(const ClipInfo& info);

}  // namespace lapfx::media
