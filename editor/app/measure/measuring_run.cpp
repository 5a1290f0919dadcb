#include "app/measure/measuring_run.h"

#include <condition_variable>
#include <mutex>
#include <utility>

#include "app/base/thread_work.h"

namespace lapfx::app {

struct MeasuringRun::Shared {
    using Made = std::shared_ptr<const match::MeasuredVideo>;

    Shared(std::filesystem::path of, match::MeasureOptions how, Jobs& all)
        : file(std::move(of)), options(std::move(how)), jobs(all) {
        options.measured = [this](const Image&, const match::Estimator* estimator, const match::FrameAmounts& amounts) {
            CountedFrames::Frame packed = CountedFrames::pack(estimator, amounts);
            const std::lock_guard lock(mutex);
            frames.push_back(amounts);
            counted.push_back(std::move(packed));
        };
        // It decodes by itself: it walks the whole film, while the feed of the reference follows the timeline.
        const auto find = [this](Job& own) -> std::optional<Made> {
            const auto goes_on = [this, &own](double done) { return reach(own, done); };
            if (!goes_on(0)) return std::nullopt;
            return std::make_shared<const match::MeasuredVideo>(
                match::measure_video(file, {.options = options, .colors_over_time = true}, goes_on, &own.stop()));
        };
        work.start(find, {.ended = [this] { close(); }, .given_up = [this] { notify(); }});
    }

    Made made() const { return work.result().value_or(nullptr); }

    /// Rests here while it is not wanted; false: it has to end.
    bool reach(Job& own, double done) {
        std::unique_lock lock(mutex);
        own.set_progress(done);
        if (job) job->set_progress(done);
        while (!own.cancelled() && (!job || job->cancelled())) {
            if (const std::shared_ptr<Job> before = std::exchange(job, nullptr)) {
                lock.unlock();
                jobs.close(before, {});
                lock.lock();
                continue;  // another one may have come
            }
            changed.wait(lock);
        }
        return !own.cancelled();
    }

    /// The job that it ends with.
    void close() {
        std::unique_lock lock(mutex);
        const std::shared_ptr<Job> last = std::exchange(job, nullptr);
        lock.unlock();
        if (last) jobs.close(last, {});
    }
    void notify() {
        { const std::lock_guard lock(mutex); }  // it does not begin to wait meanwhile
        changed.notify_all();
    }

    const std::filesystem::path file;
    match::MeasureOptions options;
    Jobs& jobs;
    mutable std::mutex mutex;
    std::condition_variable changed;
    std::shared_ptr<Job> job;  ///< null: it rests
    std::vector<match::FrameAmounts> frames;
    std::vector<CountedFrames::Frame> counted;
    ThreadWork<Made> work;  // last: it uses all of the others
};

MeasuringRun::MeasuringRun(std::filesystem::path file, match::MeasureOptions options, Jobs& jobs)
    : shared_(std::make_unique<Shared>(std::move(file), std::move(options), jobs)) {}
MeasuringRun::~MeasuringRun() = default;

void MeasuringRun::go_on(std::shared_ptr<Job> job) {
    std::unique_lock lock(shared_->mutex);
    const std::shared_ptr<Job> before = std::exchange(shared_->job, job);
    lock.unlock();
    if (before) shared_->jobs.close(before, {});
    if (ended()) shared_->jobs.close(job, {});
    shared_->changed.notify_all();
}

double MeasuringRun::progress() const {
    return shared_->work.progress();
}

void MeasuringRun::take(std::vector<match::FrameAmounts>& frames, CountedFrames& counted) {
    const std::lock_guard lock(shared_->mutex);
    frames.insert(frames.end(), shared_->frames.begin(), shared_->frames.end());
    shared_->frames.clear();
    for (CountedFrames::Frame& frame : shared_->counted) counted.add(std::move(frame));
    shared_->counted.clear();
}

bool MeasuringRun::ended() const {
    return shared_->work.ended();
}

std::shared_ptr<const match::Measurement> MeasuringRun::found() const {
    const Shared::Made made = shared_->made();
    return made ? std::shared_ptr<const match::Measurement>(made, &made->found) : nullptr;
}

std::shared_ptr<const match::ColorsOverTime> MeasuringRun::colors() const {
    const Shared::Made made = shared_->made();
    return made ? made->colors_over_time : nullptr;
}

std::vector<Fault> MeasuringRun::faults() const {
    return shared_->work.faults();
}

}  // namespace lapfx::app
