// Frames of one clip, decoded ahead into a fixed ring of buffers (paper: "buffering scheme", table 1: MAX_TEXTURES / streams
// buffers each; with one buffer it is the "pipeline scheme"). The render thread asks for frames by number and never decodes.
// All but the constructor and destructor: render thread, noexcept, and nothing is allocated.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "smoke/decode_pool.h"
#include "smoke/decoder.h"
#include "smoke/loop.h"
#include "smoke/policy.h"

namespace lapfx::smoke {

class ClipStream : private DecodePool::Job {
  public:
    /// What a worker has done so far.
    struct Work {
        double decode = 0.0, copy = 0.0;  ///< s
        std::uint64_t decoded = 0;        ///< frames
        int broken = 0;                   ///< different frames that could not be decoded
    };

    /// `buffers`: at least 1. `kept`, unless null: a byte for each frame of the clip, not 0 for those that need not be
    /// decoded; it is changed under the pool's mutex only. Both `pool` and `kept` outlive the stream.
    ClipStream(DecodePool& pool, Decoder decoder, Loop loop, int buffers,
               const std::vector<std::uint8_t>* kept = nullptr);
    /// Waits for the frame that is being decoded; a long way to a frame is cut short.
    ~ClipStream() override;

    /// Frame `index`, valid until the next call; null when it is late (Policy::latest). `waited` grows by the s of waiting.
    const Picture* frame(int index, Policy policy, double& waited) noexcept;
    /// A frame among the next ones that is decoded already, or null; it does not move the stream.
    const Picture* peek(int index) noexcept;
    /// Any frame of those decoded ahead; null when there is none. `index` is its number.
    const Picture* peek_any(int& index) noexcept;
    /// Decode from `index` on.
    void aim(int index) noexcept;
    void set_loop(Loop loop) noexcept;
    /// Gives its buffers' memory back if all frames of its loop are kept: true. Until then: false.
    bool rest() noexcept;

    Work work() const noexcept;
    std::size_t memory() const noexcept;
    int buffers() const { return static_cast<int>(slots_.size()); }

  private:
    struct Slot {
        int index = -1;  ///< frame number that it holds
        Picture picture;
    };

    int urgency() override;
    void begin() override;
    void run() noexcept override;
    void end() override;

    Slot* find(int index);
    void find_window();
    bool in_window(int index) const;
    bool is_kept(int index) const;

    DecodePool& pool_;
    const std::vector<std::uint8_t>* kept_;
    Decoder decoder_;  // the worker's while it runs

    // under the pool's mutex
    std::vector<Slot> slots_;
    std::vector<int> window_;  // the next frames that are not kept, as many as there are slots
    Loop loop_;
    int current_;
    int wanted_ = -1;  // found by urgency(): the frame to decode next, and where to
    Slot* into_ = nullptr;
    bool whole_ = true;                 // what is being decoded came out whole
    std::vector<std::uint8_t> broken_;  // a byte for each frame of the clip
    Work work_;
    std::atomic<bool> stop_{false};
};

}  // namespace lapfx::smoke
