#include "media/decode_pool.h"

#include <gtest/gtest.h>

#include <atomic>

namespace lapfx::media {
namespace {

/// Does `pieces` pieces of a fixed urgency and notes their order.
class Counter : public DecodePool::Job {
  public:
    Counter(DecodePool& pool, std::vector<int>& log, int name, int how_urgent, int pieces)
        : pool_(pool), log_(log), name_(name), urgency_(how_urgent), left_(pieces) {}
    ~Counter() override { pool_.leave(*this); }

    void await() {
        std::unique_lock lock(pool_.mutex());
        while (left_ > 0) pool_.wait_for_piece(lock);
    }
    int at_once = 0, most_at_once = 0;

  private:
    int urgency() override { return left_ > 0 ? urgency_ : -1; }
    void begin() override { most_at_once = std::max(most_at_once, ++at_once); }
    void run() noexcept override {}
    void end() override {
        --at_once;
        --left_;
        log_.push_back(name_);
    }

    DecodePool& pool_;
    std::vector<int>& log_;
    int name_, urgency_, left_;
};

/// Blocks the only thread until it is released.
class Blocker : public DecodePool::Job {
  public:
    explicit Blocker(DecodePool& pool) : pool_(pool) {}
    ~Blocker() override { pool_.leave(*this); }
    std::atomic<bool> go{false};

  private:
    int urgency() override { return go ? -1 : 0; }
    void begin() override {}
    void run() noexcept override { go.wait(false); }
    void end() override {}
    DecodePool& pool_;
};

TEST(DecodePool, DoesWhatIsMostUrgentFirstAndEqualsInTurn) {
    DecodePool pool(1);
    std::vector<int> log;
    Counter late(pool, log, 9, 5, 2), first(pool, log, 1, 0, 2), second(pool, log, 2, 0, 2);
    Blocker blocker(pool);
    pool.join(blocker);
    for (Counter* counter : {&late, &first, &second}) pool.join(*counter);
    blocker.go = true;
    blocker.go.notify_all();
    late.await();
    ASSERT_EQ(log.size(), 6u);
    EXPECT_EQ(log[0] + log[1], 3) << "one and two, each once";
    EXPECT_EQ(log[2], log[0]);
    EXPECT_EQ(log[3], log[1]);
    EXPECT_EQ(log[4], 9);
}

TEST(DecodePool, OneJobIsNeverAtTwoThreads) {
    DecodePool pool(4);
    std::vector<int> log;
    Counter a(pool, log, 1, 0, 2000), b(pool, log, 2, 1, 2000);
    pool.join(a);
    pool.join(b);
    a.await();
    b.await();
    EXPECT_EQ(a.most_at_once, 1);
    EXPECT_EQ(b.most_at_once, 1);
    EXPECT_EQ(log.size(), 4000u);
}

}  // namespace
}  // namespace lapfx::media
