#include "render/view_block.h"

#include <array>
#include <cmath>

#include "gl/srgb.h"

namespace lapfx::render {

namespace {

/// std140.
struct Block {
    glm::mat4 view, projection;
    glm::vec4 eye, axis, light, beam, plate_light, plate_film;
};

}  // namespace

ViewBlock::ViewBlock() : buffer_(sizeof(Block)) {}

void ViewBlock::bind(const View& view, bool over_plate) const noexcept {
    const glm::mat4 to_organ = glm::inverse(view.view);
    const glm::vec3 light = gl::to_linear(glm::vec3(view.lamp.color)) * static_cast<float>(view.lamp.intensity);
    const double half_angle = glm::radians(view.lamp.beam_angle) / 2.0;
    const bool film = view.response.curve == ResponseCurve::film;
    const std::array<glm::vec4, 4> camera = post_values(view.response, glm::ivec2(1));
    const Block block{
        .view = view.view,
        .projection = view.projection,
        .eye = to_organ[3],
        .axis = -to_organ[2],
        .light = glm::vec4(light, static_cast<float>(view.lamp.focus_distance)),
        .beam = glm::vec4(static_cast<float>(std::cos(half_angle)), static_cast<float>(view.lamp.ambient),
                          over_plate && !film ? static_cast<float>(view.response.exposure) : 0.0f, 0.0f),
        .plate_light = camera[0],
        .plate_film = over_plate && film ? camera[1] : glm::vec4(0.0f),
    };
    buffer_.update(0, sizeof block, &block);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer_.name());
}

}  // namespace lapfx::render
