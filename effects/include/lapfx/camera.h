// How a camera makes a picture of light, as the processor of an endoscope does: exposure, white balance, sharpening,
// saturation, the lens' fall-off, the film curve, the round mask, in this order, then sRGB. Plain data, any thread.
//
//     const lapfx::CameraResponse response{.exposure = 1.9, .curve = lapfx::ResponseCurve::film};
//     frame.finish(0, response);                                     // lapfx/frame.h
//
// A host that finishes its frames itself gets the same as text:
//
//     const std::string text = "#version 450 core\n" + lapfx::post_shader() + my_fragment_shader;
//     ...                                                            // o_color.rgb = lapfx_post(my_frame, v_uv)
//     const auto values = lapfx::post_values(response, {1280, 1024});
//     glUniform4fv(glGetUniformLocation(program, "lapfx_camera"), values.size(), &values[0].x);
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "lapfx/api.h"

namespace lapfx {

/// How light becomes the picture's.
enum class ResponseCurve {
    shoulder,  ///< as it is up to 0.7, then ever slower towards white, which no light reaches; the lens comes after it
    film       ///< as film: a toe for the darks, a shoulder for the lights, white from a certain light on
};
inline constexpr std::string_view response_curves[] = {"shoulder", "film"};

struct CameraResponse {
    double exposure = 1.0;          ///< a factor on light
    double vignette = 1.0;          ///< 0 = whole rectangle, 1 = the round picture of an endoscope
    glm::dvec3 white_balance{1.0};  ///< factors on red, green and blue
    double sharpening = 0.0;        ///< 0..2: of details of 1/340 of the height, as a factor on their contrast
    double saturation = 1.0;        ///< 0 = grey; Rec. 709 luma stays
    double lens_falloff = 0.45;     ///< 0..1: share of the light that is missing at the rim of the round view
    ResponseCurve curve = ResponseCurve::shoulder;
    double toe = 0.2;    ///< 0..1, of ResponseCurve::film: how far darks are darkened; 0: not
    double knee = 0.6;   ///< 0..1, of film: from which light on lights are compressed
    double white = 3.0;  ///< more than 1, of film: the least light that is shown as white

    friend bool operator==(const CameraResponse&, const CameraResponse&) = default;
};

/// One channel: what light after exposure, balance, saturation and lens is shown as, linear, 0..1.
LAPFX_API double shown_light(double light, const CameraResponse& response) noexcept;
/// The light that is shown as `shown`, 0..1; for ResponseCurve::shoulder, which has no white, at most 15.4.
LAPFX_API double light_shown_as(double shown, const CameraResponse& response) noexcept;

/// GLSL text for a shader of version 420 or later, without #version: `vec3 lapfx_post(sampler2D frame, vec2 uv)` gives
/// the picture at `uv`, sRGB-encoded, of a frame of linear light without mipmaps; it reads the uniform array
/// `vec4 lapfx_camera[4]`. Throws Error (runtime) when a shader folder that the editor set lacks a file. Any thread.
LAPFX_API std::string post_shader();
/// What `lapfx_camera` is set to. `size`: the frame's, pixels.
LAPFX_API std::array<glm::vec4, 4> post_values(const CameraResponse& response, glm::ivec2 size) noexcept;

}  // namespace lapfx
