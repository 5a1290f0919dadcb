#include "app/base/render_steps.h"

#include <chrono>
#include <utility>

namespace lapfx::app {

bool RenderSteps::carry_out(const std::function<void()>& step) {
    std::unique_lock lock(mutex_);
    if (stopped_) return false;
    step_ = &step;
    asked_.notify_one();
    lock.unlock();
    wake_();
    lock.lock();
    done_.wait(lock, [this] { return step_ == nullptr || (stopped_ && !under_way_); });
    if (step_ != nullptr) {
        step_ = nullptr;
        return false;
    }
    if (std::exception_ptr thrown = std::exchange(thrown_, nullptr)) std::rethrow_exception(std::move(thrown));
    return true;
}

void RenderSteps::serve(double budget) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(budget);
    std::unique_lock lock(mutex_);
    while (step_ != nullptr && !stopped_) {
        // Whoever asked for it waits, so it stays what it is while the lock is not held.
        const std::function<void()>& step = *step_;
        under_way_ = true;
        lock.unlock();
        std::exception_ptr thrown;
        try {
            step();
        } catch (...) {
            thrown = std::current_exception();
        }
        lock.lock();
        thrown_ = std::move(thrown);
        step_ = nullptr, under_way_ = false;
        done_.notify_one();
        if (std::chrono::steady_clock::now() >= until) return;
        asked_.wait_until(lock, until, [this] { return step_ != nullptr || stopped_; });
    }
}

bool RenderSteps::waiting() const {
    const std::lock_guard lock(mutex_);
    return step_ != nullptr;
}

void RenderSteps::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
    }
    done_.notify_all();
    asked_.notify_all();
}

}  // namespace lapfx::app
