#include "lapfx/effects.h"

#include <cassert>
#include <cmath>
#include <sstream>

#include "body.h"
#include "cautery/power.h"
#include "cautery/recorder.h"
#include "gl/shader_source.h"
#include "gl/srgb.h"
#include "gl/state_guard.h"
#include "inputs.h"
#include "lapfx/prepared_organ.h"
#include "organ/refine.h"
#include "render/view_block.h"
#include "smoke/contact_fat.h"
#include "smoke/smoke.h"
#include "smoke/touching.h"

namespace lapfx {

namespace {

std::shared_ptr<const Foundation> foundation_of(organ::FineOrgan& fine, const VesselParameters& vessels,
                                                organ::PixelList pixels = {}) {
    return std::make_shared<const Foundation>(fine.organ(), vessels, work::Stages{}, fine.take_unsplit(),
                                              std::move(pixels));
}

}  // namespace

struct Effects::State {
    State(const Organ& organ, std::shared_ptr<const Foundation> foundation, const EffectsOptions& wanted)
        : options(wanted),
          down(direction_of(wanted.gravity)),
          body(std::make_unique<Body>(organ, std::move(foundation), down, wanted.seed)),
          smoke(wanted.seed, wanted.streaming, wanted.clip_cache) {}

    EffectsOptions options;
    Preset preset;
    ToolQueue queue;
    cautery::Recorder recorder;
    Curves curves;
    cautery::PowerCurve power;
    double time = 0.0;
    std::size_t uploaded = 0;
    Overlay overlay = Overlay::none;
    glm::vec3 organ_color{1.0f};  // linear

    glm::dvec3 down;
    std::unique_ptr<Body> body;
    render::ViewBlock view_block;
    smoke::Smoke smoke;

    smoke::Touching touching;
    const smoke::Touching::Touches touches = [this](const glm::dvec3& place) { return body->touches(place); };
    smoke::ContactFat fat;
    VesselParameters fat_of;  // what `fat` was asked for
    const smoke::ContactFat::Sample fat_at = [this](const glm::dvec3& place) { return body->tissue().fat(place); };

    /// What the tool has done, with the power of its time.
    std::span<const ToolContact> acting() { return power.apply(recorder.contacts()); }
    void take_smoke(std::span<const ToolContact> contacts) {
        const std::span<const ToolContact> burning = touching.update(contacts, touches);
        smoke.set_contacts(burning, fat.update(burning, fat_at));
    }
    void refresh() {
        const std::span<const ToolContact> contacts = acting();
        body->set(contacts, preset);
        if (!(fat_of == preset.vessels)) fat.clear();
        fat_of = preset.vessels;
        take_smoke(contacts);
    }
    void take_contacts() {
        const std::span<const ToolContact> contacts = acting();
        body->set_contacts(contacts, preset);
        take_smoke(contacts);
    }
    /// The tool touches the organ as it is now; contacts are of the shape at rest.
    void drain_queue() {
        ToolSample sample;
        const std::uint64_t before = recorder.version();
        // No more than were there when it began: the haptic thread goes on.
        for (std::size_t i = 0; i < queue.capacity() && queue.pop(sample); ++i) {
            if (sample.touching) sample.position = body->moved().to_rest(sample.position);
            recorder.add(sample);
        }
        if (recorder.version() != before) take_contacts();
    }
};

Effects::Effects(const Organ& organ, const Preset& preset, const EffectsOptions& options) {
    require_valid(preset);
    organ::FineOrgan fine(organ);
    state_ = std::make_unique<State>(fine.organ(), foundation_of(fine, preset.vessels), options);
    set_preset(preset);
}
Effects::Effects(std::shared_ptr<const PreparedOrgan> organ, const Preset& preset, const EffectsOptions& options) {
    require_valid(preset);
    state_ = std::make_unique<State>(organ->organ(), organ->state().foundation, options);
    set_preset(preset);
}
Effects::Effects(Effects&&) noexcept = default;
Effects& Effects::operator=(Effects&&) noexcept = default;
Effects::~Effects() = default;

void Effects::set_preset(const Preset& preset) {
    require_valid(preset);
    state_->smoke.set_preset(preset, state_->options.clip_folders);
    state_->preset = preset;
    state_->refresh();
}

void Effects::set_parameters(const Preset& preset) {
    require_valid(preset);
    state_->smoke.set_parameters(preset.smoke);
    state_->preset = preset;
    state_->refresh();
}

void Effects::set_gravity(const glm::dvec3& gravity) {
    State& s = *state_;
    s.down = direction_of(gravity);
    s.options.gravity = gravity;
    s.body->set_down(s.down);
    s.refresh();
}

void Effects::set_seed(std::uint32_t seed) {
    State& s = *state_;
    s.options.seed = seed;
    s.body->set_seed(seed);
    s.smoke.set_seed(seed);
    s.refresh();
}

void Effects::set_contacts(std::span<const ToolContact> contacts) {
    state_->recorder.set(contacts);
    state_->take_contacts();
}

void Effects::set_curves(const Curves& curves) {
    State& s = *state_;
    if (curves == s.curves) return;
    s.curves = curves;
    s.power.set(curves.cautery_power);
    s.body->set_strength(FactorCurve(curves.bleeding_strength));
    s.smoke.set_factor(FactorCurve(curves.emission));
    s.take_contacts();
}

ToolQueue& Effects::tool_queue() noexcept {
    return state_->queue;
}

std::span<const ToolContact> Effects::contacts() const noexcept {
    return state_->recorder.contacts();
}

void Effects::set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    state_->body->set_shape(positions, normals);
}

glm::dvec3 Effects::to_rest(const glm::dvec3& place) const noexcept {
    return state_->body->moved().to_rest(place);
}

void Effects::set_topology(const Organ& organ, std::span<const std::uint32_t> origin) {
    State& s = *state_;
    assert(origin.size() == organ.positions.size());
    organ::FineOrgan fine(organ);
    organ::PixelList pixels = organ::copied_pixels(fine.organ(), s.body->pixels());
    std::vector<std::shared_ptr<const Image>> needed;  // until the end: decoded once
    for (const auto& one : pixels)
        if (one) needed.push_back(one->get());
    auto foundation = foundation_of(fine, s.preset.vessels, std::move(pixels));
    auto body = std::make_unique<Body>(fine.organ(), std::move(foundation), s.down, s.options.seed);
    body->set_strength(FactorCurve(s.curves.bleeding_strength));
    body->set(s.acting(), s.preset);
    body->set_overlay(s.overlay);
    body->set_color(s.organ_color);
    body->inherit(*s.body, origin, s.time);
    s.body = std::move(body);
    s.touching.clear();
    s.fat.clear();
    s.take_smoke(s.acting());
}

void Effects::reload_shaders(const std::filesystem::path& folder) {
    gl::ShaderTrial trial(folder);
    std::vector<gl::Program*> programs;
    state_->body->collect(programs);
    state_->smoke.collect(programs);
    gl::rebuild(programs);
    trial.keep();
}

void Effects::set_organ_color(const glm::dvec3& color) {
    state_->organ_color =
        color == glm::dvec3(1.0) ? glm::vec3(1.0f) : gl::to_linear(glm::vec3(color));  // white: exactly
    state_->body->set_color(state_->organ_color);
}

void Effects::set_overlay(Overlay overlay) {
    state_->overlay = overlay;
    state_->body->set_overlay(overlay);
}

void Effects::seek(double time) noexcept {
    state_->drain_queue();
    if (!std::isfinite(time)) return;
    state_->time = time;
    state_->uploaded = state_->body->seek(time);
}

void Effects::draw_organ(const View& view) noexcept {
    const gl::StateGuard guard;
    state_->view_block.bind(view);
    state_->body->draw();
}

void Effects::draw_smoke(const View& view, unsigned scene_depth) noexcept {
    const gl::StateGuard guard;
    state_->view_block.bind(view);
    const EffectsOptions& options = state_->options;
    state_->smoke.draw(view, -state_->down, state_->time, scene_depth,
                       options.wait_for_clips                      ? media::Policy::wait
                       : options.streaming.late == LateClips::skip ? media::Policy::skip
                                                                   : media::Policy::latest);
}

unsigned Effects::bleed_buffer() const noexcept {
    return state_->body->bleed_gpu().values().name();
}

void Effects::bind_bleeding() const noexcept {
    state_->body->bleed_gpu().bind();
}

Amounts Effects::amounts() const noexcept {
    const bleeding::BleedField& bleed = state_->body->bleed();
    const bleeding::BloodAmount blood = bleed.amount();
    return {.blood_area = blood.area,
            .blood_volume = blood.volume,
            .wounds = static_cast<int>(bleed.wounds().size()) - waiting_wounds(bleed.wounds()),
            .bleeding_wounds = bleed.bleeding_wounds(),
            .left_out_wounds = static_cast<int>(state_->body->left_out_wounds()),
            .lost_samples = state_->recorder.dropped() + state_->queue.missed(),
            .haze = state_->smoke.haze(state_->time)};
}

std::span<const WoundStatus> Effects::wounds() const noexcept {
    return state_->body->bleed().wounds();
}

std::vector<ClipStatus> Effects::clips() const {
    return state_->smoke.clips().status();
}

StreamingTimes Effects::streaming_times() const noexcept {
    StreamingTimes times = state_->smoke.clips().times();
    times.shading = state_->smoke.shading_seconds();
    times.shaded = state_->smoke.shaded();
    return times;
}

bool Effects::late() const noexcept {
    return state_->smoke.clips().late();
}

MemoryUse Effects::memory_use() const noexcept {
    MemoryUse use = state_->body->memory_use();
    use.clips = state_->smoke.clips().memory();
    use.targets = state_->smoke.target_memory();
    return use;
}

std::size_t Effects::uploaded() const noexcept {
    return state_->uploaded;
}

TissueSample Effects::tissue(const glm::dvec3& position) const noexcept {
    return state_->body->tissue().sample(position);
}

std::optional<OrganHit> Effects::pick(glm::dvec3 origin, glm::dvec3 direction) const noexcept {
    SurfacePoint hit;
    if (!state_->body->moved().intersect_ray(origin, direction, hit)) return std::nullopt;
    return OrganHit{.position = hit.position, .distance = hit.distance};
}

std::string bleeding_shader() {
    // Without the #line marks: their file numbers mean nothing to a host.
    std::istringstream lines(gl::shader_source("bleeding.glsl").text);
    std::string text, line;
    while (std::getline(lines, line))
        if (!line.starts_with("#line ")) text += line + "\n";
    return text;
}

}  // namespace lapfx
