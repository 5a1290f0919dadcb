// What is told of a clip that is open already.
#pragma once

#include "lapfx/clip.h"
#include "smoke/decoder.h"

namespace lapfx::smoke {

ClipReport report_of(const ClipInfo& info);

}  // namespace lapfx::smoke
