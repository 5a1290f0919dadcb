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

    /// `buffers`: at least 1. `kept`, unless null, has a byte for each frame of the clip, which is not 0 if the frame
    /// need not be decoded; it changes only under the pool's mutex. `memory`: buffers + spare_slots places to decode
    /// to, each of the format's bytes, or empty, in which case the stream allocates. `pool`, `kept` and the memory
    /// outlive the stream.
    ClipStream(DecodePool& pool, Decoder decoder, Loop loop, int buffers,
               const std::vector<std::uint8_t>* kept = nullptr, std::span<const std::span<std::uint8_t>> memory = {});
    /// Waits for the frame that is being decoded; a long search for a frame is cut short.
    ~ClipStream() override;

    /// A decoded frame.
    struct LentFrame {
        std::span<const std::uint8_t> bytes;  ///< valid until the next call; none: it is not decoded, or not any more
        int index = -1;                       ///< its number
        int slot = -1;                        ///< slot of the memory that it is in
    };
    /// Frame `index`. When it is late under Policy::latest: the newest frame of a clip that continues to play (a clip
    /// that decodes more slowly than it plays is shown in slow motion), and none after a jump. When it is late under
    /// Policy::skip: the newest frame, and decoding continues from `index`. Of a newest frame that was taken only the
    /// number is given. `waited` grows by the time of waiting, s.
    LentFrame frame(int index, Policy policy, double& waited) noexcept;
    /// One of the next frames, if it is already decoded, or none; it does not move the stream.
    LentFrame peek(int index) noexcept;
    /// Any decoded frame that is not kept yet.
    LentFrame peek_any() noexcept;
    /// The frame that was given last is not needed any more, and `memory` replaces its memory; empty: nothing replaces
    /// it.
    void take(int slot, std::span<std::uint8_t> memory) noexcept;
    /// Gives this memory to a slot that has none and that nobody reads or writes; -1: there is no such slot.
    int give(std::span<std::uint8_t> memory) noexcept;
    /// A slot with memory that was given to the stream and that it does not need any more; nobody reads or writes it,
    /// and it takes no further frame. -1: none.
    int give_back() noexcept;
    /// Decode from `index` on, each `step`-th frame.
    void aim(int index, int step = 1) noexcept;
    void set_loop(Loop loop) noexcept;
    /// Uses `buffers` of its buffers from now on, at least 1.
    void set_buffers(int buffers) noexcept;
    /// If all frames of its loop are kept, frees the memory of its buffers and gives true; a worker closes the file.
    /// Otherwise false.
    bool rest() noexcept;

    Work work() const noexcept;
    bool closed() const noexcept;  ///< its file is closed, since it rests
    std::size_t memory() const noexcept;
    /// One slot for the frame that the render thread reads, or the newest one, in addition to the buffers, so that
    /// decoding ahead never waits for it.
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

    LentFrame lend(const Slot* slot);
    Slot* find(int index);
    Slot* free_slot();
    void move_to(int index);
    int next_behind() const;
    void find_window();
    bool in_window(int index) const;
    bool is_kept(int index) const;

    DecodePool& pool_;
    const std::vector<std::uint8_t>* kept_;
    Decoder decoder_;       // belongs to the worker while it runs
    bool closing_ = false;  // its task is closing the file; found by urgency()

    // The pool's mutex guards what follows.
    std::vector<Slot> slots_;
    std::size_t buffers_;      // how many of them are in use
    std::vector<int> window_;  // the next frames that are not kept, as many as there are buffers
    Loop loop_;
    int current_;
    int step_ = 1;     // from one frame of the window to the next
    int newest_ = -1;  // the frame that was decoded last
    bool behind_ =
        false;  // decoding does not keep up, so it continues from the newest frame and not from the current one
    bool resting_ = false;        // the whole loop is kept
    bool closed_ = false;         // the decoder rests, too
    const Slot* lent_ = nullptr;  // the render thread reads it
    int wanted_ = -1;             // found by urgency(): the frame to decode next, and where to
    Slot* into_ = nullptr;
    const Slot* written_ = nullptr;     // by the worker
    bool whole_ = true;                 // the frame that was decoded is not broken
    std::vector<std::uint8_t> broken_;  // a byte for each frame of the clip
    Work work_;
    std::atomic<bool> stop_{false};
};

}  // namespace lapfx::media
