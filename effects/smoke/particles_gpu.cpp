#include "smoke/particles_gpu.h"

#include <algorithm>

#include "gl/srgb.h"

namespace lapfx::smoke {

namespace {

constexpr GLuint block_binding = 2;

}  // namespace

ParticlesGpu::ParticlesGpu() : program_("particles.vert", "particles.frag"), block_(sizeof(SpeckBlock)) {}

void ParticlesGpu::draw(std::size_t count, glm::vec3 color, GLuint scene_depth) const noexcept {
    count = std::min(count, most_specks);
    if (count == 0) return;
    block_.update(0, count * sizeof(SpeckBlock::Speck), &specks_);
    glDisable(GL_DEPTH_TEST);  // the shader reads the scene's depth
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindTextureUnit(1, scene_depth);
    glBindVertexArray(no_attributes_.name());
    glBindBufferBase(GL_UNIFORM_BUFFER, block_binding, block_.name());
    program_.set("u_color", gl::to_linear(color));
    program_.use();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

}  // namespace lapfx::smoke
