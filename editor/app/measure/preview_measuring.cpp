#include "app/measure/preview_measuring.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <opencv2/core.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "app/base/jobs.h"
#include "app/measure/drawn_curve.h"
#include "app/measure/measuring.h"
#include "app/preview/preview_host.h"
#include "app/preview/scene_pace.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/compare.h"
#include "match/picture/view.h"
#include "match/use/measure_video.h"

namespace lapfx::app {

namespace {

constexpr double settled_after = 0.4;  // s without a change
constexpr double never = std::numeric_limits<double>::infinity();

/// Of what pictures are drawn: what the scene says about the reference concerns them as far as it is measured alike.
document::Content of_pictures(const document::Content& content) {
    document::Content of = content;
    const SceneReference& reference = content.scene.reference;
    of.scene.reference.marks = {}, of.scene.reference.loop = {}, of.scene.reference.placement = {};
    of.scene.reference.offset = 0, of.scene.reference.aspect = 0;
    of.scene.reference.regions.clear();
    of.scene.reference.measure = {};
    of.scene.reference.measure.blood = reference.measure.blood;
    of.scene.reference.measure.region = reference.measure.region;
    of.scene.reference.measure.parts = reference.measure.parts;
    if (!of.scene.plate.use) of.scene.reference.file.clear();
    of.scene.name.clear(), of.scene.preset.clear(), of.preset.name.clear();
    return of;
}

bool same_pictures(const document::Content& a, const document::Content& b) {
    return equal(scene_table(), &a.scene, &b.scene) && equal(preset_table(), &a.preset, &b.preset) &&
           a.scene.folder == b.scene.folder && a.preset.folder == b.preset.folder;
}

/// Evenly spread, and the end.
std::vector<double> times_of(double duration) {
    const auto count = static_cast<std::size_t>(std::ceil(duration / PreviewMeasuring::step - 1e-9));
    const std::size_t steps = std::clamp<std::size_t>(count, 1, PreviewMeasuring::most);
    std::vector<double> times;
    for (std::size_t i = 0; i <= steps; ++i)
        times.push_back(duration * static_cast<double>(i) / static_cast<double>(steps));
    return times;
}

}  // namespace

/// The measuring of one state of the document, by a thread beside that asks for each picture.
class PreviewMeasuring::Run {
  public:
    /// `beside`: else it is done at once, here. Throws Error then.
    Run(Wanted of, match::PreviewCurve& curve, RenderSteps& steps, Jobs& jobs, bool beside)
        : wanted(std::move(of)),
          curve_(curve),
          steps_(steps),
          jobs_(jobs),
          times_(times_of(wanted.content.scene.duration)) {
        const EstimatorOptions options = match::measure_options(wanted.content.scene.reference.measure).estimator;
        if (wanted.truth) part_ = match::wanted_part({wanted.size.x, wanted.size.y}, options.region, options.masks);
        curve_.set_options({.size = wanted.size, .estimator = options});
        if (beside)
            thread_ = std::thread([this] { work(); });
        else
            measure(), ended_ = true;
    }
    ~Run() {
        stopping_ = true;
        steps_.stop();
        if (thread_.joinable()) thread_.join();
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    const Wanted wanted;

    double progress() const { return progress_; }
    /// Adds what was measured since the last call.
    void take(std::vector<match::FrameAmounts>& frames, std::vector<TrueAmounts>& truths) {
        const std::lock_guard lock(mutex_);
        frames.insert(frames.end(), frames_.begin(), frames_.end());
        truths.insert(truths.end(), truths_.begin(), truths_.end());
        frames_.clear(), truths_.clear();
    }
    /// Once it is done.
    std::shared_ptr<const match::ColorsOverTime> colors() const { return colors_; }
    bool done() const {
        const std::lock_guard lock(mutex_);
        return ended_;
    }
    std::vector<Fault> faults() const {
        const std::lock_guard lock(mutex_);
        return faults_;
    }

  private:
    using EstimatorOptions = match::EstimatorOptions;

    void work() {
        std::vector<Fault> faults;
        try {
            measure();
        } catch (const Error& error) {
            faults = error.faults();
        } catch (const std::exception& error) {
            faults = {{.file = "", .place = "", .reason = error.what()}};
        }
        {
            const std::lock_guard lock(mutex_);
            faults_ = std::move(faults);
            ended_ = true;
        }
        jobs_.wake();
    }
    void measure() {
        match::CurveCalls calls;
        calls.progress = [this](double share) {
            progress_ = share;
            return !stopping_;
        };
        calls.measured = [this](const Image& frame, const match::Estimator* estimator,
                                const match::FrameAmounts& amounts) {
            colors_->add(frame, estimator, amounts);
            {
                const std::lock_guard lock(mutex_);
                frames_.push_back(amounts);
            }
            jobs_.wake();
        };
        if (wanted.truth)
            calls.drawn = [this](Preview& preview, double time) {
                TrueAmounts truth = true_amounts(time, preview.layers(time, wanted.size));
                const std::lock_guard lock(mutex_);
                truths_.push_back(truth);
            };
        curve_.measure(wanted.content.scene, wanted.content.preset, times_, calls);
    }
    /// Over the view without what the scene leaves out.
    TrueAmounts true_amounts(double time, Layers layers) const {
        for (std::size_t i = 0; i < layers.view.size(); ++i)
            if (part_.data[i] == 0) layers.view[i] = 0;
        const ShownAmounts shown = amounts_of(layers);
        return {.time = time, .blood = shown.blood, .veil = shown.veil};
    }

    match::PreviewCurve& curve_;
    RenderSteps& steps_;
    Jobs& jobs_;
    const std::vector<double> times_;
    const std::shared_ptr<match::ColorsOverTime> colors_ = std::make_shared<match::ColorsOverTime>();  // of the thread
    cv::Mat part_;  // of the picture, CV_8U, 255
    std::atomic<double> progress_ = 0;
    std::atomic<bool> stopping_ = false;
    mutable std::mutex mutex_;
    bool ended_ = false;
    std::vector<match::FrameAmounts> frames_;
    std::vector<TrueAmounts> truths_;
    std::vector<Fault> faults_;
    std::thread thread_;
};

PreviewMeasuring::PreviewMeasuring(const document::Document& document, const PreviewHost& preview,
                                   const Reference& reference, const ScenePace& pace, Jobs& jobs,
                                   const EditorOptions& options)
    : document_(document),
      host_(preview),
      reference_(reference),
      pace_(pace),
      jobs_(jobs),
      clip_folders_(options.clip_folders),
      exact_(options.exact),
      software_(options.software),
      begins_(options.measures_preview),
      measured_side_(options.measured_side) {}
PreviewMeasuring::~PreviewMeasuring() = default;

double PreviewMeasuring::progress() const {
    return run_ ? run_->progress() : 0;
}

bool PreviewMeasuring::wants_frame() const {
    if (run_) return steps_->waiting();
    return begins_ && stale();
}

std::size_t PreviewMeasuring::memory() const {
    return curve_ ? curve_->memory() : 0;
}

void PreviewMeasuring::stop() {
    drop_run();
    known_ = wanted_content_;
    stopped_ = true;
    ++version_;
}

void PreviewMeasuring::drop_run() {
    if (!run_) return;
    run_.reset();
    if (complete_) return;
    frames_.clear(), truths_.clear();  // they were the first ones of that run
    ++version_;
}

void PreviewMeasuring::fail(const std::vector<Fault>& faults) {
    run_.reset();
    frames_.clear(), truths_.clear();
    complete_ = false;
    faults_ = faults;
    known_ = asked_;
    ++version_;
}

/// In the aspect of the reference where there is one, as both are compared.
PreviewMeasuring::Wanted PreviewMeasuring::wanted_now() const {
    const VideoReader* const video = reference_.video();
    const glm::ivec2 size =
        video != nullptr ? match::preview_size(video->info().size, document_.scene().reference.aspect, measured_side_)
                         : match::preview_size(Reference::largest_compared, 0.0, measured_side_);
    return {.content = document_.content(),
            .pictures = of_pictures(document_.content()),
            .size = size,
            .organ = host_.organ_version(),
            .truth = truth};
}

void PreviewMeasuring::update(double now) {
    due_ = never;
    if (!std::exchange(wanted_, false)) {  // nobody looks any more: what is known stays
        drop_run();
        curve_.reset();
        return;
    }
    follow(now);
    if (!run_) return;
    if (!exact_) draw(now);
    take();
}

/// Whether what was measured of `a` holds for `b`.
bool PreviewMeasuring::covers(const Wanted& a, const Wanted& b) {
    return a.size == b.size && (a.truth || !b.truth) && a.organ == b.organ && same_pictures(a.pictures, b.pictures);
}

void PreviewMeasuring::follow(double now) {
    const std::uint64_t organ = host_.organ_version();
    const bool same_shape = of_.organ == organ && of_.truth == truth && of_opened_.lock() == reference_.opened();
    if (wanted_content_ == 0 || followed_ != document_.version() || !same_shape) {
        Wanted wanted = wanted_now();
        const bool same = wanted_content_ != 0 && of_.truth == truth && covers(of_, wanted);
        followed_ = document_.version(), of_opened_ = reference_.opened();
        if (!same) {
            of_ = std::move(wanted);
            ++wanted_content_, changed_at_ = now, stopped_ = false;
            if (complete_ && covers(complete_of_, of_)) known_ = wanted_content_, faults_.clear();
        }
    }
    if (wanted_content_ == known_) return drop_run();
    if (run_ && asked_ == wanted_content_) return;
    drop_run();
    if (!begins_) return;
    if (now < changed_at_ + settled_after)
        due_ = changed_at_ + settled_after;
    else
        start(now);
}

/// False while the organ or the clips are still being loaded.
bool PreviewMeasuring::prepare() {
    const std::shared_ptr<const PreparedOrgan> organ = host_.organ_of(of_.content.scene);
    if (!organ || host_.loading()) {
        if (!host_.loading() && !host_.organ_faults().empty()) throw Error(Failure::bad_input, host_.organ_faults());
        return false;
    }
    steps_ = std::make_unique<RenderSteps>([this] { jobs_.wake(); });
    if (curve_ && curve_->organ() == organ) return true;
    curve_ = drawn_curve(organ, host_, clip_folders_, exact_ ? nullptr : &steps_);
    return true;
}

void PreviewMeasuring::start(double now) {
    asked_ = wanted_content_;
    faults_.clear();
    if (of_.content.scene.organ.file.empty()) {
        frames_.clear(), truths_.clear();
        complete_ = false, known_ = asked_, ++version_;
        return;
    }
    try {
        if (!prepare()) {
            due_ = now + look_again;
            return;
        }
        run_ = std::make_unique<Run>(of_, *curve_, *steps_, jobs_, !exact_);
    } catch (const Error& error) {
        fail(error.faults());
    }
}

void PreviewMeasuring::draw(double now) {
    if (software_ && pace_.touched(now)) {
        due_ = now + look_again;
        return;
    }
    steps_->serve(frame_budget);
    due_ = never;
}

void PreviewMeasuring::take() {
    const bool done = run_->done();
    if (std::vector<Fault> faults = run_->faults(); !faults.empty()) return fail(faults);
    if (complete_ && !done) return;  // what is known stays until it can be replaced as a whole
    if (complete_) frames_.clear(), truths_.clear();
    const std::size_t before = frames_.size();
    run_->take(frames_, truths_);
    if (frames_.size() != before || done) ++version_;
    if (!done) return;
    complete_ = true, complete_of_ = run_->wanted, colors_ = run_->colors();
    known_ = asked_;
    run_.reset();
}

}  // namespace lapfx::app
