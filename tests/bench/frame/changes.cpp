// Method: the sample scene with its preset, drawn by Effects and Frame as a host does, 30 frames a second of its own
// time; at 80x64, because what a change costs does not depend on the size and drawing varies. As many frames without a
// change as with one take turns; the slowest of them counts, because what a change left undone the next frames do, and
// the difference is taken turn by turn. Before a change everything that the headers let another thread do has been
// done: prepare_organ(), ClipCache::look_through().
#include "bench/frame/changes.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "bench/streaming/host.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/clip_cache.h"
#include "lapfx/effects.h"
#include "lapfx/frame.h"
#include "lapfx/prepared_organ.h"
#include "lapfx/scene.h"

namespace lapfx::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double budget_ms = 16.0, fps = 30.0;

struct Extent {
    glm::ivec2 size;
    int frames, runs;  // drawn before the first change; of each change
};
constexpr Extent whole{{80, 64}, 60, 11}, least{{80, 64}, 2, 1};

/// By the clock, and of the processor's time on the thread that draws.
struct FrameTime {
    double ms = 0.0, cpu_ms = 0.0;
};
FrameTime slower(FrameTime a, FrameTime b) {
    return {.ms = std::max(a.ms, b.ms), .cpu_ms = std::max(a.cpu_ms, b.cpu_ms)};
}

/// What a host has.
class Host {
  public:
    Host(const HostFrame& target, glm::ivec2 size)
        : preset(load_preset(commands::data_folder() / "presets/gastric_banding.json")),
          scene_(load_scene(commands::data_folder() / "samples/lagb.scene.json")),
          clips_(std::make_shared<ClipCache>()),
          target_(target),
          size_(size) {
        clips_->look_through(preset, commands::clip_folders());
        given_ = load_organ(scene_.folder / scene_.organ.file).positions.size();
        prepare();
        show_organ();
    }

    /// On the thread of the call; a host has one for it.
    void prepare() { organ_ = prepare_organ(scene_, preset.vessels); }
    /// The vertices that the organ's file has, mm: splitting puts others behind them.
    std::span<const glm::vec3> given() const { return std::span(organ_->organ().positions).first(given_); }
    /// The organ that was prepared last, as it is after the same events: in this Effects, or in one made for it.
    void set_organ() { effects->set_organ(organ_, scene_.events); }
    void show_organ() {
        effects.emplace(organ_, preset, EffectsOptions{.clip_folders = commands::clip_folders(), .clip_cache = clips_});
        effects->set_contacts(scene_.events);
    }
    FrameTime frame(int views = 1) {
        return frame([] {}, views);
    }
    /// The next frame, in which `change` is made first. `views`: how often it is drawn.
    FrameTime frame(const std::function<void()>& change, int views = 1) {
        const double cpu = thread_seconds();
        const auto start = Clock::now();
        change();
        effects->seek(time_ += 1.0 / fps);
        for (int i = 0; i < views; ++i) draw();
        finish_drawing();
        return {.ms = 1e3 * std::chrono::duration<double>(Clock::now() - start).count(),
                .cpu_ms = 1e3 * (thread_seconds() - cpu)};
    }

    Preset preset;
    std::optional<Effects> effects;

  private:
    void draw() {
        frame_.begin(size_);
        const View view = looking();
        effects->draw_organ(view);
        frame_.begin_smoke();
        effects->draw_smoke(view, frame_.depth());
        frame_.finish(target_.framebuffer());
    }
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
    std::size_t given_ = 0;
    Frame frame_;
    const HostFrame& target_;
    glm::ivec2 size_;
    double time_ = 4.0;  // s: the scene's tool burns, and there is smoke
};

/// In which a change may still have consequences: an organ that came in parts leaves a gone one in parts.
int frames_after(int coming) {
    return coming > 1 ? 20 : 2;
}

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
        const auto given = host.given();
        std::vector<glm::vec3> positions(given.begin(), given.end());
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
            {"organ", [&host](int) { host.set_organ(); }, [&host] { host.prepare(); }},
            {"effects", [&host](int) { host.show_organ(); }, [&host] { host.prepare(); }}};
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

/// The same views: of one update, and of an update each. In turns, CPU time of the thread that draws.
double two_views_over_two_frames(Host& host, int runs) {
    std::vector<double> one, two;
    for (int run = 0; run < runs; ++run) {
        two.push_back(host.frame().cpu_ms + host.frame().cpu_ms);
        one.push_back(host.frame(2).cpu_ms);
    }
    return median(one) / median(two);
}

}  // namespace

void measure_changes(const HostFrame& target, BenchReport& report, bool short_form) {
    const Extent& extent = short_form ? least : whole;
    const int objects_before = live_objects(), threads_before = threads();
    Host host(target, extent.size);
    for (int i = 0; i < extent.frames; ++i) host.frame();
    report.rows.push_back(
        row_of(host.effects->memory_use(), live_objects() - objects_before, threads() - threads_before));
    report.ratios["two_views_over_two_frames"] = two_views_over_two_frames(host, extent.frames);
    const std::vector<Change> all = changes(host);
    commands::Progress progress("measuring changes", static_cast<int>(all.size()) * extent.runs);
    for (const Change& change : all) {
        std::vector<double> with, without, beyond, cpu_beyond;
        for (int run = 0; run < extent.runs; ++run) {
            change.before();
            FrameTime slow = host.frame([&] { change.make(run); });
            int frames = 1;
            while (host.effects->organ_coming()) slow = slower(slow, host.frame()), ++frames;
            for (int i = 0, left = frames_after(frames); i < left; ++i) slow = slower(slow, host.frame()), ++frames;
            FrameTime still = host.frame();
            while (--frames > 0) still = slower(still, host.frame());
            without.push_back(still.ms);
            with.push_back(slow.ms);
            beyond.push_back(slow.ms - still.ms);
            cpu_beyond.push_back(slow.cpu_ms - still.cpu_ms);
            progress.step();
        }
        const double hitch = std::max(median(beyond), 0.0);
        report.rows.push_back({.of = {{"what", "frame while this changes"}, {"change", change.name}},
                               .measured = {{"frame_ms", median(without)},
                                            {"changed_ms", median(with)},
                                            {"worst_ms", std::ranges::max(with)},
                                            {"hitch_ms", hitch},
                                            {"worst_hitch_ms", std::ranges::max(beyond)},
                                            {"hitch_cpu_ms", median(cpu_beyond)},
                                            {"worst_hitch_cpu_ms", std::ranges::max(cpu_beyond)}}});
        report.ratios["hitch_" + change.name + "_over_16ms"] = hitch / budget_ms;
    }
}

}  // namespace lapfx::bench
