#include "smoke/smoke_gpu.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "gl/srgb.h"
#include "lapfx/authoring/clip_roles.h"
#include "lapfx/error.h"
#include "smoke/window.h"

namespace lapfx::smoke {

namespace {

constexpr GLuint layer_binding = 2;
constexpr GLuint frames_unit = 0, chroma_unit = 4, opacity_unit = 8, noise_unit = 12, depth_unit = 13;
constexpr GLuint sum_unit = 0, sum_depth_unit = 1;  // of resolve.frag

void blend(GLenum source, GLenum destination) {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(source, destination);
}

void over_the_frame() {
    blend(GL_ONE, GL_SRC1_COLOR);  // destination * transmission + light
}

/// Index of the program in Role::programs that draws this many layers at once.
std::size_t program_index(int count) {
    return count == 4 ? 2u : count == 2 ? 1u : 0u;
}

/// What draws a layer: a quad in the scene, or the whole view.
struct LayerShaders {
    const char *vertices, *pixels;
};
constexpr LayerShaders shaders_of(ClipRole role) {
    switch (role) {
        case ClipRole::plume:
            return {"plume.vert", "plume.frag"};
        case ClipRole::haze:
            return {"fullscreen.vert", "haze.frag"};
    }
    return {};
}

}  // namespace

/// The host's framebuffer, which gets the smoke; off-screen passes use others in between.
struct SmokeGpu::HostTarget {
    HostTarget() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
        glGetFloati_v(GL_VIEWPORT, 0, &viewport.x);
        scissor = glIsEnabledi(GL_SCISSOR_TEST, 0);
    }
    void leave() const { glDisablei(GL_SCISSOR_TEST, 0); }
    void come_back() const {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
        glViewportIndexedfv(0, &viewport.x);
        if (scissor == GL_TRUE) glEnablei(GL_SCISSOR_TEST, 0);
    }
    glm::ivec2 size() const { return {std::lround(viewport.z), std::lround(viewport.w)}; }

    GLint framebuffer = 0;
    glm::vec4 viewport{0.0f};
    GLboolean scissor = GL_FALSE;
};

SmokeGpu::SmokeGpu(SmokeResolution resolution, bool timings)
    : resolution_(resolution),
      resolve_even_("resolve.vert", "resolve.frag", "#define LAPFX_EVEN\n"),
      view_depth_("fullscreen.vert", "view_depth.frag"),
      timer_(timings) {
    for (const ClipRoleRow& row : clip_roles)
        roles_[row.role].resolve =
            gl::Program("resolve.vert", "resolve.frag", row.fills_view ? "" : "#define LAPFX_PLUME\n");
}

unsigned SmokeGpu::variant_of(media::Layout layout, bool has_alpha, bool is_turned, bool windowed,
                              const KeyingParameters& k) {
    return (is_turned ? turned : 0u) | (windowed ? window : 0u) | (layout == media::Layout::planar ? planar : 0u) |
           (has_alpha ? alpha : 0u) | (k.chroma_high > 0.0 || k.spill > 0.0 ? chroma : 0u) |
           (k.choke > 0.0 || k.feather > 0.0 ? edges : 0u) | (k.noise_strength > 0.0 ? noise : 0u);
}

void SmokeGpu::compile(ClipRole which, int count, unsigned variant) {
    std::string defines = "#define LAPFX_LAYERS " + std::to_string(count) + "\n";
    constexpr std::pair<unsigned, const char*> names[] = {{planar, "PLANAR"}, {alpha, "ALPHA"}, {chroma, "CHROMA"},
                                                          {edges, "EDGES"},   {noise, "NOISE"}, {turned, "TURNED"},
                                                          {window, "WINDOW"}};
    for (const auto& [bit, name] : names)
        if ((variant & bit) != 0u) defines += std::string("#define LAPFX_") + name + "\n";
    if (resolution_ == SmokeResolution::screen) defines += "#define LAPFX_DIRECT\n";
    const LayerShaders shaders = shaders_of(which);
    roles_[which].programs[program_index(count)][variant] = gl::Program(shaders.vertices, shaders.pixels, defines);
}

void SmokeGpu::prepare(const SmokeClip& clip, media::Layout layout, bool has_alpha, const KeyingParameters& keying,
                       int count) {
    const ClipRole which = clip.role;
    const bool is_turned = row_of(which).fills_view && clip.rotation > 0.0;
    const unsigned variant = variant_of(layout, has_alpha, is_turned, has_window(clip), keying);
    for (int together = 1; together <= (draws_together(which) ? std::min(count, most_together) : 1); together *= 2)
        if (!roles_[which].programs[program_index(together)][variant]) compile(which, together, variant);
}

const gl::Program* SmokeGpu::program(ClipRole which, int count, unsigned variant) noexcept {
    std::optional<gl::Program>& found = roles_[which].programs[program_index(count)][variant];
    try {
        if (!found) compile(which, count, variant);
    } catch (const Error&) {
        return nullptr;  // prepare() has reported the reason
    }
    return &*found;
}

void SmokeGpu::collect(std::vector<gl::Program*>& programs) {
    for (Role& r : roles_) {
        programs.push_back(&r.resolve);
        for (Programs& of_count : r.programs)
            for (std::optional<gl::Program>& program : of_count)
                if (program) programs.push_back(&*program);
    }
    for (gl::Program* program : {&tiles_.program(), &resolve_even_, &view_depth_}) programs.push_back(program);
}

std::size_t SmokeGpu::memory() const noexcept {
    const auto pixels = [](const gl::Texture& texture) {
        return texture.name() == 0
                   ? 0
                   : static_cast<std::size_t>(texture.size().x) * static_cast<std::size_t>(texture.size().y);
    };
    std::size_t bytes = 0;
    for (const Role& r : roles_) bytes += pixels(r.sum) * 8 + pixels(r.sum_depth) * 4;
    return bytes;
}

void SmokeGpu::set_clip_pixels(const PerRole<int>& pixels) noexcept {
    for (const ClipRoleRow& row : clip_roles) roles_[row.role].clip_pixels = pixels[row.role];
}

void SmokeGpu::begin(const PerRole<SmokeMedium>& media, double softness) noexcept {
    for (const ClipRoleRow& row : clip_roles) {
        Role& r = roles_[row.role];
        r.medium = media[row.role];
        r.layers.clear();
        r.blocks.clear();
        r.batches.clear();
        r.bounds = row.fills_view ? glm::vec4(0.0f, 0.0f, 1.0f, 1.0f) : glm::vec4(1.0f, 1.0f, 0.0f, 0.0f);
    }
    even_ = 0.0f;
    softness_ = static_cast<float>(softness);
    tiles_.clear();
    glGetFloati_v(GL_VIEWPORT, 0, &viewport_.x);
}

void SmokeGpu::add(ClipRole which, const Layer& layer, const LayerBlock& block) noexcept {
    const media::PictureFormat& format = layer.frame.format;
    const unsigned variant = variant_of(format.layout, format.alpha, layer.angle != 0.0f,
                                        layer.clip != nullptr && has_window(*layer.clip), *layer.keying);
    const float aspect = static_cast<float>(format.size.x) / static_cast<float>(format.size.y);
    const NoiseTiles::Grid grid =
        (variant & noise) != 0u ? NoiseTiles::grid(*layer.keying, aspect, layer.time) : NoiseTiles::Grid{};
    roles_[which].layers.push_back(
        {variant, layer.frame.color, layer.frame.chroma, layer.frame.alpha, layer.seed & 0xffffu, grid});
    roles_[which].blocks.push_back(block);
}

void SmokeGpu::standing(ClipRole which, const Layer& layer, const std::array<glm::vec3, 4>& corners,
                        glm::vec4 bounds) noexcept {
    if (!(bounds.z > bounds.x && bounds.w > bounds.y)) return;  // out of sight
    Role& r = roles_[which];
    LayerBlock block = layer_block(layer, r.medium, softness_);
    for (std::size_t i = 0; i < corners.size(); ++i) block.corners[i] = glm::vec4(corners[i], 1.0f);
    add(which, layer, block);
    r.bounds = {glm::min(glm::vec2(r.bounds), glm::vec2(bounds)),
                glm::max(glm::vec2(r.bounds.z, r.bounds.w), glm::vec2(bounds.z, bounds.w))};
}

void SmokeGpu::filling(ClipRole which, const Layer& layer, double unevenness) noexcept {
    LayerBlock block = layer_block(layer, roles_[which].medium, unevenness);
    turn_block(block, layer, viewport_.z / std::max(viewport_.w, 1.0f));
    add(which, layer, block);
}

/// The shader sums up layers that fill the view, which saves reading and writing the target in between. Others are at
/// different places, and layers directly over the frame are drawn one after the other.
bool SmokeGpu::draws_together(ClipRole which) const noexcept {
    return row_of(which).fills_view && resolution_ != SmokeResolution::screen;
}

/// Draws consecutive layers of the same kind together.
void SmokeGpu::make_batches(ClipRole which) noexcept {
    Role& r = roles_[which];
    const bool together = draws_together(which);
    for (std::size_t first = 0; first < r.layers.size();) {
        const Drawn& like = r.layers[first];
        int count = 1;
        while (together && count < most_together && first + static_cast<std::size_t>(count) < r.layers.size()) {
            const Drawn& next = r.layers[first + static_cast<std::size_t>(count)];
            if (next.variant != like.variant || next.noise != like.noise) break;
            ++count;
        }
        if (count == 3) count = 2;
        std::size_t tile = 0;
        if ((like.variant & noise) != 0u) {
            glm::ivec4 seeds(0);
            for (int i = 0; i < count; ++i)
                seeds[i] = static_cast<int>(r.layers[first + static_cast<std::size_t>(i)].seed);
            tile = tiles_.add(like.noise, seeds, count);
        }
        r.batches.push_back({first, count, tile});
        first += static_cast<std::size_t>(count);
    }
}

/// All blocks of a role at once; more memory only for more layers than ever before.
void SmokeGpu::upload(Role& r) noexcept {
    for (const Batch& batch : r.batches)
        if ((r.layers[batch.first].variant & noise) != 0u) r.blocks[batch.first].tile = tiles_.place(batch.tile);
    const std::size_t bytes = r.blocks.size() * sizeof(LayerBlock);
    if (bytes == 0) return;
    if (r.buffer.size() < bytes) r.buffer = gl::Buffer(bytes);
    r.buffer.update(0, bytes, r.blocks.data());
}

void SmokeGpu::bind(const Drawn& layer, GLuint index) const noexcept {
    glBindTextureUnit(frames_unit + index, layer.frames);
    if ((layer.variant & planar) != 0u) glBindTextureUnit(chroma_unit + index, layer.chroma);
    if ((layer.variant & alpha) != 0u) glBindTextureUnit(opacity_unit + index, layer.opacity);
}

void SmokeGpu::draw_layers(ClipRole which) noexcept {
    const Role& r = roles_[which];
    for (const Batch& batch : r.batches) {
        const gl::Program* shader = program(which, batch.count, r.layers[batch.first].variant);
        if (shader == nullptr) continue;
        glBindBufferRange(GL_UNIFORM_BUFFER, layer_binding, r.buffer.name(),
                          static_cast<GLintptr>(batch.first * sizeof(LayerBlock)),
                          static_cast<GLsizeiptr>(static_cast<std::size_t>(batch.count) * sizeof(LayerBlock)));
        for (int i = 0; i < batch.count; ++i)
            bind(r.layers[batch.first + static_cast<std::size_t>(i)], static_cast<GLuint>(i));
        shader->use();
        if (row_of(which).fills_view)
            glDrawArrays(GL_TRIANGLES, 0, 3);
        else
            glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

glm::ivec2 SmokeGpu::sum_size(ClipRole which, glm::ivec2 view) const noexcept {
    const Role& r = roles_[which];
    const double pixels = std::max(1.0, static_cast<double>(view.x) * view.y);
    const double scale = std::min(1.0, std::sqrt(std::max(r.clip_pixels, 1) / pixels));
    const glm::ivec2 size(std::lround(view.x * scale), std::lround(view.y * scale));
    const bool halved =
        resolution_ == SmokeResolution::half || (resolution_ == SmokeResolution::balanced && row_of(which).fills_view);
    return glm::max(halved ? (size + 1) / 2 : size, glm::ivec2(1));
}

/// Adds up the thickness of a role's layers, off-screen.
void SmokeGpu::sum_up(ClipRole which, const HostTarget& host, GLuint scene_depth) noexcept {
    Role& r = roles_[which];
    if (r.layers.empty()) return;
    const glm::ivec2 size = sum_size(which, host.size());
    if (r.sum.size() != size) {
        r.sum = gl::Texture({.size = size, .format = GL_RGBA16F});
        r.target = gl::Framebuffer(r.sum, nullptr);
    }
    glViewportIndexedf(0, 0.0f, 0.0f, static_cast<float>(size.x), static_cast<float>(size.y));
    if (!row_of(which).fills_view) {
        if (r.sum_depth.size() != size) {
            r.sum_depth = gl::Texture({.size = size, .format = GL_R32F, .filter = GL_NEAREST});
            r.depth_target = gl::Framebuffer(r.sum_depth, nullptr);
        }
        glDisable(GL_BLEND);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, r.depth_target.name());
        glBindTextureUnit(depth_unit, scene_depth);
        view_depth_.set("u_viewport", host.viewport);
        view_depth_.use();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindTextureUnit(depth_unit, r.sum_depth.name());
    }
    constexpr float nothing[4] = {};
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, r.target.name());
    glClearBufferfv(GL_COLOR, 0, nothing);
    blend(GL_ONE, GL_ONE);
    draw_layers(which);
}

/// Draws the sums over the frame.
void SmokeGpu::resolve(const gl::Program& shader, const Role& r, glm::vec4 bounds) const noexcept {
    shader.set("u_color", gl::to_linear(glm::vec3(r.medium.color)));
    shader.set("u_extinction", glm::vec3(r.medium.extinction));
    shader.set("u_bounds", bounds);
    shader.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

/// Draws a role over the frame: its layers, or their sum.
void SmokeGpu::lay_over(ClipRole which) noexcept {
    const Role& r = roles_[which];
    if (resolution_ == SmokeResolution::screen) return draw_layers(which);
    if (r.layers.empty()) return;
    glBindTextureUnit(sum_unit, r.sum.name());
    if (!row_of(which).fills_view) {
        glBindTextureUnit(sum_depth_unit, r.sum_depth.name());
        r.resolve.set("u_softness", softness_);
    }
    resolve(r.resolve, r, r.bounds);
}

void SmokeGpu::draw(GLuint scene_depth) noexcept {
    const bool any = std::any_of(roles_.begin(), roles_.end(), [](const Role& r) { return !r.layers.empty(); });
    if (!any && even_ <= 0.0f) return;
    timer_.begin();
    const HostTarget host;
    glDisable(GL_DEPTH_TEST);  // the shaders read the scene's depth instead: soft, and it hides what lies behind
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBindVertexArray(no_attributes_.name());
    host.leave();
    for (const ClipRoleRow& row : clip_roles) make_batches(row.role);
    tiles_.draw();
    // Binding 0 to a unit would unbind the textures of all targets there, including other kinds that the host has
    // bound.
    if (tiles_.texture() != 0) glBindTextureUnit(noise_unit, tiles_.texture());
    for (Role& r : roles_) upload(r);
    if (resolution_ != SmokeResolution::screen)
        for (const ClipRoleRow& row : clip_roles) sum_up(row.role, host, scene_depth);
    host.come_back();
    over_the_frame();
    glBindTextureUnit(depth_unit, scene_depth);
    for (const ClipRoleRow& row : clip_roles) lay_over(row.role);
    if (even_ > 0.0f) {
        const Role& haze = roles_[ClipRole::haze];
        resolve_even_.set("u_even", even_);
        resolve(resolve_even_, haze, haze.bounds);
    }
    timer_.end();
}

}  // namespace lapfx::smoke
