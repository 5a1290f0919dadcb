#include "media/decode_pool.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace lapfx::media {

namespace {

/// Decoding ahead can wait, a haptic thread cannot: when they share a core, the scheduler should run other threads
/// first. On Linux each thread has its own priority. If the system refuses, only that is lost.
void let_others_go_first() {
    constexpr int niceness = 10;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness);
}

}  // namespace

DecodePool::DecodePool(int threads) : threads_wanted_(std::max(threads, 1)) {}

DecodePool::~DecodePool() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    work_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void DecodePool::join(Job& job) {
    while (threads_.size() < static_cast<std::size_t>(threads_wanted_)) threads_.emplace_back([this] { work(); });
    {
        const std::lock_guard lock(mutex_);
        jobs_.push_back(&job);
    }
    wake();
}

void DecodePool::leave(Job& job) {
    std::unique_lock lock(mutex_);
    std::erase(jobs_, &job);
    done_.wait(lock, [&] { return !job.running_; });
}

DecodePool::Job* DecodePool::most_urgent() {
    Job* best = nullptr;
    int least = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
        Job* job = jobs_[(turn_ + i) % jobs_.size()];
        if (job->running_) continue;
        const int urgency = job->urgency();
        if (urgency < 0 || (best != nullptr && urgency >= least)) continue;
        best = job;
        least = urgency;
        at = (turn_ + i) % jobs_.size();
    }
    if (best != nullptr) turn_ = at + 1;
    return best;
}

void DecodePool::work() {
    let_others_go_first();
    std::unique_lock lock(mutex_);
    while (true) {
        Job* job = nullptr;
        work_.wait(lock, [&] { return stop_ || (job = most_urgent()) != nullptr; });
        if (stop_) return;
        job->begin();
        job->running_ = true;
        wake();  // there may be work for another thread
        lock.unlock();
        job->run();
        lock.lock();
        job->running_ = false;
        job->end();
        done_.notify_all();
    }
}

}  // namespace lapfx::media
