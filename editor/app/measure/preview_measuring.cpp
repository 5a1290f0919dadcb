#include "app/measure/preview_measuring.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
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

/// A table without some of its rows and tables.
struct Fewer {
    Fewer(const Table& of, std::initializer_list<std::string_view> left_out) : table(of) {
        const auto counts = [&](const auto& part) { return std::ranges::find(left_out, part.key) == left_out.end(); };
        std::ranges::copy_if(of.rows, std::back_inserter(rows), counts);
        std::ranges::copy_if(of.tables, std::back_inserter(tables), counts);
        table.rows = rows, table.tables = tables;
    }
    Fewer(const Fewer&) = delete;
    Fewer& operator=(const Fewer&) = delete;
    std::vector<Parameter> rows;
    std::vector<Table> tables;
    Table table;
};

/// Whether both are measured alike: what the scene says about the reference concerns them as far as that is done alike.
/// Nothing is copied.
bool same_pictures(const document::Content& a, const document::Content& b) {
    static const Fewer preset(preset_table(), {"name"}), scene(scene_table(), {"name", "preset", "reference"}),
        measure(*scene_table().find("reference")->find("measure"), {"baseline", "from", "to"});
    const SceneReference &left = a.scene.reference, &right = b.scene.reference;
    return equal(preset.table, &a.preset, &b.preset) && equal(scene.table, &a.scene, &b.scene) &&
           equal(measure.table, &left.measure, &right.measure) && (!a.scene.plate.use || left.file == right.file) &&
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
    Run(std::shared_ptr<const Subject> subject, match::PreviewCurve& curve, RenderSteps& steps, Jobs& jobs, bool beside)
        : of(std::move(subject)),
          curve_(curve),
          steps_(steps),
          jobs_(jobs),
          times_(times_of(of->content.scene.duration)) {
        const EstimatorOptions options = match::measure_options(of->content.scene.reference.measure).estimator;
        if (of->truth) part_ = match::wanted_part({of->size.x, of->size.y}, options.region, options.masks);
        curve_.set_options({.size = of->size, .estimator = options});
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

    const std::shared_ptr<const Subject> of;

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
        if (of->truth)
            calls.drawn = [this](Preview& preview, double time) {
                TrueAmounts truth = true_amounts(time, preview.layers(time, of->size));
                const std::lock_guard lock(mutex_);
                truths_.push_back(truth);
            };
        curve_.measure(of->content.scene, of->content.preset, times_, calls);
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
    known_of_ = run_ ? run_->of : subject();
    drop_run();
    known_ = stopped_ = true;
    ++version_;
}

void PreviewMeasuring::drop_run() {
    if (!run_) return;
    run_.reset();
    if (complete()) return;
    frames_.clear(), truths_.clear();  // they were the first ones of that run
    ++version_;
}

void PreviewMeasuring::fail(const std::vector<Fault>& faults) {
    known_of_ = run_ ? run_->of : subject();
    run_.reset();
    frames_.clear(), truths_.clear();
    complete_of_.reset();
    faults_ = faults;
    known_ = true;
    ++version_;
}

/// In the aspect of the reference where there is one, as both are compared.
glm::ivec2 PreviewMeasuring::size() const {
    const VideoReader* const video = reference_.video();
    return video != nullptr
               ? match::preview_size(video->info().size, document_.scene().reference.aspect, measured_side_)
               : match::preview_size(Reference::largest_compared, 0.0, measured_side_);
}

/// What is wanted now.
std::shared_ptr<const PreviewMeasuring::Subject> PreviewMeasuring::subject() const {
    return std::make_shared<const Subject>(
        Subject{.content = document_.content(), .size = size(), .organ = host_.organ_version(), .truth = truth});
}

/// Whether what was measured of it holds for what is wanted now.
bool PreviewMeasuring::holds(const std::shared_ptr<const Subject>& of) const {
    return of && of->size == size() && (of->truth || !truth) && of->organ == host_.organ_version() &&
           same_pictures(of->content, document_.content());
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

void PreviewMeasuring::follow(double now) {
    const std::uint64_t organ = host_.organ_version();
    const bool same_shape = organ_ == organ && truth_ == truth && of_opened_.lock() == reference_.opened();
    if (followed_ != document_.version() || !same_shape) {
        const bool differs = !same_shape || document_.changes_since(followed_) != 0;
        followed_ = document_.version(), of_opened_ = reference_.opened(), organ_ = organ;
        const bool other_truth = std::exchange(truth_, truth) != truth;
        if (differs) take_change(now, other_truth);
    }
    if (known_) return drop_run();
    if (run_ || !begins_) return;
    if (now < changed_at_ + settled_after)
        due_ = changed_at_ + settled_after;
    else
        start(now);
}

/// Something may be another now: is what is known, or being measured, still of it?
void PreviewMeasuring::take_change(double now, bool other_truth) {
    if (!other_truth && holds(run_ ? run_->of : known_of_)) return;
    known_ = stopped_ = false;
    drop_run();
    known_of_.reset();
    changed_at_ = now;
    if (!holds(complete_of_)) return;
    known_ = true, known_of_ = complete_of_;
    faults_.clear();
}

/// False while the organ or the clips are still being loaded.
bool PreviewMeasuring::prepare() {
    const std::shared_ptr<const PreparedOrgan> organ = host_.organ_of(document_.scene());
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
    faults_.clear();
    if (document_.scene().organ.file.empty()) {
        frames_.clear(), truths_.clear();
        complete_of_.reset(), known_of_ = subject();
        known_ = true, ++version_;
        return;
    }
    try {
        if (!prepare()) {
            due_ = now + look_again;
            return;
        }
        run_ = std::make_unique<Run>(subject(), *curve_, *steps_, jobs_, !exact_);
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
    if (complete() && !done) return;  // what is known stays until it can be replaced as a whole
    if (complete()) frames_.clear(), truths_.clear();
    const std::size_t before = frames_.size();
    run_->take(frames_, truths_);
    if (frames_.size() != before || done) ++version_;
    if (!done) return;
    complete_of_ = known_of_ = run_->of, colors_ = run_->colors();
    known_ = true;
    run_.reset();
}

}  // namespace lapfx::app
