// The camera's picture of linear light, computed on the CPU as in shaders/post.glsl. Pure functions, any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "lapfx/camera.h"

namespace lapfx::test {

/// Linear light, rows upward as a texture has them.
struct Light {
    glm::ivec2 size{0};
    std::vector<glm::vec3> pixels = {};

    glm::dvec3 at(glm::ivec2 p) const {
        p = glm::clamp(p, glm::ivec2(0), size - 1);
        return glm::dvec3(pixels[static_cast<std::size_t>(p.y * size.x + p.x)]);
    }
};

/// Code values 0..255, unrounded.
class PostCpu {
  public:
    PostCpu(const Light& light, const CameraResponse& response) : light_(light), response_(response) {}

    glm::dvec3 at(glm::ivec2 p) const {
        glm::dvec3 color = light_.at(p) * exposed() * std::pow(1.0 + sharpening(p), 2.0);
        color = glm::max(glm::mix(glm::dvec3(glm::dot(color, luma)), color, response_.saturation), 0.0);
        const double height = light_.size.y;
        const double radius = glm::length(glm::dvec2(p) + 0.5 - 0.5 * glm::dvec2(light_.size)) / (0.5 * height);
        const double lens = 1.0 - response_.lens_falloff * glm::smoothstep(0.35, 1.15, radius);
        const double mask = 1.0 - glm::smoothstep(1.11, 1.13, radius), v = response_.vignette;
        const bool film = response_.curve == ResponseCurve::film;
        for (int c = 0; c < 3; ++c)
            color[c] = film ? shown_light(color[c] * glm::mix(1.0, lens, v), response_) * glm::mix(1.0, mask, v)
                            : shown_light(color[c], response_) * glm::mix(1.0, lens * mask, v);
        for (int c = 0; c < 3; ++c) color[c] = 255.0 * encoded(std::clamp(color[c], 0.0, 1.0));
        return color;
    }

  private:
    static constexpr glm::dvec3 luma{0.2126, 0.7152, 0.0722};
    static double encoded(double linear) {
        return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    }
    glm::dvec3 exposed() const { return response_.white_balance * response_.exposure; }
    double brightness(glm::ivec2 p) const { return std::sqrt(std::max(glm::dot(light_.at(p) * exposed(), luma), 0.0)); }
    double brightness_at(glm::dvec2 place) const {
        const glm::dvec2 from = glm::floor(place), f = place - from;
        const glm::ivec2 first(from);
        return glm::mix(glm::mix(brightness(first), brightness(first + glm::ivec2(1, 0)), f.x),
                        glm::mix(brightness(first + glm::ivec2(0, 1)), brightness(first + glm::ivec2(1, 1)), f.x), f.y);
    }
    double sharpening(glm::ivec2 p) const {
        const double apart = 1.5 / 512.0 * light_.size.y, here = brightness(p);
        double around = 0.0;
        for (const glm::dvec2 to : {glm::dvec2(apart, 0), {-apart, 0}, {0, apart}, {0, -apart}})
            around += 0.25 * brightness_at(glm::dvec2(p) + to);
        return std::clamp(response_.sharpening * (here - around) / (here + 0.05), -0.25, 0.25);
    }

    const Light& light_;
    const CameraResponse& response_;
};

}  // namespace lapfx::test
