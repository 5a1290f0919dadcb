// lapfx bench frame: what smoke adds to a frame of the sample scene, how much a haptic thread is delayed, what the core
// and changes of preset, clips and organ cost a host (changes.cpp), and what the simulation costs without drawing
// (simulation/simulation.cpp).
//
// Method: the sample scene at 1280x1024 without smoke and with 15 clips 720x480 over the whole view, resident, in
// turns, medians; as its camera sees it, and from so far away that the scene without smoke costs 20 ms, or as little as
// it can. The 1 kHz thread sleeps until each millisecond and notes how late it wakes (99.9th percentile). In one case
// the core plays 15 clips and draws the sample organ at 640x512, 30 frames per second in real time if possible, and
// each sample touches: a stroke cuts, and its blood grows. In the other case threads only use the same share of the
// processor. They are as many as the core has: one that draws, one per processor that decodes, and with a software
// renderer one per processor that fills pixels. The cases take turns; the figures are medians, with half of the
// distance between the quartiles as spread. Haptic threads run at real-time priority if the system permits it (as root,
// or by RLIMIT_RTPRIO), and the ratio is theirs. The ratio of a thread of ordinary priority has another name, and is
// the only one if the system does not permit real time.
#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "bench/benches.h"
#include "bench/frame/changes.h"
#include "bench/simulation/simulation.h"
#include "bench/streaming/host.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "lapfx/authoring/preview.h"

namespace lapfx::bench {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::duration;

constexpr double frame_seconds = 1.0 / bench_clip_fps;
constexpr double light_scene_ms = 20.0;
constexpr double samples_from = 20.0;  // s: the scene's own events are over

struct Extent {
    int clips, frame_runs, haptic_runs;
    double haptic_seconds;
    glm::ivec2 size, haptic_size;
};
constexpr Extent whole{15, 9, 5, 4.0, {screen_width, screen_height}, {640, 512}},
    least{2, 1, 1, 0.2, {160, 128}, {80, 64}};
constexpr double no_blood_s = 600.0;  // then something is wrong: a busy machine is given all the time until some grows

double seconds_since(Clock::time_point start) {
    return duration<double>(Clock::now() - start).count();
}

/// CPU time of the process, s.
double process_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The sample scene with the bench's clips over the whole view.
struct Played {
    Played(const Extent& of, const BenchClips& clips)
        : extent(of), scene(load_scene(commands::data_folder() / "samples/lagb.scene.json")) {
        smoky = load_preset(commands::data_folder() / "presets/gastric_banding.json");
        smoky.smoke.clips = smoke_of(of.clips, clips).smoke.clips;
        smoky.folder = clips.folder();
        clear = smoky;
        clear.smoke.clips.clear();
        clear.smoke.haze.accumulation = 0.0;
        organ = prepare_organ(scene, smoky.vessels);
    }
    const Extent& extent;
    Scene scene;
    Preset smoky, clear;
    std::shared_ptr<const PreparedOrgan> organ;
};

/// A haptic thread that sends the place of its tool at 1 kHz: a stroke that cuts, forwards and backwards.
class HapticThread {
  public:
    /// Starts at once. `queue` may be null. `real_time`: at real-time priority, if that is allowed.
    HapticThread(ToolQueue* queue, const ToolContact& stroke, double seconds, bool real_time) : stroke_(stroke) {
        late_.reserve(static_cast<std::size_t>(2000.0 * seconds));
        thread_ = std::thread([this, queue, real_time] {
            if (real_time) become_real_time();
            work(queue);
        });
    }
    /// Whether this process may have such threads.
    static bool real_time_allowed() {
        bool allowed = false;
        std::thread([&allowed] { allowed = become_real_time(); }).join();
        return allowed;
    }
    ~HapticThread() {
        if (thread_.joinable()) finish();
    }
    HapticThread(const HapticThread&) = delete;
    HapticThread& operator=(const HapticThread&) = delete;

    /// Ends the thread. Gives the lateness that one wake in a thousand exceeds, s.
    double finish() {
        stop_ = true;
        thread_.join();
        std::sort(late_.begin(), late_.end());
        return late_.empty() ? 0.0 : late_[late_.size() * 999 / 1000];
    }

  private:
    static bool become_real_time() {
        sched_param priority{};
        priority.sched_priority = 1;
        return pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) == 0;
    }
    void work(ToolQueue* queue) {
        const auto start = Clock::now();
        auto next = start;
        while (!stop_ && late_.size() < late_.capacity()) {
            next += std::chrono::milliseconds(1);
            std::this_thread::sleep_until(next);
            const auto now = Clock::now();
            late_.push_back(duration<double>(now - next).count());
            if (queue) queue->push(sample_at(duration<double>(now - start).count()));
            // A missed millisecond is not made up for.
            while (next + std::chrono::milliseconds(1) < now) next += std::chrono::milliseconds(1);
        }
    }
    ToolSample sample_at(double seconds) const {
        const double share = 0.5 - 0.5 * std::cos(3.0 * seconds);
        return {.time = samples_from + seconds,
                .position = glm::mix(stroke_.position, stroke_.to, share),
                .touching = true,
                .action = ToolAction::cut};  // bleeds at once
    }

    const ToolContact stroke_;
    std::vector<double> late_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

/// Half of the distance between the quartiles.
double spread(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return 0.5 * (values[values.size() * 3 / 4] - values[values.size() / 4]);
}

struct Beside {
    double late = 0.0;   ///< s, 99.9th percentile
    double load = 0.0;   ///< processors in use
    double blood = 0.0;  ///< mm2 that the samples have made
};

Beside beside_the_core(const HostFrame& host, const Played& played, bool real_time) {
    Scene scene = played.scene;
    scene.events.erase(
        scene.events.begin());  // its stroke is that of the haptic thread; the scene's own blood and smoke exist
    Preview preview(scene, played.smoky, played.organ, {});
    preview.draw(samples_from, played.extent.haptic_size, host.framebuffer());
    const double before = preview.amounts().blood_area;
    HapticThread haptic(&preview.tool_queue(), played.scene.events.front(), played.extent.haptic_seconds, real_time);
    const double cpu = process_seconds();
    const auto start = Clock::now();
    auto next = start;
    const auto grown = [&] { return preview.amounts().blood_area - before; };
    while (seconds_since(start) < played.extent.haptic_seconds ||
           (grown() <= 0.0 && seconds_since(start) < no_blood_s)) {
        preview.draw(samples_from + seconds_since(start), played.extent.haptic_size, host.framebuffer());
        finish_drawing();
        next += std::chrono::duration_cast<Clock::duration>(duration<double>(frame_seconds));
        std::this_thread::sleep_until(next);
    }
    const double load = (process_seconds() - cpu) / seconds_since(start);
    return {.late = haptic.finish(), .load = load, .blood = grown()};
}

/// Threads that spin for a share of each frame and sleep for the rest; `load` is their sum.
Beside beside_a_load(double load, const Played& played, bool real_time) {
    const int threads = 1 + 2 * static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const double share = std::min(load / threads, 1.0);
    std::atomic<bool> stop{false};
    std::vector<std::thread> burners;
    const double cpu = process_seconds();
    const auto start = Clock::now();
    for (int i = 0; i < threads; ++i)
        burners.emplace_back([&stop, share] {
            auto next = Clock::now();
            while (!stop) {
                // Counts its own processor time, so that other processes do not reduce the load.
                const double begin = thread_seconds();
                while (thread_seconds() - begin < share * frame_seconds) {
                }
                next += std::chrono::duration_cast<Clock::duration>(duration<double>(frame_seconds));
                std::this_thread::sleep_until(next);
            }
        });
    const double seconds = played.extent.haptic_seconds;
    HapticThread haptic(nullptr, played.scene.events.front(), seconds, real_time);
    std::this_thread::sleep_for(duration<double>(seconds));
    const double late = haptic.finish();
    stop = true;
    for (std::thread& burner : burners) burner.join();
    return {.late = late, .load = (process_seconds() - cpu) / seconds_since(start)};
}

/// The ratio of the two latenesses.
double compare_haptics(const HostFrame& host, const Played& played, bool real_time, BenchReport& report,
                       commands::Progress& progress) {
    std::vector<double> with, without, loads, stand_in_loads, blood;
    for (int run = 0; run < played.extent.haptic_runs; ++run) {
        const Beside core = beside_the_core(host, played, real_time);
        const Beside load = beside_a_load(core.load, played, real_time);
        blood.push_back(core.blood);
        with.push_back(1e6 * core.late);
        without.push_back(1e6 * load.late);
        loads.push_back(core.load);
        stand_in_loads.push_back(load.load);
        progress.step();
    }
    const auto row = [&](const char* what, std::vector<double>& late, std::vector<double>& load) {
        report.rows.push_back(
            {.of = {{"what", what}, {"priority", real_time ? "real-time" : "ordinary"}},
             .measured = {{"late_us_p999", median(late)}, {"spread_us", spread(late)}, {"processors", median(load)}}});
    };
    row("1 kHz thread with the core", with, loads);
    report.rows.back().measured["blood_grown_mm2"] = median(blood);
    row("1 kHz thread with an equal load", without, stand_in_loads);
    return median(with) / median(without);
}

/// ms for a frame of the scene, each at another time, so that nothing can be reused.
double frame_ms(Preview& preview, int run, glm::ivec2 size, unsigned framebuffer) {
    const auto start = Clock::now();
    preview.draw(8.0 + run * frame_seconds, size, framebuffer);
    finish_drawing();
    return 1e3 * seconds_since(start);
}

/// The scene's camera, farther away until a frame costs no more than light_scene_ms, or the organ is a dot.
SceneCamera far_away(Preview& preview, const SceneCamera& near, glm::ivec2 size, unsigned framebuffer) {
    SceneCamera camera = near;
    for (int doubled = 1; doubled <= 6; ++doubled) {
        camera.eye = near.target + std::exp2(doubled) * (near.eye - near.target);
        preview.set_camera(camera);
        frame_ms(preview, doubled, size, framebuffer);
        if (frame_ms(preview, doubled, size, framebuffer) <= light_scene_ms) break;
    }
    return camera;
}

/// `name` of the ratio, and the scene as named in the rows.
void compare_frames(Preview& smoky, Preview& clear, const Extent& extent, const HostFrame& host,
                    const std::string& name, const std::string& scene, BenchReport& report,
                    commands::Progress& progress) {
    std::vector<double> with_ms, none_ms;
    for (int run = 0; run <= extent.frame_runs; ++run) {
        const double clear_ms = frame_ms(clear, run, extent.size, host.framebuffer()),
                     smoky_ms = frame_ms(smoky, run, extent.size, host.framebuffer());
        progress.step();
        if (run == 0) continue;  // makes its targets
        none_ms.push_back(clear_ms);
        with_ms.push_back(smoky_ms);
    }
    report.rows.push_back(
        {.of = {{"what", "frame without smoke, " + scene}}, .measured = {{"frame_ms", median(none_ms)}}});
    report.rows.push_back(
        {.of = {{"what", "frame with 15 clips, " + scene}}, .measured = {{"frame_ms", median(with_ms)}}});
    report.ratios[name] = median(with_ms) / median(none_ms);
}

void compare_frames(const HostFrame& host, const Played& played, BenchReport& report, commands::Progress& progress) {
    Preview smoky(played.scene, played.smoky, played.organ, {.clip_folders = {}, .wait_for_clips = true}),
        clear(played.scene, played.clear, played.organ, {});
    for (int i = 0; i <= bench_clip_frames; ++i)  // every clip is resident after these small frames
        smoky.draw(8.0 + i * frame_seconds, {64, 48}, host.framebuffer());
    compare_frames(smoky, clear, played.extent, host, "frame_15_over_0", "as the sample scene is", report, progress);
    const SceneCamera camera = far_away(clear, played.scene.camera, played.extent.size, host.framebuffer());
    smoky.set_camera(camera);
    compare_frames(smoky, clear, played.extent, host, "frame_15_over_0_light_scene", "from far away", report, progress);
}

}  // namespace

BenchReport bench_frame(const BenchOptions& options) {
    const Context context = Context::create(Backend::automatic);
    BenchReport report{.bench = "frame", .renderer = context.renderer(), .rows = {}, .ratios = {}, .table = {}};
    if (!options.changes) measure_simulation(report, options.short_form);
    if (options.simulation) return report;
    const HostFrame host;
    measure_changes(host, report, options.short_form);
    if (options.changes) return report;
    const Extent& extent = options.short_form ? least : whole;
    const BenchClips clips(extent.clips);
    const Played played(extent, clips);
    const bool real_time = HapticThread::real_time_allowed();
    commands::Progress progress("measuring", 2 * (extent.frame_runs + 1) + extent.haptic_runs * (real_time ? 2 : 1));
    compare_frames(host, played, report, progress);
    const double ordinary = compare_haptics(host, played, false, report, progress);
    report.ratios["haptic_lateness_with_over_without_ordinary"] = ordinary;
    report.ratios["haptic_lateness_with_over_without"] =
        real_time ? compare_haptics(host, played, true, report, progress) : ordinary;
    return report;
}

}  // namespace lapfx::bench
