// One clip of a preset, playing by one of the schemes. Render thread, context current.
#pragma once

#include <array>
#include <memory>

#include "lapfx/smoke_parameters.h"
#include "lapfx/streaming.h"
#include "media/clip_stream.h"
#include "media/file_stamp.h"
#include "media/frame_textures.h"
#include "media/sent_frames.h"

namespace lapfx::media {

/// A file that clips play: its index, and the frames that stay on the GPU. All clips of a preset that name the file
/// share it.
struct ClipFile {
    /// `seen`: its stamp before the decoder opened it.
    ClipFile(const std::filesystem::path& where, const FileStamp& seen, const Decoder& decoder);

    std::filesystem::path path;
    FileStamp stamp;
    ClipInfo info;
    PictureFormat format;
    FrameStore store;
    std::uint64_t drawn = 0;  // in which cycle
};

class ClipPlayer {
  public:
    /// `decoder` has opened `file`. `buffers`: for each head.
    ClipPlayer(DecodePool& pool, std::shared_ptr<ClipFile> file, Decoder decoder, const SmokeClip& settings,
               Scheme scheme, int buffers);

    const std::shared_ptr<ClipFile>& file() const { return file_; }
    Scheme scheme() const { return scheme_; }
    bool stays() const;  ///< as SchemeRow::stays
    /// Number of buffers for decoding ahead from now on; at most the number at construction.
    void set_buffers(int buffers) noexcept;
    bool same_heads(const SmokeClip& settings) const {
        return (settings.crossfade > 0.0) == (heads_[1].stream != nullptr);
    }
    /// In and out points; the other settings do not concern this class.
    void set_loops(const SmokeClip& settings) noexcept;

    /// ClipSet says what it does.
    ClipFrame frame(int head, int index, Policy policy, StreamingTimes& times) noexcept;
    ClipFrame shown(int head) const noexcept;
    int asked(int head) const noexcept { return heads_[static_cast<std::size_t>(head)].asked; }
    /// `cycle` grows by one in each cycle. Buffering sends the frames of even heads in even cycles and those of odd
    /// heads in odd cycles; ClipSet numbers the heads so that those of all clips are spread evenly.
    void end_cycle(std::uint64_t cycle, StreamingTimes& times) noexcept;
    std::size_t heads() const { return heads_[1].stream != nullptr ? 2u : 1u; }

    std::size_t memory() const noexcept;  ///< bytes, without the file's store
    std::uint64_t misses() const { return misses_; }
    ClipStream::Work work() const noexcept;

  private:
    struct Head {
        std::vector<gl::PixelBuffer> memory;  // buffering: the memory that the stream decodes to
        std::vector<std::uint8_t> on_gpu;     // buffering: a byte for each frame, not 0 where `sent` holds it
        std::unique_ptr<ClipStream> stream;
        SentFrames sent;   // streaming schemes
        int shown = -1;    // resident: frame number; -1: nothing yet
        int asked = -1;    // frame number
        bool now = false;  // asked for in this cycle
        Policy policy = Policy::wait;
        std::array<int, 3> moves{1, 1, 1};  // frames that it advanced by, the last cycle first; -1: it jumped
        bool late = false;                  // Policy::skip: every second frame is skipped
        Loop loop;
        bool rests = false;  // the whole loop is in the store

        void ask(int index, Policy how);
        int step() const;
        bool outruns_the_display() const { return moves[0] > 1 && moves[1] > 1; }
    };
    static constexpr std::size_t sent_ahead = 3;
    using Ahead = std::array<int, sent_ahead>;

    ClipFrame resident_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept;
    ClipFrame streamed_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept;
    ClipFrame shown_of(const Head& head) const noexcept;
    void give_memory(Head& head, int buffers) noexcept;
    void send(Head& head, const ClipStream::LentFrame& decoded, std::span<const int> needed,
              StreamingTimes& times) noexcept;
    void coalesce(Head& head, bool turn, StreamingTimes& times) noexcept;
    void skip_one(Head& head, const Ahead& ahead, StreamingTimes& times) noexcept;
    void send_ahead(Head& head, const Ahead& ahead, int most, StreamingTimes& times) noexcept;
    void keep(const ClipStream::LentFrame& decoded, StreamingTimes& times) noexcept;

    DecodePool& pool_;
    std::shared_ptr<ClipFile> file_;
    Scheme scheme_;
    std::array<Head, 2> heads_;
    std::uint64_t misses_ = 0;
};

/// The frames that the settings of a clip play, from the first to the last.
Loop played_frames(const ClipInfo& clip, const SmokeClip& settings);

/// The bytes of main and GPU memory that a head of a clip needs besides the store.
std::size_t head_memory(const PictureFormat& format, Scheme scheme, int buffers);

}  // namespace lapfx::media
