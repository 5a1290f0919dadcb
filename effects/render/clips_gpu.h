// Clips on the GPU: one mesh, drawn once for each of them. Render thread, context current; the view block bound at 0.
#pragma once

#include <span>
#include <vector>

#include "cautery/clips.h"
#include "gl/objects.h"
#include "gl/program.h"

namespace lapfx::render {

class ClipsGpu {
  public:
    /// Sets the clips to draw. `length`: mm. Sends only what has changed, and gives the bytes sent.
    std::size_t set(std::span<const cautery::ClipPose> poses, double length);
    void draw(const gl::Program& program) const noexcept;
    std::size_t memory() const;  ///< bytes on the GPU

  private:
    void make_mesh(double length);

    gl::VertexArray vertex_array_;
    gl::Buffer positions_, normals_, indices_, instances_;
    std::vector<cautery::ClipPose> poses_;
    double length_ = 0.0;
    std::size_t room_ = 0;  // of instances_
    int index_count_ = 0;
};

}  // namespace lapfx::render
