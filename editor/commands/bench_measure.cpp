// lapfx bench measure: how far measured amounts are from the true ones.
//
// Method: 200 stills, each another view, and 20 clips of 30 frames, drawn at random from a seed: organ, its colour,
// camera, light, preset, wounds and burns, noise of the camera, compression (bench_measure_renders.cpp). The true
// amounts come from the layers of the renders (Preview::layers), before noise and compression: blood is each pixel
// whose light blood changes by more than a tenth, veil the mean of 1 - transmission. Each picture is measured by the
// estimator with a clear picture of the same view as baseline, as `lapfx measure` does. Printed: mean absolute error,
// bias (measured minus true), correlation, and the share of intervals that hold the true amount (nine of ten should).
// Speed: the whole of `lapfx measure` (baseline, survey, each frame, all decoding) on one core, for the shipped
// reference at 720x480, over the time that playing it takes. It fails where not nearly all frames are measurable:
// frames that are refused cost less.
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "commands/bench.h"
#include "commands/bench_measure_renders.h"
#include "commands/progress.h"
#include "commands/scratch_folder.h"
#include "commands/session.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/estimator.h"
#include "match/measure.h"
#include "output/files.h"

namespace lapfx::commands {

namespace {

struct Extent {
    int stills, clips, frames_of_clip, timed_frames;
};
constexpr Extent whole{200, 20, 30, 200}, least{3, 1, 4, 5};

const cv::Size speed_size(720, 480);
constexpr int speed_rounds = 3;
constexpr double least_measurable = 0.9;

struct Pair {
    int view;
    bool of_clip;
    double true_blood, true_veil;
    match::FrameAmounts measured;
};

struct Figures {
    double error = 0.0, bias = 0.0, correlation = 0.0, coverage = 0.0, width = 0.0;
    std::size_t count = 0;
};

Figures figures_of(const std::vector<Pair>& pairs, double Pair::*truth, match::Amount match::FrameAmounts::*amount) {
    Figures f;
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (const Pair& pair : pairs) {
        const double was = pair.*truth;
        const match::Amount& is = pair.measured.*amount;
        f.error += std::abs(is.value - was);
        f.bias += is.value - was;
        f.coverage += was >= is.low - 1e-9 && was <= is.high + 1e-9 ? 1.0 : 0.0;
        f.width += is.high - is.low;
        x += was, y += is.value, xx += was * was, yy += is.value * is.value, xy += was * is.value;
        ++f.count;
    }
    const double n = std::max<double>(static_cast<double>(f.count), 1.0);
    for (double* sum : {&f.error, &f.bias, &f.coverage, &f.width}) *sum /= n;
    const double spread = std::sqrt(std::max(xx - x * x / n, 0.0) * std::max(yy - y * y / n, 0.0));
    f.correlation = spread > 0.0 ? (xy - x * y / n) / spread : 0.0;
    return f;
}

void measure_view(const KnownView& view, int index, bool of_clip, std::vector<Pair>& pairs) {
    match::Estimator estimator(view.baseline, {});
    const std::size_t count = view.frames.size();
    const std::size_t step = (count + match::surveyed_frames - 1) / match::surveyed_frames;
    for (std::size_t i = 0; i < count; i += step) estimator.survey(view.frames[i].picture);
    estimator.forget();
    double time = 0.0;
    for (const KnownFrame& frame : view.frames) {
        pairs.push_back({index, of_clip, frame.blood, frame.veil, estimator.measure(frame.picture, time)});
        time += 0.1;
    }
}

void add_rows(BenchReport& report, const std::vector<Pair>& pairs, const std::string& of) {
    const auto add = [&](const char* what, double Pair::*truth, match::Amount match::FrameAmounts::*amount,
                         const std::vector<Pair>& some, const std::string& where) {
        const Figures f = figures_of(some, truth, amount);
        if (f.count == 0) return;
        report.rows.push_back({.of = {{"amount", what}, {"pictures", where}},
                               .measured = {{"count", static_cast<double>(f.count)},
                                            {"mean_absolute_error", f.error},
                                            {"bias", f.bias},
                                            {"correlation", f.correlation},
                                            {"interval_coverage", f.coverage},
                                            {"interval_width", f.width}}});
        char line[160];
        std::snprintf(line, sizeof line, "%-6s %-22s %5zu  %7.4f  %+8.4f  %7.3f  %9.3f  %8.3f\n", what, where.c_str(),
                      f.count, f.error, f.bias, f.correlation, f.coverage, f.width);
        report.table += line;
    };
    add("blood", &Pair::true_blood, &match::FrameAmounts::blood, pairs, of);
    add("veil", &Pair::true_veil, &match::FrameAmounts::veil, pairs, of);
    if (of != "all") return;
    for (const auto& [low, high, name] :
         {std::tuple{0.0, 0.2, "veil below 0.2"}, {0.2, 0.5, "veil 0.2 to 0.5"}, {0.5, 1.01, "veil above 0.5"}}) {
        std::vector<Pair> some;
        std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(some),
                     [low, high](const Pair& p) { return p.true_veil >= low && p.true_veil < high; });
        add("blood", &Pair::true_blood, &match::FrameAmounts::blood, some, name);
        add("veil", &Pair::true_veil, &match::FrameAmounts::veil, some, name);
    }
}

void write_frames(const std::string& file, const std::vector<Pair>& pairs) {
    std::string text =
        "view,clip,true_blood,blood,blood_low,blood_high,true_veil,veil,veil_low,veil_high,valid,likeness,rest,"
        "hidden,flags\n";
    for (const Pair& p : pairs) {
        const match::FrameAmounts& m = p.measured;
        char line[320];
        std::snprintf(line, sizeof line, "%d,%d,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.4f,%.4f,%.4f,%.4f,%u\n",
                      p.view, p.of_clip ? 1 : 0, p.true_blood, m.blood.value, m.blood.low, m.blood.high, p.true_veil,
                      m.veil.value, m.veil.low, m.veil.high, m.valid, m.likeness, m.rest, m.hidden, m.flags);
        text += line;
    }
    write_file(file, text);
}

/// This thread, those that it starts and OpenCV's work run on one core, until this goes.
class OneCore {
  public:
    OneCore() : threads_(cv::getNumThreads()) {
        cv::setNumThreads(1);
        sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(std::max(sched_getcpu(), 0), &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~OneCore() {
        sched_setaffinity(0, sizeof before_, &before_);
        cv::setNumThreads(threads_);
    }
    OneCore(const OneCore&) = delete;
    OneCore& operator=(const OneCore&) = delete;

  private:
    int threads_;
    cpu_set_t before_{};
};

/// Its first frames at 720x480.
void write_speed_clip(const std::filesystem::path& file, int frames) {
    VideoReader reader(data_folder() / "samples/reference/operation.mp4");
    output::VideoFile video(file, reader.info().frames_per_second, speed_size);
    Image image;
    cv::Mat scaled;
    for (int i = 0; i < std::min(frames, reader.info().frames); ++i) {
        reader.read(i, image);
        cv::resize(cv::Mat(image.height, image.width, CV_8UC4, image.pixels.data()), scaled, speed_size, 0, 0,
                   cv::INTER_AREA);
        video.add(
            {.width = scaled.cols, .height = scaled.rows, .pixels = {scaled.datastart, scaled.dataend}, .name = ""});
    }
    video.finish();
}

/// Seconds that measuring the whole video takes, over the seconds that playing it takes.
double over_playback(int frames) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "speed.mp4";
    write_speed_clip(file, frames);
    const OneCore one;
    double best = 1e30, plays = 1.0;
    for (int round = 0; round < speed_rounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        VideoReader video(file);
        const match::Measurement found = match::measure(video, {});
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        plays = video.info().duration;
        const auto measurable = std::count_if(found.frames.begin(), found.frames.end(),
                                              [](const match::FrameAmounts& f) { return f.measurable(); });
        if (static_cast<double>(measurable) < least_measurable * static_cast<double>(found.frames.size()))
            throw Error(Failure::runtime,
                        Fault{.file = "",
                              .place = "measure_over_playback_720x480",
                              .reason = "only " + std::to_string(measurable) + " of " +
                                        std::to_string(found.frames.size()) + " frames of the clip are measurable"});
    }
    return best / plays;
}

}  // namespace

BenchReport bench_measure(const BenchOptions& options) {
    if (!options.pairs.empty()) return bench_measure_pairs(options);
    const Extent& extent = options.short_form ? least : whole;
    const Context context = Context::create(Backend::automatic);
    std::vector<Pair> stills, clips;
    KnownRenders renders(static_cast<std::uint32_t>(options.seed));
    {
        Progress progress("rendering and measuring", extent.stills + extent.clips);
        for (int i = 0; i < extent.stills; ++i, progress.step()) measure_view(renders.still(), i, false, stills);
        for (int i = 0; i < extent.clips; ++i, progress.step())
            measure_view(renders.clip(extent.frames_of_clip), i, true, clips);
    }
    std::vector<Pair> all = stills;
    all.insert(all.end(), clips.begin(), clips.end());
    if (!options.frames.empty()) write_frames(options.frames, all);

    BenchReport report{.bench = "measure", .renderer = context.renderer(), .rows = {}, .ratios = {}, .table = {}};
    report.table = "seed " + std::to_string(options.seed) + "; share of the view, 0 to 1\n\n" +
                   "amount pictures               count    error      bias     corr   coverage     width\n";
    add_rows(report, stills, "stills");
    add_rows(report, clips, "clips");
    add_rows(report, all, "all");
    report.ratios["measure_over_playback_720x480"] = over_playback(extent.timed_frames);
    return report;
}

}  // namespace lapfx::commands
