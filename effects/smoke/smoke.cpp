#include "smoke/smoke.h"

#include <cassert>
#include <cmath>

#include "gl/noise.h"

namespace lapfx::smoke {

namespace {

/// Decoded frames held in main memory over all streams (paper, table 1: MAX_TEXTURES).
constexpr int max_textures = 64;
constexpr int most_buffers = 8;  // more than a few frames ahead buys nothing and costs memory

/// A repeatable number for the n-th thing that wants chance.
std::uint32_t chance(std::uint32_t seed, std::size_t n) {
    return gl::noise_hash({static_cast<int>(n), 17, 4}, seed);
}

/// Where smoke rises to on screen, unit.
glm::vec2 screen_up(const glm::mat4& view, glm::dvec3 up) {
    const glm::vec2 on_screen(glm::mat3(view) * glm::vec3(up));
    const float length = glm::length(on_screen);
    return length > 1e-3f ? on_screen / length : glm::vec2(0.0f, 1.0f);
}

}  // namespace

Smoke::Smoke(std::uint32_t seed) : seed_(seed), no_frame_({.format = GL_RGB8}) {
    const std::uint8_t black[3] = {};
    no_frame_.upload(GL_BGR, black);
}

void Smoke::set_preset(const Preset& preset, std::span<const std::filesystem::path> search_path) {
    const auto& wanted = preset.smoke.clips;
    const int buffers = std::clamp(max_textures / std::max(1, static_cast<int>(wanted.size())), 2, most_buffers);
    std::vector<Clip> clips;
    for (const SmokeClip& clip : wanted) {
        const auto path = find_clip(clip.file, preset.folder, search_path);
        // A clip that is named twice plays at two places of its own: one stream goes to one entry.
        const auto same = std::find_if(clips_.begin(), clips_.end(), [&](const Clip& known) {
            return known.path == path && std::none_of(clips.begin(), clips.end(), [&](const Clip& used) {
                       return used.textures == known.textures;
                   });
        });
        clips.push_back({path, same != clips_.end() ? same->textures : std::make_shared<ClipTextures>(path, buffers)});
    }
    clips_ = std::move(clips);
    parameters_ = preset.smoke;
    set_haze();
}

void Smoke::set_contacts(std::span<const ToolContact> contacts, std::span<const double> fat) {
    assert(fat.size() == contacts.size());
    contacts_.assign(contacts.begin(), contacts.end());
    fat_.assign(fat.begin(), fat.end());
    set_haze();
}

void Smoke::set_haze() {
    emissions_.clear();
    suctions_.clear();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ToolContact& contact = contacts_[i];
        if (contact.hot())
            emissions_.push_back({contact.time, contact.end(), emission(contact, fat_[i], parameters_.plume)});
        else if (contact.action == ToolAction::suction)
            suctions_.push_back({contact.time, contact.end()});
    }
    haze_.set(emissions_, suctions_, parameters_.haze);
}

const gl::Texture& Smoke::frame_at(std::size_t clip, double time, Policy policy) noexcept {
    ClipTextures& textures = *clips_[clip].textures;
    const int count = textures.info().frame_count;
    const double start = chance(seed_, clip) % static_cast<std::uint32_t>(count);
    const double played = std::floor(start + time * textures.info().fps * parameters_.clips[clip].speed);
    const double looped = std::fmod(std::fmod(played, count) + count, count);
    return textures.frame(std::clamp(static_cast<int>(looped), 0, count - 1), policy);
}

void Smoke::draw(const glm::mat4& view, glm::dvec3 up, double time, GLuint scene_depth, Policy policy) noexcept {
    gpu_.begin(scene_depth);
    double haze_weight = 0.0;
    for (const SmokeClip& clip : parameters_.clips)
        if (clip.role == ClipRole::haze) haze_weight += clip.weight;
    for (std::size_t i = 0; i < clips_.size(); ++i)
        if (parameters_.clips[i].role == ClipRole::plume) draw_plume(i, view, up, time, policy);
    draw_particles(up, time, scene_depth);
    // Haze lies between the camera and everything, so it comes last; several clips share its density. Without one it is even.
    if (haze_weight <= 0.0) draw_even_haze(time);
    for (std::size_t i = 0; i < clips_.size(); ++i)
        if (parameters_.clips[i].role == ClipRole::haze && haze_weight > 0.0)
            draw_haze(i, time, parameters_.clips[i].weight / haze_weight, policy);
}

void Smoke::draw_plume(std::size_t clip, const glm::mat4& view, glm::dvec3 up, double time, Policy policy) noexcept {
    const SmokeClip& settings = parameters_.clips[clip];
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const PlumeState state = plume_state(contacts_[i], parameters_.plume, up, time, fat_[i]);
        if (state.density * settings.weight <= 0.0) continue;
        const Layer layer{.frame = &frame_at(clip, time, policy),
                          .clip = &settings,
                          .color = parameters_.plume.color,
                          .extinction = parameters_.plume.extinction,
                          .density = state.density * settings.weight,
                          .time = time,
                          .seed = chance(seed_ + 1, clip * 4099 + i)};
        gpu_.plume(layer, parameters_.keying, glm::vec3(state.anchor), static_cast<float>(state.height),
                   screen_up(view, up));
    }
}

void Smoke::draw_particles(glm::dvec3 up, double time, GLuint scene_depth) noexcept {
    static_assert(most_particles <= most_specks);
    const ParticleParameters& parameters = parameters_.particles;
    const std::size_t count = particles_at(contacts_, fat_, parameters, up, chance(seed_ + 3, 0), time, particles_);
    if (count == 0) return;
    for (std::size_t i = 0; i < count; ++i) {
        const Particle& p = particles_[i];
        const float shape = static_cast<float>(p.shape & 0xffffu) / 65536.0f;
        particles_gpu_.specks().specks[i] = {glm::vec4(p.position, p.diameter), {p.opacity, p.glow, shape, 0.0f}};
    }
    particles_gpu_.draw(count, glm::vec3(parameters.color), scene_depth);
    gpu_.begin(scene_depth);  // haze follows, and blends in its own way
}

void Smoke::draw_even_haze(double time) noexcept {
    static const SmokeClip no_clip;
    const double density = haze(time);
    if (density <= 0.0) return;
    const Layer layer{.frame = &no_frame_,
                      .clip = &no_clip,
                      .color = parameters_.haze.color,
                      .extinction = parameters_.haze.extinction,
                      .density = density,
                      .time = time};
    gpu_.haze(layer, parameters_.keying, 0.0f);
}

void Smoke::draw_haze(std::size_t clip, double time, double share, Policy policy) noexcept {
    const double density = haze(time) * share;
    if (density <= 0.0) return;
    const Layer layer{.frame = &frame_at(clip, time, policy),
                      .clip = &parameters_.clips[clip],
                      .color = parameters_.haze.color,
                      .extinction = parameters_.haze.extinction,
                      .density = density,
                      .time = time,
                      .seed = chance(seed_ + 2, clip)};
    gpu_.haze(layer, parameters_.keying, static_cast<float>(parameters_.haze.unevenness));
}

}  // namespace lapfx::smoke
