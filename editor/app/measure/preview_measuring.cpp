#include "app/measure/preview_measuring.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <opencv2/core.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "app/base/jobs.h"
#include "app/measure/measuring.h"
#include "app/preview/preview_host.h"
#include "app/preview/scene_pace.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/preview.h"
#include "match/fit/preview_curve.h"
#include "match/view.h"

namespace lapfx::app {

namespace {

constexpr double settled_after = 0.4;                        // s without a change
constexpr double look_again = 0.05;                          // s
constexpr double frame_budget = 8e-3;                        // s of a frame for drawing; one picture is drawn anyway
constexpr std::size_t most_waiting = 4;                      // pictures that are drawn and not measured yet
constexpr std::size_t clip_memory = std::size_t{128} << 20;  // bytes: the clips of the preview are there already
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

struct Picture {
    enum Kind : std::uint8_t { baseline, survey, frame } kind = frame;
    double time = 0;
    Image image;
    std::optional<Layers> layers;
};

}  // namespace

/// The measuring of one state of the document: pictures go in, in their order, and amounts come out.
class PreviewMeasuring::Run {
  public:
    Run(Wanted of, Jobs& jobs, std::shared_ptr<Job> job)
        : wanted(std::move(of)), times(times_of(wanted.content.scene.duration)), jobs_(jobs), job_(std::move(job)) {
        options_ = measure_options(wanted.content.scene.reference.measure).estimator;
        const std::size_t surveyed = std::min<std::size_t>(match::surveyed_frames, times.size());
        for (std::size_t i = 0; i < surveyed; ++i)
            order_.push_back({Picture::survey, times[i * times.size() / surveyed]});
        for (const double time : times) order_.push_back({Picture::frame, time});
        if (job_) thread_ = std::thread([this] { work(); });
    }
    ~Run() {
        if (job_) job_->cancel();
        {
            const std::lock_guard lock(mutex_);
            stopping_ = true;
        }
        changed_.notify_all();
        if (thread_.joinable()) thread_.join();
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    const Wanted wanted;
    const std::vector<double> times;

    std::size_t drawn = 0;  ///< of pictures()
    std::size_t pictures() const { return order_.size(); }
    Picture next() const { return {order_[drawn].first, order_[drawn].second, {}, {}}; }
    bool all_drawn() const { return drawn == order_.size(); }
    bool has_room() const {
        const std::lock_guard lock(mutex_);
        return waiting_.size() < most_waiting;
    }
    /// Without a job, it is measured at once. Throws Error then.
    void add(Picture picture) {
        ++drawn;
        if (!job_) return measure(picture);
        {
            const std::lock_guard lock(mutex_);
            waiting_.push_back(std::move(picture));
        }
        changed_.notify_all();
    }
    double progress() const {
        const std::lock_guard lock(mutex_);
        return static_cast<double>(taken_) / static_cast<double>(order_.size());
    }
    /// Adds what was measured since the last call.
    void take(std::vector<match::FrameAmounts>& frames, std::vector<TrueAmounts>& truths) {
        const std::lock_guard lock(mutex_);
        frames.insert(frames.end(), frames_.begin(), frames_.end());
        truths.insert(truths.end(), truths_.begin(), truths_.end());
        frames_.clear(), truths_.clear();
    }
    bool done() const {
        const std::lock_guard lock(mutex_);
        return ended_;
    }
    std::vector<Fault> faults() const {
        const std::lock_guard lock(mutex_);
        return faults_;
    }

  private:
    void work() {
        try {
            for (std::size_t i = 0; i < order_.size(); ++i) {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [&] { return stopping_ || !waiting_.empty() || job_->cancelled(); });
                if (stopping_ || job_->cancelled()) break;
                const Picture picture = std::move(waiting_.front());
                waiting_.pop_front();
                lock.unlock();
                measure(picture);
                job_->set_progress(progress());
                jobs_.wake();  // there is room for another picture
            }
        } catch (const Error& error) {
            const std::lock_guard lock(mutex_);
            faults_ = error.faults();
        } catch (const std::exception& error) {
            const std::lock_guard lock(mutex_);
            faults_ = {{.file = "", .place = "", .reason = error.what()}};
        }
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
        }
        jobs_.wake();
    }

    /// Over the view without what the scene leaves out.
    TrueAmounts true_amounts(double time, Layers layers) const {
        for (std::size_t i = 0; i < layers.view.size(); ++i)
            if (wanted_part_.data[i] == 0) layers.view[i] = 0;
        const ShownAmounts shown = amounts_of(layers);
        return {.time = time, .blood = shown.blood, .veil = shown.veil};
    }
    void measure(const Picture& picture) {
        std::optional<match::FrameAmounts> amounts;
        std::optional<TrueAmounts> truth;
        switch (picture.kind) {
            case Picture::baseline:
                wanted_part_ =
                    match::wanted_part({picture.image.width, picture.image.height}, options_.region, options_.masks);
                estimator_.emplace(picture.image, options_);
                break;
            case Picture::survey:
                estimator_->survey(picture.image);
                break;
            case Picture::frame:
                if (picture.time == times.front()) estimator_->forget();
                amounts = estimator_->measure(picture.image, picture.time);
                if (picture.layers) truth = true_amounts(picture.time, *picture.layers);
        }
        const std::lock_guard lock(mutex_);
        if (amounts) frames_.push_back(*amounts);
        if (truth) truths_.push_back(*truth);
        if (++taken_ == order_.size()) ended_ = true;
    }

    Jobs& jobs_;
    /// Null: nothing is done beside. It is not in the list of jobs, for it waits for frames of the UI; the panel shows
    /// its progress.
    const std::shared_ptr<Job> job_;
    match::EstimatorOptions options_;
    std::vector<std::pair<Picture::Kind, double>> order_{{Picture::baseline, 0.0}};
    // Of the one thread that measures:
    std::optional<match::Estimator> estimator_;
    cv::Mat wanted_part_;  // CV_8U, 255
    // Of both:
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Picture> waiting_;
    std::size_t taken_ = 0;
    bool stopping_ = false, ended_ = false;
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
      begins_(!options.exact || options.exact_scale >= 1) {}
PreviewMeasuring::~PreviewMeasuring() = default;

double PreviewMeasuring::progress() const {
    return run_ ? run_->progress() : 0;
}

bool PreviewMeasuring::wants_frame() const {
    if (run_) return !run_->all_drawn() && run_->has_room();
    return begins_ && stale();
}

std::size_t PreviewMeasuring::memory() const {
    return preview_ ? preview_->memory_use().clips + preview_->memory_use().targets : 0;
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
    const glm::ivec2 size = video != nullptr
                                ? match::preview_size(video->info().size, document_.scene().reference.aspect)
                                : match::preview_size(Reference::largest_compared);
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
        preview_.reset(), preview_organ_.reset();
        return;
    }
    follow(now);
    if (!run_) return;
    try {
        draw(now);
    } catch (const Error& error) {
        return fail(error.faults());
    }
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
    const Scene& scene = of_.content.scene;
    const std::shared_ptr<const PreparedOrgan> organ = host_.organ_of(scene);
    if (!organ || host_.loading()) {
        if (!host_.loading() && !host_.organ_faults().empty()) throw Error(Failure::bad_input, host_.organ_faults());
        return false;
    }
    Scene clear = scene;
    clear.events.clear();
    if (preview_ && preview_organ_ == organ && preview_->takes(clear)) {
        preview_->set_scene(clear);
        preview_->set_preset(of_.content.preset);
        return true;
    }
    preview_.reset();
    preview_ = std::make_unique<Preview>(clear, of_.content.preset, organ,
                                         PreviewOptions{.clip_folders = clip_folders_,
                                                        .wait_for_clips = true,
                                                        .streaming = {.memory = clip_memory},
                                                        .clip_cache = host_.clip_cache()});
    preview_organ_ = organ;
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
    } catch (const Error& error) {
        return fail(error.faults());
    }
    run_ = std::make_unique<Run>(of_, jobs_, exact_ ? nullptr : std::make_shared<Job>("Measuring the preview"));
}

/// The baseline is the scene before any tool has touched it.
void PreviewMeasuring::draw(double now) {
    if (software_ && !exact_ && pace_.touched(now)) {
        due_ = now + look_again;
        return;
    }
    const auto start = std::chrono::steady_clock::now();
    Run& run = *run_;
    while (!run.all_drawn() && run.has_room()) {
        Picture picture = run.next();
        if (run.drawn == 1) preview_->set_contacts(run.wanted.content.scene.events);
        picture.image = preview_->image(picture.time, run.wanted.size);
        if (run.wanted.truth && picture.kind == Picture::frame)
            picture.layers = preview_->layers(picture.time, run.wanted.size);
        run.add(std::move(picture));
        const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (!exact_ && spent > frame_budget) break;
    }
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
    complete_ = true, complete_of_ = run_->wanted;
    known_ = asked_;
    run_.reset();
}

}  // namespace lapfx::app
