// The frames of a clip from FFmpeg's libavcodec, in the order in which they are shown. Not thread safe.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>

#include "media/clip_index.h"
#include "media/media_file.h"

namespace lapfx::media {

enum class Step { frame, end, stopped };

class FrameReader {
  public:
    /// Throws Error (bad_input) like MediaFile, and when there is no decoder for it.
    explicit FrameReader(const std::filesystem::path& path);

    MediaFile& file() { return file_; }
    /// What is unusual about the file, or empty.
    const std::string& warning() const { return warning_; }

    /// Goes to the first frame. Throws Error (bad_input) when the file is not a video any more.
    void restart();
    /// Goes to the frame of a seek point; false when it cannot be found that way, and then restart() is needed.
    bool seek(const SeekPoint& point) noexcept;

    /// The next frame that decodes without a fault, and its number in `index`. If given, `stop` is asked between
    /// packets.
    Step next(const ClipIndex& index, AVFrame& frame, int& number, const std::atomic<bool>* stop) noexcept;

    /// Packets that the decoder was given since the file was opened: the work of decoding, whatever the machine.
    std::int64_t packets() const { return packets_; }

  private:
    void open_codec();
    bool feed(const ClipIndex& index) noexcept;
    bool starts_anew(const ClipIndex& index) const noexcept;
    bool reach(const SeekPoint& point, std::int64_t stamp) noexcept;

    const std::filesystem::path path_;
    MediaFile file_;
    libav::Codec codec_;  ///< none when the file is not a video any more
    libav::Packet packet_;
    bool held_ = false;     ///< packet_ is still to be decoded
    bool fresh_ = true;     ///< the decoder has had no packet since it was made or emptied
    bool resets_ = false;   ///< it gives out what it still has, and is then emptied
    bool drained_ = false;  ///< the decoder knows that no packet follows
    int last_ = -1;         ///< frames up to this one are not given any more
    int count_ = 0;         ///< frames given since the start
    std::int64_t packets_ = 0;
    std::string warning_;
};

}  // namespace lapfx::media
