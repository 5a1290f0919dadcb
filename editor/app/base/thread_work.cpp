#include "app/base/thread_work.h"

namespace lapfx::app {

void ThreadWorkBase::start_work(std::function<void(Job&)> work, Calls calls, bool beside, std::shared_ptr<Job> job) {
    calls_ = std::move(calls);
    job_ = job ? std::move(job) : std::make_shared<Job>("");
    if (beside)
        thread_ = std::thread([this, work = std::move(work)] { carry_out(work); });
    else
        carry_out(work);
}

void ThreadWorkBase::carry_out(const std::function<void(Job&)>& work) {
    try {
        work(*job_);
    } catch (...) {
        thrown_ = std::current_exception();
    }
    ended_ = true;
    if (calls_.ended) calls_.ended();
}

void ThreadWorkBase::cancel() {
    if (running()) job_->cancel();
}

void ThreadWorkBase::give_up() {
    if (running()) {
        job_->cancel();
        if (calls_.given_up) calls_.given_up();
    }
    if (thread_.joinable()) thread_.join();
}

void ThreadWorkBase::forget() {
    give_up();
    job_.reset();
    ended_ = false;
    thrown_ = nullptr;
}

void ThreadWorkBase::rethrow() const {
    if (ended_ && thrown_) std::rethrow_exception(thrown_);
}

std::vector<Fault> ThreadWorkBase::faults(const std::string& file) const {
    try {
        rethrow();
        return {};
    } catch (const Error& error) {
        return error.faults();
    } catch (const std::exception& error) {
        return {{.file = file, .place = "", .reason = error.what()}};
    }
}

}  // namespace lapfx::app
