// One clip of a preset, playing by one of the schemes. Render thread, context current.
#pragma once

#include <array>
#include <memory>

#include "lapfx/preset.h"
#include "lapfx/streaming.h"
#include "smoke/clip_stream.h"
#include "smoke/file_stamp.h"
#include "smoke/frame_textures.h"

namespace lapfx::smoke {

/// A file that clips play: what is known of it, and those of its frames that are on the GPU to stay, shared by all clips of a
/// preset that name it.
struct ClipFile {
    /// `seen`: before the decoder opened it.
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
    /// `file` was opened by `decoder`. `buffers`: of each head.
    ClipPlayer(DecodePool& pool, std::shared_ptr<ClipFile> file, Decoder decoder, const SmokeClip& settings,
               Scheme scheme, int buffers);

    const std::shared_ptr<ClipFile>& file() const { return file_; }
    Scheme scheme() const { return scheme_; }
    /// Decoding ahead from now on; never more than it was made with.
    void set_buffers(int buffers) noexcept;
    bool same_heads(const SmokeClip& settings) const {
        return (settings.crossfade > 0.0) == (heads_[1].stream != nullptr);
    }
    /// In and out points; the rest of the settings is not this class's.
    void set_loops(const SmokeClip& settings) noexcept;

    /// As ClipSet's.
    ClipFrame frame(int head, int index, Policy policy, StreamingTimes& times) noexcept;
    void end_cycle(StreamingTimes& times) noexcept;

    std::size_t memory() const noexcept;  ///< bytes, without the file's store
    std::uint64_t misses() const { return misses_; }
    ClipStream::Work work() const noexcept;

  private:
    struct Head {
        std::unique_ptr<ClipStream> stream;
        FrameTextures sent;                // streaming schemes: what was sent last, and the one after it
        std::array<int, 2> holds{-1, -1};  // frame numbers
        int shown = -1;                    // frame number (resident) or layer of `sent`; -1: nothing yet
        int asked = -1;                    // frame number
        Loop loop;
        bool rests = false;  // all of the loop is in the store
    };

    ClipFrame resident_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept;
    ClipFrame streamed_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept;
    void send(Head& head, int layer, int index, const Picture& picture, StreamingTimes& times) noexcept;
    void keep(int index, const Picture& picture, StreamingTimes& times) noexcept;

    DecodePool& pool_;
    std::shared_ptr<ClipFile> file_;
    Scheme scheme_;
    std::array<Head, 2> heads_;
    std::uint64_t misses_ = 0;
};

/// The frames of a clip that its settings play: from the first of its loops to the last.
Loop played_frames(const ClipInfo& clip, const SmokeClip& settings);

/// The bytes of main and GPU memory that a head of a clip takes besides the store.
std::size_t head_memory(const PictureFormat& format, Scheme scheme, int buffers);

}  // namespace lapfx::smoke
