#include "lapfx/effects.h"

#include <cassert>
#include <cmath>
#include <future>
#include <system_error>

#include "body.h"
#include "gl/context_hold.h"
#include "gl/shader_source.h"
#include "gl/srgb.h"
#include "gl/state_guard.h"
#include "incoming_organ.h"
#include "inputs.h"
#include "lapfx/prepared_organ.h"
#include "organ/refine.h"
#include "render/view_block.h"
#include "simulation.h"
#include "smoke/smoke.h"

namespace lapfx {

using namespace std::chrono_literals;

namespace {

std::shared_ptr<const Foundation> foundation_of(organ::FineOrgan& fine, const VesselParameters& vessels,
                                                organ::PixelList pixels = {}) {
    return std::make_shared<const Foundation>(fine.organ(), vessels, work::Stages{}, fine.take_unsplit(),
                                              std::move(pixels));
}

/// What an organ has that another one replaced, on its way (`incoming` alone) or when it was shown.
struct Leaving {
    std::unique_ptr<IncomingOrgan> incoming;
    std::unique_ptr<Simulation> simulation;
    std::unique_ptr<Body> body;

    bool free_texture() noexcept {
        return (body != nullptr && body->free_texture()) || (incoming != nullptr && incoming->free_texture());
    }
    void free_names() noexcept {
        body.reset();
        if (incoming) incoming->free_names();
    }
};

}  // namespace

struct Effects::State {
    State(const Organ& organ, const std::shared_ptr<const Foundation>& foundation, const EffectsOptions& wanted)
        : options(wanted),
          simulation(std::make_unique<Simulation>(foundation, direction_of(wanted.gravity))),
          programs(std::make_shared<render::OrganPrograms>(true)),
          body(make_body(organ, foundation)),
          smoke(wanted.seed, wanted.streaming, wanted.clip_cache) {}
    ~State() { context.enter(); }

    gl::ContextHold context;
    EffectsOptions options;
    ToolQueue queue;
    std::unique_ptr<Simulation> simulation;
    Curves curves;
    std::size_t uploaded = 0;
    std::uint64_t lost_before = 0;  // samples, of organs that are gone
    Overlay overlay = Overlay::none;
    glm::vec3 organ_color{1.0f};         // linear
    std::optional<glm::mat4> projector;  // the organ is a plate

    std::shared_ptr<render::OrganPrograms> programs;
    std::unique_ptr<Body> body;
    std::unique_ptr<IncomingOrgan> incoming;  ///< null: none
    std::vector<Leaving> leaving;             // for the next frames to free
    std::vector<std::future<void>> freeing;   // by other threads: what is left of it
    render::ViewBlock view_block;
    smoke::Smoke smoke;

    void bind(const View& view) const noexcept { view_block.bind(view, projector.has_value()); }
    std::unique_ptr<Body> make_body(const Organ& organ, const std::shared_ptr<const Foundation>& foundation) const {
        return std::make_unique<Body>(organ, foundation, *simulation, options.seed, programs,
                                      render::OrganTextures(organ, foundation->pixels));
    }
    void show_plate(const glm::mat4& thrown) {
        projector = thrown;
        body->set_projector(thrown);
    }
    /// `changed`: redo bits; none: it is not known.
    void take(const SimulationParameters& parameters, std::optional<unsigned> changed = std::nullopt) {
        changed ? simulation->set_parameters(parameters, *changed) : simulation->set_parameters(parameters);
        body->take(*simulation);
    }
    bool smokes() const { return !smoke.parameters().clips.empty(); }
    void show_incoming();
    void free_leaving();
    /// What has no names of OpenGL.
    template <typename T>
    void free_beside(T gone) {
        std::erase_if(freeing, [](const auto& one) { return one.wait_for(0s) == std::future_status::ready; });
        try {
            freeing.push_back(std::async(std::launch::async,
                                         [gone = std::move(gone)]() mutable { const T freed = std::move(gone); }));
        } catch (const std::system_error&) {
            // No thread is to be had: it has been freed here.
        }
    }
};

/// What has been set while it came holds for it too.
void Effects::State::show_incoming() {
    Leaving gone;
    gone.simulation = std::exchange(simulation, incoming->take_simulation());
    gone.body = std::exchange(body, incoming->take_body());
    lost_before += gone.simulation->amounts().lost_samples;
    if (const auto& down = gone.simulation->down(); down != simulation->down()) simulation->set_down(down);
    if (incoming->later_curves) simulation->set_curves(curves);
    if (incoming->later_contacts) simulation->set_contacts(*incoming->later_contacts);
    projector = incoming->projector();
    gone.incoming = std::move(incoming);
    leaving.push_back(std::move(gone));
    body->set_seed(options.seed);
    body->set_color(organ_color);
    take(leaving.back().simulation->parameters());
    body->set_overlay(overlay, *simulation);
}

/// The names of OpenGL here, a part in each frame; then everything else on another thread.
void Effects::State::free_leaving() {
    if (leaving.empty() || leaving.front().free_texture()) return;
    leaving.front().free_names();
    free_beside(std::move(leaving.front()));
    leaving.erase(leaving.begin());
}

Effects::Effects(const Organ& organ, const Preset& preset, const EffectsOptions& options) {
    require_valid(preset);
    organ::FineOrgan fine(organ);
    state_ = std::make_unique<State>(fine.organ(), foundation_of(fine, preset.vessels), options);
    set_preset(preset);
}
Effects::Effects(std::shared_ptr<const PreparedOrgan> organ, const Preset& preset, const EffectsOptions& options) {
    require_valid(preset);
    state_ = std::make_unique<State>(organ->organ(), organ->state().foundation, options);
    if (const auto& plate = organ->state().foundation->plate) state_->show_plate(glm::mat4(plate->projector()));
    set_preset(preset);
}
Effects::Effects(Effects&&) noexcept = default;
Effects& Effects::operator=(Effects&&) noexcept = default;
Effects::~Effects() = default;

void Effects::set_preset(const Preset& preset) {
    require_valid(preset);
    state_->programs->prepare(bleeding::model_of(preset.bleeding));
    state_->smoke.set_preset(preset, state_->options.clip_folders);
    state_->take(preset);
}

void Effects::set_parameters(const Preset& preset) {
    require_valid(preset);
    state_->programs->prepare(bleeding::model_of(preset.bleeding));
    state_->smoke.set_parameters(preset.smoke);
    state_->take(preset);
}

void Effects::set_parameters(const Preset& preset, unsigned changed) {
    require_valid(preset);
    state_->programs->prepare(bleeding::model_of(preset.bleeding));
    if (changed & redo::smoke) state_->smoke.set_parameters(preset.smoke);
    state_->take(preset, changed);
}

Preset Effects::preset() const {
    const SimulationParameters& shown = state_->simulation->parameters();
    return {.name = {},
            .description = {},
            .tags = {},
            .bleeding = shown.bleeding,
            .vessels = shown.vessels,
            .cautery = shown.cautery,
            .smoke = state_->smoke.parameters(),
            .folder = {}};
}

void Effects::set_gravity(const glm::dvec3& gravity) {
    State& s = *state_;
    s.simulation->set_down(direction_of(gravity));
    s.options.gravity = gravity;
    s.body->take(*s.simulation);
}

void Effects::set_seed(std::uint32_t seed) {
    state_->options.seed = seed;
    state_->body->set_seed(seed);
    state_->body->take(*state_->simulation);
    state_->smoke.set_seed(seed);
}

void Effects::set_organ(std::shared_ptr<const PreparedOrgan> organ, std::span<const ToolContact> contacts) {
    State& s = *state_;
    assert(organ != nullptr);
    OrganHistory history{.parameters = s.simulation->parameters(),
                         .contacts = {contacts.begin(), contacts.end()},
                         .curves = s.curves,
                         .down = s.simulation->down(),
                         .seed = s.options.seed,
                         .time = s.simulation->time()};
    std::unique_ptr<IncomingOrgan> before = std::move(s.incoming);
    if (before && !before->only_in_memory())
        s.leaving.push_back({.incoming = std::move(before), .simulation = {}, .body = {}});
    s.incoming = std::make_unique<IncomingOrgan>(std::move(organ), std::move(history), s.programs, std::move(before));
}

bool Effects::organ_coming() const noexcept {
    return state_->incoming != nullptr;
}

void Effects::set_contacts(std::span<const ToolContact> contacts) {
    if (auto& incoming = state_->incoming) incoming->later_contacts.emplace(contacts.begin(), contacts.end());
    state_->simulation->set_contacts(contacts);
}

void Effects::set_curves(const Curves& curves) {
    if (curves == state_->curves) return;
    state_->curves = curves;
    if (auto& incoming = state_->incoming) incoming->later_curves = true;
    state_->simulation->set_curves(curves);
}

ToolQueue& Effects::tool_queue() noexcept {
    return state_->queue;
}

std::span<const ToolContact> Effects::contacts() const noexcept {
    return state_->simulation->contacts();
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
    std::vector<std::shared_ptr<const Image>> needed;  // kept until the end, so that they are decoded once
    for (const auto& one : pixels)
        if (one) needed.push_back(one->get());
    const auto foundation = foundation_of(fine, s.simulation->parameters().vessels, std::move(pixels));
    auto body = s.make_body(fine.organ(), foundation);
    body->set_color(s.organ_color);
    if (s.projector) body->set_projector(*s.projector);
    s.simulation->set_surface(foundation, origin);
    s.body = std::move(body);
    s.body->take(*s.simulation);
    s.body->set_overlay(s.overlay, *s.simulation);
}

void Effects::reload_shaders(const std::filesystem::path& folder) {
    gl::ShaderTrial trial(folder);
    std::vector<gl::Program*> programs;
    state_->programs->collect(programs);
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
    state_->body->set_overlay(overlay, *state_->simulation);
}

void Effects::seek(double time) noexcept {
    state_->simulation->take_samples(state_->queue, state_->body->moved());
    state_->smoke.update();
    state_->free_leaving();
    if (!std::isfinite(time)) return;
    if (state_->incoming && state_->incoming->advance(state_->options.wait_for_clips)) state_->show_incoming();
    state_->simulation->seek(time);
    state_->uploaded = state_->body->send(*state_->simulation);
}

void Effects::draw_organ(const View& view) noexcept {
    const gl::StateGuard guard;
    state_->bind(view);
    state_->body->draw();
}

void Effects::draw_metal_clips(const View& view) noexcept {
    const gl::StateGuard guard;
    state_->bind(view);
    state_->body->draw_metal_clips();
}

void Effects::draw_smoke(const View& view, unsigned scene_depth) noexcept {
    const gl::StateGuard guard;
    state_->bind(view);
    const EffectsOptions& options = state_->options;
    const Simulation& simulation = *state_->simulation;
    state_->smoke.draw(view,
                       {.burns = simulation.burns(),
                        .factor = simulation.emission_factor(),
                        .haze = view.haze ? simulation.smoke(simulation.time(), state_->smokes()).haze : 0.0,
                        .up = -simulation.down(),
                        .time = simulation.time()},
                       scene_depth,
                       options.wait_for_clips                      ? media::Policy::wait
                       : options.streaming.late == LateClips::skip ? media::Policy::skip
                                                                   : media::Policy::latest);
}

unsigned Effects::bleed_buffer() const noexcept {
    return state_->body->blood().attributes().front().buffer->name();
}

void Effects::bind_bleeding() const noexcept {
    state_->body->blood().bind();
}

Amounts Effects::amounts() const noexcept {
    Amounts amounts = state_->simulation->amounts(state_->smokes());
    amounts.lost_samples += state_->queue.missed() + state_->lost_before;
    return amounts;
}

std::span<const WoundStatus> Effects::wounds() const noexcept {
    return state_->simulation->blood().wounds();
}

std::span<const ClipStatus> Effects::clips() const {
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
    MemoryUse use = state_->body->memory_use(*state_->simulation);
    use.clips = state_->smoke.clips().memory();
    use.targets = state_->smoke.target_memory();
    return use;
}

std::size_t Effects::uploaded() const noexcept {
    return state_->uploaded;
}

TissueSample Effects::tissue(const glm::dvec3& position) const noexcept {
    return state_->simulation->density().sample(position);
}

std::optional<OrganHit> Effects::pick(glm::dvec3 origin, glm::dvec3 direction) const noexcept {
    SurfacePoint hit;
    if (!state_->body->moved().intersect_ray(origin, direction, hit)) return std::nullopt;
    return OrganHit{.position = hit.position, .distance = hit.distance};
}

std::string bleeding_shader() {
    return gl::host_text(bleeding::shaders_of(bleeding::Model::spread).for_hosts);
}

}  // namespace lapfx
