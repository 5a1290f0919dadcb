// How the renderer's shapes have to look, computed pixel by pixel in plain C++.
#pragma once

#include "ui/draw/draw_list.h"
#include "ui/support/picture.h"

namespace lapfx::ui::test {

/// Draws clears, fills, frames, lines, gradients, checkers and shadows, none thinner than a pixel. They are blended in
/// 8 bits, one after the other.
Picture reference_picture(const DrawList& list);

}  // namespace lapfx::ui::test
