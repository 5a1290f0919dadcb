#include "composite.h"

#include <cmath>
#include <numbers>

#include "noise.h"

namespace clips {

void LoopBlend::add(int index, Picture picture) {
    if (index < 0) {
        before_.push_back(std::move(picture));
        return;
    }
    const int into = index - (frames_ - blend_);
    if (into >= 0) {
        const Picture& early = before_[std::size_t(into)];
        const float share = glm::smoothstep(0.0f, 1.0f, float(into + 1) / float(blend_ + 1));
        for (std::size_t n = 0; n < picture.value.size(); ++n) {
            picture.value[n] = glm::mix(picture.value[n], early.value[n], share);
            picture.alpha[n] = glm::mix(picture.alpha[n], early.alpha[n], share);
        }
    }
    output_(index, picture);
}

RgbFrame over(const Picture& smoke, glm::vec3 background) {
    constexpr glm::vec3 thin(0.955f, 0.995f, 1.045f), thick(1.0f, 1.0f, 0.985f);
    RgbFrame frame(smoke.width, smoke.height);
    for (std::size_t n = 0; n < smoke.value.size(); ++n) {
        const float alpha = smoke.alpha[n];
        const glm::vec3 tint = glm::mix(thin, thick, alpha);
        const glm::vec3 color = 255.0f * smoke.value[n] * tint + (1.0f - alpha) * background;
        for (int c = 0; c < 3; ++c) frame.rgb[3 * n + std::size_t(c)] = std::clamp(color[c], 0.0f, 255.0f);
    }
    return frame;
}

RgbFrame alpha_as_grey(const Picture& smoke) {
    RgbFrame frame(smoke.width, smoke.height);
    for (std::size_t n = 0; n < smoke.alpha.size(); ++n)
        for (std::size_t c = 0; c < 3; ++c) frame.rgb[3 * n + c] = 255.0f * smoke.alpha[n];
    return frame;
}

void add_sensor_noise(RgbFrame& frame, float deviation, std::uint32_t seed) {
    for (std::size_t n = 0; n < frame.rgb.size(); ++n) {
        // Box and Muller (1958): a normal deviate from two uniform ones.
        const std::uint32_t h = hash(std::uint32_t(n), seed);
        const float radius = std::sqrt(-2.0f * std::log(1.0f - uniform(h)));
        const float angle = 2.0f * std::numbers::pi_v<float> * uniform(hash(h));
        frame.rgb[n] = std::clamp(frame.rgb[n] + deviation * radius * std::cos(angle), 0.0f, 255.0f);
    }
}

}  // namespace clips
