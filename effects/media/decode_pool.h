// The decoding threads, shared by all clips. Each takes the most urgent job, so that many clips use few cores well and
// the frame that is needed first comes first.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace lapfx::media {

class DecodePool {
  public:
    /// A job that consists of small pieces. One thread at a time has it.
    class Job {
      public:
        virtual ~Job() = default;

      private:
        friend class DecodePool;
        /// How soon its next piece is needed: 0 now, larger is later, negative: there is no piece. Called under the
        /// pool's mutex.
        virtual int urgency() = 0;
        /// Takes the piece that urgency() has just found. Called under the pool's mutex.
        virtual void begin() = 0;
        /// Without the mutex.
        virtual void run() noexcept = 0;
        /// Under the pool's mutex.
        virtual void end() = 0;
        bool running_ = false;
    };

    /// `threads`: at least 1; they start with the first job.
    explicit DecodePool(int threads);
    /// All jobs must have left.
    ~DecodePool();

    /// The lock that a job's shared state is under.
    std::mutex& mutex() { return mutex_; }
    void join(Job& job);
    /// Waits until the running piece is done.
    void leave(Job& job);
    /// Call this when something may have become urgent. Change the data of urgency() under the mutex, otherwise a
    /// thread that has just looked continues to sleep; this call itself does not need the mutex.
    void wake() { work_.notify_one(); }
    /// Waits until a piece is done. Any thread, under the mutex.
    void wait_for_piece(std::unique_lock<std::mutex>& lock) { done_.wait(lock); }

  private:
    void work();
    Job* most_urgent();

    const int threads_wanted_;
    std::mutex mutex_;
    std::condition_variable work_, done_;
    std::vector<Job*> jobs_;
    std::size_t turn_ = 0;  // equally urgent jobs take turns
    bool stop_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace lapfx::media
