#include "volume_renderer.h"

#include <array>
#include <cmath>

#include "parallel.h"

namespace clips {
namespace {

/// Mitchell and Netravali's cubic (1988) with B = C = 1/3: sharp enough, and free of the grid's pattern.
std::array<float, 4> mitchell(float t) {
    const auto near = [](float x) { return (7.0f * x * x * x - 12.0f * x * x + 16.0f / 3.0f) / 6.0f; };
    const auto far = [](float x) {
        return (-7.0f / 3.0f * x * x * x + 12.0f * x * x - 20.0f * x + 32.0f / 3.0f) / 6.0f;
    };
    return {far(1.0f + t), near(t), near(1.0f - t), far(2.0f - t)};
}

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

}  // namespace

VolumeRenderer::VolumeRenderer(const Field& lattice, LightSettings light, ViewSettings view, int width, int height)
    : light_(light),
      view_(view),
      width_(width),
      height_(height),
      nx_(lattice.size.x),
      ny_(lattice.size.y),
      spacing_(lattice.spacing),
      shadow_(std::size_t(nx_) * ny_),
      next_(shadow_.size()),
      value_(shadow_.size()),
      clear_(shadow_.size()) {}

/// Carries the optical depth towards the light one slice deeper. The small blur models light that is scattered forward:
/// shadows become softer with depth (as in half-angle slicing, Kniss et al. 2003).
void VolumeRenderer::shift_shadow() {
    const float dx = light_.slant.x, dy = light_.slant.y;
    const auto value = [&](int i, int j) {
        return shadow_[std::size_t(std::clamp(j, 0, ny_ - 1)) * nx_ + std::size_t(std::clamp(i, 0, nx_ - 1))];
    };
    const int ox = int(std::floor(dx)), oy = int(std::floor(dy));
    const auto weights = [](float f) {
        constexpr float side = 0.06f, middle = 1.0f - 2.0f * side;
        return std::array<float, 4>{side * (1 - f), middle * (1 - f) + side * f, middle * f + side * (1 - f), side * f};
    };
    const auto wx = weights(dx - float(ox)), wy = weights(dy - float(oy));
    for (int j = 0; j < ny_; ++j)
        for (int i = 0; i < nx_; ++i) {
            float sum = 0.0f;
            for (int b = 0; b < 4; ++b) {
                float row = 0.0f;
                for (int a = 0; a < 4; ++a) row += wx[std::size_t(a)] * value(i + ox - 1 + a, j + oy - 1 + b);
                sum += wy[std::size_t(b)] * row;
            }
            next_[std::size_t(j) * nx_ + std::size_t(i)] = sum;
        }
    std::swap(shadow_, next_);
}

/// Front to back through the slices; the camera looks along -z, so the last slice is in front.
void VolumeRenderer::sweep(const Field& density) {
    std::fill(shadow_.begin(), shadow_.end(), 0.0f);
    std::fill(value_.begin(), value_.end(), 0.0f);
    std::fill(clear_.begin(), clear_.end(), 1.0f);
    const std::size_t plane = shadow_.size();
    const float depth = light_.extinction * spacing_;
    const float towards_light =
        light_.shadow * depth * std::sqrt(1.0f + light_.slant.x * light_.slant.x + light_.slant.y * light_.slant.y);
    bool any = false;
    for (int k = density.size.z - 1; k >= 0; --k) {
        const float* slice = density.values.data() + std::size_t(k) * plane;
        if (any) shift_shadow();
        for (std::size_t n = 0; n < plane; ++n) {
            if (slice[n] <= 1e-5f) continue;
            any = true;
            const float opacity = 1.0f - std::exp(-slice[n] * depth);
            // Light that arrives after one, two and three scatterings, each less hindered than the one before
            // (Wrenninge, Kulla and Lundqvist 2013, "Oz: the great and volumetric").
            const float tau = shadow_[n] + 0.5f * slice[n] * towards_light;
            const float lit = 0.5f * std::exp(-tau) + 0.3f * std::exp(-0.4f * tau) + 0.2f * std::exp(-0.15f * tau);
            value_[n] += clear_[n] * opacity * (light_.ambient + light_.direct * lit);
            clear_[n] *= 1.0f - opacity;
            shadow_[n] += slice[n] * towards_light;
        }
    }
}

float VolumeRenderer::border(glm::vec2 p) const {
    if (!view_.fades) return 1.0f;
    const glm::vec4 box = view_.fade_box, width = view_.fade;
    return smooth_step(0.0f, width.x, p.x - box.x) * smooth_step(0.0f, width.y, box.y - p.x) *
           smooth_step(0.0f, width.z, box.z - p.y) * smooth_step(0.0f, width.w, p.y - box.w);
}

Picture VolumeRenderer::draw(const Field& density) {
    sweep(density);
    Picture picture(width_, height_);
    const float cell = view_.height / float(height_);
    for_slabs(height_, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width_; ++x) {
                const glm::vec2 p = view_.centre + cell * glm::vec2(float(x) + 0.5f - 0.5f * float(width_),
                                                                    0.5f * float(height_) - float(y) - 0.5f);
                const float gx = p.x / spacing_ - 0.5f, gy = p.y / spacing_ - 0.5f;
                if (gx < 1.0f || gy < 1.0f || gx >= float(nx_ - 3) || gy >= float(ny_ - 3)) continue;
                const int i = int(gx), j = int(gy);
                const auto wx = mitchell(gx - float(i)), wy = mitchell(gy - float(j));
                float value = 0.0f, clear = 0.0f;
                for (int b = 0; b < 4; ++b)
                    for (int a = 0; a < 4; ++a) {
                        const std::size_t n = std::size_t(j - 1 + b) * nx_ + std::size_t(i - 1 + a);
                        const float weight = wx[std::size_t(a)] * wy[std::size_t(b)];
                        value += weight * value_[n];
                        clear += weight * clear_[n];
                    }
                const float keep = border(p);
                const std::size_t n = std::size_t(y) * width_ + std::size_t(x);
                picture.alpha[n] = keep * std::clamp(1.0f - clear, 0.0f, 1.0f);
                picture.value[n] = std::clamp(keep * value, 0.0f, picture.alpha[n]);
            }
    });
    return picture;
}

}  // namespace clips
