// Measures pictures whose amounts are known, each with the clear picture of its view as baseline, as `lapfx measure`
// does.
#pragma once

#include <functional>

#include "bench/measure/camera.h"
#include "match/frame/estimator.h"

namespace lapfx::bench {

/// Gives each picture that counts, with the estimator that has measured it. Any thread; no OpenGL.
void measure_each(
    const KnownView& view, const match::EstimatorOptions& options,
    const std::function<void(const KnownPicture&, const match::Estimator&, const match::FrameAmounts&)>& measured);

}  // namespace lapfx::bench
