// Tool samples from a haptic thread, without ever making it wait.
//
//     lapfx::ToolQueue& queue = effects.tool_queue();
//     // haptic thread, 1 kHz:
//     queue.push({.time = now, .position = tip, .touching = pedal, .action = lapfx::ToolAction::cauterise});
//     // render thread: effects.seek(now) takes what has come
//
// Samples that touch make a contact, which grows while they continue with the same action, power and strength, at most
// 0.1 s apart; a slower host sets contacts instead. A contact is straight and, while the tip moves, at most 0.1 s long:
// where the tip turns, another contact of the same stroke begins (goes_on, tool.h). Samples that are not finite, not
// later than the one before, or beyond 1e5 mm or 1e7 s are dropped and counted in Amounts::lost_samples;
// Effects::set_contacts() and the organ of set_organ() begin anew with any time. Samples later than seek() act when
// their time comes. Samples that do not touch cost nothing. How fast a tip may be to burn: tool.h.
//
// One thread pushes, one thread pops; both are wait-free and allocate nothing. Lengths mm in organ space, times s on
// the clock of Effects::seek().
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "lapfx/tool.h"

namespace lapfx {

/// Where the tip is at one moment and what it does there.
struct ToolSample {
    double time = 0.0;
    glm::dvec3 position{0.0};
    bool touching = false;  ///< the tool touches the organ and acts (pedal down, blades closed)
    ToolAction action = ToolAction::cauterise;
    double power = 1.0;     ///< 0..1
    double strength = 1.0;  ///< of the wound
};

class ToolQueue {
  public:
    /// Room for at least `capacity` samples, at least one; 8192 are eight seconds at 1 kHz. Throws std::bad_alloc.
    explicit ToolQueue(std::size_t capacity = 8192)
        : ring_(std::bit_ceil(std::clamp<std::size_t>(capacity, 1, largest))), mask_(ring_.size() - 1) {}
    ToolQueue(const ToolQueue&) = delete;
    ToolQueue& operator=(const ToolQueue&) = delete;

    /// Producer. False when there is no room; the sample is then lost and counted in missed().
    bool push(const ToolSample& sample) noexcept {
        const std::size_t at = written_.load(std::memory_order_relaxed);
        if (at - known_read_ > mask_) {
            known_read_ = read_.load(std::memory_order_acquire);
            if (at - known_read_ > mask_) {
                missed_.fetch_add(1, std::memory_order_relaxed);
                return false;
            }
        }
        ring_[at & mask_] = sample;
        written_.store(at + 1, std::memory_order_release);
        return true;
    }

    /// Consumer. False when there is none.
    bool pop(ToolSample& sample) noexcept {
        const std::size_t at = read_.load(std::memory_order_relaxed);
        if (at == known_written_) {
            known_written_ = written_.load(std::memory_order_acquire);
            if (at == known_written_) return false;
        }
        sample = ring_[at & mask_];
        read_.store(at + 1, std::memory_order_release);
        return true;
    }

    /// Samples lost because the queue was full. Any thread.
    std::uint64_t missed() const noexcept { return missed_.load(std::memory_order_relaxed); }
    std::size_t capacity() const noexcept { return ring_.size(); }

  private:
    static constexpr std::size_t largest = std::size_t{1} << 24;
    static constexpr std::size_t line = 64;  // bytes of a cache line: each side writes its own lines

    std::vector<ToolSample> ring_;
    std::size_t mask_;
    alignas(line) std::atomic<std::size_t> written_{0};
    std::size_t known_read_ = 0;  // the producer's copy: it need not read the consumer's line while there is room
    std::atomic<std::uint64_t> missed_{0};
    alignas(line) std::atomic<std::size_t> read_{0};
    std::size_t known_written_ = 0;  // consumer's
};

}  // namespace lapfx
