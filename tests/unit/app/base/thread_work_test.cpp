// Work on a thread of its own: what comes of it, and how it ends.
#include "app/base/thread_work.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <stdexcept>

#include "support/wait_until.h"

namespace lapfx::app {
namespace {

using test::wait_until;
using Numbers = ThreadWork<int>;

/// Counts until it is cancelled.
std::optional<int> count(Job& job) {
    int counted = 0;
    while (!job.cancelled()) ++counted, std::this_thread::yield();
    return counted;
}

TEST(ThreadWork, TheResultComesFromAnotherThread) {
    std::thread::id by;
    std::atomic<int> ends = 0;
    Numbers work;
    EXPECT_FALSE(work.begun());
    EXPECT_FALSE(work.ended());
    const bool replaced = work.start(
        [&](Job& job) {
            by = std::this_thread::get_id();
            job.set_progress(0.75);
            return 42;
        },
        {.ended = [&] { ends = work.ended() && work.result() == 42 ? ends + 1 : -9; }});
    EXPECT_FALSE(replaced);
    ASSERT_TRUE(wait_until([&] { return ends != 0; }));
    EXPECT_EQ(ends, 1) << "the result is there when the end is told";
    EXPECT_TRUE(work.ended());
    EXPECT_FALSE(work.running());
    EXPECT_EQ(work.result(), 42);
    EXPECT_EQ(work.progress(), 0.75);
    EXPECT_TRUE(work.faults().empty());
    EXPECT_NE(by, std::this_thread::get_id());
}

TEST(ThreadWork, NotBesideItHasEndedAtOnce) {
    std::thread::id by;
    int ends = 0;
    Numbers work;
    work.start([&](Job&) { return by = std::this_thread::get_id(), 7; }, {.ended = [&] { ++ends; }}, false);
    EXPECT_EQ(by, std::this_thread::get_id());
    EXPECT_TRUE(work.ended());
    EXPECT_EQ(work.result(), 7);
    EXPECT_EQ(ends, 1);
}

TEST(ThreadWork, CancelledItGivesWhatItHas) {
    std::atomic<bool> counts = false;
    Numbers work;
    work.start([&](Job& job) { return counts = true, count(job); });
    ASSERT_TRUE(wait_until([&] { return counts.load(); }));
    EXPECT_TRUE(work.running());
    EXPECT_FALSE(work.cancelled());
    work.cancel();
    EXPECT_TRUE(work.cancelled());
    ASSERT_TRUE(wait_until([&] { return work.ended(); }));
    EXPECT_TRUE(work.result().has_value());
    work.start([](Job&) { return std::nullopt; }, {}, false);
    EXPECT_FALSE(work.cancelled()) << "that was the one before";
    EXPECT_TRUE(work.ended());
    EXPECT_FALSE(work.result().has_value()) << "nothing is no fault";
    EXPECT_TRUE(work.faults().empty());
}

TEST(ThreadWork, GivenUpItIsLetGoFromWhatItWaitsFor) {
    std::mutex mutex;
    std::condition_variable go_on;
    std::atomic<int> told = 0, cancelled = 0;
    const ThreadWorkBase::Calls calls = {.given_up = [&] {
        { const std::lock_guard lock(mutex); }
        ++told, go_on.notify_all();
    }};
    const auto rest = [&](Job& job) {
        std::unique_lock lock(mutex);
        go_on.wait(lock, [&] { return told != 0; });
        return cancelled = job.cancelled() ? 1 : -1;
    };
    {
        Numbers work;
        work.start(rest, calls);
        work.cancel();
        EXPECT_EQ(told, 0) << "what a person cancels gives what it has";
    }
    EXPECT_EQ(told, 1);
    EXPECT_EQ(cancelled, 1);
    Numbers ended;
    ended.start(rest, calls, false);
    ended.drop();
    EXPECT_EQ(told, 1) << "what has ended waits for nothing";
    EXPECT_FALSE(ended.result().has_value());
    EXPECT_FALSE(ended.begun());
}

TEST(ThreadWork, WhatItThrowsIsToldAsFaults) {
    Numbers work;
    work.start([](Job&) -> std::optional<int> {
        throw Error(Failure::bad_input, Fault{.file = "a.mp4", .place = "", .reason = "has no frame"});
    });
    ASSERT_TRUE(wait_until([&] { return work.ended(); }));
    EXPECT_FALSE(work.result().has_value());
    ASSERT_EQ(work.faults("b.html").size(), 1U);
    EXPECT_EQ(work.faults("b.html")[0].text(), "a.mp4: has no frame");
    work.start([](Job&) -> std::optional<int> { throw std::runtime_error("no memory"); }, {}, false);
    ASSERT_EQ(work.faults().size(), 1U);
    EXPECT_EQ(work.faults("b.html")[0].text(), "b.html: no memory");
    work.start([](Job&) { return 1; }, {}, false);
    EXPECT_TRUE(work.faults().empty()) << "of the one before";
}

TEST(ThreadWork, WhatIsReplacedIsCancelledAndWaitedForAndTold) {
    std::atomic<bool> counts = false;
    std::atomic<int> first_ended = 0;
    Numbers work;
    work.start([&](Job& job) { return counts = true, count(job); }, {.ended = [&] { ++first_ended; }});
    ASSERT_TRUE(wait_until([&] { return counts.load(); }));
    EXPECT_TRUE(work.start([&](Job&) { return first_ended.load(); }, {}, false)) << "one was running";
    EXPECT_EQ(work.result(), 1) << "it had ended before this one began";
    EXPECT_FALSE(work.start([](Job&) { return 2; }, {}, false)) << "none was";
}

TEST(ThreadWork, DestroyedWhileItRunsItIsWaitedFor) {
    std::atomic<bool> counts = false, ended = false;
    {
        Numbers work;
        work.start([&](Job& job) { return counts = true, count(job); }, {.ended = [&] { ended = true; }});
        ASSERT_TRUE(wait_until([&] { return counts.load(); }));
    }
    EXPECT_TRUE(ended);
}

TEST(ThreadWork, AJobOfAListCancelsIt) {
    Jobs jobs;
    const std::shared_ptr<Job> listed = jobs.open("Writing a.html", {});
    Numbers work;
    work.start([](Job& job) { return count(job); }, {.ended = [&] { jobs.close(listed, {}); }}, true, listed);
    ASSERT_EQ(jobs.running().size(), 1U);
    jobs.running()[0]->cancel();
    EXPECT_TRUE(work.cancelled());
    ASSERT_TRUE(wait_until([&] { return work.ended(); }));
}

}  // namespace
}  // namespace lapfx::app
