// What the renderer's shapes are to look like, worked out pixel by pixel in plain C++.
#pragma once

#include "ui/draw/draw_list.h"
#include "ui/support/picture.h"

namespace lapfx::ui::test {

/// Clears, fills, frames, lines, gradients, checkers and shadows; nothing thinner than a pixel. Blended in 8 bits, one
/// after the other.
Picture reference_picture(const DrawList& list);

}  // namespace lapfx::ui::test
