// Long work beside the UI: files read, organs made ready, presets rendered. Each job has a name, a progress and can be
// cancelled; what comes of it is applied on the UI thread.
//
//     jobs.start("Loading stomach.glb", [=](Job& job) -> Jobs::Apply {
//         auto organ = std::make_shared<Organ>(load_organ(path));   // worker thread; what it throws is the job's fault
//         job.set_progress(0.5);
//         return [=, this] { show(*organ); };                        // UI thread, in Jobs::take()
//     });
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "lapfx/error.h"

namespace lapfx::app {

/// What a job's own thread sees of it.
class Job {
  public:
    explicit Job(std::string name) : name_(std::move(name)) {}
    const std::string& name() const { return name_; }
    /// 0..1; negative: nobody knows.
    double progress() const { return progress_.load(std::memory_order_relaxed); }
    void set_progress(double share) { progress_.store(share, std::memory_order_relaxed); }
    bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
    const std::atomic<bool>& stop() const { return cancelled_; }  ///< cancelled(), for what reads long files
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

  private:
    std::string name_;
    std::atomic<double> progress_ = -1;
    std::atomic<bool> cancelled_ = false;
};

class Jobs {
  public:
    using Apply = std::function<void()>;
    using Work = std::function<Apply(Job&)>;
    using Failed = std::function<void(const std::vector<Fault>&)>;

    /// `wake`: any thread; called when a job has ended. `threads`: at least one.
    explicit Jobs(std::function<void()> wake = {}, int threads = 2);
    /// Cancels all and waits for those that run.
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    /// UI thread. `failed` gets, on the UI thread, what the work threw. A cancelled job applies and tells nothing. Keep
    /// the job to cancel it.
    std::shared_ptr<Job> start(std::string name, Work work, Failed failed);
    /// Lists work that a thread of the caller's does: it waits for none of these, and none of these for it. That thread
    /// ends it with close(), also when it was cancelled. UI thread.
    std::shared_ptr<Job> open(std::string name, Failed failed);
    /// Any thread: as if the job's work had given `apply`, or thrown `faults`. Once for each open().
    void close(const std::shared_ptr<Job>& job, Apply apply, std::vector<Fault> faults = {});
    /// UI thread, once a frame: applies what has come. Gives whether there was anything.
    bool take();
    /// Waits for all jobs, also those that results of others start: for tests and pictures.
    void finish();

    /// Jobs that wait or run, the oldest first, without those cancelled.
    std::vector<std::shared_ptr<Job>> running() const;
    bool busy() const;
    void set_wake(std::function<void()> wake);
    void wake();  ///< any thread: as if a job had ended
    std::size_t threads() const { return threads_.size(); }

  private:
    struct Entry {
        std::shared_ptr<Job> job;
        std::uint64_t number = 0;  ///< jobs are numbered in the order in which they were begun
        Work work;
        Failed failed;
        Apply apply;
        std::vector<Fault> faults;
    };
    std::shared_ptr<Entry> entry_of(std::string name, Failed failed);
    void run();
    static void carry_out(Entry& entry);

    mutable std::mutex mutex_;
    std::condition_variable wanted_, ended_;
    std::deque<std::shared_ptr<Entry>> waiting_;
    std::vector<std::shared_ptr<Entry>> running_, done_;
    std::uint64_t begun_ = 0;  ///< UI thread
    bool stopping_ = false;
    std::function<void()> wake_;
    std::vector<std::thread> threads_;
};

}  // namespace lapfx::app
