// Method: the sample scene with its preset at 640x512, drawn by Effects and Frame as a host does, 30 frames a second of
// its own time. Two frames without a change and two of which the first has one take turns, each 1/30 s later; the
// slower of the two counts, because what a change left undone the next frame does. Before a change everything that the
// headers let another thread do has been done: prepare_organ(), ClipCache::look_through().
#include "commands/bench_changes.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "commands/bench_host.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/clip_cache.h"
#include "lapfx/effects.h"
#include "lapfx/frame.h"
#include "lapfx/prepared_organ.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double budget_ms = 16.0, fps = 30.0;

struct Extent {
    glm::ivec2 size;
    int frames, runs;  // drawn before the first change; of each change
};
constexpr Extent whole{{640, 512}, 60, 15}, least{{80, 64}, 2, 1};

/// What a host has.
class Host {
  public:
    Host(const HostFrame& target, glm::ivec2 size)
        : preset(load_preset(data_folder() / "presets/gastric_banding.json")),
          scene_(load_scene(data_folder() / "samples/lagb.scene.json")),
          clips_(std::make_shared<ClipCache>()),
          target_(target),
          size_(size) {
        clips_->look_through(preset, clip_folders());
        prepare();
        show_organ();
    }

    /// On the thread of the call; a host has one for it.
    void prepare() { organ_ = prepare_organ(scene_, preset.vessels); }
    const Organ& organ() const { return organ_->organ(); }
    /// The organ that was prepared last, as it is after the same events.
    void show_organ() {
        effects.emplace(organ_, preset, EffectsOptions{.clip_folders = clip_folders(), .clip_cache = clips_});
        effects->set_contacts(scene_.events);
    }
    /// ms for the next frame, in which `change` is made first.
    double frame_ms(const std::function<void()>& change = [] {}) {
        const auto start = Clock::now();
        change();
        effects->seek(time_ += 1.0 / fps);
        frame_.begin(size_);
        const View view = looking();
        effects->draw_organ(view);
        frame_.begin_smoke();
        effects->draw_smoke(view, frame_.depth());
        frame_.finish(target_.framebuffer());
        finish_drawing();
        return 1e3 * std::chrono::duration<double>(Clock::now() - start).count();
    }

    Preset preset;
    std::optional<Effects> effects;

  private:
    View looking() const {
        const SceneCamera& c = scene_.camera;
        const double aspect = static_cast<double>(size_.x) / size_.y;
        return {.view = glm::mat4(glm::lookAt(c.eye, c.target, c.up)),
                .projection = glm::mat4(glm::perspective(glm::radians(c.field_of_view), aspect, 2.0, 5000.0)),
                .lamp = {.intensity = scene_.light.intensity, .focus_distance = scene_.light.focus_distance}};
    }

    Scene scene_;
    std::shared_ptr<ClipCache> clips_;
    std::shared_ptr<const PreparedOrgan> organ_;
    Frame frame_;
    const HostFrame& target_;
    glm::ivec2 size_;
    double time_ = 4.0;  // s: the scene's tool burns, and there is smoke
};

/// What a host changes between two frames, one of many: `run` tells them apart.
struct Change {
    std::string name;
    std::function<void(int run)> make;
    std::function<void()> before = [] {};  ///< what another thread does
};

std::vector<Change> changes(Host& host) {
    const auto tuned = [&host](int run) {
        Preset other = host.preset;
        other.bleeding.speed = 4.0 + 0.1 * run;
        other.smoke.haze.accumulation = 0.02 + 0.001 * run;
        return other;
    };
    const auto moved = [&host](int run) {
        std::vector<glm::vec3> positions = host.organ().positions;
        for (glm::vec3& p : positions) p.y += 0.1f * static_cast<float>(run);
        host.effects->set_shape(positions);
    };
    return {{"values", [&host, tuned](int run) { host.effects->set_preset(tuned(run)); }},
            {"keying",
             [&host, tuned](int run) {
                 Preset other = tuned(run);
                 other.smoke.keying.luma_low = 16.0 + run;
                 host.effects->set_preset(other);
             }},
            {"clips",
             [&host, tuned](int run) {
                 Preset other = tuned(run);
                 if (run % 2 == 0) other.smoke.clips.pop_back();
                 host.effects->set_preset(other);
             }},
            {"shape", moved},
            {"organ", [&host](int) { host.show_organ(); }, [&host] { host.prepare(); }}};
}

/// Of the current context. Not counted: shaders, which a program does not keep, fences, and names above 4095.
int live_objects() {
    int live = 0;
    for (GLuint name = 1; name < 4096; ++name)
        live += glIsBuffer(name) + glIsTexture(name) + glIsFramebuffer(name) + glIsVertexArray(name) +
                glIsProgram(name) + glIsQuery(name) + glIsSampler(name) + glIsRenderbuffer(name);
    return live;
}

int threads() {
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return static_cast<int>(std::distance(begin(tasks), end(tasks)));
}

BenchRow row_of(const MemoryUse& use, int objects, int threads_more) {
    const auto mb = [](std::size_t bytes) { return static_cast<double>(bytes) / 1e6; };
    return {.of = {{"what", "the sample scene in a host"}},
            .measured = {{"memory_mb", mb(use.total())},
                         {"memory_surface_mb", mb(use.surface)},
                         {"memory_pixels_mb", mb(use.pixels)},
                         {"memory_densities_mb", mb(use.densities)},
                         {"memory_geometry_mb", mb(use.geometry)},
                         {"memory_textures_mb", mb(use.textures)},
                         {"memory_clips_mb", mb(use.clips)},
                         {"memory_targets_mb", mb(use.targets)},
                         {"gl_objects", objects},
                         {"threads", threads_more}}};
}

}  // namespace

void measure_changes(const HostFrame& target, BenchReport& report, bool short_form) {
    const Extent& extent = short_form ? least : whole;
    const int objects_before = live_objects(), threads_before = threads();
    Host host(target, extent.size);
    for (int i = 0; i < extent.frames; ++i) host.frame_ms();
    report.rows.push_back(
        row_of(host.effects->memory_use(), live_objects() - objects_before, threads() - threads_before));
    const std::vector<Change> all = changes(host);
    Progress progress("measuring changes", static_cast<int>(all.size()) * extent.runs);
    for (const Change& change : all) {
        std::vector<double> with, without;
        for (int run = 0; run < extent.runs; ++run) {
            change.before();
            const double first = host.frame_ms(), second = host.frame_ms();
            without.push_back(std::max(first, second));
            const double changed = host.frame_ms([&] { change.make(run); }), after = host.frame_ms();
            with.push_back(std::max(changed, after));
            progress.step();
        }
        const double beyond = median(with) - median(without);
        report.rows.push_back({.of = {{"what", "frame while this changes"}, {"change", change.name}},
                               .measured = {{"frame_ms", median(without)},
                                            {"changed_ms", median(with)},
                                            {"worst_ms", std::ranges::max(with)},
                                            {"beyond_ms", beyond}}});
        report.ratios["hitch_" + change.name + "_over_16ms"] = std::max(beyond, 0.0) / budget_ms;
    }
}

}  // namespace lapfx::commands
