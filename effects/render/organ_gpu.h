// An organ on the GPU and its shader. Render thread, context current; the view block bound at 0, bleeding's at 1.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "bleeding/bleeding_gpu.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "lapfx/organ.h"
#include "lapfx/view.h"
#include "organ/changed_vertices.h"
#include "organ/pixels.h"
#include "organ/refine.h"
#include "render/organ_textures.h"
#include "render/touched_triangles.h"

namespace lapfx::render {

/// Density of vessels and fat over a base-colour image, as a texture; empty: the image says nothing.
struct DensityPicture {
    glm::ivec2 size{0};
    std::span<const glm::u8vec2> values;  ///< rows from the top
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
};

/// What organs are drawn with; any number of organs may share them.
struct OrganPrograms {
    /// `tissue`: false for an instrument, which has neither blood nor metal clips. Throws Error (runtime) when a shader
    /// does not compile.
    explicit OrganPrograms(bool tissue);
    /// Compiles what shows tissue with the blood of this model, unless that has been done. Throws as above.
    void prepare(bleeding::Model model);
    void collect(std::vector<gl::Program*>& programs);  ///< for gl::rebuild()
    const gl::Program& wounded(bleeding::Model model) const { return wounded_[static_cast<std::size_t>(model)]; }
    gl::Program plain, clips;

  private:
    std::array<gl::Program, bleeding::model_count> wounded_;
};

class OrganGpu {
  public:
    /// Uploads vertices and textures. `blood` is kept as in set_blood(); null for an instrument, which neither bleeds
    /// nor chars. `pixels`: those of images that have none themselves. `unsplit`: the organ before
    /// splitting. Throws Error (runtime) when the shader does not compile.
    OrganGpu(const Organ& organ, const bleeding::BleedingGpu* blood, const organ::PixelList& pixels = {},
             const organ::Unsplit& unsplit = {});
    /// The same with programs and textures that exist.
    OrganGpu(const Organ& organ, const bleeding::BleedingGpu* blood, std::shared_ptr<OrganPrograms> programs,
             OrganTextures textures, const organ::Unsplit& unsplit);

    /// The blood that is drawn: its buffers have to live as long as this object, or until this is called again. Throws
    /// Error (runtime) when the model's shader does not compile, and then draws what it drew.
    void set_blood(const bleeding::BleedingGpu& blood);
    /// Sends the runs of `values` (per vertex: char and divided, 0..1) that have changed;
    /// bytes sent.
    std::size_t send_marks(std::span<const glm::vec2> values, std::span<const VertexRun> changed) const noexcept;
    /// Moves the vertices (mm, unit normals); noise and char stay where they are on the tissue. `midway`: the vertices
    /// made by splitting are still midway between their two.
    void set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, bool midway);
    /// Sends the densities for the overlays of vessels and fat: a picture per image of the organ, times a value per
    /// vertex.
    void send_density(std::span<const DensityPicture> images, std::span<const glm::vec2> vertices);
    void set_overlay(Overlay overlay) { overlay_ = overlay; }
    /// The organ is a plate: its base colour is thrown onto it by this matrix (organ/plate.h) and not lit.
    void set_projector(const glm::mat4& projector) { projector_ = projector; }
    /// Multiplies the colours of all materials; linear.
    void set_color(glm::vec3 color) { color_ = color; }
    std::size_t geometry_memory() const;                           ///< bytes on the GPU
    std::size_t texture_memory() const;                            ///< bytes on the GPU
    bool free_texture() noexcept { return textures_.free_one(); }  ///< Body's says what it does
    OrganPrograms& programs() const { return *programs_; }
    /// `model`: organ space to scene space, rigid. `touched`: all triangles with blood or marks; null: any may have
    /// some.
    void draw(const glm::mat4& model, const TouchedTriangles* touched = nullptr) const noexcept;

  private:
    struct Material {
        int image;                               ///< index of the base-colour texture, or -1
        GLuint base_color, normal_map, density;  ///< names of textures, which do not change when this object moves
        glm::vec4 factor;
        float roughness, normal_scale;
        bool double_sided;
    };
    void take_materials(const Organ& organ);
    void use(const gl::Program& program, const glm::mat4& model) const noexcept;
    void use(const gl::Program& program, const Part& part) const noexcept;
    void draw_wounded(const glm::mat4& model, const TouchedTriangles* touched) const noexcept;
    void draw_plain(const glm::mat4& model) const noexcept;

    std::shared_ptr<OrganPrograms> programs_;
    gl::VertexArray vertex_array_;
    std::vector<gl::Buffer> vertices_;
    gl::Buffer marks_;
    gl::Buffer rest_;  // positions at rest, once the organ has moved
    gl::Buffer indices_, unsplit_indices_;
    OrganTextures textures_;
    std::vector<gl::Texture> densities_;  // per image, made when an overlay first needs them
    gl::Buffer vertex_density_;
    Overlay overlay_ = Overlay::none;
    glm::vec3 color_{1.0f};
    std::optional<glm::mat4> projector_;
    gl::Texture white_, flat_;
    std::vector<Material> materials_;
    std::vector<Part> parts_, unsplit_parts_;
    bleeding::Model model_{};
    std::vector<GLuint> blood_attributes_;  // that the model has set
    bool tissue_;
    bool midway_ = true;
};

}  // namespace lapfx::render
