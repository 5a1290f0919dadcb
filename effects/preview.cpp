#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/prepared_scene.h"

#include <algorithm>
#include <optional>

#include "foundation.h"
#include "gl/read_back.h"
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
                                PreparedOrganAccess::state(*organ).source.organ.file + "\""});
}

}  // namespace

struct Preview::State {
    State(const Scene& wanted, const Preset& wanted_preset, std::shared_ptr<const PreparedOrgan> made,
          const PreviewOptions& options)
        : scene(wanted),
          prepared(require_same(wanted, std::move(made))),
          effects(prepared, wanted_preset, effects_options(wanted, options)) {
        const PreparedOrganAccess::State& known = PreparedOrganAccess::state(*prepared);
        if (known.tool) tool.emplace(*known.tool, nullptr, known.tool_pixels);
        if (known.tool) tool_end = render::tool_end(known.tool->positions);
        organ::let_go(known.tool_pixels);  // they have been sent to the GPU
        effects.set_curves(scene.curves);
        effects.set_contacts(scene.events);
        effects.set_overlay(options.overlay);
        set_organ_color();
        if (plate()) send_picture(*known.foundation->pixels.front()->get());
    }

    /// A plate shows the reference as it is.
    void set_organ_color() { effects.set_organ_color(plate() ? glm::dvec3(1.0) : scene.organ.color); }
    void send_picture(const Image& image) {
        plate_picture = gl::Texture({.size = {image.width, image.height}, .format = GL_RGBA8});
        plate_picture.upload(GL_RGBA, image.pixels.data());
    }

    Scene scene;
    bool haze_shown = true;
    std::shared_ptr<const PreparedOrgan> prepared;
    Effects effects;
    std::optional<render::OrganGpu> tool;
    std::vector<glm::vec3> tool_end;  // of its vertices
    render::ViewBlock view_block;
    render::Frame frame;
    gl::Texture plate_picture;  // the frame shows it, if there is a plate

    const std::optional<organ::Plate>& plate() const { return PreparedOrganAccess::state(*prepared).foundation->plate; }

    /// Whether a plate is seen through its own camera: as its picture, and not from elsewhere, as a surface.
    bool through_plate() const {
        const SceneCamera& camera = scene.camera;
        return plate() && camera.eye == plate()->camera.eye && camera.target == plate()->camera.target &&
               camera.up == plate()->camera.up && camera.field_of_view == plate()->camera.field_of_view;
    }
    /// The whole picture of a plate is shown in a frame of any aspect.
    SceneCamera camera(glm::ivec2 size) const {
        return through_plate() ? render::fitted(scene.camera, plate()->aspect, size) : scene.camera;
    }
    /// A plate's picture of the video already has its vignette, and its camera has sharpened it.
    void finish(unsigned framebuffer, const SceneCamera& seen, glm::ivec2 size) const noexcept {
        CameraResponse response = seen.response();
        if (!through_plate()) return frame.finish(framebuffer, response, {.there = plate().has_value()});
        const double height = std::tan(glm::radians(seen.field_of_view) / 2.0);
        const glm::vec2 extent(plate()->half_extent() / glm::dvec2(height * size.x / size.y, height));
        response.vignette = response.sharpening = 0.0;
        frame.finish(framebuffer, response, {.there = true, .picture = plate_picture.name(), .extent = extent});
    }

    /// Draws organ and tool at `time` into the frame, without smoke; resolved and bound.
    void draw_tissue(const View& view, double time) noexcept {
        effects.seek(time);
        frame.begin_scene();
        effects.draw_organ(view);
        draw_tool(view, time);
        frame.begin_smoke();
    }
    std::vector<std::uint8_t> shown_part(const SceneCamera& seen, glm::ivec2 size) const;
    /// Layers::view.
    std::vector<std::uint8_t> view_part(const View& view, double time, const SceneCamera& seen, glm::ivec2 size);
    void draw_tool(const View& view, double time) noexcept {
        if (!tool) return;
        const auto pose = render::tool_pose(effects.contacts(), scene.tool.port, time,
                                            PreparedOrganAccess::state(*prepared).foundation->surface);
        if (!pose) return;
        const gl::StateGuard guard;
        view_block.bind(view, plate().has_value());
        const glm::dvec3 eye(glm::inverse(view.view)[3]);
        tool->draw(
            render::out_of_tissue(*pose, tool_end, eye, PreparedOrganAccess::state(*prepared).foundation->surface));
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
    const SceneCamera camera = s.camera(size);
    View view = render::view_of(camera, s.scene.light, size);
    view.haze = s.haze_shown;
    s.draw_tissue(view, time);
    s.effects.draw_smoke(view, s.frame.scene_depth());
    s.finish(framebuffer, camera, size);
}

Image Preview::image(double time, glm::ivec2 size) {
    state_->frame.resize(size);  // refuses a size that the driver cannot make, before anything is allocated for it
    const gl::Texture target({.size = size, .format = GL_RGBA8});
    const gl::Framebuffer framebuffer(target, nullptr);
    draw(time, size, framebuffer.name());
    Image image{.width = size.x, .height = size.y, .pixels = {}, .name = ""};
    image.pixels.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4);
    gl::read_rgba(target.name(), size, image.pixels);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw Error(Failure::runtime, Fault{.file = "",
                                            .place = "",
                                            .reason = "OpenGL error " + std::to_string(error) + " in the frame at " +
                                                      std::to_string(time) + " s"});
    return image;
}

namespace {

/// The bound framebuffer in linear light, three values a pixel, rows from the top.
std::vector<float> read_linear(glm::ivec2 size) {
    const std::size_t row = static_cast<std::size_t>(size.x) * 3;
    std::vector<float> upward(row * static_cast<std::size_t>(size.y)), image(upward.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_FLOAT, upward.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y)
        std::copy_n(upward.end() - static_cast<std::ptrdiff_t>((y + 1) * row), row,
                    image.begin() + static_cast<std::ptrdiff_t>(y * row));
    return image;
}

constexpr float visible_change = 0.1F;  // share of the tissue's light

bool changed(const float* tissue, const float* bloody) {
    const float light = std::max({tissue[0], tissue[1], tissue[2], 1e-4F});
    float most = 0.0F;
    for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(bloody[k] - tissue[k]));
    return most > visible_change * light;
}

/// Rows from the top; 1 where nothing was drawn.
std::vector<float> read_depth(GLuint texture, glm::ivec2 size) {
    const auto row = static_cast<std::size_t>(size.x);
    std::vector<float> upward(row * static_cast<std::size_t>(size.y)), depth(upward.size());
    glGetTextureImage(texture, 0, GL_DEPTH_COMPONENT, GL_FLOAT, static_cast<GLsizei>(upward.size() * sizeof(float)),
                      upward.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y)
        std::copy_n(upward.end() - static_cast<std::ptrdiff_t>((y + 1) * row), row,
                    depth.begin() + static_cast<std::ptrdiff_t>(y * row));
    return depth;
}

}  // namespace

/// Where what is drawn reaches the finished picture at all: white does, where black does not look the same.
std::vector<std::uint8_t> Preview::State::shown_part(const SceneCamera& seen, glm::ivec2 size) const {
    const gl::Texture target({.size = size, .format = GL_RGBA8});
    const gl::Framebuffer framebuffer(target, nullptr);
    const auto finished = [&](float light) {
        frame.begin_smoke();
        glClearColor(light, light, light, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        finish(framebuffer.name(), seen, size);
        return read_linear(size);
    };
    const std::vector<float> black = finished(0.0F), white = finished(1.0F);
    std::vector<std::uint8_t> part(black.size() / 3);
    for (std::size_t i = 0; i < part.size(); ++i) part[i] = white[3 * i] > black[3 * i] ? 255 : 0;
    return part;
}

std::vector<std::uint8_t> Preview::State::view_part(const View& view, double time, const SceneCamera& camera,
                                                    glm::ivec2 size) {
    std::vector<std::uint8_t> part = shown_part(camera, size);
    draw_tissue(view, time);
    const std::vector<float> with_tool = read_depth(frame.scene_depth(), size);
    frame.begin_scene();
    effects.draw_organ(view);
    frame.begin_smoke();
    const std::vector<float> organ = read_depth(frame.scene_depth(), size);
    bool seen = false;
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (with_tool[i] != organ[i]) part[i] = 0;
        seen = seen || (part[i] != 0 && organ[i] < 1.0F);
    }
    if (!seen) std::ranges::fill(part, std::uint8_t{0});
    return part;
}

Layers Preview::layers(double time, glm::ivec2 size) {
    State& s = *state_;
    s.frame.resize(size);
    const SceneCamera camera = s.camera(size);
    const View view = render::view_of(camera, s.scene.light, size);
    const auto over = [&](float light) {  // what smoke makes of a background of this light
        s.draw_tissue(view, time);        // its depth, and the smoke of that time
        glClearColor(light, light, light, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        s.effects.draw_smoke(view, s.frame.scene_depth());
        return read_linear(size);
    };
    const std::vector<float> black = over(0.0F), white = over(1.0F);
    s.draw_tissue(view, time);
    const std::vector<float> bloody = read_linear(size);
    const Preset whole = s.effects.preset();
    Preset dry = whole;
    dry.bleeding.max_extent = 0.0;
    dry.bleeding.threshold = 10.0;
    set_parameters(dry);
    s.draw_tissue(view, time);
    const std::vector<float> tissue = read_linear(size);
    set_parameters(whole);

    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    Layers layers{.view = s.view_part(view, time, camera, size),
                  .blood = std::vector<std::uint8_t>(pixels),
                  .veil = std::vector<float>(pixels)};
    for (std::size_t i = 0; i < pixels; ++i) {
        float through = 0.0F;
        for (std::size_t k = 0; k < 3; ++k) through += (white[3 * i + k] - black[3 * i + k]) / 3.0F;
        layers.veil[i] = std::clamp(1.0F - through, 0.0F, 1.0F);
        layers.blood[i] = changed(&tissue[3 * i], &bloody[3 * i]) ? 255 : 0;
    }
    return layers;
}

ShownAmounts amounts_of(const Layers& layers) {
    ShownAmounts amounts;
    double pixels = 0.0;
    for (std::size_t i = 0; i < layers.view.size(); ++i) {
        if (layers.view[i] == 0) continue;
        pixels += 1.0;
        amounts.blood += layers.blood[i] != 0 ? 1.0 : 0.0;
        amounts.veil += static_cast<double>(layers.veil[i]);
    }
    if (pixels == 0.0) return {};
    amounts.blood /= pixels;
    amounts.veil /= pixels;
    amounts.view = pixels / static_cast<double>(layers.view.size());
    return amounts;
}

void Preview::set_preset(const Preset& preset) {
    state_->effects.set_preset(preset);
}
void Preview::set_parameters(const Preset& preset) {
    state_->effects.set_parameters(preset);
}
void Preview::set_parameters(const Preset& preset, unsigned changed) {
    state_->effects.set_parameters(preset, changed);
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
    s.scene = scene;
    s.set_organ_color();
}

void Preview::reload_shaders(const std::filesystem::path& folder) {
    State& s = *state_;
    std::vector<gl::Program*> own{&s.frame.post()};
    if (s.tool) s.tool->programs().collect(own);
    gl::ShaderTrial trial(folder);
    std::vector<gl::Program> made;
    for (const gl::Program* program : own) made.push_back(program->rebuilt());
    s.effects.reload_shaders(folder);  // nothing throws from here on
    for (std::size_t i = 0; i < own.size(); ++i) *own[i] = std::move(made[i]);
    trial.keep();
}

void Preview::set_overlay(Overlay overlay) {
    state_->effects.set_overlay(overlay);
}
void Preview::set_camera(const SceneCamera& camera) {
    state_->scene.camera = camera;
}
void Preview::set_haze_shown(bool shown) {
    state_->haze_shown = shown;
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
    if (s.plate()) use.textures += 4 * static_cast<std::size_t>(s.plate_picture.size().x * s.plate_picture.size().y);
    if (!s.tool) return use;
    use.geometry += s.tool->geometry_memory();
    use.textures += s.tool->texture_memory();
    return use;
}
TissueSample Preview::tissue(const glm::dvec3& position) const {
    return state_->effects.tissue(position);
}

std::optional<OrganHit> Preview::pick(glm::dvec2 pixel, glm::ivec2 size) const {
    return state_->effects.pick(state_->scene.camera.eye, render::ray_through(state_->camera(size), pixel, size));
}

}  // namespace lapfx
