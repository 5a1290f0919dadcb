// Knows when a decoding thread has nothing else to do: what would have been decoded by itself is decoded then.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

#include "media/decode_pool.h"
#include "support/wait_until.h"

namespace lapfx::test {

/// Of a pool of one thread.
class Idle : private media::DecodePool::Job {
  public:
    explicit Idle(media::DecodePool& pool) : pool_(pool) { pool.join(*this); }
    ~Idle() override { pool_.leave(*this); }
    void wait() {
        {
            const std::lock_guard lock(pool_.mutex());
            asked_ = true;
        }
        pool_.wake();
        ASSERT_TRUE(wait_until([&] { return !asked_; }));
    }

  private:
    int urgency() override { return asked_ ? 1000 : -1; }
    void begin() override {}
    void run() noexcept override { asked_ = false; }
    void end() override {}

    media::DecodePool& pool_;
    std::atomic<bool> asked_{false};
};

}  // namespace lapfx::test
