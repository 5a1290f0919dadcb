// Frames of one clip, decoded ahead into a fixed ring of buffers (paper: "buffering scheme", table 1: MAX_TEXTURES /
// streams buffers each; with one buffer it is the "pipeline scheme"). The render thread asks for frames by number and
// never decodes. All but the constructor and destructor: render thread, noexcept, and nothing is allocated.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "media/decode_pool.h"
#include "media/decoder.h"
#include "media/loop.h"
#include "media/policy.h"

namespace lapfx::media {

class ClipStream : private DecodePool::Job {
  public:
    /// What a worker has done so far.
    struct Work {
        double decode = 0.0, copy = 0.0;  ///< s
        std::uint64_t decoded = 0;        ///< frames
        int broken = 0;                   ///< different frames that could not be decoded
    };

    /// `buffers`: at least 1. `kept`, unless null: a byte for each frame of the clip, not 0 for those that need not be
    /// decoded; it is changed under the pool's mutex only. `memory`: where the frames are decoded to, buffers +
    /// spare_slots of them, each of the format's bytes or empty; what has none takes its own. `pool`, `kept` and the
    /// memory outlive the stream.
    ClipStream(DecodePool& pool, Decoder decoder, Loop loop, int buffers,
               const std::vector<std::uint8_t>* kept = nullptr, std::span<const std::span<std::uint8_t>> memory = {});
    /// Waits for the frame that is being decoded; a long way to a frame is cut short.
    ~ClipStream() override;

    /// A decoded frame.
    struct Shown {
        std::span<const std::uint8_t> bytes;  ///< valid until the next call; none: it is not there, or not any more
        int index = -1;                       ///< its number
        int slot = -1;                        ///< of the memory that it is in
    };
    /// Frame `index`. Under Policy::latest, when it is late: the newest one that there is of a clip that plays on (one
    /// that takes longer to decode than to play is shown in slow motion), none after a jump. Under Policy::skip, when
    /// it is late: the newest one, and decoding goes on from `index`. Of a newest one that was taken there is but the
    /// number. `waited` grows by the s of waiting.
    Shown frame(int index, Policy policy, double& waited) noexcept;
    /// A frame among the next ones that is decoded already, or none; it does not move the stream.
    Shown peek(int index) noexcept;
    /// Any decoded frame that is not kept yet.
    Shown peek_any() noexcept;
    /// The frame that was given last is not needed any more, and `memory` takes the place of its own; empty: nothing
    /// does.
    void take(int slot, std::span<std::uint8_t> memory) noexcept;
    /// A slot that has no memory and that nobody reads or writes decodes to this from now on; -1: there is none.
    int give(std::span<std::uint8_t> memory) noexcept;
    /// The slot of memory that is given to the stream, that nobody reads or writes and that it has too much of; it
    /// takes no frame any more. -1: none.
    int give_back() noexcept;
    /// Decode from `index` on, each `step`-th frame.
    void aim(int index, int step = 1) noexcept;
    void set_loop(Loop loop) noexcept;
    /// From now on `buffers` of those it was made with, at least 1.
    void set_buffers(int buffers) noexcept;
    /// Gives its buffers' memory back if all frames of its loop are kept: true, and a worker closes the file. Until
    /// then: false.
    bool rest() noexcept;

    Work work() const noexcept;
    bool closed() const noexcept;  ///< its file is, since it rests
    std::size_t memory() const noexcept;
    /// One that the render thread reads, or the newest: besides the buffers, so that decoding ahead never waits for
    /// them.
    static constexpr int spare_slots = 1;

  private:
    struct Slot {
        int index = -1;  ///< frame number that it holds
        std::span<std::uint8_t> given;
        Picture picture;  ///< unless memory was given

        std::span<const std::uint8_t> bytes() const { return given.empty() ? std::span(picture.bytes) : given; }
        void clear() { index = -1, picture = {}; }
    };

    int urgency() override;
    void begin() override;
    void run() noexcept override;
    void end() override;

    Shown lend(const Slot* slot);
    Slot* find(int index);
    Slot* free_slot();
    void move_to(int index);
    int next_behind() const;
    void find_window();
    bool in_window(int index) const;
    bool is_kept(int index) const;

    DecodePool& pool_;
    const std::vector<std::uint8_t>* kept_;
    Decoder decoder_;       // the worker's while it runs
    bool closing_ = false;  // what it runs is closing the file; found by urgency()

    // under the pool's mutex
    std::vector<Slot> slots_;
    std::size_t buffers_;      // of them in use
    std::vector<int> window_;  // the next frames that are not kept, as many as there are buffers
    Loop loop_;
    int current_;
    int step_ = 1;          // from one frame of the window to the next
    int newest_ = -1;       // the frame that was decoded last
    bool behind_ = false;   // decoding does not keep up: it goes on from the newest frame, not from the current one
    bool resting_ = false;  // all of the loop is kept
    bool closed_ = false;   // the decoder rests, too
    const Slot* lent_ = nullptr;  // the render thread reads it
    int wanted_ = -1;             // found by urgency(): the frame to decode next, and where to
    Slot* into_ = nullptr;
    const Slot* written_ = nullptr;     // by the worker
    bool whole_ = true;                 // what is being decoded came out whole
    std::vector<std::uint8_t> broken_;  // a byte for each frame of the clip
    Work work_;
    std::atomic<bool> stop_{false};
};

}  // namespace lapfx::media
