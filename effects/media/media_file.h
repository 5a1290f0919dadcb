// The pictures' packets of one plain local file, by FFmpeg's libavformat. Not thread safe.
#pragma once

#include <cstdint>
#include <filesystem>

#include "media/libav.h"

namespace lapfx::media {

/// What FFmpeg's decoders may make of a picture: 8K squared. A file's own word may be anything.
constexpr std::int64_t maximum_pixels = std::int64_t{8192} * 8192;

class MediaFile {
  public:
    /// Throws Error (bad_input): not a plain local file, a playlist, of no known format, without pictures or with too
    /// large ones.
    explicit MediaFile(const std::filesystem::path& path);
    ~MediaFile();
    MediaFile(const MediaFile&) = delete;
    MediaFile& operator=(const MediaFile&) = delete;

    /// To the first packet. The file is the one that was opened, even when its name is gone. Throws as the constructor;
    /// then there are no more packets.
    void restart();

    /// The next packet that holds something of the video; false at the end.
    bool next(AVPacket& packet) noexcept;
    /// To the last place before `stamp` where decoding can start, as far as the container tells; false when it cannot.
    bool seek(std::int64_t stamp) noexcept;

    const AVStream& video() const { return *format_->streams[video_]; }
    /// FFmpeg's name of the container.
    const char* container() const { return format_->iformat->name; }
    bool single_image() const;
    /// 0..1, how far into the file the last bytes were read from.
    double read_share() const { return size_ > 0 ? static_cast<double>(offset_) / static_cast<double>(size_) : 0.0; }
    /// Whether more was wanted than the file holds.
    bool ran_out() const { return avio_feof(io_.get()) != 0; }

  private:
    static int read(void* self, std::uint8_t* into, int size);
    static std::int64_t move(void* self, std::int64_t offset, int whence);
    void look_at_streams();
    void require_image_size() const;
    void require_size(std::int64_t width, std::int64_t height) const;
    void choose_video();

    const std::filesystem::path path_;
    int descriptor_ = -1;
    std::int64_t size_ = 0, offset_ = 0;
    libav::Io io_;
    libav::Format format_;
    int video_ = 0;
};

}  // namespace lapfx::media
