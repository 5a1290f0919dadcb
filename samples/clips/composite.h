// From pictures of smoke to frames of a clip: looping, tint, background, sensor noise.
#pragma once

#include <functional>
#include <vector>

#include "encoder.h"
#include "volume_renderer.h"

namespace clips {

/// Makes a series of pictures loop: the last `blend` pictures fade into the `blend` pictures from before the first.
class LoopBlend {
  public:
    LoopBlend(int frames, int blend, std::function<void(int, const Picture&)> output)
        : frames_(frames), blend_(blend), output_(std::move(output)) {}

    /// Pictures in order, -blend to frames - 1.
    void add(int index, Picture picture);

  private:
    int frames_, blend_;
    std::function<void(int, const Picture&)> output_;
    std::vector<Picture> before_;
};

/// Smoke over one colour. Thin smoke scatters blue more than red and looks bluish, thick smoke is a warm
/// white.
RgbFrame over(const Picture& smoke, glm::vec3 background);

/// The alpha as grey: 255 is opaque.
RgbFrame alpha_as_grey(const Picture& smoke);

/// Adds sensor noise with the given standard deviation in code values.
void add_sensor_noise(RgbFrame& frame, float deviation, std::uint32_t seed);

}  // namespace clips
