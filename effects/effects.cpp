#include "lapfx/effects.h"

#include <cassert>
#include <cmath>
#include <sstream>

#include "bleeding/bleed_cpu.h"
#include "bleeding/bleed_gpu.h"
#include "cautery/char_cpu.h"
#include "cautery/heat_cpu.h"
#include "gl/shader_source.h"
#include "gl/state_guard.h"
#include "organ/moved_surface.h"
#include "render/organ_gpu.h"
#include "render/view_block.h"
#include "smoke/smoke.h"

namespace lapfx {

namespace {

/// All that belongs to one mesh; cutting the organ makes another.
struct Body {
    Body(const Organ& organ, glm::dvec3 down, std::uint32_t seed)
        : surface(organ),
          moved(surface),
          positions(organ.positions),
          bleed(surface, down),
          charred(positions),
          bleed_gpu(organ.positions.size(), seed, down),
          organ_gpu(organ, &bleed_gpu.values()) {}

    Surface surface;
    MovedSurface moved;
    std::vector<glm::vec3> positions, normals;
    bleeding::BleedField bleed;
    cautery::CharField charred;
    bleeding::BleedGpu bleed_gpu;
    render::OrganGpu organ_gpu;

    void set(std::span<const ToolContact> contacts, const Preset& preset) {
        bleed.set(cautery::wounds_of(contacts, preset.cautery), preset.bleeding);
        bleed.set_clearing(contacts);
        charred.set(contacts, preset.cautery);
        bleed_gpu.set(preset.bleeding);
    }

    /// Bytes sent to the GPU.
    std::size_t seek(double time) noexcept {
        bleed.update(time);
        std::size_t sent = bleed_gpu.send(bleed.values(), bleed.changed().take());
        const VertexRun whole{0, static_cast<std::uint32_t>(positions.size())};
        if (charred.update(time)) sent += organ_gpu.send_marks(charred.values(), {&whole, 1});
        return sent;
    }
};

/// Blood of the former body at the vertices that are still there, per surface vertex of the new one.
std::vector<glm::vec2> surviving(const Body& former, const Body& now, std::span<const std::uint32_t> origin) {
    std::vector<glm::vec2> kept(now.surface.positions.size(), glm::vec2(bleeding::BleedField::dry, 0.0f));
    const std::span<const glm::vec2> values = former.bleed.values();
    for (std::size_t v = 0; v < origin.size(); ++v) {
        if (origin[v] >= values.size()) continue;
        glm::vec2& at = kept[now.surface.weld[v]];
        if (values[origin[v]].x > at.x) at = values[origin[v]];
    }
    return kept;
}

}  // namespace

struct Effects::State {
    State(const Organ& organ, const EffectsOptions& wanted)
        : options(wanted),
          down(glm::normalize(wanted.gravity)),
          body(std::make_unique<Body>(organ, down, wanted.seed)),
          smoke(wanted.seed) {}

    EffectsOptions options;
    Preset preset;
    std::vector<ToolContact> contacts;
    double time = 0.0;
    std::size_t uploaded = 0;

    glm::dvec3 down;
    std::unique_ptr<Body> body;
    render::ViewBlock view_block;
    smoke::Smoke smoke;

    void refresh() {
        body->set(contacts, preset);
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

void Effects::set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    Body& body = *state_->body;
    assert(positions.size() == body.positions.size() && (normals.empty() || normals.size() == positions.size()));
    body.moved.move(positions);
    if (normals.empty()) {
        body.normals.resize(positions.size());
        body.moved.normals(body.normals);
        normals = body.normals;
    }
    body.organ_gpu.set_shape(positions, normals);
}

glm::dvec3 Effects::to_rest(const glm::dvec3& place) const noexcept {
    return state_->body->moved.to_rest(place);
}

void Effects::set_topology(const Organ& organ, std::span<const std::uint32_t> origin) {
    State& s = *state_;
    assert(origin.size() == organ.positions.size());
    auto body = std::make_unique<Body>(organ, s.down, s.options.seed);
    body->set(s.contacts, s.preset);
    body->bleed.keep(surviving(*s.body, *body, origin), s.time);
    s.body = std::move(body);
}

void Effects::seek(double time) noexcept {
    if (!std::isfinite(time)) return;
    state_->time = time;
    state_->uploaded = state_->body->seek(time);
}

void Effects::draw_organ(const View& view) noexcept {
    const gl::StateGuard guard;
    state_->view_block.bind(view);
    state_->body->bleed_gpu.bind();
    state_->body->organ_gpu.draw(glm::mat4(1.0f));
}

void Effects::draw_smoke(const View& view, unsigned scene_depth) noexcept {
    const gl::StateGuard guard;
    state_->view_block.bind(view);
    state_->smoke.draw(view.view, -state_->down, state_->time, scene_depth,
                       state_->options.wait_for_clips ? smoke::Policy::wait : smoke::Policy::latest);
}

unsigned Effects::bleed_buffer() const noexcept {
    return state_->body->bleed_gpu.values().name();
}

void Effects::bind_bleeding() const noexcept {
    state_->body->bleed_gpu.bind();
}

Amounts Effects::amounts() const noexcept {
    const bleeding::BleedField& bleed = state_->body->bleed;
    const bleeding::BloodAmount blood = bleed.amount();
    const auto in = [&](auto... states) {
        return static_cast<int>(std::count_if(bleed.wounds().begin(), bleed.wounds().end(),
                                              [&](const WoundStatus& w) { return ((w.state == states) || ...); }));
    };
    return {.blood_area = blood.area,
            .blood_volume = blood.volume,
            .wounds = static_cast<int>(bleed.wounds().size()) - in(WoundState::waiting),
            .bleeding_wounds = bleed.growing(state_->time),
            .haze = state_->smoke.haze(state_->time)};
}

std::span<const WoundStatus> Effects::wounds() const noexcept {
    return state_->body->bleed.wounds();
}

std::size_t Effects::uploaded() const noexcept {
    return state_->uploaded;
}

std::optional<OrganHit> Effects::pick(glm::dvec3 origin, glm::dvec3 direction) const noexcept {
    SurfacePoint hit;
    if (!state_->body->moved.intersect_ray(origin, direction, hit)) return std::nullopt;
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
