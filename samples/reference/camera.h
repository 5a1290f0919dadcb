// What an endoscope's camera does to a clean picture: a soft lens, and a sensor whose noise grows with the light.
//
//     camera::film(frame, {.seed = hash(seed, number)});  // in place
//
// Every frame on its own; the same seed, the same noise.
#pragma once

#include <cstdint>

#include "clips/encoder.h"

namespace camera {

struct Camera {
    float softness = 0.55f;     ///< px, standard deviation of the lens's blur
    float electrons = 1900.0f;  ///< that a pixel of full light collects: fewer, more noise
    float read_noise = 2.5f;    ///< electrons, standard deviation, in the dark, too
    float grain = 0.6f;         ///< px, standard deviation of the blur that mosaic and cleaning up leave in the noise
    float color_grain = 1.4f;   ///< px, likewise of its colour
    std::uint32_t seed = 0;
};

/// `frame`: sRGB code values.
void film(clips::RgbFrame& frame, const Camera& camera);

/// Blurs one channel of three by a Gaussian; its energy stays at the borders.
void blur(clips::RgbFrame& frame, int channel, float deviation);

}  // namespace camera
