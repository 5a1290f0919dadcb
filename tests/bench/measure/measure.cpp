// lapfx bench measure: how far measured amounts are from the true ones, by class of picture.
//
// Method: 200 stills, each another view, and 20 clips, drawn at random from a seed (views.cpp): organ,
// its colour, camera, light, preset, wounds and burns; shift, gain, white balance, noise, compression
// (camera.cpp). --quick draws a tenth of them. With --over known veils and blood are laid over real clear frames as
// well (over.cpp), and with --labelled real frames are measured in which a person said where the blood is
// (labelled.cpp), also with their blood told by ten draws of strokes over one and over two of them (by_strokes.cpp).
// With --puffs real videos are measured whose onset, peak and end of smoke a person told by eye (puffs.cpp).
// The true amounts of renders come from their layers (Preview::layers), before noise and compression: blood is each
// pixel whose light blood changes by more than a tenth, veil the mean of 1 - transmission, both over the view without
// the instrument. Each picture is measured by the estimator with a clear picture of the same view as baseline, as
// `lapfx measure` does. Classes, bounds and figures: classes.cpp.
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "bench/benches.h"
#include "bench/measure/by_strokes.h"
#include "bench/measure/classes.h"
#include "bench/measure/each.h"
#include "bench/measure/labelled.h"
#include "bench/measure/over.h"
#include "bench/measure/puffs.h"
#include "bench/measure/renders.h"
#include "bench/measure/speed.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/video.h"
#include "match/video/measure.h"

namespace lapfx::bench {

namespace {

struct Extent {
    int stills, clips, pictures_of_clip, composites, timed_frames, draws;
};
constexpr Extent whole{200, 20, 40, 4, 200, 10}, quick{20, 3, 9, 2, 0, 10}, least{4, 1, 8, 2, 5, 1};

constexpr std::size_t longest_model = 1 << 20;  // bytes
constexpr double least_area = 0.005;            // of the view: of less blood the Dice is chance

/// Of the true and the found area, in the pixels of the estimator.
std::optional<double> dice_of(const KnownPicture& known, const match::Estimator& estimator) {
    if (known.blood < least_area) return {};
    cv::Mat truth;
    cv::resize(known.blood_area, truth, estimator.working_size(), 0, 0, cv::INTER_AREA);
    truth = truth > 127;
    const cv::Mat found = estimator.blood() & estimator.valid();
    const double both = cv::countNonZero(truth & found);
    return 2.0 * both / std::max(cv::countNonZero(truth) + cv::countNonZero(found), 1);
}

void measure_view(const KnownView& view, int index, const match::EstimatorOptions& options,
                  std::vector<MeasuredPicture>& pictures) {
    measure_each(
        view, options,
        [&](const KnownPicture& known, const match::Estimator& estimator, const match::FrameAmounts& measured) {
            pictures.push_back({.view = index,
                                .real = view.real,
                                .moves = view.moves,
                                .shifted = known.shifted,
                                .labelled = view.labelled,
                                .labels = view.labels,
                                .true_blood = known.blood,
                                .true_veil = known.veil,
                                .dice = dice_of(known, estimator),
                                .hazeness = match::hazeness_of(known.picture),
                                .measured = measured});
        });
}

/// Its label, in quotes: names of files may have commas.
std::string quoted(const MeasuredPicture& picture, const std::string& label) {
    const auto found = picture.labels.find(label);
    std::string text = "\"";
    for (const char c : found == picture.labels.end() ? std::string() : found->second)
        text += c == '"' ? "\"\"" : std::string(1, c);
    return text + "\"";
}

/// Keys of the classes that it is in, with one blank between them.
std::string classes_of(const MeasuredPicture& picture) {
    std::string keys;
    for (const PictureClass& row : picture_classes())
        if (row.holds(picture)) keys += (keys.empty() ? "" : " ") + std::string(row.key);
    return keys;
}

void write_frames(const std::string& file, const std::vector<MeasuredPicture>& pictures) {
    std::string text =
        "view,real,labelled,shifted,classes,organ,light,camera,operation,true_blood,blood,blood_low,blood_high,dice,"
        "true_veil,veil,veil_low,veil_high,hazeness,valid,likeness,rest,hidden,flags\n";
    for (const MeasuredPicture& p : pictures) {
        const match::FrameAmounts& m = p.measured;
        text += std::to_string(p.view) + (p.real ? ",1," : ",0,") + (p.labelled ? "1," : "0,") +
                (p.shifted ? "1," : "0,") + classes_of(p) + ",";
        for (const char* label : {"organ", "light", "camera", "operation"}) text += quoted(p, label) + ",";
        char line[320];
        std::snprintf(line, sizeof line, "%.5f,%.5f,%.5f,%.5f,", p.true_blood, m.blood.value, m.blood.low,
                      m.blood.high);
        text += line;
        if (p.dice) text += std::to_string(*p.dice);
        std::snprintf(line, sizeof line, ",%.5f,%.5f,%.5f,%.5f,%.4f,%.4f,%.4f,%.4f,%.4f,%u\n", p.true_veil,
                      m.veil.value, m.veil.low, m.veil.high, p.hazeness, m.valid, m.likeness, m.rest, m.hidden,
                      m.flags);
        text += line;
    }
    write_file(file, text);
}

/// Adds what was measured in pictures over real frames; says what was left out.
std::string measure_over(const BenchOptions& options, const match::EstimatorOptions& estimator, int composites,
                         std::vector<MeasuredPicture>& pictures) {
    commands::Progress progress("measuring over real frames", static_cast<int>(options.over.size()));
    OverCounts counts;
    int number = 0, index = 0;
    for (const std::string& file : options.over) {
        const auto seed = static_cast<std::uint32_t>(options.seed);
        for (const KnownView& view : known_over(file, seed, number, composites, counts))
            measure_view(view, index++, estimator, pictures);
        ++number;
        progress.step();
    }
    char text[240];
    std::snprintf(
        text, sizeof text,
        "%zu files; of %d baselines %d are not measurable, and nothing was laid over their frames; %d files have "
        "no frame 1 s later; %d frames cannot be read\n\n",
        options.over.size(), counts.views, counts.refused, counts.without_later, counts.missing);
    return text;
}

/// The same frames with their blood told by strokes over one of them, and over two.
void measure_by_strokes(const KnownView& view, int index, const BenchOptions& options,
                        match::EstimatorOptions estimator, int draws, std::vector<MeasuredPicture>& pictures) {
    for (const int frames : {1, 2})
        for (int draw = 0; draw < draws; ++draw) {
            Random random(static_cast<std::uint32_t>(options.seed), static_cast<std::uint32_t>(frames),
                          static_cast<std::uint32_t>(100 * index + draw));
            const PaintedView painted = painted_view(view, random, frames);
            if (!painted.blood) continue;
            estimator.painted_blood = painted.blood;
            const std::size_t before = pictures.size();
            measure_view(painted.view, index, estimator, pictures);
            for (std::size_t i = before; i < pictures.size(); ++i) pictures[i].by_strokes = frames;
        }
}

void measure_puffs(std::span<const KnownPuff> puffs, BenchReport& report) {
    commands::Progress progress("measuring puffs", static_cast<int>(puffs.size()));
    std::vector<MeasuredPuff> measured;
    for (const KnownPuff& puff : puffs) {
        measured.push_back(measured_puff(puff));
        progress.step();
    }
    add_puffs(report, measured);
}

/// Share of the bounds that are kept.
double met_of_all(const BenchReport& report) {
    double met = 0.0, all = 0.0;
    for (const BenchRow& row : report.rows)
        if (const auto found = row.measured.find("met"); found != row.measured.end()) met += found->second, all += 1.0;
    return met / std::max(all, 1.0);
}

}  // namespace

BenchReport bench_measure(const BenchOptions& options) {
    if (!options.pairs.empty()) return bench_measure_pairs(options);
    if (!options.learn.empty()) return bench_measure_learn(options);
    match::EstimatorOptions estimator;
    if (!options.model.empty())
        estimator.veil_model = std::make_shared<match::VeilModel>(
            match::VeilModel::read(read_file(options.model, longest_model), options.model));
    const Extent& extent = options.short_form ? least : options.quick ? quick : whole;
    for (const std::string& file : options.over)
        const VideoReader opened(file);  // those that cannot be read are told at once
    const std::vector<KnownView> labelled =
        options.labelled.empty() ? std::vector<KnownView>{} : known_labelled(options.labelled);
    const std::vector<KnownPuff> puffs = options.puffs.empty() ? std::vector<KnownPuff>{} : known_puffs(options.puffs);
    for (const KnownPuff& puff : puffs) const VideoReader opened(puff.video);
    const Context context = Context::create(Backend::automatic);
    std::vector<MeasuredPicture> pictures;
    KnownRenders renders(static_cast<std::uint32_t>(options.seed));
    {
        commands::Progress progress("rendering and measuring", extent.stills + extent.clips);
        for (int i = 0; i < extent.stills; ++i, progress.step()) measure_view(renders.still(i), i, estimator, pictures);
        for (int i = 0; i < extent.clips; ++i, progress.step())
            measure_view(renders.clip(i, extent.pictures_of_clip), extent.stills + i, estimator, pictures);
    }
    std::vector<MeasuredPicture> over;
    const std::string left_out = options.over.empty() ? "" : measure_over(options, estimator, extent.composites, over);
    for (int index = 0; const KnownView& view : labelled) {
        measure_view(view, index, estimator, over);
        measure_by_strokes(view, index++, options, estimator, extent.draws, over);
    }
    if (!options.frames.empty()) {
        std::vector<MeasuredPicture> all = pictures;
        all.insert(all.end(), over.begin(), over.end());
        write_frames(options.frames, all);
    }

    BenchReport report{.bench = "measure", .renderer = context.renderer(), .rows = {}, .ratios = {}, .table = {}};
    report.table = "seed " + std::to_string(options.seed) + "; shares of the view, 0 to 1\n\n";
    add_classes(report, pictures, false);
    if (!over.empty()) {
        report.table += left_out;
        add_classes(report, over, true);
    }
    if (!puffs.empty()) measure_puffs(puffs, report);
    report.ratios["classes_within_bounds"] = met_of_all(report);
    if (!options.quick) report.ratios["measure_over_playback_720x480"] = measure_over_playback(extent.timed_frames);
    return report;
}

}  // namespace lapfx::bench
