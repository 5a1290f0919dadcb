// An organ on the GPU and its shader. Render thread, context current; the view block bound at 0, bleeding's at 1.
#pragma once

#include <vector>

#include "gl/objects.h"
#include "gl/program.h"
#include "lapfx/organ.h"
#include "organ/changed_vertices.h"

namespace lapfx::render {

class OrganGpu {
  public:
    /// Uploads vertices and textures. `bleed` is attribute 5 (mm and clot, per organ vertex); null for an instrument, which neither
    /// bleeds nor chars. Throws Error (runtime) when the shader does not compile.
    OrganGpu(const Organ& organ, const gl::Buffer* bleed);

    /// Sends the runs of `values` (per vertex: char and divided, 0..1) that have changed;
    /// bytes sent.
    std::size_t send_marks(std::span<const glm::vec2> values, std::span<const VertexRun> changed) const noexcept;
    /// Moves the vertices (mm, unit normals); noise and char stay where they are on the tissue.
    void set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals);
    /// `model`: organ space to scene space, rigid.
    void draw(const glm::mat4& model) const noexcept;

  private:
    struct Material {
        GLuint base_color, normal_map;  ///< textures' names, which a move of this object leaves as they are
        glm::vec4 factor;
        float roughness, normal_scale;
        bool double_sided;
    };
    void upload_textures(const Organ& organ);
    void draw_part(const gl::Program& program, const Part& part) const noexcept;

    void draw_parts(const gl::Program& program) const noexcept;

    gl::Program plain_, wounded_;
    gl::VertexArray vertex_array_;
    std::vector<gl::Buffer> vertices_;
    gl::Buffer marks_;
    gl::Buffer rest_;  // positions at rest, once the organ has moved
    gl::Buffer indices_;
    std::vector<gl::Texture> textures_;
    gl::Texture white_, flat_;
    std::vector<Material> materials_;
    std::vector<Part> parts_;
    bool tissue_;
};

}  // namespace lapfx::render
