// One piece of work on a thread of its own beside the window, and what comes of it: a result, nothing, or an Error.
//
//     ThreadWork<Image> work;
//     work.start([=](Job& job) -> std::optional<Image> {
//         return draw(file, [&](double share) { return job.set_progress(share), !job.cancelled(); });
//     }, {.ended = [&] { jobs.wake(); }});
//     each frame:  if (work.ended()) work.faults().empty() ? show(work.result()) : tell(work.faults());
//
// Unlike a job of Jobs it waits for no other, and may wait for the window: for steps of drawing, or to go on. All but
// the work itself is called by the thread that made it; `ended` may ask for the result and the faults, too.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/base/jobs.h"
#include "lapfx/error.h"

namespace lapfx::app {

/// What ThreadWork is without its result.
class ThreadWorkBase {
  public:
    struct Calls {
        std::function<void()> ended = {};  ///< the thread of the work, however it has ended
        /// Nobody wants its result any more, and it is cancelled and going to be waited for: lets go what it waits for.
        std::function<void()> given_up = {};
    };

    bool begun() const { return job_ != nullptr; }
    /// Nothing more comes. False before start().
    bool ended() const { return ended_; }
    bool running() const { return begun() && !ended_; }
    double progress() const { return job_ ? std::max(job_->progress(), 0.0) : 0.0; }  ///< 0..1
    bool cancelled() const { return job_ && job_->cancelled(); }
    /// It ends soon, with what it has, which is still wanted. Nothing where it has ended already.
    void cancel();
    /// Once it has ended: what it threw; empty where it threw nothing. `file`: for what does not name its own.
    std::vector<Fault> faults(const std::string& file = {}) const;
    void rethrow() const;  ///< the same, thrown as it was

  protected:
    ThreadWorkBase() = default;
    ~ThreadWorkBase() = default;  // the derived class has waited
    ThreadWorkBase(const ThreadWorkBase&) = delete;
    ThreadWorkBase& operator=(const ThreadWorkBase&) = delete;
    void start_work(std::function<void(Job&)> work, Calls calls, bool beside, std::shared_ptr<Job> job);
    void give_up();  ///< and waits for it
    void forget();

  private:
    void carry_out(const std::function<void(Job&)>& work);

    Calls calls_;
    std::shared_ptr<Job> job_;  ///< null: nothing was started
    std::atomic<bool> ended_ = false;
    std::exception_ptr thrown_;  ///< once it has ended
    std::thread thread_;
};

template <typename Result>
class ThreadWork : public ThreadWorkBase {
  public:
    /// Nothing: it was cancelled before there was anything.
    using Work = std::function<std::optional<Result>(Job&)>;

    ThreadWork() = default;
    ~ThreadWork() { give_up(); }

    /// `beside`: else all of it is done here, at once. `job`: one of a list, whose progress and cancelling it takes;
    /// null: its own. One that is running is given up; gives whether there was one.
    bool start(Work work, Calls calls = {}, bool beside = true, std::shared_ptr<Job> job = nullptr) {
        const bool replaced = running();
        drop();
        start_work([this, work = std::move(work)](Job& own) { result_ = work(own); }, std::move(calls), beside,
                   std::move(job));
        return replaced;
    }
    /// Gives it up, waits for it and forgets what has come of it.
    void drop() {
        forget();
        result_.reset();
    }
    /// Once it has ended; may be moved from.
    std::optional<Result>& result() { return result_; }
    const std::optional<Result>& result() const { return result_; }

  private:
    std::optional<Result> result_;  ///< the work's until it has ended
};

}  // namespace lapfx::app
