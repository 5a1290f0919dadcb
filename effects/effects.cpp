#include "lapfx/effects.h"

#include <cmath>
#include <sstream>

#include "bleeding/bleed_cpu.h"
#include "bleeding/bleed_gpu.h"
#include "cautery/char_cpu.h"
#include "cautery/heat_cpu.h"
#include "gl/shader_source.h"
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
          positions(organ.positions),
          bleed(surface, down),
          charred(positions),
          bleed_gpu(organ.positions.size(), wanted.seed, down),
          organ_gpu(organ, &bleed_gpu.values()),
          smoke(wanted.seed) {}

    EffectsOptions options;
    Preset preset;
    std::vector<ToolContact> contacts;
    double time = 0.0;

    glm::dvec3 down;
    Surface surface;
    std::vector<glm::vec3> positions;
    bleeding::BleedField bleed;
    cautery::CharField charred;
    bleeding::BleedGpu bleed_gpu;
    render::OrganGpu organ_gpu;
    render::ViewBlock view_block;
    smoke::Smoke smoke;

    void refresh() {
        bleed.set(cautery::wounds_of(contacts, preset.cautery), preset.bleeding);
        charred.set(contacts, preset.cautery);
        bleed_gpu.set(preset.bleeding);
        smoke.set_contacts(contacts);
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
    state_->contacts.assign(contacts.begin(), contacts.end());
    state_->refresh();
}

void Effects::seek(double time) noexcept {
    if (!std::isfinite(time)) return;
    State& s = *state_;
    s.time = time;
    const bleeding::Dirty dirty = s.bleed.update(time);
    const VertexRun changed{dirty.begin, dirty.end};
    if (!dirty.empty()) s.bleed_gpu.send(s.bleed.values(), {&changed, 1});
    const VertexRun whole{0, static_cast<std::uint32_t>(s.positions.size())};
    if (s.charred.update(time)) s.organ_gpu.send_marks(s.charred.values(), {&whole, 1});
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

unsigned Effects::bleed_buffer() const noexcept {
    return state_->bleed_gpu.values().name();
}

void Effects::bind_bleeding() const noexcept {
    state_->bleed_gpu.bind();
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

std::string bleeding_shader() {
    // Without the #line marks: their file numbers mean nothing to a host.
    std::istringstream lines(gl::shader_source("bleeding.glsl").text);
    std::string text, line;
    while (std::getline(lines, line))
        if (!line.starts_with("#line ")) text += line + "\n";
    return text;
}

}  // namespace lapfx
