#include "media/media_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/authoring/file_guard.h"
#include "media/clip_file.h"
#include "media/image.h"
#include "media/matroska.h"
#include "media/orientation.h"

namespace lapfx::media {

namespace {

constexpr int maximum_side = 8192;  // pixels: 8K
constexpr int io_buffer = 1 << 16;  // bytes
constexpr int patience = 64;        // consecutive faulty places of a file that are skipped

/// Containers of video and single images. What is not in the list (playlists, devices, text, scripts) is never read.
constexpr const char* formats =
    "mov,mp4,m4a,3gp,3g2,mj2,matroska,webm,avi,mpeg,mpegts,mpegvideo,ogg,asf,flv,ivf,nut,mxf,dv,vc1,obu,av1,rm,wtv,"
    "yuv4mpegpipe,m4v,h263,h264,hevc,mjpeg,gif,apng,png_pipe,jpeg_pipe,jpegls_pipe,jpegxl_pipe,j2k_pipe,webp_pipe,"
    "bmp_pipe,tiff_pipe,qoi_pipe,sgi_pipe,psd_pipe,dpx_pipe,exr_pipe";

/// A clip is one file: what the file names besides is never opened.
int refuse_other_file(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**) {
    return AVERROR(EACCES);
}

}  // namespace

MediaFile::MediaFile(const std::filesystem::path& path) : path_(path) {
    require_clip_file(path);
    note_read(path);
    // Does not wait, in case a pipe has replaced the file since.
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0) throw bad_clip(path, "cannot be read");
    try {
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) throw bad_clip(path, "is not a plain file");
        size_ = status.st_size;
        require_still_image();
        restart();
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

MediaFile::~MediaFile() {
    format_.reset();
    io_.reset();
    ::close(descriptor_);
}

int MediaFile::read(void* self, std::uint8_t* into, int size) {
    auto& file = *static_cast<MediaFile*>(self);
    const ssize_t count = ::pread(file.descriptor_, into, static_cast<std::size_t>(size), file.offset_);
    if (count < 0) return AVERROR(errno);
    file.offset_ += count;
    return count == 0 ? AVERROR_EOF : static_cast<int>(count);
}

std::int64_t MediaFile::move(void* self, std::int64_t offset, int whence) {
    auto& file = *static_cast<MediaFile*>(self);
    whence &= ~AVSEEK_FORCE;
    if (whence == AVSEEK_SIZE) return file.size_;
    if (whence == SEEK_CUR) offset += file.offset_;
    if (whence == SEEK_END) offset += file.size_;
    if (offset < 0) return AVERROR(EINVAL);
    return file.offset_ = offset;
}

void MediaFile::restart() {
    be_quiet();  // again: what else uses FFmpeg in this process, as OpenCV does, may have made it talk since
    format_.reset();
    io_.reset();
    offset_ = 0;
    auto* buffer = static_cast<unsigned char*>(libav::made(av_malloc(io_buffer)));
    io_.reset(avio_alloc_context(buffer, io_buffer, 0, this, read, nullptr, move));
    if (!io_) {
        av_free(buffer);
        throw std::bad_alloc();
    }
    AVFormatContext* format = libav::made(avformat_alloc_context());
    format->pb = io_.get();
    format->io_open = refuse_other_file;
    format->protocol_whitelist = av_strdup("");
    format->format_whitelist = av_strdup(formats);
    // Recognises the format only by content, because there is no name. It is freed when it fails.
    if (avformat_open_input(&format, "", nullptr, nullptr) < 0) throw bad_clip(path_, not_decodable);
    format_.reset(format);
    look_at_streams();
    choose_video();
}

/// FFmpeg decodes some frames here already, before a decoder of ours is told how large they may be.
void MediaFile::look_at_streams() {
    for (unsigned i = 0; i < format_->nb_streams; ++i)
        require_size(format_->streams[i]->codecpar->width, format_->streams[i]->codecpar->height);
    std::vector<AVDictionary*> options(format_->nb_streams, nullptr);
    for (AVDictionary*& one : options) av_dict_set_int(&one, "max_pixels", maximum_pixels, 0);
    const int result = avformat_find_stream_info(format_.get(), options.data());
    for (AVDictionary*& one : options) av_dict_free(&one);
    if (result < 0) throw bad_clip(path_, not_decodable);
}

std::vector<std::uint8_t> MediaFile::bytes_at(std::int64_t offset, std::size_t size) const {
    std::vector<std::uint8_t> bytes(size);
    const ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), offset);
    bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return bytes;
}

std::vector<std::uint8_t> MediaFile::head() const {
    return bytes_at(0, io_buffer);
}

/// Single images state their size at the beginning. FFmpeg forgets it if the image is too large for its decoders, and
/// has none for a WebP that moves.
void MediaFile::require_still_image() const {
    const std::vector<std::uint8_t> begin = head();
    media::ImageSize size;
    if (media::image_size(begin, size)) require_size(size.width, size.height);
    if (media::is_animated_webp(begin)) throw bad_clip(path_, animated_webp);
}

int MediaFile::orientation() const {
    return exif_orientation([this](std::int64_t offset, std::size_t size) { return bytes_at(offset, size); });
}

std::int64_t MediaFile::stated_size() const {
    return matroska_size(head());
}

void MediaFile::require_size(std::int64_t width, std::int64_t height) const {
    if (width > maximum_side || height > maximum_side)
        throw bad_clip(path_, "is " + std::to_string(width) + "x" + std::to_string(height) + " pixels; at most " +
                                  std::to_string(maximum_side) + " a side are allowed");
}

void MediaFile::choose_video() {
    video_ = av_find_best_stream(format_.get(), AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (video_ < 0 || (video().disposition & AV_DISPOSITION_ATTACHED_PIC) != 0)
        throw bad_clip(path_, "contains no picture");
    for (unsigned i = 0; i < format_->nb_streams; ++i)
        if (static_cast<int>(i) != video_) format_->streams[i]->discard = AVDISCARD_ALL;
    require_size(video().codecpar->width, video().codecpar->height);
}

bool MediaFile::next(AVPacket& packet) noexcept {
    be_quiet();
    for (int faults = 0; format_ != nullptr && faults < patience;) {
        av_packet_unref(&packet);
        const int result = av_read_frame(format_.get(), &packet);
        if (result == AVERROR_EOF) return false;
        if (result < 0) {
            ++faults;
            continue;
        }
        // Empty packets repeat the frame before: that one is shown for longer.
        if (packet.stream_index == video_ && packet.size > 0) return true;
    }
    av_packet_unref(&packet);
    return false;
}

bool MediaFile::seek(std::int64_t stamp) noexcept {
    return format_ != nullptr && av_seek_frame(format_.get(), video_, stamp, AVSEEK_FLAG_BACKWARD) >= 0;
}

bool MediaFile::single_image() const {
    return std::string_view(container()).ends_with("_pipe");
}

}  // namespace lapfx::media
