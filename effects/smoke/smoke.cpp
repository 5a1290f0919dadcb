#include "smoke/smoke.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lapfx/authoring/clip_roles.h"
#include "lapfx/preset.h"
#include "media/playhead.h"
#include "media/schemes.h"
#include "smoke/clip_share.h"
#include "smoke/noise.h"

namespace lapfx::smoke {

namespace {

/// Thicker haze lets nothing through, and the sums in the shaders must stay within half floats.
constexpr double thickest = 500.0;

/// A repeatable random number for thing number n.
std::uint32_t chance(std::uint32_t seed, std::size_t n) {
    return noise_hash({static_cast<int>(n), 17, 4}, seed);
}

/// Where smoke rises to on screen, unit.
glm::vec2 screen_up(const glm::mat4& view, glm::dvec3 up) {
    const glm::vec2 on_screen(glm::mat3(view) * glm::vec3(up));
    const float length = glm::length(on_screen);
    return length > 1e-3f ? on_screen / length : glm::vec2(0.0f, 1.0f);
}

const KeyingParameters& keying_for(const SmokeClip& clip, const SmokeParameters& parameters) {
    return clip.own_keying ? clip.keying : parameters.keying;
}

/// Under Policy::latest a clip has no frame at first.
bool there(const media::ClipFrame& frame) {
    return frame.color != 0;
}

/// A clip that fades from one of its frames to another is two layers, because thickness adds up. If only one of them
/// exists, it gets the full weight.
template <typename Add>
void add_shown(auto shown, Layer layer, double density, const Add& add) {
    if (shown.fading && !there(*shown.fading)) shown.fading.reset(), shown.fade = 0.0;
    if (!there(shown.frame) && shown.fading) shown.frame = *shown.fading, shown.fading.reset(), shown.fade = 0.0;
    if (!there(shown.frame)) return;
    layer.frame = shown.frame;
    layer.density = density * (1.0 - shown.fade);
    add(layer);
    if (!shown.fading) return;
    layer.frame = *shown.fading;
    layer.density = density * shown.fade;
    add(layer);
}

}  // namespace

Smoke::Smoke(std::uint32_t seed, const StreamingOptions& options, std::shared_ptr<ClipCache> cache)
    : seed_(seed),
      options_(options),
      clips_(options, std::move(cache)),
      gpu_(options.resolution, options.gpu_timings) {}

void Smoke::set_preset(const Preset& preset, std::span<const std::filesystem::path> search_path) {
    wanted_ = preset.smoke;
    prepare(wanted_, [&](std::size_t i) { return clips_.known_alpha(wanted_.clips[i], preset.folder, search_path); });
    clips_.set(wanted_.clips, preset.folder, search_path);
    take_wanted();
    updated_ = true;  // new clips are asked again until they come
}

void Smoke::set_parameters(const SmokeParameters& parameters) {
    wanted_ = parameters;
    wanted_.clips = parameters_.clips;  // those that play go on
    used_.assign(parameters.clips.size(), false);
    for (SmokeClip& clip : wanted_.clips) {
        for (std::size_t i = 0; i < parameters.clips.size(); ++i) {
            if (used_[i] || parameters.clips[i].file != clip.file) continue;
            const double in = clip.in, out = clip.out, crossfade = clip.crossfade;
            clip = parameters.clips[i];
            clip.in = in, clip.out = out, clip.crossfade = crossfade;  // of the loop that plays
            used_[i] = true;
            break;
        }
    }
    prepare(wanted_, [&](std::size_t i) { return clips_.info(i).alpha; });
    take_wanted();
}

/// Nothing here throws Error.
void Smoke::take_wanted() {
    std::swap(parameters_, wanted_);
    PerRole<int> pixels;
    for (std::size_t i = 0; i < parameters_.clips.size(); ++i) {
        const glm::ivec2 size = clips_.info(i).size;
        int& most = pixels[parameters_.clips[i].role];
        most = std::max(most, size.x * size.y);
    }
    gpu_.set_clip_pixels(pixels);
}

/// `alpha`: whether a clip has its own opacity, which needs other programs; both are made while that is unknown.
void Smoke::prepare(const SmokeParameters& wanted, const std::function<std::optional<bool>(std::size_t)>& alpha) {
    PerRole<int> clips;
    for (const SmokeClip& clip : wanted.clips) ++clips[clip.role];
    for (std::size_t i = 0; i < wanted.clips.size(); ++i) {
        const SmokeClip& clip = wanted.clips[i];
        const std::optional<bool> known = alpha(i);
        for (const bool has_alpha : {false, true})
            if (known.value_or(has_alpha) == has_alpha)
                gpu_.prepare(clip, media::row_of(options_.scheme).layout, has_alpha, keying_for(clip, wanted),
                             2 * clips[clip.role]);  // twice: cross-fades
    }
}

/// Two eyes see one frame, also of a clip that is late, and what it costs is paid once.
media::ClipFrame Smoke::clip_frame(std::size_t clip, int head, int index, media::Policy policy) noexcept {
    if (!updated_ && clips_.asked(clip, head) == index) return clips_.shown(clip, head);
    return clips_.frame(clip, head, index, policy);
}

Smoke::ClipInFrame Smoke::show(std::size_t clip, double time, media::Policy policy) noexcept {
    const media::Playhead head = playhead(clips_.info(clip), parameters_.clips[clip], chance(seed_, clip), time);
    ClipInFrame shown{.frame = clip_frame(clip, 0, head.frame, policy), .fading = std::nullopt, .fade = head.fade};
    if (head.fading >= 0) shown.fading = clip_frame(clip, 1, head.fading, policy);
    return shown;
}

void Smoke::draw(const View& view, const SmokeScene& scene, GLuint scene_depth, media::Policy policy) noexcept {
    PerRole<SmokeMedium> media;
    for (const ClipRoleRow& row : clip_roles) media[row.role] = row.medium(parameters_);
    gpu_.begin(media, parameters_.plume.softness);
    add_layers(view, scene, policy);
    draw_particles(scene, scene_depth);  // smoke lies over them
    gpu_.draw(scene_depth);
    if (std::exchange(updated_, false)) clips_.end_cycle();
}

/// Without a clip, or while a clip has no frame, the haze is even.
void Smoke::add_layers(const View& view, const SmokeScene& scene, media::Policy policy) noexcept {
    const double density = std::min(scene.haze, thickest);
    double even = 0.0;
    bool clips_show_haze = false;
    for (std::size_t i = 0; i < parameters_.clips.size(); ++i) {
        const double share = clip_share(parameters_.clips, parameters_.clips[i]);
        switch (parameters_.clips[i].role) {
            case ClipRole::plume:
                add_plumes(i, share, view, scene, policy);
                break;
            case ClipRole::haze:
                clips_show_haze = clips_show_haze || share > 0.0;
                if (!add_haze(i, scene.time, density * share, policy)) even += density * share;
                break;
        }
    }
    gpu_.even_haze(clips_show_haze ? even : density);
}

Layer Smoke::layer(std::size_t clip, double time) const noexcept {
    return {.frame = {},
            .keying = &keying_for(parameters_.clips[clip], parameters_),
            .polarity = parameters_.clips[clip].polarity,
            .clip = &parameters_.clips[clip],
            .time = time};
}

void Smoke::add_plumes(std::size_t clip, double share, const View& view, const SmokeScene& scene,
                       media::Policy policy) noexcept {
    const SmokeClip& settings = parameters_.clips[clip];
    const PlumeParameters& plume = parameters_.plume;
    const glm::vec2 size(clips_.info(clip).size);
    std::optional<ClipInFrame> shown;
    for (const Burn& burn : scene.burns.after(scene.time - plume.fade_out)) {
        const PlumeState state = plume_state(burn, scene.burns.parts(), plume, scene.up, scene.time, scene.factor);
        if (state.density * share <= 0.0) continue;
        if (!shown) shown = show(clip, scene.time, policy);
        const std::uint32_t seed = chance(seed_ + 1, clip * 4099 + burn.number);
        const double width = state.size * state.widening * size.x / size.y;
        const ClipTurn turn = clip_turn(settings, seed);
        const glm::vec2 source(glm::dvec2(settings.source_x, settings.source_y));
        const auto corners = plume_corners({.anchor = glm::vec3(view.view * glm::vec4(glm::vec3(state.anchor), 1.0f)),
                                            .extent = glm::vec2(glm::dvec2(width, state.height)),
                                            .source = source,
                                            .up = screen_up(view.view, scene.up),
                                            .lean = static_cast<float>(plume.lean),
                                            .turn = turn});
        Layer drawn = layer(clip, scene.time);
        drawn.mirrored = turn.mirrored;
        drawn.seed = seed;
        drawn.source = {turn.mirrored ? 1.0f - source.x : source.x, source.y};
        drawn.widening = static_cast<float>(state.widening);
        drawn.below = 1.0 - settings.crop.bottom - settings.source_y;
        const glm::vec4 bounds = view_bounds(corners, view.projection);
        add_shown(*shown, drawn, state.density * share,
                  [&](const Layer& one) { gpu_.standing(settings.role, one, corners, bounds); });
    }
}

void Smoke::draw_particles(const SmokeScene& scene, GLuint scene_depth) noexcept {
    static_assert(most_particles <= most_specks);
    const ParticleParameters& parameters = parameters_.particles;
    const std::span<const BurnPart> recent =
        scene.burns.parts().subspan(scene.burns.first_after(scene.time - parameters.lifetime));
    const std::size_t count = particles_at(recent, parameters, scene.up, chance(seed_ + 3, 0), scene.time, particles_);
    if (count == 0) return;
    for (std::size_t i = 0; i < count; ++i) {
        const Particle& p = particles_[i];
        const float shape = static_cast<float>(p.shape & 0xffffu) / 65536.0f;
        particles_gpu_.specks().specks[i] = {glm::vec4(p.position, p.diameter), {p.opacity, p.glow, shape, 0.0f}};
    }
    particles_gpu_.draw(count, glm::vec3(parameters.color), scene_depth);
}

/// False when the clip has nothing to show.
bool Smoke::add_haze(std::size_t clip, double time, double density, media::Policy policy) noexcept {
    if (density <= 0.0) return true;
    Layer drawn = layer(clip, time);
    drawn.seed = chance(seed_ + 2, clip);
    const ClipTurn turn = clip_turn(parameters_.clips[clip], drawn.seed);
    drawn.mirrored = turn.mirrored;
    drawn.angle = turn.angle;
    const ClipInFrame shown = show(clip, time, policy);
    add_shown(shown, drawn, density,
              [&](const Layer& one) { gpu_.filling(ClipRole::haze, one, parameters_.haze.unevenness); });
    return there(shown.frame) || (shown.fading && there(*shown.fading));
}

}  // namespace lapfx::smoke
