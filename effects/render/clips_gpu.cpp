#include "render/clips_gpu.h"

#include <algorithm>

#include "render/clip_mesh.h"

namespace lapfx::render {

namespace {

static_assert(sizeof(cautery::ClipPose) == 9 * sizeof(float), "three vectors, as the shader reads them");
constexpr GLuint first_of_instance = 2;  // attributes: position and normal, then a pose's three vectors

}  // namespace

void ClipsGpu::make_mesh(double length) {
    const ClipMesh mesh = clip_mesh(length);
    positions_ = gl::Buffer(std::span(mesh.positions));
    normals_ = gl::Buffer(std::span(mesh.normals));
    indices_ = gl::Buffer(std::span(mesh.indices));
    index_count_ = static_cast<int>(mesh.indices.size());
    vertex_array_.attribute(0, positions_, 3);
    vertex_array_.attribute(1, normals_, 3);
    vertex_array_.indices(indices_);
    length_ = length;
}

std::size_t ClipsGpu::set(std::span<const cautery::ClipPose> poses, double length) {
    if (length != length_ && !poses.empty()) make_mesh(length);
    if (std::ranges::equal(poses, poses_)) return 0;
    poses_.assign(poses.begin(), poses.end());
    if (poses_.size() > room_) {
        room_ = std::max(poses_.size(), 2 * room_);
        instances_ = gl::Buffer(room_ * sizeof(cautery::ClipPose));
        const GLuint array = vertex_array_.name();
        glVertexArrayVertexBuffer(array, first_of_instance, instances_.name(), 0, sizeof(cautery::ClipPose));
        glVertexArrayBindingDivisor(array, first_of_instance, 1);
        for (GLuint i = 0; i < 3; ++i) {
            glEnableVertexArrayAttrib(array, first_of_instance + i);
            glVertexArrayAttribFormat(array, first_of_instance + i, 3, GL_FLOAT, GL_FALSE, i * 3 * sizeof(float));
            glVertexArrayAttribBinding(array, first_of_instance + i, first_of_instance);
        }
    }
    if (poses_.empty()) return 0;
    return instances_.update(std::span<const cautery::ClipPose>(poses_), 0, poses_.size());
}

std::size_t ClipsGpu::memory() const {
    return positions_.size() + normals_.size() + indices_.size() + instances_.size();
}

void ClipsGpu::draw(const gl::Program& program) const noexcept {
    if (poses_.empty()) return;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    glBindVertexArray(vertex_array_.name());
    program.use();
    glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(poses_.size()));
}

}  // namespace lapfx::render
