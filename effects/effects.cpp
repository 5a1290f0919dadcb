#include "lapfx/effects.h"

#include <cmath>

#include "bleeding/bleed_cpu.h"
#include "bleeding/bleed_gpu.h"
#include "bleeding/tissue_density_cpu.h"
#include "cautery/char_cpu.h"
#include "cautery/heat_cpu.h"
#include "gl/state_guard.h"
#include "render/organ_gpu.h"
#include "render/view_block.h"
#include "smoke/smoke.h"

namespace lapfx {

struct Effects::State {
    State(const Organ& organ, const EffectsOptions& wanted, const VesselParameters& vessels)
        : options(wanted),
          down(glm::normalize(wanted.gravity)),
          surface(organ),
          positions(organ.positions),
          tissue(organ, surface, vessels),
          bleed(surface, down),
          charred(positions),
          bleed_gpu(organ.positions.size(), wanted.seed),
          organ_gpu(organ, &bleed_gpu.values()),
          smoke(wanted.seed) {}

    EffectsOptions options;
    Preset preset;
    std::vector<ToolContact> contacts;
    double time = 0.0;

    glm::dvec3 down;
    Surface surface;
    std::vector<glm::vec3> positions;
    bleeding::TissueDensity tissue;
    bleeding::BleedField bleed;
    cautery::CharField charred;
    bleeding::BleedGpu bleed_gpu;
    render::OrganGpu organ_gpu;
    render::ViewBlock view_block;
    smoke::Smoke smoke;
    Overlay overlay = Overlay::none;
    int shown_tissue = 0;  // the version that was sent

    /// The wounds of the contacts, as strong as the tissue there lets them be; where vessels are too few there is none.
    std::vector<Wound> wounds() const {
        std::vector<Wound> found = cautery::wounds_of(contacts, preset.cautery);
        for (Wound& wound : found) wound.strength *= tissue.wound_strength(wound.position);
        std::erase_if(found, [](const Wound& wound) { return wound.strength == 0.0; });
        return found;
    }

    /// Densities are sent only while they are looked at, and once.
    void show_overlay() {
        organ_gpu.set_overlay(overlay);
        if ((overlay != Overlay::vessels && overlay != Overlay::fat) || shown_tissue == tissue.version()) return;
        shown_tissue = tissue.version();
        std::vector<render::DensityPicture> pictures(tissue.images());
        for (std::size_t i = 0; i < pictures.size(); ++i)
            if (const bleeding::DensityMap* map = tissue.map(static_cast<int>(i)))
                pictures[i] = {.size = map->size(), .values = map->values()};
        organ_gpu.send_density(pictures, tissue.vertex_values());
    }

    void refresh() {
        bleed.set(wounds(), preset.bleeding);
        charred.set(contacts, preset.cautery);
        bleed_gpu.set(preset.bleeding);
        smoke.set_contacts(contacts);
    }
};

namespace {

void require_valid(const Preset& preset) {
    if (std::vector<Fault> faults = check(preset_table(), &preset); !faults.empty())
        throw Error(Failure::bad_input, std::move(faults));
}

}  // namespace

Effects::Effects(const Organ& organ, const Preset& preset, const EffectsOptions& options) {
    require_valid(preset);
    state_ = std::make_unique<State>(organ, options, preset.vessels);
    set_preset(preset);
}
Effects::Effects(Effects&&) noexcept = default;
Effects& Effects::operator=(Effects&&) noexcept = default;
Effects::~Effects() = default;

void Effects::set_preset(const Preset& preset) {
    require_valid(preset);
    state_->smoke.set_preset(preset, state_->options.clip_folders);
    state_->preset = preset;
    state_->tissue.set(preset.vessels);
    state_->show_overlay();
    state_->refresh();
}

void Effects::set_contacts(std::span<const ToolContact> contacts) {
    state_->contacts.assign(contacts.begin(), contacts.end());
    state_->refresh();
}

void Effects::set_overlay(Overlay overlay) {
    state_->overlay = overlay;
    state_->show_overlay();
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

Amounts Effects::amounts() const noexcept {
    return {.blood_area = state_->bleed.area(),
            .bleeding_wounds = state_->bleed.growing(state_->time),
            .haze = state_->smoke.haze(state_->time)};
}

TissueSample Effects::tissue(const glm::dvec3& position) const noexcept {
    return state_->tissue.sample(position);
}

std::optional<OrganHit> Effects::pick(glm::dvec3 origin, glm::dvec3 direction) const noexcept {
    SurfacePoint hit;
    if (!state_->surface.intersect_ray(origin, direction, hit)) return std::nullopt;
    return OrganHit{.position = hit.position, .distance = hit.distance};
}

}  // namespace lapfx
