#include "reference/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "clips/noise.h"

namespace camera {

namespace {

using clips::hash;
using clips::RgbFrame;
using clips::uniform;

float to_linear(float code) {
    const float v = code / 255.0f;
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

float to_code(float linear) {
    const float v = std::clamp(linear, 0.0f, 1.0f);
    return 255.0f * (v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f);
}

/// Box and Muller (1958): a normal deviate from two uniform ones.
float normal(std::uint32_t number, std::uint32_t seed) {
    const std::uint32_t h = hash(number, seed);
    const float radius = std::sqrt(-2.0f * std::log(1.0f - uniform(h)));
    return radius * std::cos(2.0f * std::numbers::pi_v<float> * uniform(hash(h)));
}

std::vector<float> kernel(float deviation) {
    const int reach = std::max(1, static_cast<int>(std::ceil(3.0f * deviation)));
    std::vector<float> weights;
    float sum = 0.0f;
    for (int i = -reach; i <= reach; ++i) {
        weights.push_back(std::exp(-0.5f * static_cast<float>(i * i) / (deviation * deviation)));
        sum += weights.back();
    }
    for (float& weight : weights) weight /= sum;
    return weights;
}

/// One row or column of `count` values that are `step` apart.
void blur_line(float* first, int count, int step, const std::vector<float>& weights, std::vector<float>& line) {
    const int reach = static_cast<int>(weights.size()) / 2;
    line.resize(static_cast<std::size_t>(count + 2 * reach));
    for (int i = 0; i < count + 2 * reach; ++i)
        line[static_cast<std::size_t>(i)] = first[std::ptrdiff_t{step} * std::clamp(i - reach, 0, count - 1)];
    for (int i = 0; i < count; ++i) {
        float sum = 0.0f;
        for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * line[static_cast<std::size_t>(i) + k];
        first[std::ptrdiff_t{step} * i] = sum;
    }
}

/// Normal noise, brightness in channel 0 and colour in two more, as fine as in the camera's picture, each of deviation
/// 1.
RgbFrame grain(const RgbFrame& like, const Camera& camera) {
    RgbFrame noise(like.width, like.height);
    for (std::size_t i = 0; i < noise.rgb.size(); ++i)
        noise.rgb[i] = normal(static_cast<std::uint32_t>(i), camera.seed);
    for (int channel = 0; channel < 3; ++channel) {
        const float deviation = channel == 0 ? camera.grain : camera.color_grain;
        blur(noise, channel, deviation);
        double energy = 0.0;
        const auto first = static_cast<std::size_t>(channel);
        for (std::size_t i = first; i < noise.rgb.size(); i += 3) energy += noise.rgb[i] * noise.rgb[i];
        const auto scale = static_cast<float>(std::sqrt(static_cast<double>(noise.rgb.size() / 3) / energy));
        for (std::size_t i = first; i < noise.rgb.size(); i += 3) noise.rgb[i] *= scale;
    }
    return noise;
}

}  // namespace

void blur(RgbFrame& frame, int channel, float deviation) {
    if (!(deviation > 0.0f)) return;
    const std::vector<float> weights = kernel(deviation);
    std::vector<float> line;
    for (int y = 0; y < frame.height; ++y)
        blur_line(frame.rgb.data() + std::ptrdiff_t{3} * y * frame.width + channel, frame.width, 3, weights, line);
    for (int x = 0; x < frame.width; ++x)
        blur_line(frame.rgb.data() + std::ptrdiff_t{3} * x + channel, frame.height, 3 * frame.width, weights, line);
}

void film(RgbFrame& frame, const Camera& camera) {
    for (float& value : frame.rgb) value = to_linear(value);
    for (int channel = 0; channel < 3; ++channel) blur(frame, channel, camera.softness);
    const RgbFrame noise = grain(frame, camera);
    const float dark = camera.read_noise * camera.read_noise;
    for (std::size_t i = 0; i < frame.rgb.size(); i += 3) {
        const float* n = &noise.rgb[i];
        // Red and blue differ from green, which has half of a mosaic's pixels.
        const float share[3] = {n[0] + 0.7f * n[1], n[0] - 0.25f * (n[1] + n[2]), n[0] + 0.8f * n[2]};
        for (std::size_t c = 0; c < 3; ++c) {
            float& value = frame.rgb[i + c];
            const float deviation = std::sqrt(value * camera.electrons + dark) / camera.electrons;
            value = to_code(value + deviation * share[c]);
        }
    }
}

}  // namespace camera
