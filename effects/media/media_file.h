// The video packets of one plain local file, read by FFmpeg's libavformat. Not thread safe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "media/libav.h"

namespace lapfx::media {

/// The largest picture that FFmpeg's decoders may make: 8K squared. A file may claim any size.
constexpr std::int64_t maximum_pixels = std::int64_t{8192} * 8192;

class MediaFile {
  public:
    /// Throws Error (bad_input): not a plain local file, a playlist, an unknown format, no pictures, or too large ones.
    explicit MediaFile(const std::filesystem::path& path);
    ~MediaFile();
    MediaFile(const MediaFile&) = delete;
    MediaFile& operator=(const MediaFile&) = delete;

    /// Goes to the first packet of the file that was opened, even if its name does not exist any more. Throws like the
    /// constructor; then there are no more packets.
    void restart();

    /// The next packet of the video that is not empty; false at the end.
    bool next(AVPacket& packet) noexcept;
    /// Goes to the last place before `stamp` where decoding can start, according to the container; false when it does
    /// not know.
    bool seek(std::int64_t stamp) noexcept;

    const AVStream& video() const { return *format_->streams[video_]; }
    /// FFmpeg's name of the container.
    const char* container() const { return format_->iformat->name; }
    bool single_image() const;
    /// How a picture is to be turned according to its own EXIF data: EXIF's number, 1 for upright. JPEGs say it in
    /// their frames.
    int orientation() const;
    /// Position in the file of the bytes that were read last, 0..1.
    double read_share() const { return size_ > 0 ? static_cast<double>(offset_) / static_cast<double>(size_) : 0.0; }
    std::int64_t size() const { return size_; }  ///< bytes
    /// Bytes of the whole file according to its own beginning, for Matroska and WebM. 0: it does not say.
    std::int64_t stated_size() const;
    /// Whether more bytes were wanted than the file has.
    bool ran_out() const { return avio_feof(io_.get()) != 0; }

  private:
    static int read(void* self, std::uint8_t* into, int size);
    static std::int64_t move(void* self, std::int64_t offset, int whence);
    void look_at_streams();
    std::vector<std::uint8_t> bytes_at(std::int64_t offset, std::size_t size) const;
    std::vector<std::uint8_t> head() const;
    void require_still_image() const;
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
