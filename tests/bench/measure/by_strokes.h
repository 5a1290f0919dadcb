// Labelled frames as a person would paint over them: strokes that are drawn at random inside the label and beside it.
//
//     const PaintedView painted = bench::painted_view(view, random, 1);
//     measure_each(painted.view, {.painted_blood = painted.blood}, add);
//
// Any thread; no OpenGL.
#pragma once

#include <memory>

#include "bench/measure/camera.h"
#include "bench/measure/random.h"
#include "match/frame/painted_blood.h"

namespace lapfx::bench {

inline constexpr int strokes_of_blood = 3, strokes_of_other = 6;  // over each frame that is painted

struct PaintedView {
    /// The same, led by the frame before the bleeding, which is learned from, too. The painted frames do not count.
    KnownView view;
    std::shared_ptr<const match::PaintedBlood> blood;  ///< null where fewer than three frames have blood
};

/// `view`: labelled, in order. Painted over is the second frame with blood, and, of `frames` 2, the fourth or the last.
PaintedView painted_view(const KnownView& view, Random& random, int frames);

}  // namespace lapfx::bench
