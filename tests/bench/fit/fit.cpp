// lapfx bench fit: how well hidden presets are found again.
//
// Method: scenes are drawn at random from a seed (cases.cpp): one burn and one cut each, on some organ, with
// some camera and light. The hidden one is drawn at 6 frames per second and 320x256, noise and compression of a camera
// are laid over it (measure/camera.h), and it is measured as a video is. Two scenes are fitted to it, each from
// the shipped preset gastric_banding with tools that begin at other times: one with another organ, camera and light,
// and the hidden one itself under another light. First the proposal is made (match/fit/proposal.h), then the fit, with
// colours and exposure. Curves: true amounts (Preview::layers) of the fitted scene beside those of the hidden one, once
// a second, root mean square; and again over those times alone at which the reference is measurable. How far the
// measured reference itself is from its truth stands beside them. Parameters: those of the scene itself; the smoke rate
// b is the optical depth that a second of burning adds to what the camera sees, since presets show the same haze more
// or less densely. Intervals are those of the fit. --quick: the first four scenes, by turns from another view and
// from the same, from smaller pictures and at a third of the times. --bloodless: real
// videos in which nothing bleeds, as well (bloodless.h).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <span>

#include "bench/benches.h"
#include "bench/fit/bloodless.h"
#include "bench/fit/cases.h"
#include "bench/measure/camera.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "lapfx/amounts.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/clip_cache.h"
#include "match/frame/veil.h"
#include "match/scene/preview_curve.h"
#include "match/scene/view_share.h"
#include "match/use/fit_scene.h"
#include "match/video/episode.h"
#include "match/video/measure.h"
#include "match/video/peak_colors.h"
#include "output/files.h"

namespace lapfx::bench {

namespace {

constexpr std::uint32_t film_part = 41;  // of the random numbers (random.h)
constexpr double begins_at = 0.3;        // s: where tools of the fitted scene begin before the fit
constexpr int quick_cases = 4;

struct Drawing {
    glm::ivec2 size{320, 256};
    double rate = 6.0;        ///< frames per second of the reference
    double truth_step = 1.0;  ///< s between pictures whose true amounts are known
    int curve_side = match::preview_side;
    std::shared_ptr<ClipCache> clips = std::make_shared<ClipCache>();
    PreviewOptions options() const {
        return {.clip_folders = commands::clip_folders(), .wait_for_clips = true, .clip_cache = clips};
    }
    Preview preview(const CaseScene& scene) const {
        return Preview(scene.tuned.scene, scene.tuned.preset, scene.organ, options());
    }
};

/// A hidden scene as a camera leaves it, measured as a video is.
struct Filmed {
    std::vector<match::FrameAmounts> frames = {};
    match::PeakColors colors = {};
};
Filmed film(const CaseScene& hidden, Random random, const Drawing& drawing) {
    Preview preview = drawing.preview(hidden);
    const double noise = draw_noise(random);
    const auto picture = [&](double time) {
        cv::Mat bgr;
        output::to_bgr(preview.image(time, drawing.size), bgr);
        Image image = filmed(random, bgr, cv::Scalar::all(1.0), noise);
        compress(random, image);
        return image;
    };
    preview.set_contacts({});
    match::EstimatorOptions told = {};
    told.round_view = match::round_view_of(hidden.tuned.scene.camera, case_aspect);  // as with --view
    match::Estimator estimator(picture(0.0), told);
    preview.set_contacts(hidden.tuned.scene.events);
    const auto count = static_cast<int>(case_duration * drawing.rate);
    std::vector<Image> pictures;
    for (int i = 0; i < count; ++i) pictures.push_back(picture(i / drawing.rate));
    for (int i = 0; i < match::surveyed_frames; ++i)
        estimator.survey(pictures[static_cast<std::size_t>(i * count / match::surveyed_frames)]);
    estimator.forget();
    Filmed filmed;
    for (int i = 0; i < count; ++i) {
        const Image& shown = pictures[static_cast<std::size_t>(i)];
        filmed.frames.push_back(estimator.measure(shown, i / drawing.rate));
        filmed.colors.add(shown, &estimator, filmed.frames.back());
    }
    return filmed;
}

/// What a picture shows, exactly.
struct TrueAmounts : ShownAmounts {
    double plume = 0.0;  ///< how much of the veil stands out (match::standing_out)
};
std::vector<TrueAmounts> truth_of(const CaseScene& scene, const Drawing& drawing) {
    Preview preview = drawing.preview(scene);
    std::vector<TrueAmounts> truth;
    std::vector<float> sorted;
    for (double time = 0.0; time <= case_duration; time += drawing.truth_step) {
        Layers layers = preview.layers(time, drawing.size);
        const cv::Mat veil(drawing.size.y, drawing.size.x, CV_32F, layers.veil.data()),
            view(drawing.size.y, drawing.size.x, CV_8U, layers.view.data());
        truth.push_back({amounts_of(layers), match::standing_out(veil, view, sorted)});
    }
    return truth;
}

/// The mean of what stands out while a tool smokes.
double plume_of(const CaseScene& scene, const std::vector<TrueAmounts>& truth, double truth_step) {
    AmountsModel model(scene.organ, {.gravity = scene.tuned.scene.gravity});
    model.set(scene.tuned.preset, scene.tuned.scene.events, scene.tuned.scene.curves);
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        if (model.smoke_at(static_cast<double>(i) * truth_step).emission > 0.0) sum += truth[i].plume, count += 1.0;
    return count > 0.0 ? sum / count : 0.0;
}

double depth_of(const ShownAmounts& shown) {
    return -std::log1p(-std::min(shown.veil, 0.99));
}

ShownPeaks peaks_of(const std::vector<TrueAmounts>& truth) {
    ShownPeaks peaks;
    for (const ShownAmounts& shown : truth)
        peaks.depth = std::max(peaks.depth, depth_of(shown)), peaks.blood = std::max(peaks.blood, shown.blood);
    return peaks;
}

/// Optical depth of the veil over the core's haze: a preset's extinction and unevenness have a part in it, so that a
/// smoke rate says little without. Of when the plume is gone; nothing where there is no such time.
std::optional<double> haze_factor(const CaseScene& scene, const std::vector<TrueAmounts>& truth, double truth_step) {
    const document::Content& tuned = scene.tuned;
    AmountsModel model(scene.organ, {.gravity = tuned.scene.gravity});
    model.set(tuned.preset, tuned.scene.events, tuned.scene.curves);
    double clear_from = 0.0, both = 0.0, haze2 = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double time = static_cast<double>(i) * truth_step;
        const SmokeAmounts smoke = model.smoke_at(time);
        if (smoke.emission > 0.0) clear_from = time + tuned.preset.smoke.plume.fade_out + truth_step;
        if (time < clear_from || smoke.haze <= 0.0) continue;
        both += depth_of(truth[i]) * smoke.haze;
        haze2 += smoke.haze * smoke.haze;
    }
    return haze2 > 0.0 ? std::optional(both / haze2) : std::nullopt;
}

/// The frames of the reference at the times of truth_of(); null where there is none.
std::vector<const match::FrameAmounts*> frames_at(const Filmed& reference, const Drawing& drawing, std::size_t times) {
    std::vector<const match::FrameAmounts*> frames(times, nullptr);
    for (const match::FrameAmounts& frame : reference.frames) {
        const auto i = static_cast<std::size_t>(std::lround(frame.time / drawing.truth_step));
        const double away = std::abs(frame.time - static_cast<double>(i) * drawing.truth_step);
        if (i < times && away <= 0.5 / drawing.rate + 1e-9) frames[i] = &frame;
    }
    return frames;
}

/// At which of them the amount can be told.
std::vector<bool> told_at(std::span<const match::FrameAmounts* const> frames, match::Curve curve) {
    std::vector<bool> told;
    for (const match::FrameAmounts* frame : frames) told.push_back(frame != nullptr && measurable(*frame, curve));
    return told;
}

/// What was measured; 0 where there is no frame.
std::vector<TrueAmounts> measured_at(std::span<const match::FrameAmounts* const> frames) {
    std::vector<TrueAmounts> measured;
    for (const match::FrameAmounts* frame : frames) {
        TrueAmounts& at = measured.emplace_back();
        if (frame != nullptr) at.blood = frame->blood.value, at.veil = frame->veil.value;
    }
    return measured;
}

/// Over the times that count; nothing where none does.
std::optional<double> rms(const std::vector<TrueAmounts>& a, const std::vector<TrueAmounts>& b,
                          double ShownAmounts::*amount, const std::vector<bool>& counts) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (counts[i]) sum += (a[i].*amount - b[i].*amount) * (a[i].*amount - b[i].*amount), ++count;
    return count > 0 ? std::optional(std::sqrt(sum / count)) : std::nullopt;
}
double rms(const std::vector<TrueAmounts>& a, const std::vector<TrueAmounts>& b, double ShownAmounts::*amount) {
    return *rms(a, b, amount, std::vector<bool>(a.size(), true));
}

/// One fitted scene beside the hidden one.
struct Outcome {
    bool same_view = false;
    std::string hidden, fitted;  ///< organs
    double blood_rms = 0.0, veil_rms = 0.0, blood_before = 0.0, veil_before = 0.0;
    std::optional<double> blood_rms_told = {}, veil_rms_told = {};  ///< at times at which the reference is measurable
    std::optional<double> blood_off = {}, veil_off = {};  ///< of the measured reference itself, at those times
    ShownPeaks peaks;                                     ///< of the hidden scene
    SeenTruth truth, found;
    bool b_is_alike = false;  ///< smoke rates are as the camera sees them; else the haze never stands alone
    match::FitResult result;
    std::string burn_key, cut_key;  ///< of when its tools begin; empty: none of the kind works
    double seconds = 0.0;
};

/// What a fit takes.
struct Effort {
    std::uint32_t seed = 1;
    double step = 0.25;  ///< s between the times that are drawn
    int rounds = match::FitInput{}.rounds;
};

/// Of the first that works.
std::string time_key(const std::vector<ToolContact>& events, bool (*works)(const ToolContact&)) {
    std::string key;
    double first = 0.0;
    for (std::size_t i = 0; i < events.size(); ++i)
        if (works(events[i]) && (key.empty() || events[i].time < first))
            first = events[i].time, key = "events." + std::to_string(i) + ".time";
    return key;
}

Outcome fit_one(const CaseScene& hidden, CaseScene scene, const Filmed& reference,
                const std::vector<TrueAmounts>& hidden_truth, const Drawing& drawing, const Effort& effort) {
    for (ToolContact& event : scene.tuned.scene.events) event.time = begins_at;
    Outcome outcome;
    outcome.hidden = hidden.label, outcome.fitted = scene.label;
    outcome.truth = seen_truth(hidden.tuned, hidden.organ);
    outcome.peaks = peaks_of(hidden_truth);
    const std::vector<TrueAmounts> before = truth_of(scene, drawing);
    outcome.blood_before = rms(before, hidden_truth, &ShownAmounts::blood);
    outcome.veil_before = rms(before, hidden_truth, &ShownAmounts::veil);
    const auto began = std::chrono::steady_clock::now();
    const match::SceneFit fit{.start = scene.tuned,
                              .organ = scene.organ,
                              .keys = {match::usual_parameters.begin(), match::usual_parameters.end()},
                              .reference = reference.frames,
                              .to = case_duration,
                              .step = effort.step,
                              .aspect = case_aspect,
                              .seed = effort.seed,
                              .rounds = effort.rounds,
                              .colors = match::ColorsOfFit::match,
                              .reference_colors = reference.colors.at_peak()};
    match::PreviewCurve curve(scene.organ, drawing.options(),
                              {.size = match::preview_size(drawing.size, 0.0, drawing.curve_side)});
    outcome.result = *match::fit_scene(fit, curve).result;
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    scene.tuned = outcome.result.tuned;
    const std::vector<TrueAmounts> after = truth_of(scene, drawing);
    outcome.blood_rms = rms(after, hidden_truth, &ShownAmounts::blood);
    outcome.veil_rms = rms(after, hidden_truth, &ShownAmounts::veil);
    const std::vector<const match::FrameAmounts*> frames = frames_at(reference, drawing, hidden_truth.size());
    const std::vector<TrueAmounts> measured = measured_at(frames);
    const std::vector<bool> blood_told = told_at(frames, match::Curve::blood),
                            veil_told = told_at(frames, match::Curve::veil);
    outcome.blood_rms_told = rms(after, hidden_truth, &ShownAmounts::blood, blood_told);
    outcome.veil_rms_told = rms(after, hidden_truth, &ShownAmounts::veil, veil_told);
    outcome.blood_off = rms(measured, hidden_truth, &ShownAmounts::blood, blood_told);
    outcome.veil_off = rms(measured, hidden_truth, &ShownAmounts::veil, veil_told);
    outcome.found = seen_truth(scene.tuned, scene.organ);
    outcome.truth.plume = plume_of(hidden, hidden_truth, drawing.truth_step);
    outcome.found.plume = plume_of(scene, after, drawing.truth_step);
    const std::optional<double> true_factor = haze_factor(hidden, hidden_truth, drawing.truth_step),
                                factor = haze_factor(scene, after, drawing.truth_step);
    outcome.b_is_alike = true_factor && factor;
    if (outcome.b_is_alike) outcome.truth.smoke_rate *= *true_factor, outcome.found.smoke_rate *= *factor;
    const std::vector<ToolContact>& events = scene.tuned.scene.events;
    outcome.burn_key = time_key(events, [](const ToolContact& c) { return c.hot() && c.power > 0.0; });
    outcome.cut_key = time_key(events, [](const ToolContact& c) { return divides(c.action) && c.strength > 0.0; });
    return outcome;
}

double ratio(double found, double truth) {
    return truth > 0.0 ? found / truth : 0.0;
}

std::string line_of(const Outcome& o) {
    char text[480];
    std::snprintf(text, sizeof text,
                  "%-17s %-17s %s blood %.4f (%.4f, measured %.4f) veil %.4f (%.4f, measured %.4f) burn %+.2f s cut "
                  "%+.2f s b x%.2f w x%.2f pace "
                  "x%.2f extent x%.2f%s; clears %.1f s, peaks: depth %.2f, blood %.3f; %d curves %.0f s\n",
                  o.hidden.c_str(), o.fitted.c_str(), o.same_view ? "same " : "other", o.blood_rms, o.blood_before,
                  o.blood_off.value_or(-1.0), o.veil_rms, o.veil_before, o.veil_off.value_or(-1.0),
                  o.found.burn_start - o.truth.burn_start, o.found.cut_start - o.truth.cut_start,
                  ratio(o.found.smoke_rate, o.truth.smoke_rate), ratio(o.found.ventilation, o.truth.ventilation),
                  ratio(o.found.blood_pace, o.truth.blood_pace), ratio(o.found.blood_extent, o.truth.blood_extent),
                  o.truth.blood_stops ? "" : " (grows on)", o.truth.clears_for, o.peaks.depth, o.peaks.blood,
                  o.result.curves, o.seconds);
    return text;
}

/// What is known of one parameter, or of when a tool begins, in all outcomes of the same view.
struct Recovery {
    const char* name;
    const char* figure;  ///< its name in rows of figures
    const char* key;     ///< of the fitted parameter; null: `event` is
    std::string Outcome::*event;
    double SeenTruth::*value;
    bool as_ratio;          ///< errors are shares of the truth, else differences, s
    double median, ninety;  ///< bounds of its errors
};
constexpr Recovery recoveries[] = {
    {"smoke begins", "smoke_begins", nullptr, &Outcome::burn_key, &SeenTruth::burn_start, false, 0.2, 0.2},
    {"blood begins", "blood_begins", nullptr, &Outcome::cut_key, &SeenTruth::cut_start, false, 0.2, 0.2},
    {"b", "b", "smoke.haze.accumulation", nullptr, &SeenTruth::smoke_rate, true, 0.1, 0.2},
    {"ventilation", "ventilation", "smoke.haze.ventilation", nullptr, &SeenTruth::ventilation, true, 0.3, 0.3},
    {"plume", "plume", "smoke.plume.density", nullptr, &SeenTruth::plume, true, 0.3, 0.5},
    {"speed", "speed", "bleeding.speed", nullptr, &SeenTruth::blood_pace, true, 0.1, 0.2},
    {"max extent", "max_extent", "bleeding.max_extent", nullptr, &SeenTruth::blood_extent, true, 0.1, 0.2},
};

const match::FittedParameter* fitted_of(const Outcome& o, const Recovery& r) {
    const std::string key = r.event != nullptr ? o.*r.event : std::string(r.key);
    for (const match::FittedParameter& p : o.result.parameters)
        if (p.parameter.key == key) return &p;
    return nullptr;
}

/// Whether the fit says that it knows it.
bool told(const Outcome& o, const Recovery& r) {
    const match::FittedParameter* const p = fitted_of(o, r);
    return p != nullptr && p->determined && (r.value != &SeenTruth::smoke_rate || o.b_is_alike);
}

/// What the fit found of one parameter.
struct Found {
    bool told = false;      ///< the fit says that it knows it
    double error = 0.0;     ///< a share of the truth or a difference, as Recovery::as_ratio
    bool interval = false;  ///< there is one
    bool covered = false;   ///< it holds the truth
};
Found found_of(const Outcome& o, const Recovery& r) {
    Found result{.told = told(o, r)};
    const double truth = o.truth.*r.value, found = o.found.*r.value;
    result.error = r.as_ratio ? ratio(found, truth) - 1.0 : found - truth;
    const match::FittedParameter* const p = fitted_of(o, r);
    if (p == nullptr || found <= 0.0) return result;
    const double true_value = r.as_ratio ? p->after * truth / found : p->after + truth - found;
    result.interval = true, result.covered = p->low <= true_value && true_value <= p->high;
    return result;
}

BenchRow figures_of(const Outcome& o) {
    BenchRow row{.of = {{"hidden", o.hidden}, {"fitted", o.fitted}, {"view", o.same_view ? "same" : "other"}},
                 .measured = {{"blood_rms", o.blood_rms},
                              {"blood_rms_before", o.blood_before},
                              {"veil_rms", o.veil_rms},
                              {"veil_rms_before", o.veil_before},
                              {"peak_depth", o.peaks.depth},
                              {"peak_blood", o.peaks.blood},
                              {"curves", o.result.curves},
                              {"fit_s", o.seconds}}};
    if (o.blood_rms_told) row.measured["blood_rms_told"] = *o.blood_rms_told;
    if (o.veil_rms_told) row.measured["veil_rms_told"] = *o.veil_rms_told;
    if (o.blood_off) row.measured["blood_rms_of_measured"] = *o.blood_off;
    if (o.veil_off) row.measured["veil_rms_of_measured"] = *o.veil_off;
    for (const Recovery& r : recoveries) {
        const Found found = found_of(o, r);
        const std::string name = r.figure;
        row.measured[name + (r.as_ratio ? "_error" : "_late_s")] = found.error;
        row.measured[name + "_told"] = found.told;
        if (found.interval) row.measured[name + "_covered"] = found.covered;
    }
    return row;
}

double share_at(std::vector<double> errors, double share) {
    if (errors.empty()) return 0.0;
    std::sort(errors.begin(), errors.end());
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1) + 0.5)];
}

std::string row_of(const Recovery& r, const std::vector<Outcome>& outcomes) {
    std::vector<double> errors;
    int all = 0, covered = 0, with_interval = 0;
    for (const Outcome& o : outcomes) {
        if (!o.same_view) continue;
        ++all;
        const Found found = found_of(o, r);
        if (!found.told) continue;
        errors.push_back(std::abs(found.error));
        with_interval += found.interval ? 1 : 0, covered += found.covered ? 1 : 0;
    }
    char text[240];
    std::snprintf(text, sizeof text, "%-13s told %2d of %2d, error median %.3f (%.2f) 90 %% %.3f (%.2f)%s", r.name,
                  static_cast<int>(errors.size()), all, share_at(errors, 0.5), r.median, share_at(errors, 0.9),
                  r.ninety, r.as_ratio ? "" : " s");
    std::string row = text;
    if (with_interval > 0)
        row += ", interval holds it in " + std::to_string(covered) + " of " + std::to_string(with_interval);
    return row + '\n';
}

constexpr double close = 0.05;
bool is_close(const Outcome& o) {
    return o.blood_rms <= close && o.veil_rms <= close;
}
/// As far as the reference tells, which may be its clear beginning only: blood behind a veil above 40 % is hidden.
bool is_close_where_told(const Outcome& o) {
    return o.blood_rms_told && o.veil_rms_told && *o.blood_rms_told <= close && *o.veil_rms_told <= close;
}

/// Bounds stand behind the figures, in parentheses.
std::string summary(const std::vector<Outcome>& outcomes) {
    std::string text = "\n";
    for (const bool same_view : {false, true}) {
        int all = 0, near = 0, near_where_told = 0;
        std::vector<double> seconds;
        for (const Outcome& o : outcomes) {
            if (o.same_view != same_view) continue;
            ++all, near += is_close(o) ? 1 : 0, near_where_told += is_close_where_told(o) ? 1 : 0;
            seconds.push_back(o.seconds);
        }
        if (all == 0) continue;
        char line[240];
        std::snprintf(line, sizeof line,
                      "%s view: both curves within 0.05 RMS of the truth in %d of %d (9 of 10), at times at which the "
                      "reference is measurable in %d; %.0f s for each fit\n",
                      same_view ? "same" : "other", near, all, near_where_told, median(seconds));
        text += line;
    }
    if (std::none_of(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return o.same_view; })) return text;
    text += "Parameters, same view, where the fit says that it knows them:\n";
    for (const Recovery& r : recoveries) text += row_of(r, outcomes);
    return text;
}

/// How many cases are fitted, and how carefully.
struct Extent {
    int first = 0, end = commands::fit_cases;
    enum class Views : std::uint8_t { both, other, by_turns } views = Views::both;
    Drawing drawing = {};
    Effort effort = {};
    BloodlessEffort bloodless = {};

    bool fits(int number, bool same_view) const {
        return views == Views::both || same_view == (views == Views::by_turns && number % 2 == 1);
    }
    int fits() const { return (views == Views::both ? 2 : 1) * (end - first); }
};
Extent extent_of(const BenchOptions& options) {
    Extent extent{.first = std::min(options.first, commands::fit_cases) - 1,
                  .end = std::min(options.last, commands::fit_cases)};
    if (options.short_form)
        extent = {.end = 1,
                  .views = Extent::Views::other,
                  .drawing = {.size = {160, 128}, .rate = 1.0, .truth_step = 3.5, .curve_side = 64},
                  .effort = {.step = 3.5, .rounds = 1},
                  .bloodless = {.side = 64, .step = 2.0, .rounds = 1, .apart = 0.5}};
    if (options.quick)
        extent = {.end = quick_cases,
                  .views = Extent::Views::by_turns,
                  .drawing = {.size = {240, 192}, .rate = 2.0, .truth_step = 2.0, .curve_side = 128},
                  .effort = {.step = 0.7, .rounds = 3}};
    extent.effort.seed = extent.bloodless.seed = static_cast<std::uint32_t>(options.seed);
    return extent;
}

BenchRow figures_of(const BloodlessFit& fit) {
    BenchRow row{.of = {{"bloodless", fit.video}},
                 .measured = {{"fitted", fit.fitted},
                              {"left_alone", fit.left_alone},
                              {"most_blood", fit.most_blood},
                              {"blood_above_error_s", fit.above_error},
                              {"fit_s", fit.seconds}}};
    if (fit.veil_rms) row.measured["veil_rms"] = *fit.veil_rms;
    return row;
}

std::string line_of(const BloodlessFit& fit) {
    char text[160];
    std::snprintf(text, sizeof text, ": blood at most %.3f, above its error for %.2f s; %.0f s", fit.most_blood,
                  fit.above_error, fit.seconds);
    const char* const what = !fit.fitted ? ", not fitted" : fit.left_alone ? ", left alone" : ", CHANGED";
    return fit.video + what + text + (fit.why.empty() ? "" : "; " + fit.why) + '\n';
}

/// Adds rows, the share that leave bleeding alone, and a line that says so.
void fit_all_bloodless(const std::vector<std::string>& videos, const CaseScene& scene, const Extent& extent,
                       BenchReport& report) {
    if (videos.empty()) return;
    commands::Progress progress("fitting to videos without bleeding", static_cast<int>(videos.size()));
    int fitted = 0, left_alone = 0;
    for (const std::string& video : videos) {
        const BloodlessFit fit = fit_bloodless(video, scene, extent.drawing.options(), extent.bloodless);
        std::cout << line_of(fit) << std::flush;
        report.rows.push_back(figures_of(fit));
        fitted += fit.fitted ? 1 : 0, left_alone += fit.left_alone ? 1 : 0;
        progress.step();
    }
    report.table += "Videos without bleeding: it is left alone in " + std::to_string(left_alone) + " of " +
                    std::to_string(fitted) + " that are fitted (all), of " + std::to_string(videos.size()) + '\n';
    report.ratios["bleeding_left_alone"] = static_cast<double>(left_alone) / std::max(fitted, 1);
}

}  // namespace

BenchReport bench_fit(const BenchOptions& options) {
    if (options.last < options.first)
        throw commands::wrong_option(
            "--last", std::to_string(options.last) + " is before --first " + std::to_string(options.first));
    const Context context = Context::create(Backend::automatic);
    BenchReport report{.bench = "fit", .renderer = context.renderer(), .rows = {}, .ratios = {}, .table = {}};
    PreparedViews prepared;
    for (const std::string& video : options.bloodless)
        const VideoReader opened(video);  // those that cannot be read are told at once
    const Extent extent = extent_of(options);
    const Drawing& drawing = extent.drawing;
    const std::uint32_t seed = extent.effort.seed;
    std::vector<Outcome> outcomes;
    std::optional<CaseScene> any;  // that bleeds
    commands::Progress progress("fitting", extent.fits());
    for (int i = extent.first; i < extent.end; ++i) {
        std::vector<TrueAmounts> truth;  // of the scene that is drawn last, which is the hidden one
        FitCase drawn = draw_fit_case(seed, i, prepared, [&](const CaseScene& scene) {
            truth = truth_of(scene, drawing);
            return peaks_of(truth);
        });
        const Filmed reference = film(drawn.hidden, Random(seed, film_part, static_cast<std::uint32_t>(i)), drawing);
        for (const bool same_view : {false, true}) {
            if (!extent.fits(i, same_view)) continue;
            CaseScene scene = same_view ? drawn.hidden : drawn.fitted;
            if (same_view) {
                scene.tuned.scene.light.color = drawn.fitted.tuned.scene.light.color;
                scene.tuned.preset = drawn.fitted.tuned.preset;
                scene.tuned.preset.vessels = drawn.hidden.tuned.preset.vessels;
            }
            Outcome outcome = fit_one(drawn.hidden, scene, reference, truth, drawing, extent.effort);
            outcome.same_view = same_view;
            std::cout << i + 1 << ' ' << line_of(outcome) << std::flush;  // a whole run takes more than an hour
            report.rows.push_back(figures_of(outcome));
            outcomes.push_back(std::move(outcome));
            progress.step();
        }
        if (!any) any = std::move(drawn.fitted);
    }
    report.table = summary(outcomes);
    fit_all_bloodless(options.bloodless, *any, extent, report);
    const auto close = std::count_if(outcomes.begin(), outcomes.end(), is_close);
    report.ratios["curves_close"] = static_cast<double>(close) / static_cast<double>(outcomes.size());
    return report;
}

}  // namespace lapfx::bench
