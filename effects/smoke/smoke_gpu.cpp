#include "smoke/smoke_gpu.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "gl/srgb.h"
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
    role(ClipRole::plume).resolve = gl::Program("resolve.vert", "resolve.frag", "#define LAPFX_PLUME\n");
    role(ClipRole::haze).resolve = gl::Program("resolve.vert", "resolve.frag");
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
    role(which).programs[program_index(count)][variant] = which == ClipRole::plume
                                                              ? gl::Program("plume.vert", "plume.frag", defines)
                                                              : gl::Program("fullscreen.vert", "haze.frag", defines);
}

void SmokeGpu::prepare(const SmokeClip& clip, media::Layout layout, bool has_alpha, const KeyingParameters& keying,
                       int count) {
    const ClipRole which = clip.role;
    const bool is_turned = which == ClipRole::haze && clip.rotation > 0.0;
    const unsigned variant = variant_of(layout, has_alpha, is_turned, has_window(clip), keying);
    for (int together = 1; together <= (draws_together(which) ? std::min(count, most_together) : 1); together *= 2)
        if (!role(which).programs[program_index(together)][variant]) compile(which, together, variant);
}

const gl::Program* SmokeGpu::program(ClipRole which, int count, unsigned variant) noexcept {
    std::optional<gl::Program>& found = role(which).programs[program_index(count)][variant];
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
    std::size_t bytes = pixels(sum_depth_) * 4;
    for (const Role& r : roles_) bytes += pixels(r.sum) * 8;
    return bytes;
}

void SmokeGpu::set_clip_pixels(int plume, int haze) noexcept {
    role(ClipRole::plume).clip_pixels = plume;
    role(ClipRole::haze).clip_pixels = haze;
}

void SmokeGpu::begin(const Medium& plume, const Medium& haze, double softness) noexcept {
    role(ClipRole::plume).medium = plume;
    role(ClipRole::haze).medium = haze;
    for (Role& r : roles_) {
        r.layers.clear();
        r.blocks.clear();
        r.batches.clear();
    }
    role(ClipRole::plume).bounds = {1.0f, 1.0f, 0.0f, 0.0f};
    role(ClipRole::haze).bounds = {0.0f, 0.0f, 1.0f, 1.0f};
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
    role(which).layers.push_back(
        {variant, layer.frame.color, layer.frame.chroma, layer.frame.alpha, layer.seed & 0xffffu, grid});
    role(which).blocks.push_back(block);
}

void SmokeGpu::plume(const Layer& layer, const std::array<glm::vec3, 4>& corners, glm::vec4 bounds) noexcept {
    if (!(bounds.z > bounds.x && bounds.w > bounds.y)) return;  // out of sight
    Role& r = role(ClipRole::plume);
    LayerBlock block = layer_block(layer, r.medium, softness_);
    for (std::size_t i = 0; i < corners.size(); ++i) block.corners[i] = glm::vec4(corners[i], 1.0f);
    add(ClipRole::plume, layer, block);
    r.bounds = {glm::min(glm::vec2(r.bounds), glm::vec2(bounds)),
                glm::max(glm::vec2(r.bounds.z, r.bounds.w), glm::vec2(bounds.z, bounds.w))};
}

void SmokeGpu::haze(const Layer& layer, double unevenness) noexcept {
    LayerBlock block = layer_block(layer, role(ClipRole::haze).medium, unevenness);
    turn_block(block, layer, viewport_.z / std::max(viewport_.w, 1.0f));
    add(ClipRole::haze, layer, block);
}

/// The shader sums up layers of haze, which saves reading and writing the target in between. Plumes are at different
/// places, and layers directly over the frame are drawn one after the other.
bool SmokeGpu::draws_together(ClipRole which) const noexcept {
    return which == ClipRole::haze && resolution_ != SmokeResolution::screen;
}

/// Draws consecutive layers of the same kind together.
void SmokeGpu::make_batches(ClipRole which) noexcept {
    Role& r = role(which);
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
    const Role& r = role(which);
    for (const Batch& batch : r.batches) {
        const gl::Program* shader = program(which, batch.count, r.layers[batch.first].variant);
        if (shader == nullptr) continue;
        glBindBufferRange(GL_UNIFORM_BUFFER, layer_binding, r.buffer.name(),
                          static_cast<GLintptr>(batch.first * sizeof(LayerBlock)),
                          static_cast<GLsizeiptr>(static_cast<std::size_t>(batch.count) * sizeof(LayerBlock)));
        for (int i = 0; i < batch.count; ++i)
            bind(r.layers[batch.first + static_cast<std::size_t>(i)], static_cast<GLuint>(i));
        shader->use();
        if (which == ClipRole::plume)
            glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        else
            glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

glm::ivec2 SmokeGpu::sum_size(ClipRole which, glm::ivec2 view) const noexcept {
    const Role& r = roles_[static_cast<std::size_t>(which)];
    const double pixels = std::max(1.0, static_cast<double>(view.x) * view.y);
    const double scale = std::min(1.0, std::sqrt(std::max(r.clip_pixels, 1) / pixels));
    const glm::ivec2 size(std::lround(view.x * scale), std::lround(view.y * scale));
    const bool halved =
        resolution_ == SmokeResolution::half || (resolution_ == SmokeResolution::balanced && which == ClipRole::haze);
    return glm::max(halved ? (size + 1) / 2 : size, glm::ivec2(1));
}

/// Adds up the thickness of a role's layers, off-screen.
void SmokeGpu::sum_up(ClipRole which, const HostTarget& host, GLuint scene_depth) noexcept {
    Role& r = role(which);
    if (r.layers.empty()) return;
    const glm::ivec2 size = sum_size(which, host.size());
    if (r.sum.size() != size) {
        r.sum = gl::Texture({.size = size, .format = GL_RGBA16F});
        r.target = gl::Framebuffer(r.sum, nullptr);
    }
    glViewportIndexedf(0, 0.0f, 0.0f, static_cast<float>(size.x), static_cast<float>(size.y));
    if (which == ClipRole::plume) {
        if (sum_depth_.size() != size) {
            sum_depth_ = gl::Texture({.size = size, .format = GL_R32F, .filter = GL_NEAREST});
            depth_target_ = gl::Framebuffer(sum_depth_, nullptr);
        }
        glDisable(GL_BLEND);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, depth_target_.name());
        glBindTextureUnit(depth_unit, scene_depth);
        view_depth_.set("u_viewport", host.viewport);
        view_depth_.use();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindTextureUnit(depth_unit, sum_depth_.name());
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

void SmokeGpu::draw(GLuint scene_depth) noexcept {
    Role &plume = role(ClipRole::plume), &haze = role(ClipRole::haze);
    if (plume.layers.empty() && haze.layers.empty() && even_ <= 0.0f) return;
    timer_.begin();
    const HostTarget host;
    const bool direct = resolution_ == SmokeResolution::screen;
    glDisable(GL_DEPTH_TEST);  // the shaders read the scene's depth instead: soft, and it hides what lies behind
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBindVertexArray(no_attributes_.name());
    host.leave();
    make_batches(ClipRole::plume);
    make_batches(ClipRole::haze);
    tiles_.draw();
    // Binding 0 to a unit would unbind the textures of all targets there, including other kinds that the host has
    // bound.
    if (tiles_.texture() != 0) glBindTextureUnit(noise_unit, tiles_.texture());
    upload(plume);
    upload(haze);
    if (!direct) {
        sum_up(ClipRole::plume, host, scene_depth);
        sum_up(ClipRole::haze, host, scene_depth);
    }
    host.come_back();
    over_the_frame();
    glBindTextureUnit(depth_unit, scene_depth);
    if (direct) {
        draw_layers(ClipRole::plume);
    } else if (!plume.layers.empty()) {
        glBindTextureUnit(sum_unit, plume.sum.name());
        glBindTextureUnit(sum_depth_unit, sum_depth_.name());
        plume.resolve.set("u_softness", softness_);
        resolve(plume.resolve, plume, plume.bounds);
    }
    // Haze lies between the camera and everything, so it comes last.
    if (direct) {
        draw_layers(ClipRole::haze);
    } else if (!haze.layers.empty()) {
        glBindTextureUnit(sum_unit, haze.sum.name());
        resolve(haze.resolve, haze, haze.bounds);
    }
    if (even_ > 0.0f) {
        resolve_even_.set("u_even", even_);
        resolve(resolve_even_, haze, haze.bounds);
    }
    timer_.end();
}

}  // namespace lapfx::smoke
