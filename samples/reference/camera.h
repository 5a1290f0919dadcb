// Makes a clean picture look like one of an endoscope's camera, with a soft lens and a sensor whose noise grows with
// the light.
//
//     camera::film(frame, {.seed = hash(seed, number)});  // in place
//
// Each frame has independent noise; the same seed gives the same noise.
#pragma once

#include <cstdint>

#include "clips/encoder.h"

namespace camera {

struct Camera {
    float softness = 0.55f;     ///< px, standard deviation of the lens's blur
    float electrons = 1900.0f;  ///< electrons that a pixel in full light collects: fewer mean more noise
    float read_noise = 2.5f;    ///< electrons, standard deviation, also in the dark
    float grain = 0.6f;         ///< px, standard deviation of the blur of the noise by mosaic and processing
    float color_grain = 1.4f;   ///< px, likewise for its colour
    std::uint32_t seed = 0;
};

/// `frame`: sRGB code values.
void film(clips::RgbFrame& frame, const Camera& camera);

/// Blurs one channel of three by a Gaussian, which keeps its energy at the borders.
void blur(clips::RgbFrame& frame, int channel, float deviation);

}  // namespace camera
