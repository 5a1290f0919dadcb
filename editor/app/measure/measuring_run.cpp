#include "app/measure/measuring_run.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "app/base/jobs.h"
#include "lapfx/authoring/video.h"

namespace lapfx::app {

struct MeasuringRun::Shared {
    Shared(std::filesystem::path of, match::MeasureOptions how, Jobs& all)
        : file(std::move(of)), options(std::move(how)), jobs(all) {
        options.measured = [this](const Image&, const match::Estimator* estimator, const match::FrameAmounts& amounts) {
            CountedFrames::Frame packed = CountedFrames::pack(estimator, amounts);
            const std::lock_guard lock(mutex);
            frames.push_back(amounts);
            counted.push_back(std::move(packed));
        };
        thread = std::thread([this] { work(); });
    }

    void work() {
        if (!reach(0)) return;
        std::shared_ptr<const match::MeasuredVideo> made;
        std::vector<Fault> wrong;
        try {
            VideoReader video(file, &stopping);
            made = std::make_shared<const match::MeasuredVideo>(match::measure_video(
                video, {.options = options, .colors_over_time = true}, [this](double done) { return reach(done); }));
        } catch (const Error& error) {
            wrong = error.faults();
        } catch (const std::exception& error) {
            wrong = {{.file = "", .place = "", .reason = error.what()}};
        }
        std::unique_lock lock(mutex);
        found = std::move(made), faults = std::move(wrong);
        ended = true;
        const std::shared_ptr<Job> last = job;
        lock.unlock();
        if (last) jobs.close(last, {});
    }

    /// Rests here while it is not wanted; false: it has to end.
    bool reach(double done) {
        std::unique_lock lock(mutex);
        share = done;
        if (job) job->set_progress(done);
        while (!stopping && (!job || job->cancelled())) {
            if (const std::shared_ptr<Job> before = std::exchange(job, nullptr)) {
                lock.unlock();
                jobs.close(before, {});
                lock.lock();
                continue;  // another one may have come
            }
            changed.wait(lock);
        }
        return !stopping;
    }

    const std::filesystem::path file;
    match::MeasureOptions options;
    Jobs& jobs;
    std::atomic<bool> stopping = false;
    mutable std::mutex mutex;
    std::condition_variable changed;
    std::shared_ptr<Job> job;  ///< null: it rests
    double share = 0;
    std::vector<match::FrameAmounts> frames;
    std::vector<CountedFrames::Frame> counted;
    bool ended = false;
    std::shared_ptr<const match::MeasuredVideo> found;
    std::vector<Fault> faults;
    std::thread thread;
};

MeasuringRun::MeasuringRun(std::filesystem::path file, match::MeasureOptions options, Jobs& jobs)
    : shared_(std::make_unique<Shared>(std::move(file), std::move(options), jobs)) {}

MeasuringRun::~MeasuringRun() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->stopping = true;
    }
    shared_->changed.notify_all();
    shared_->thread.join();
    if (shared_->job) shared_->jobs.close(shared_->job, {});
}

void MeasuringRun::go_on(std::shared_ptr<Job> job) {
    std::unique_lock lock(shared_->mutex);
    const std::shared_ptr<Job> before = std::exchange(shared_->job, job);
    const bool ended = shared_->ended;
    lock.unlock();
    if (before) shared_->jobs.close(before, {});
    if (ended) shared_->jobs.close(job, {});
    shared_->changed.notify_all();
}

double MeasuringRun::progress() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->share;
}

void MeasuringRun::take(std::vector<match::FrameAmounts>& frames, CountedFrames& counted) {
    const std::lock_guard lock(shared_->mutex);
    frames.insert(frames.end(), shared_->frames.begin(), shared_->frames.end());
    shared_->frames.clear();
    for (CountedFrames::Frame& frame : shared_->counted) counted.add(std::move(frame));
    shared_->counted.clear();
}

bool MeasuringRun::ended() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->ended;
}

std::shared_ptr<const match::Measurement> MeasuringRun::found() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->found ? std::shared_ptr<const match::Measurement>(shared_->found, &shared_->found->found) : nullptr;
}

std::shared_ptr<const match::ColorsOverTime> MeasuringRun::colors() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->found ? shared_->found->colors_over_time : nullptr;
}

std::vector<Fault> MeasuringRun::faults() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->faults;
}

}  // namespace lapfx::app
