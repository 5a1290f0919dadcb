#include "lapfx/effects.h"

#include <cmath>

#include "bleeding/bleed_cpu.h"
#include "bleeding/bleed_gpu.h"
#include "cautery/cautery.h"
#include "cautery/recorder.h"
#include "gl/state_guard.h"
#include "render/organ_gpu.h"
#include "render/view_block.h"
#include "smoke/smoke.h"

namespace lapfx {

struct Effects::State {
    State(const Organ& organ, const EffectsOptions& wanted)
        : options(wanted),
          down(glm::normalize(wanted.gravity)),
          surface(organ),
          bleed(surface, down),
          cautery(surface, {}),
          bleed_gpu(organ.positions.size(), wanted.seed),
          organ_gpu(organ, &bleed_gpu.values()),
          smoke(wanted.seed) {}

    EffectsOptions options;
    Preset preset;
    ToolQueue queue;
    cautery::Recorder recorder;
    double time = 0.0;

    glm::dvec3 down;
    Surface surface;
    bleeding::BleedField bleed;
    cautery::Cautery cautery;
    std::uint64_t wounds_version = 0;
    bleeding::BleedGpu bleed_gpu;
    render::OrganGpu organ_gpu;
    render::ViewBlock view_block;
    smoke::Smoke smoke;

    void refresh() {
        take_contacts();
        take_wounds();
        bleed_gpu.set(preset.bleeding);
    }
    void take_contacts() {
        cautery.set(recorder.contacts(), preset.cautery);
        smoke.set_contacts(recorder.contacts());
    }
    void take_wounds() {
        const std::span<const Wound> wounds = cautery.wounds();
        bleed.set({wounds.begin(), wounds.end()}, preset.bleeding);
        wounds_version = cautery.wounds_version();
    }
    void drain_queue() {
        ToolSample sample;
        bool any = false;
        // No more than were there when it began: the haptic thread goes on.
        for (std::size_t i = 0; i < queue.capacity() && queue.pop(sample); ++i) any |= recorder.add(sample);
        if (any) take_contacts();
    }
};

Effects::Effects(const Organ& organ, const Preset& preset, const EffectsOptions& options)
    : state_(std::make_unique<State>(organ, options)) {
    set_preset(preset);
}
Effects::Effects(Effects&&) noexcept = default;
Effects& Effects::operator=(Effects&&) noexcept = default;
Effects::~Effects() = default;

void Effects::set_preset(const Preset& preset) {
    if (std::vector<Fault> faults = check(preset_table(), &preset); !faults.empty())
        throw Error(Failure::bad_input, std::move(faults));
    state_->smoke.set_preset(preset, state_->options.clip_folders);
    state_->preset = preset;
    state_->refresh();
}

void Effects::set_contacts(std::span<const ToolContact> contacts) {
    state_->recorder.set(contacts);
    state_->take_contacts();
}

ToolQueue& Effects::tool_queue() noexcept {
    return state_->queue;
}

std::span<const ToolContact> Effects::contacts() const noexcept {
    return state_->recorder.contacts();
}

void Effects::seek(double time) noexcept {
    if (!std::isfinite(time)) return;
    State& s = *state_;
    s.time = time;
    s.drain_queue();
    s.cautery.update(time);
    if (s.wounds_version != s.cautery.wounds_version()) s.take_wounds();
    const bleeding::Dirty dirty = s.bleed.update(time);
    const VertexRun changed{dirty.begin, dirty.end};
    if (!dirty.empty()) s.bleed_gpu.send(s.bleed.values(), {&changed, 1});
    if (!s.cautery.changed().empty()) s.organ_gpu.send_marks(s.cautery.marks(), s.cautery.changed().take());
}

void Effects::draw_organ(const View& view) noexcept {
    const gl::StateGuard guard;
    state_->view_block.bind(view);
    state_->bleed_gpu.bind();
    state_->organ_gpu.draw(glm::mat4(1.0f));
}

void Effects::draw_smoke(const View& view, unsigned scene_depth) noexcept {
    const gl::StateGuard guard;
    state_->view_block.bind(view);
    state_->smoke.draw(view.view, -state_->down, state_->time, scene_depth,
                       state_->options.wait_for_clips ? smoke::Policy::wait : smoke::Policy::latest);
}

Amounts Effects::amounts() const noexcept {
    return {.blood_area = state_->bleed.area(),
            .bleeding_wounds = state_->bleed.growing(state_->time),
            .haze = state_->smoke.haze(state_->time)};
}

std::optional<OrganHit> Effects::pick(glm::dvec3 origin, glm::dvec3 direction) const noexcept {
    SurfacePoint hit;
    if (!state_->surface.intersect_ray(origin, direction, hit)) return std::nullopt;
    return OrganHit{.position = hit.position, .distance = hit.distance};
}

}  // namespace lapfx
