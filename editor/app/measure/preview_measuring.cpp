#include "app/measure/preview_measuring.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "app/base/thread_work.h"
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
        measure(*scene_table().find("reference")->find("measure"),
                {"baseline", "from", "to", "without_blood", "strokes"});
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
    using Colors = std::shared_ptr<const match::ColorsOverTime>;

    /// `beside`: else it is done at once, here.
    Run(std::shared_ptr<const Subject> subject, match::PreviewCurve& curve, RenderSteps& steps, Jobs& jobs, bool beside)
        : of(std::move(subject)), curve_(curve), jobs_(jobs), times_(times_of(of->content.scene.duration)) {
        const EstimatorOptions options = match::measure_options(of->content.scene.reference.measure).estimator;
        if (of->truth) part_ = match::wanted_part({of->size.x, of->size.y}, options.region, options.masks);
        curve_.set_options({.size = of->size, .measured = of->measured, .estimator = options});
        curve_.count_plate_by(of->plate_blood);
        work_.start([this](Job& job) { return measure(job); },
                    {.ended = [&jobs] { jobs.wake(); }, .given_up = [&steps] { steps.stop(); }}, beside);
    }

    const std::shared_ptr<const Subject> of;

    double progress() const { return work_.progress(); }
    /// Adds what was measured since the last call.
    void take(std::vector<match::FrameAmounts>& frames, std::vector<TrueAmounts>& truths) {
        const std::lock_guard lock(mutex_);
        frames.insert(frames.end(), frames_.begin(), frames_.end());
        truths.insert(truths.end(), truths_.begin(), truths_.end());
        frames_.clear(), truths_.clear();
    }
    /// Once it is done.
    const Colors& colors() const { return *work_.result(); }
    bool done() const { return work_.ended(); }
    std::vector<Fault> faults() const { return work_.faults(); }

  private:
    using EstimatorOptions = match::EstimatorOptions;

    std::optional<Colors> measure(Job& job) {
        const auto colors = std::make_shared<match::ColorsOverTime>();
        match::CurveCalls calls;
        calls.progress = [&job](double share) {
            job.set_progress(share);
            return !job.cancelled();
        };
        calls.measured = [&, this](const Image& frame, const match::Estimator* estimator,
                                   const match::FrameAmounts& amounts) {
            colors->add(frame, estimator, amounts);
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
        return colors;
    }
    /// Over the view without what the scene leaves out.
    TrueAmounts true_amounts(double time, Layers layers) const {
        for (std::size_t i = 0; i < layers.view.size(); ++i)
            if (part_.data[i] == 0) layers.view[i] = 0;
        const ShownAmounts shown = amounts_of(layers);
        return {.time = time, .blood = shown.blood, .veil = shown.veil};
    }

    match::PreviewCurve& curve_;
    Jobs& jobs_;
    const std::vector<double> times_;
    cv::Mat part_;  // of the picture, CV_8U, 255
    std::mutex mutex_;
    std::vector<match::FrameAmounts> frames_;
    std::vector<TrueAmounts> truths_;
    ThreadWork<Colors> work_;  // last: it uses all of the others
};

PreviewMeasuring::PreviewMeasuring(const document::Document& document, const PreviewHost& preview,
                                   const Reference& reference, const Measuring& measuring, const ScenePace& pace,
                                   Jobs& jobs, const EditorOptions& options)
    : document_(document),
      host_(preview),
      reference_(reference),
      measuring_(measuring),
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

void PreviewMeasuring::drop_known() {
    frames_.clear(), truths_.clear();
    complete_of_.reset();
    ++version_;
}

void PreviewMeasuring::forget() {
    run_.reset();
    drop_known();
    known_of_.reset();
    known_ = stopped_ = false;
    followed_ = 0;
    faults_.clear();
}

void PreviewMeasuring::fail(const std::vector<Fault>& faults) {
    known_of_ = run_ ? run_->of : subject();
    run_.reset();
    drop_known();
    faults_ = faults;
    known_ = true;
}

/// In the aspect of the reference where there is one, as both are compared.
match::PreviewCurve::Options PreviewMeasuring::shape() const {
    using match::PreviewCurve;
    const VideoReader* const video = reference_.video();
    return video != nullptr
               ? PreviewCurve::options_for(video->info().size, document_.scene().reference.aspect, {}, measured_side_)
               : PreviewCurve::options_for(ReferencePicture::without_video, 0.0, {}, measured_side_);
}

/// What is wanted now.
std::shared_ptr<const PreviewMeasuring::Subject> PreviewMeasuring::subject() const {
    const match::PreviewCurve::Options of = shape();
    return std::make_shared<const Subject>(Subject{.content = document_.content(),
                                                   .size = of.size,
                                                   .measured = of.measured,
                                                   .organ = host_.organ_version(),
                                                   .truth = truth,
                                                   .plate_blood = plate_blood()});
}

/// What is known of an earlier state of the strokes serves until they are measured anew.
std::shared_ptr<const match::PaintedBlood> PreviewMeasuring::plate_blood() const {
    const Scene& scene = document_.scene();
    if (!scene.plate.use || !match::paints_blood(scene.reference.measure)) return nullptr;
    const match::Measurement* const found = measuring_.found();
    return found != nullptr && measuring_.file() == reference_.file() ? match::painted_blood(*found) : nullptr;
}

/// Whether what was measured of it holds for what is wanted now.
bool PreviewMeasuring::holds(const std::shared_ptr<const Subject>& of) const {
    if (!of) return false;
    const match::PreviewCurve::Options now = shape();
    return of->size == now.size && of->measured == now.measured && (of->truth || !truth) &&
           of->organ == host_.organ_version() && of->plate_blood == plate_blood() &&
           same_pictures(of->content, document_.content());
}

/// Whether what is known was measured beside another reference than the scene's now.
bool PreviewMeasuring::other_reference() const {
    return complete_of_ && complete_of_->content.scene.reference.file != document_.scene().reference.file;
}

void PreviewMeasuring::update(double now) {
    due_ = Settling::never;
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
    const bool same_shape =
        organ_ == organ && truth_ == truth && plate_blood_ == plate_blood() && of_opened_.lock() == reference_.opened();
    if (followed_ != document_.version() || !same_shape) {
        const bool differs = !same_shape || document_.changes_since(followed_) != 0;
        followed_ = document_.version(), of_opened_ = reference_.opened(), organ_ = organ, plate_blood_ = plate_blood();
        const bool other_truth = std::exchange(truth_, truth) != truth;
        if (differs) take_change(now, other_truth);
    }
    if (known_) return drop_run();
    if (run_ || !begins_) return;
    if (settling_.due_at(now))
        start(now);
    else
        due_ = settling_.due();
}

/// Something may be another now: is what is known, or being measured, still of it?
void PreviewMeasuring::take_change(double now, bool other_truth) {
    if (!other_truth && holds(run_ ? run_->of : known_of_)) return;
    known_ = stopped_ = false;
    drop_run();
    known_of_.reset();
    settling_.change(now);
    if (!holds(complete_of_)) {
        // Beside another reference it would be taken for what is compared with that.
        if (other_reference()) drop_known();
        return;
    }
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
        drop_known();
        known_of_ = subject();
        known_ = true;
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
    due_ = Settling::never;
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
