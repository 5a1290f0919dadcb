// Keeps the threads of the editor's jobs busy as long as a test likes, so that jobs started meanwhile have to wait. The
// list of jobs does not show it. It is only for an editor that does not wait for jobs itself: start(size, false).
//
//     HeldJobs held(editor().jobs);
//     open_sample();  // its organ waits to be loaded
//     held.let_go();  // and is loaded now
#pragma once

#include <latch>
#include <memory>
#include <string_view>
#include <vector>

#include "app/base/jobs.h"

namespace lapfx::test {

class HeldJobs {
  public:
    explicit HeldJobs(app::Jobs& jobs) {
        const auto count = static_cast<std::ptrdiff_t>(jobs.threads());
        const auto begun = std::make_shared<std::latch>(count);
        std::vector<std::shared_ptr<app::Job>> holders;
        for (std::ptrdiff_t i = 0; i < count; ++i)
            holders.push_back(jobs.start("Held",
                                         [begun, gate = gate_](app::Job&) -> app::Jobs::Apply {
                                             begun->count_down();
                                             gate->wait();
                                             return {};
                                         },
                                         {}));
        begun->wait();
        for (const auto& job : holders) job->cancel();  // cancelled jobs are not listed
    }
    ~HeldJobs() { let_go(); }
    void let_go() {
        if (gate_) gate_->count_down();
        gate_.reset();
    }
    /// Cancels all waiting jobs except those whose names begin so.
    static void keep_only(app::Jobs& jobs, std::string_view begins) {
        for (const auto& job : jobs.running())
            if (!job->name().starts_with(begins)) job->cancel();
    }
    HeldJobs(const HeldJobs&) = delete;
    HeldJobs& operator=(const HeldJobs&) = delete;

  private:
    std::shared_ptr<std::latch> gate_ = std::make_shared<std::latch>(1);
};

}  // namespace lapfx::test
