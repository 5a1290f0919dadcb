#include "app/base/jobs.h"

#include <algorithm>
#include <exception>

namespace lapfx::app {

Jobs::Jobs(std::function<void()> wake, int threads) : wake_(std::move(wake)) {
    for (int i = 0; i < std::max(threads, 1); ++i) threads_.emplace_back([this] { run(); });
}

Jobs::~Jobs() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        for (const auto& entry : waiting_) entry->job->cancel();
        for (const auto& entry : running_) entry->job->cancel();
    }
    wanted_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

std::shared_ptr<Jobs::Entry> Jobs::entry_of(std::string name, Failed failed) {
    auto entry = std::make_shared<Entry>();
    entry->job = std::make_shared<Job>(std::move(name));
    entry->failed = std::move(failed);
    entry->number = begun_++;
    return entry;
}

std::shared_ptr<Job> Jobs::start(std::string name, Work work, Failed failed) {
    const auto entry = entry_of(std::move(name), std::move(failed));
    entry->work = std::move(work);
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(entry);
    }
    wanted_.notify_one();
    return entry->job;
}

std::shared_ptr<Job> Jobs::open(std::string name, Failed failed) {
    const auto entry = entry_of(std::move(name), std::move(failed));
    const std::lock_guard lock(mutex_);
    running_.push_back(entry);
    return entry->job;
}

void Jobs::close(const std::shared_ptr<Job>& job, Apply apply, std::vector<Fault> faults) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(running_.begin(), running_.end(), [&](const auto& e) { return e->job == job; });
    if (found == running_.end()) return;
    (*found)->apply = std::move(apply);
    (*found)->faults = std::move(faults);
    done_.push_back(std::move(*found));
    running_.erase(found);
    ended_.notify_all();
    if (wake_) wake_();
}

void Jobs::carry_out(Entry& entry) {
    try {
        if (!entry.job->cancelled()) entry.apply = entry.work(*entry.job);
    } catch (const Error& error) {
        entry.faults = error.faults();
    } catch (const std::exception& error) {
        entry.faults = {{.file = "", .place = "", .reason = error.what()}};
    }
}

void Jobs::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        wanted_.wait(lock, [&] { return stopping_ || !waiting_.empty(); });
        if (stopping_) return;
        const std::shared_ptr<Entry> entry = std::move(waiting_.front());
        waiting_.pop_front();
        running_.push_back(entry);
        lock.unlock();
        carry_out(*entry);
        lock.lock();
        std::erase(running_, entry);
        done_.push_back(entry);
        ended_.notify_all();
        if (wake_) wake_();
    }
}

bool Jobs::take() {
    std::vector<std::shared_ptr<Entry>> done;
    {
        const std::lock_guard lock(mutex_);
        done.swap(done_);
    }
    for (const auto& entry : done) {
        if (entry->job->cancelled()) continue;
        if (!entry->faults.empty() && entry->failed) entry->failed(entry->faults);
        if (entry->faults.empty() && entry->apply) entry->apply();
    }
    return !done.empty();
}

void Jobs::finish() {
    while (busy()) {
        {
            std::unique_lock lock(mutex_);
            ended_.wait(lock, [&] { return !done_.empty(); });
        }
        take();
    }
}

void Jobs::set_wake(std::function<void()> wake) {
    const std::lock_guard lock(mutex_);
    wake_ = std::move(wake);
}

void Jobs::wake() {
    const std::lock_guard lock(mutex_);
    if (wake_) wake_();
}

std::vector<std::shared_ptr<Job>> Jobs::running() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::shared_ptr<Entry>> entries = running_;
    entries.insert(entries.end(), waiting_.begin(), waiting_.end());
    std::ranges::sort(entries, {}, &Entry::number);  // those of threads of their own pass those that wait
    std::vector<std::shared_ptr<Job>> jobs;
    for (const auto& entry : entries) jobs.push_back(entry->job);
    std::erase_if(jobs, [](const std::shared_ptr<Job>& job) { return job->cancelled(); });
    return jobs;
}

bool Jobs::busy() const {
    const std::lock_guard lock(mutex_);
    return !running_.empty() || !waiting_.empty() || !done_.empty();
}

}  // namespace lapfx::app
