#include "smoke/smoke_gpu.h"

#include "gl/srgb.h"

namespace lapfx::smoke {

namespace {

/// The uniform block LapfxSmoke of shaders/smoke.glsl, std140.
struct Block {
    glm::vec4 luma_chroma, key_color, vary, color, extinction, clip;
};

constexpr GLuint block_binding = 2;

/// Smoke that rises along tissue is turned away from it, into the room where the camera is.
constexpr float lean = 0.7f;

Block fill(const Layer& layer, const KeyingParameters& k) {
    const glm::ivec2 size = layer.frame->size();
    const bool mirrored = (layer.seed & 1u) != 0u;
    Block block;
    block.luma_chroma = glm::vec4(glm::dvec4(k.luma_low, k.luma_high, k.chroma_low, k.chroma_high));
    block.key_color = glm::vec4(glm::vec3(k.key_color) * 255.0f, static_cast<float>(k.spill));
    // The shader's seed is a float that must hold it exactly: 16 bits are plenty.
    block.vary = glm::vec4(glm::vec3(glm::dvec3(k.noise_scale, k.noise_strength, k.noise_drift)),
                           static_cast<float>(layer.seed & 0xffffu));
    block.color =
        glm::vec4(gl::to_linear(glm::vec3(layer.color)), layer.clip->polarity == ClipPolarity::dark ? 1.0f : 0.0f);
    block.extinction = glm::vec4(glm::vec3(layer.extinction), static_cast<float>(layer.density));
    block.clip = glm::vec4(static_cast<float>(size.x) / static_cast<float>(size.y), mirrored ? -1.0f : 1.0f,
                           static_cast<float>(layer.time), static_cast<float>(layer.soft_distance));
    return block;
}

}  // namespace

SmokeGpu::SmokeGpu()
    : plume_("plume.vert", "plume.frag"), haze_("fullscreen.vert", "haze.frag"), block_(sizeof(Block)) {}

void SmokeGpu::begin(GLuint scene_depth) const noexcept {
    glDisable(GL_DEPTH_TEST);  // the shaders read the scene's depth instead: soft, and it hides what lies behind
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_SRC1_COLOR);
    glBindTextureUnit(1, scene_depth);
    glBindVertexArray(no_attributes_.name());
    glBindBufferBase(GL_UNIFORM_BUFFER, block_binding, block_.name());
}

void SmokeGpu::bind(const Layer& layer, const KeyingParameters& keying) const noexcept {
    const Block block = fill(layer, keying);
    block_.update(0, sizeof block, &block);
    glBindTextureUnit(0, layer.frame->name());
}

void SmokeGpu::plume(const Layer& layer, const KeyingParameters& keying, glm::vec3 anchor, float height,
                     glm::vec2 up) const noexcept {
    bind(layer, keying);
    const glm::ivec2 size = layer.frame->size();
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const bool mirrored = (layer.seed & 1u) != 0u;
    const float source_x = static_cast<float>(layer.clip->source_x);
    plume_.set("u_anchor", anchor);
    plume_.set("u_extent", glm::vec2(height * aspect, height));
    plume_.set("u_source", glm::vec2(mirrored ? 1.0f - source_x : source_x, static_cast<float>(layer.clip->source_y)));
    plume_.set("u_up", up);
    plume_.set("u_lean", lean);
    plume_.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void SmokeGpu::haze(const Layer& layer, const KeyingParameters& keying, float unevenness) const noexcept {
    bind(layer, keying);
    haze_.set("u_unevenness", unevenness);
    haze_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace lapfx::smoke
