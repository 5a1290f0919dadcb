#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/prepared_scene.h"

#include <optional>

#include "foundation.h"
#include "gl/shader_source.h"
#include "gl/state_guard.h"
#include "render/camera.h"
#include "render/frame.h"
#include "render/organ_gpu.h"
#include "render/view_block.h"

namespace lapfx {

namespace {

EffectsOptions effects_options(const Scene& scene, const PreviewOptions& options) {
    return {.seed = static_cast<std::uint32_t>(scene.seed),
            .gravity = scene.gravity,
            .clip_folders = options.clip_folders,
            .wait_for_clips = options.wait_for_clips,
            .streaming = options.streaming,
            .clip_cache = options.clip_cache};
}

std::shared_ptr<const PreparedOrgan> require_same(const Scene& scene, std::shared_ptr<const PreparedOrgan> organ) {
    if (made_for(*organ, scene)) return organ;
    throw Error(Failure::bad_input,
                Fault{.file = "",
                      .place = "/organ/file",
                      .reason = "\"" + scene.organ.file + "\" is not the organ that was prepared: \"" +
                                PreparedOrganAccess::state(*organ).organ_source.file + "\""});
}

}  // namespace

struct Preview::State {
    State(const Scene& wanted, const Preset& preset, std::shared_ptr<const PreparedOrgan> made,
          const PreviewOptions& options)
        : scene(wanted),
          prepared(require_same(wanted, std::move(made))),
          effects(prepared, preset, effects_options(wanted, options)) {
        const PreparedOrganAccess::State& known = PreparedOrganAccess::state(*prepared);
        if (known.tool) tool.emplace(*known.tool, nullptr, known.tool_pixels);
        organ::let_go(known.tool_pixels);  // they have been sent to the GPU
        effects.set_curves(scene.curves);
        effects.set_contacts(scene.events);
        effects.set_overlay(options.overlay);
        effects.set_organ_color(scene.organ.color);
    }

    Scene scene;
    std::shared_ptr<const PreparedOrgan> prepared;
    Effects effects;
    std::optional<render::OrganGpu> tool;
    render::ViewBlock view_block;
    render::Frame frame;

    void draw_tool(const View& view, double time) noexcept {
        if (!tool) return;
        const auto pose = render::tool_pose(effects.contacts(), scene.tool.port, time);
        if (!pose) return;
        const gl::StateGuard guard;
        view_block.bind(view);
        tool->draw(*pose);
    }
};

Preview::Preview(const Scene& scene, const Preset& preset, const PreviewOptions& options)
    : Preview(scene, preset, prepare_organ(scene, preset.vessels), options) {}
Preview::Preview(const Scene& scene, const Preset& preset, std::shared_ptr<const PreparedOrgan> organ,
                 const PreviewOptions& options)
    : state_(std::make_unique<State>(scene, preset, std::move(organ), options)) {}
Preview::Preview(Preview&&) noexcept = default;
Preview& Preview::operator=(Preview&&) noexcept = default;
Preview::~Preview() = default;

void Preview::draw(double time, glm::ivec2 size, unsigned framebuffer) {
    State& s = *state_;
    s.frame.resize(size);
    const View view = render::view_of(s.scene.camera, s.scene.light, size);
    s.effects.seek(time);
    s.frame.begin_scene();
    s.effects.draw_organ(view);
    s.draw_tool(view, time);
    s.frame.begin_smoke();
    s.effects.draw_smoke(view, s.frame.scene_depth());
    s.frame.finish(framebuffer, static_cast<float>(s.scene.camera.exposure),
                   static_cast<float>(s.scene.camera.vignette));
}

Image Preview::image(double time, glm::ivec2 size) {
    state_->frame.resize(size);  // refuses a size that the driver cannot make, before anything is allocated for it
    const gl::Texture target({.size = size, .format = GL_RGBA8});
    const gl::Framebuffer framebuffer(target, nullptr);
    draw(time, size, framebuffer.name());
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    std::vector<std::uint8_t> upward(row * static_cast<std::size_t>(size.y));
    glGetTextureImage(target.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(upward.size()), upward.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw Error(Failure::runtime, Fault{.file = "",
                                            .place = "",
                                            .reason = "OpenGL error " + std::to_string(error) + " in the frame at " +
                                                      std::to_string(time) + " s"});
    Image image{.width = size.x, .height = size.y, .pixels = std::vector<std::uint8_t>(upward.size()), .name = ""};
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y)
        std::copy_n(upward.end() - static_cast<std::ptrdiff_t>((y + 1) * row), row,
                    image.pixels.begin() + static_cast<std::ptrdiff_t>(y * row));
    return image;
}

void Preview::set_preset(const Preset& preset) {
    state_->effects.set_preset(preset);
}
void Preview::set_parameters(const Preset& preset) {
    state_->effects.set_parameters(preset);
}

bool Preview::takes(const Scene& scene) const {
    return made_for(*state_->prepared, scene);
}

void Preview::set_scene(const Scene& scene) {
    State& s = *state_;
    if (!takes(scene))
        throw Error(Failure::bad_input,
                    Fault{.file = "",
                          .place = "/organ",
                          .reason = "organ and tool cannot change in a preview: \"" + scene.organ.file +
                                    "\" is not the \"" + s.scene.organ.file + "\" that it was made for"});
    if (scene.gravity != s.scene.gravity) s.effects.set_gravity(scene.gravity);
    if (scene.seed != s.scene.seed) s.effects.set_seed(static_cast<std::uint32_t>(scene.seed));
    s.effects.set_curves(scene.curves);
    s.effects.set_contacts(scene.events);
    s.effects.set_organ_color(scene.organ.color);
    s.scene = scene;
}

void Preview::reload_shaders(const std::filesystem::path& folder) {
    State& s = *state_;
    std::vector<gl::Program*> own{&s.frame.post()};
    if (s.tool) s.tool->collect(own);
    gl::ShaderTrial trial(folder);
    std::vector<gl::Program> made;
    for (const gl::Program* program : own) made.push_back(program->rebuilt());
    s.effects.reload_shaders(folder);  // from here on nothing throws
    for (std::size_t i = 0; i < own.size(); ++i) *own[i] = std::move(made[i]);
    trial.keep();
}

void Preview::set_overlay(Overlay overlay) {
    state_->effects.set_overlay(overlay);
}
void Preview::set_camera(const SceneCamera& camera) {
    state_->scene.camera = camera;
}
void Preview::set_curves(const Curves& curves) {
    state_->effects.set_curves(curves);
}
void Preview::set_contacts(std::span<const ToolContact> contacts) {
    state_->effects.set_contacts(contacts);
}
ToolQueue& Preview::tool_queue() {
    return state_->effects.tool_queue();
}
std::span<const ToolContact> Preview::contacts() const {
    return state_->effects.contacts();
}
const SceneCamera& Preview::camera() const {
    return state_->scene.camera;
}
const Organ& Preview::organ() const {
    return state_->prepared->organ();
}
Amounts Preview::amounts() const {
    return state_->effects.amounts();
}
std::span<const ClipStatus> Preview::clips() const {
    return state_->effects.clips();
}
StreamingTimes Preview::streaming_times() const {
    return state_->effects.streaming_times();
}
bool Preview::late() const {
    return state_->effects.late();
}
MemoryUse Preview::memory_use() const {
    const State& s = *state_;
    MemoryUse use = s.effects.memory_use();
    use.surface +=
        PreparedOrganAccess::state(*s.prepared).own_memory();  // the data of the organ is already counted in it
    use.pixels += PreparedOrganAccess::state(*s.prepared).tool_pixel_memory();
    use.targets += s.frame.memory();
    if (!s.tool) return use;
    use.geometry += s.tool->geometry_memory();
    use.textures += s.tool->texture_memory();
    return use;
}
TissueSample Preview::tissue(const glm::dvec3& position) const {
    return state_->effects.tissue(position);
}

std::optional<OrganHit> Preview::pick(glm::dvec2 pixel, glm::ivec2 size) const {
    return state_->effects.pick(state_->scene.camera.eye, render::ray_through(state_->scene.camera, pixel, size));
}

}  // namespace lapfx
