// lapfx bench frame: what smoke adds to a frame of the sample scene, what a haptic thread notices of it all, and what
// happening costs without drawing (bench_simulation.cpp).
//
// Method: the sample scene at 1280x1024 without smoke and with 15 clips 720x480 over the whole view, resident, in
// turns, medians. The 1 kHz thread sleeps until each millisecond and notes how late it wakes (99.9th percentile); once
// beside the core that plays 15 clips at 30 frames per second in real time, once beside threads that do nothing but
// take the same share of the processor, as many as the core has at work beside it: the drawing one, and one for each
// processor that decodes and, with a renderer in software, one that fills pixels. In turns; medians, and half of the
// distance between the quartiles as spread. Haptic threads run at real-time priority where the system lets them (as
// root, or by RLIMIT_RTPRIO): then that is the ratio; that of a thread of ordinary priority has a name of its own, and
// is the only one where the system does not.
#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <memory>
#include <thread>

#include "commands/bench_host.h"
#include "commands/bench_simulation.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "lapfx/authoring/preview.h"

namespace lapfx::commands {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::duration;

constexpr int clip_count = 15, frame_runs = 9, haptic_runs = 5;
constexpr double haptic_seconds = 4.0;
constexpr double frame_seconds = 1.0 / bench_clip_fps;

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

/// CPU time of the calling thread, s.
double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A haptic thread: 1 kHz, sends where its tool is.
class HapticThread {
  public:
    /// Starts at once. `queue` may be null. `real_time`: at real-time priority, if that is allowed.
    HapticThread(ToolQueue* queue, bool real_time) {
        late_.reserve(static_cast<std::size_t>(2000.0 * haptic_seconds));
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

    /// Ends it: s of lateness that one wake in a thousand exceeds.
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
            if (queue) queue->push({.time = duration<double>(now - start).count(), .position = {0.0, 80.0, 0.0}});
            // Who has slept through a millisecond does not make up for it.
            while (next + std::chrono::milliseconds(1) < now) next += std::chrono::milliseconds(1);
        }
    }
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
    double late = 0.0;  ///< s, 99.9th percentile
    double load = 0.0;  ///< processors in use
};

Beside beside_the_core(const HostFrame& host, const BenchClips& clips, bool real_time) {
    Effects effects(triangle(), smoke_of(clip_count, clips), {});
    effects.set_contacts(burning());
    HapticThread haptic(&effects.tool_queue(), real_time);
    const double cpu = process_seconds();
    const auto start = Clock::now();
    auto next = start;
    while (seconds_since(start) < haptic_seconds) {
        effects.seek(20.0 + seconds_since(start));
        host.bind(1.0);
        effects.draw_smoke(looking_on(), host.depth());
        finish_drawing();
        next += std::chrono::duration_cast<Clock::duration>(duration<double>(frame_seconds));
        std::this_thread::sleep_until(next);
    }
    const double load = (process_seconds() - cpu) / seconds_since(start);
    return {.late = haptic.finish(), .load = load};
}

/// Threads that spin for a share of each frame and sleep for the rest; `load` is that of all together.
Beside beside_a_load(double load, bool real_time) {
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
                // Its own processor time: what others take from it does not make the load less.
                const double begin = thread_seconds();
                while (thread_seconds() - begin < share * frame_seconds) {
                }
                next += std::chrono::duration_cast<Clock::duration>(duration<double>(frame_seconds));
                std::this_thread::sleep_until(next);
            }
        });
    HapticThread haptic(nullptr, real_time);
    std::this_thread::sleep_for(duration<double>(haptic_seconds));
    const double late = haptic.finish();
    stop = true;
    for (std::thread& burner : burners) burner.join();
    return {.late = late, .load = (process_seconds() - cpu) / seconds_since(start)};
}

/// The ratio of the two latenesses.
double compare_haptics(const HostFrame& host, const BenchClips& clips, bool real_time, BenchReport& report,
                       Progress& progress) {
    std::vector<double> with, without, loads, stand_in_loads;
    for (int run = 0; run < haptic_runs; ++run) {
        const Beside core = beside_the_core(host, clips, real_time);
        const Beside load = beside_a_load(core.load, real_time);
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
    row("1 kHz thread with an equal load", without, stand_in_loads);
    return median(with) / median(without);
}

/// ms for a frame of the scene; another time each, so that nothing is as it was.
double frame_ms(Preview& preview, int run, unsigned framebuffer) {
    const auto start = Clock::now();
    preview.draw(8.0 + run * frame_seconds, {screen_width, screen_height}, framebuffer);
    finish_drawing();
    return 1e3 * seconds_since(start);
}

void compare_frames(const HostFrame& host, const BenchClips& clips, BenchReport& report, Progress& progress) {
    const std::filesystem::path data = data_folder();
    const Scene scene = load_scene(data / "samples/lagb.scene.json");
    Preset with = load_preset(data / "presets/gastric_banding.json");
    with.smoke.clips = smoke_of(clip_count, clips).smoke.clips;
    with.folder = clips.folder();
    Preset none = with;
    none.smoke.clips.clear();
    none.smoke.haze.accumulation = 0.0;
    Preview smoky(scene, with, {.clip_folders = {}, .wait_for_clips = true}), clear(scene, none, {});
    for (int i = 0; i <= bench_clip_frames; ++i)  // until every clip is resident; small
        smoky.draw(8.0 + i * frame_seconds, {64, 48}, host.framebuffer());
    std::vector<double> with_ms, none_ms;
    for (int run = 0; run <= frame_runs; ++run) {
        const double clear_ms = frame_ms(clear, run, host.framebuffer()),
                     smoky_ms = frame_ms(smoky, run, host.framebuffer());
        progress.step();
        if (run == 0) continue;  // makes its targets
        none_ms.push_back(clear_ms);
        with_ms.push_back(smoky_ms);
    }
    report.rows.push_back({.of = {{"what", "frame without smoke"}}, .measured = {{"frame_ms", median(none_ms)}}});
    report.rows.push_back({.of = {{"what", "frame with 15 clips"}}, .measured = {{"frame_ms", median(with_ms)}}});
    report.ratios["frame_15_over_0"] = median(with_ms) / median(none_ms);
}

}  // namespace

BenchReport bench_frame(const BenchOptions& options) {
    const Context context = Context::create(Backend::automatic);
    BenchReport report{.bench = "frame", .renderer = context.renderer(), .rows = {}, .ratios = {}, .table = {}};
    measure_simulation(report);
    if (options.simulation) return report;
    const BenchClips clips(clip_count);
    const HostFrame host;
    const bool real_time = HapticThread::real_time_allowed();
    Progress progress("measuring", frame_runs + 1 + haptic_runs * (real_time ? 2 : 1));
    compare_frames(host, clips, report, progress);
    const double ordinary = compare_haptics(host, clips, false, report, progress);
    report.ratios["haptic_lateness_with_over_without_ordinary"] = ordinary;
    report.ratios["haptic_lateness_with_over_without"] =
        real_time ? compare_haptics(host, clips, true, report, progress) : ordinary;
    return report;
}

}  // namespace lapfx::commands
