#include "lapfx/camera.h"

#include <algorithm>
#include <cmath>

#include "gl/shader_source.h"

namespace lapfx {

namespace {

constexpr double shoulder_knee = 0.7, most_of_shoulder = 0.98;  // shaders/color.glsl; light beyond says nothing

/// The shoulder of the film curve, from the knee on: 0 to 1 over light from the knee to white.
struct Shoulder {
    double knee, end;  // end: light of white, over the knee, in units of what is left between the knee and 1
    explicit Shoulder(const CameraResponse& response)
        : knee(response.knee), end((response.white - response.knee) / (1.0 - response.knee)) {}
};

}  // namespace

double shown_light(double light, const CameraResponse& response) noexcept {
    const double x = std::max(light, 0.0);
    if (response.curve == ResponseCurve::shoulder) {
        const double over = std::max(x - shoulder_knee, 0.0) / (1.0 - shoulder_knee);
        return std::min(x, shoulder_knee) + (1.0 - shoulder_knee) * over / (1.0 + over);
    }
    const double t = response.toe, lifted = x > 0.0 ? x * x * (1.0 + t) / (x + t) : 0.0;
    const Shoulder s(response);
    const double u = std::min(std::max(lifted - s.knee, 0.0) / (1.0 - s.knee), s.end);
    return std::min(lifted, s.knee) + (1.0 - s.knee) * u * (1.0 + u / (s.end * s.end)) / (1.0 + u);
}

double light_shown_as(double shown, const CameraResponse& response) noexcept {
    double y = std::clamp(shown, 0.0, 1.0);
    if (response.curve == ResponseCurve::shoulder) {
        const double over = std::min(std::max(y - shoulder_knee, 0.0) / (1.0 - shoulder_knee), most_of_shoulder);
        return std::min(y, shoulder_knee) + (1.0 - shoulder_knee) * over / (1.0 - over);
    }
    const Shoulder s(response);
    if (y > s.knee) {
        const double share = (y - s.knee) / (1.0 - s.knee), less = share - 1.0;
        const double u = 0.5 * s.end * s.end * (less + std::sqrt(less * less + 4.0 * share / (s.end * s.end)));
        y = s.knee + (1.0 - s.knee) * u;
    }
    const double dark = y / (1.0 + response.toe);
    return 0.5 * (dark + std::sqrt(dark * dark + 4.0 * response.toe * dark));
}

std::string post_shader() {
    return gl::host_text("post.glsl");
}

std::array<glm::vec4, 4> post_values(const CameraResponse& response, glm::ivec2 size) noexcept {
    const bool film = response.curve == ResponseCurve::film;
    return {glm::vec4(glm::vec3(response.white_balance * response.exposure), static_cast<float>(response.saturation)),
            glm::vec4(film ? glm::vec3(response.toe, response.knee, Shoulder(response).end) : glm::vec3(0.0F),
                      film ? 1.0F : 0.0F),
            glm::vec4(response.lens_falloff, response.vignette, response.sharpening, 0.0), glm::vec4(size, 0.0F, 0.0F)};
}

}  // namespace lapfx
