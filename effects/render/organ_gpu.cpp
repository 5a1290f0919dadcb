#include "render/organ_gpu.h"

#include <array>

namespace lapfx::render {

namespace {

gl::Texture one_texel(std::array<std::uint8_t, 4> value) {
    gl::Texture texture({.wrap_u = GL_REPEAT, .wrap_v = GL_REPEAT});
    texture.upload(GL_RGBA, value.data());
    return texture;
}

template <typename T>
gl::Buffer buffer_of(const std::vector<T>& data) {
    return gl::Buffer(std::span<const T>(data));
}

/// Draws the bound indices from `begin` to `end`.
void draw_triangles(std::size_t begin, std::size_t end) noexcept {
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * (end - begin)), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(3 * begin * sizeof(std::uint32_t)));
}

}  // namespace

OrganPrograms::OrganPrograms(bool tissue)
    : plain("organ.vert", "organ.frag"), clips(tissue ? gl::Program("clip.vert", "clip.frag") : gl::Program()) {}

void OrganPrograms::collect(std::vector<gl::Program*>& programs) {
    programs.insert(programs.end(), {&plain, &clips});
    for (gl::Program& program : wounded_) programs.push_back(&program);
}

void OrganPrograms::prepare(bleeding::Model model) {
    gl::Program& program = wounded_[static_cast<std::size_t>(model)];
    const bleeding::ModelShaders& shaders = bleeding::shaders_of(model);
    if (program.name() == 0) program = gl::Program(shaders.vertex, shaders.fragment);
}

OrganGpu::OrganGpu(const Organ& organ, const bleeding::BleedingGpu* blood, const organ::PixelList& pixels,
                   const organ::Unsplit& unsplit)
    : OrganGpu(organ, blood, std::make_shared<OrganPrograms>(blood != nullptr), OrganTextures(organ, pixels), unsplit) {
}

OrganGpu::OrganGpu(const Organ& organ, const bleeding::BleedingGpu* blood, std::shared_ptr<OrganPrograms> programs,
                   OrganTextures textures, const organ::Unsplit& unsplit)
    : programs_(std::move(programs)),
      marks_(buffer_of(std::vector<glm::vec2>(organ.positions.size(), glm::vec2(0.0f)))),
      indices_(buffer_of(organ.indices)),
      unsplit_indices_(buffer_of(unsplit.indices)),
      textures_(std::move(textures)),
      white_(one_texel({255, 255, 255, 255})),
      flat_(one_texel({128, 128, 255, 255})),
      parts_(organ.parts),
      unsplit_parts_(unsplit.parts),
      tissue_(blood != nullptr) {
    vertices_.push_back(buffer_of(organ.positions));
    vertices_.push_back(buffer_of(organ.normals));
    vertices_.push_back(buffer_of(organ.tangents));
    vertices_.push_back(buffer_of(organ.uvs));
    vertices_.push_back(buffer_of(organ.colors));
    constexpr int components[] = {3, 3, 4, 2, 4};
    for (GLuint i = 0; i < vertices_.size(); ++i) vertex_array_.attribute(i, vertices_[i], components[i]);
    vertex_array_.attribute(5, marks_, 2);  // marks and blood of an instrument stay 0
    vertex_array_.attribute(6, marks_, 2);
    vertex_array_.attribute(7, vertices_[0], 3);
    vertex_array_.attribute(8, marks_, 2);  // marks stand in until densities exist
    if (blood != nullptr) set_blood(*blood);
    take_materials(organ);
}

void OrganGpu::set_blood(const bleeding::BleedingGpu& blood) {
    programs_->prepare(blood.model());
    model_ = blood.model();
    for (const GLuint index : blood_attributes_) vertex_array_.attribute(index, marks_, 2);  // their buffers may go
    blood_attributes_.clear();
    for (const bleeding::Attribute& attribute : blood.attributes()) {
        vertex_array_.attribute(attribute.index, *attribute.buffer, attribute.components);
        blood_attributes_.push_back(attribute.index);
    }
}

void OrganGpu::take_materials(const Organ& organ) {
    const auto texture = [&](int image, bool color, const gl::Texture& none) {
        const GLuint name = textures_.find(image, color);
        return name != 0 ? name : none.name();
    };
    for (const lapfx::Material& m : organ.materials)
        materials_.push_back({.image = m.base_color_image,
                              .base_color = texture(m.base_color_image, true, white_),
                              .normal_map = texture(m.normal_image, false, flat_),
                              .density = white_.name(),
                              .factor = m.base_color,
                              .roughness = m.roughness,
                              .normal_scale = m.normal_scale,
                              .double_sided = m.double_sided});
}

std::size_t OrganGpu::geometry_memory() const {
    std::size_t bytes =
        marks_.size() + rest_.size() + indices_.size() + unsplit_indices_.size() + vertex_density_.size();
    for (const gl::Buffer& buffer : vertices_) bytes += buffer.size();
    return bytes;
}

std::size_t OrganGpu::texture_memory() const {
    std::size_t bytes = textures_.memory();
    const auto pixels = [](const gl::Texture& texture) {
        return static_cast<std::size_t>(texture.size().x) * static_cast<std::size_t>(texture.size().y) * 4 / 3;
    };  // including mip levels
    for (const gl::Texture& texture : densities_) bytes += pixels(texture) * 2;
    return bytes;
}

std::size_t OrganGpu::send_marks(std::span<const glm::vec2> values, std::span<const VertexRun> changed) const noexcept {
    std::size_t bytes = 0;
    for (const VertexRun& run : changed) bytes += marks_.update(values, run.begin, run.end);
    return bytes;
}

void OrganGpu::set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, bool midway) {
    midway_ = midway;
    if (rest_.size() == 0) {
        rest_ = gl::Buffer(vertices_[0].size());
        glCopyNamedBufferSubData(vertices_[0].name(), rest_.name(), 0, 0, static_cast<GLsizeiptr>(rest_.size()));
        vertex_array_.attribute(7, rest_, 3);
    }
    vertices_[0].update(positions, 0, positions.size());
    vertices_[1].update(normals, 0, normals.size());
}

void OrganGpu::send_density(std::span<const DensityPicture> images, std::span<const glm::vec2> vertices) {
    if (vertex_density_.name() == 0) {
        vertex_density_ = gl::Buffer(vertices);
        vertex_array_.attribute(8, vertex_density_, 2);
    } else {
        vertex_density_.update(vertices, 0, vertices.size());
    }
    densities_.resize(images.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        const DensityPicture& picture = images[i];
        if (picture.values.empty()) continue;
        if (densities_[i].name() == 0)
            densities_[i] = gl::Texture({.size = picture.size,
                                         .format = GL_RG8,
                                         .levels = gl::level_count(picture.size),
                                         .wrap_u = wrap_mode(picture.wrap_u),
                                         .wrap_v = wrap_mode(picture.wrap_v)});
        densities_[i].upload(GL_RG, picture.values.data());
        densities_[i].generate_mipmaps();
    }
    for (Material& material : materials_)
        if (material.image >= 0 && densities_[static_cast<std::size_t>(material.image)].name() != 0)
            material.density = densities_[static_cast<std::size_t>(material.image)].name();
}

void OrganGpu::draw(const glm::mat4& model, const TouchedTriangles* touched) const noexcept {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glBindVertexArray(vertex_array_.name());
    // Noise is most of the cost of a pixel, and most of an organ has neither blood nor char. So the wounded program
    // draws the triangles with blood or char, and the plain program draws all: a pixel that is already drawn has the
    // same depth, or one in front (draw_plain), and is not shaded again.
    if (tissue_) draw_wounded(model, touched);
    draw_plain(model);
}

void OrganGpu::draw_wounded(const glm::mat4& model, const TouchedTriangles* touched) const noexcept {
    vertex_array_.indices(indices_);
    const gl::Program& wounded = programs_->wounded(model_);
    use(wounded, model);
    for (const Part& part : parts_) {
        const std::size_t begin = part.first_index / 3, end = begin + part.index_count / 3;
        use(wounded, part);
        if (touched == nullptr)
            draw_triangles(begin, end);
        else
            touched->for_each(begin, end, draw_triangles);
    }
}

/// Splitting changes neither the shape nor values that are linear in a triangle, so untouched tissue is drawn with its
/// original, fewer triangles. Rounding changes their depth, so they are moved back by more than that behind the wounded
/// ones. Drawing all of them leaves no crack where they meet. Overlays need the values at every vertex.
void OrganGpu::draw_plain(const glm::mat4& model) const noexcept {
    const bool unsplit = !unsplit_parts_.empty() && midway_ && overlay_ == Overlay::none;
    if (unsplit) {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0.01f, 4.0f);  // a hundredth of a pixel, and of the depth's last places
    }
    vertex_array_.indices(unsplit ? unsplit_indices_ : indices_);
    use(programs_->plain, model);
    for (const Part& part : unsplit ? unsplit_parts_ : parts_) {
        use(programs_->plain, part);
        draw_triangles(part.first_index / 3, (part.first_index + part.index_count) / 3);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void OrganGpu::use(const gl::Program& program, const glm::mat4& model) const noexcept {
    program.set("u_model", model);
    program.set("u_tissue", tissue_ ? 1 : 0);
    program.set("u_overlay", static_cast<int>(overlay_));
    program.set("u_plate", projector_ ? 1 : 0);
    program.set("u_projector", projector_.value_or(glm::mat4(1.0f)));
    program.use();
}

void OrganGpu::use(const gl::Program& program, const Part& part) const noexcept {
    const Material& material = materials_[static_cast<std::size_t>(part.material)];
    // Scans and simulator meshes are often wound inconsistently, and open ones show their back, so tissue is never
    // culled.
    const bool cull = !tissue_ && !material.double_sided;
    cull ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
    glBindTextureUnit(0, material.base_color);
    glBindTextureUnit(1, material.normal_map);
    glBindTextureUnit(2, material.density);
    program.set("u_base_factor", material.factor * glm::vec4(color_, 1.0f));
    program.set("u_roughness", material.roughness);
    program.set("u_normal_scale", material.normal_scale);
}

}  // namespace lapfx::render
