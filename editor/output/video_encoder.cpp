#include "output/video_encoder.h"

#include <array>
#include <cassert>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <new>
#include <utility>

#include "output/files.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

namespace lapfx::output {

namespace {

namespace fs = std::filesystem;

constexpr double slowest = 0.001, fastest = 10'000;  // frames per second
constexpr int largest_number = 65'535;               // MPEG-4 part 2 takes no larger number in the fraction of a rate
constexpr int high_definition = 720;                 // rows from which BT.709 is assumed of a video without tags

struct Free {
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
    void operator()(AVFormatContext* file) const {
        avio_closep(&file->pb);
        avformat_free_context(file);
    }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

template <class T>
Owned<T> made(T* object) {
    if (object == nullptr) throw std::bad_alloc();
    return Owned<T>(object);
}

/// FFmpeg and x264 print lines of their own. The log level belongs to the whole process: a host that has set one keeps
/// it. INFO is FFmpeg's default, ERROR the level that OpenCV sets.
void be_quiet() {
    const int level = av_log_get_level();
    if (level == AV_LOG_INFO || level == AV_LOG_ERROR) av_log_set_level(AV_LOG_QUIET);
}

std::string words_of(int error) {
    std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
    av_strerror(error, text.data(), text.size());
    return text.data();
}

/// What each encoder is told of its own: the quality, and how it works.
void set_up(AVCodecContext& c, std::string_view encoder, const QualityRow& quality) {
    c.pix_fmt = AV_PIX_FMT_YUV420P;
    if (encoder == "libx264") {
        av_opt_set_int(c.priv_data, "crf", quality.crf_h264, 0);
        c.thread_count = 0;  // x264 takes as many as it thinks right
    } else if (encoder == "libx265") {
        av_opt_set_int(c.priv_data, "crf", quality.crf_h265, 0);
        av_opt_set(c.priv_data, "x265-params", "log-level=none", 0);  // it does not print through FFmpeg
    } else if (encoder == "mpeg4") {
        c.flags |= AV_CODEC_FLAG_QSCALE;
        c.global_quality = FF_QP2LAMBDA * quality.quantizer_mpeg4;
    } else if (encoder == "ffv1") {
        c.pix_fmt = AV_PIX_FMT_BGR0;
        c.level = 3;     // with sums that show what is damaged
        c.gop_size = 1;  // each frame alone: a jump costs one
        c.thread_count = 0;
    }
}

bool is_rgb(const AVCodecContext& c) {
    return c.pix_fmt == AV_PIX_FMT_BGR0;
}

/// Says BT.709 wherever the stream or the container can; in AVI, MPEG-4 part 2 cannot.
void set_colors(AVCodecContext& c, const AVOutputFormat& container) {
    c.color_primaries = AVCOL_PRI_BT709;
    c.color_trc = AVCOL_TRC_BT709;
    c.colorspace = is_rgb(c) ? AVCOL_SPC_RGB : AVCOL_SPC_BT709;
    c.color_range = is_rgb(c) ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
    if (!is_rgb(c)) c.chroma_sample_location = AVCHROMA_LOC_LEFT;
    const bool untagged = c.codec_id == AV_CODEC_ID_MPEG4 && std::string_view(container.name) == "avi";
    if (untagged && c.height < high_definition) c.colorspace = AVCOL_SPC_SMPTE170M;  // what is assumed then
}

Owned<SwsContext> converter_to(const AVCodecContext& c) {
    Owned<SwsContext> scaler = made(sws_alloc_context());
    const int flags = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_FULL_CHR_H_INP;
    const std::pair<const char*, int> options[] = {
        {"srcw", c.width},         {"srch", c.height},       {"src_format", AV_PIX_FMT_RGB0},
        {"src_range", 1},          {"dstw", c.width},        {"dsth", c.height},
        {"dst_format", c.pix_fmt}, {"dst_range", is_rgb(c)}, {"sws_flags", flags},
    };
    for (const auto& [name, value] : options) av_opt_set_int(scaler.get(), name, value, 0);
    if (!is_rgb(c)) {  // chroma lies left, halfway between two rows
        av_opt_set_int(scaler.get(), "dst_h_chr_pos", 0, 0);
        av_opt_set_int(scaler.get(), "dst_v_chr_pos", 128, 0);
    }
    if (sws_init_context(scaler.get(), nullptr, nullptr) < 0) return nullptr;
    const int* const space = sws_getCoefficients(c.colorspace == AVCOL_SPC_BT709 ? SWS_CS_ITU709 : SWS_CS_ITU601);
    sws_setColorspaceDetails(scaler.get(), space, 1, space, is_rgb(c), 0, 1 << 16, 1 << 16);
    return scaler;
}

Owned<AVFrame> frame_of(int width, int height, int format) {
    Owned<AVFrame> frame = made(av_frame_alloc());
    frame->width = width;
    frame->height = height;
    frame->format = format;
    if (av_frame_get_buffer(frame.get(), 0) < 0) throw std::bad_alloc();
    return frame;
}

}  // namespace

struct VideoEncoder::State {
    State(const fs::path& written, const VideoFormat& wanted, fs::path named)
        : format(wanted), path(written.string()), shown(std::move(named)) {}

    std::string what() const;
    void open();
    bool open_encoder(const AVCodec& found);
    void open_file();
    void begin_frames();
    void put(const Image& image);
    void encode(const AVFrame* frame);
    void write_packets();
    /// Of FFmpeg's answer to something that writes to the file.
    void require_written(int answer) const;

    VideoFormat format;
    std::string path;
    fs::path shown;
    AVRational rate{};
    Owned<AVFormatContext> file;
    Owned<AVCodecContext> codec;
    Owned<SwsContext> scaler;
    Owned<AVFrame> picture, frame;  ///< the picture as it comes, and the frame as it is encoded
    Owned<AVPacket> packet = made(av_packet_alloc());
    AVStream* stream = nullptr;
    std::int64_t frames = 0;
};

/// "a video of 1280x1024 pixels and 25 frames a second"
std::string VideoEncoder::State::what() const {
    std::array<char, 32> fps{};
    std::snprintf(fps.data(), fps.size(), "%.6g", format.fps);
    return "a video of " + std::to_string(format.size.x) + "x" + std::to_string(format.size.y) + " pixels and " +
           fps.data() + " frames a second";
}

void VideoEncoder::State::require_written(int answer) const {
    if (answer >= 0) return;
    // The muxer's own answer may be of what followed from the fault of the file.
    const int error = file->pb != nullptr && file->pb->error < 0 ? file->pb->error : answer;
    const bool full = error == AVERROR(ENOSPC) || error == AVERROR(EFBIG) || error == AVERROR(EDQUOT);
    throw cannot_write(shown, "writing failed: " + words_of(error) + (full ? "; is the disk full?" : ""));
}

/// The first of the encoders that is there and takes this size and rate.
void VideoEncoder::State::open() {
    const CodecRow& row = row_of(format.codec);
    const std::string as = format.codec == Codec::h264 ? "" : " as " + std::string(row.title);
    if (!(format.fps >= slowest && format.fps <= fastest))
        throw cannot_write(shown, what() + " cannot be encoded here" + as);
    rate = av_d2q(format.fps, largest_number);
    AVFormatContext* opened = nullptr;
    if (avformat_alloc_output_context2(&opened, nullptr, nullptr, path.c_str()) < 0)
        throw cannot_write(shown, "is not the name of a video that can be written");
    file.reset(opened);
    file->flags |= AVFMT_FLAG_BITEXACT;  // no numbers by chance in it
    bool any = false;
    for (const std::string_view name : format.encoders.empty() ? row.encoders : format.encoders) {
        const AVCodec* const found = avcodec_find_encoder_by_name(std::string(name).c_str());
        if (found == nullptr) continue;
        any = true;
        if (!open_encoder(*found)) continue;
        open_file();
        begin_frames();
        return;
    }
    if (!any)
        throw cannot_write(shown, std::string(row.title) + " cannot be encoded here: FFmpeg has no encoder for it");
    throw cannot_write(shown, what() + " cannot be encoded here" + as);
}

bool VideoEncoder::State::open_encoder(const AVCodec& found) {
    codec = made(avcodec_alloc_context3(&found));
    AVCodecContext& c = *codec;
    c.width = format.size.x;
    c.height = format.size.y;
    c.sample_aspect_ratio = {1, 1};
    c.framerate = rate;
    c.time_base = av_inv_q(rate);
    set_up(c, found.name, row_of(format.quality));
    set_colors(c, *file->oformat);
    if ((file->oformat->flags & AVFMT_GLOBALHEADER) != 0) c.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    // AVI has no time of a frame but its place: they have to come in the order in which they are shown.
    if (std::string_view(file->oformat->name) == "avi") c.max_b_frames = 0;
    if (avcodec_open2(&c, &found, nullptr) < 0) return false;
    scaler = converter_to(c);
    return scaler != nullptr;
}

void VideoEncoder::State::open_file() {
    stream = avformat_new_stream(file.get(), nullptr);
    if (stream == nullptr || avcodec_parameters_from_context(stream->codecpar, codec.get()) < 0) throw std::bad_alloc();
    stream->time_base = codec->time_base;
    stream->avg_frame_rate = stream->r_frame_rate = rate;
    stream->sample_aspect_ratio = codec->sample_aspect_ratio;
    const std::string_view container = file->oformat->name;
    const bool quicktime = container == "mp4" || container == "mov";
    if (quicktime && codec->codec_id == AV_CODEC_ID_HEVC) stream->codecpar->codec_tag = MKTAG('h', 'v', 'c', '1');
    require_written(avio_open(&file->pb, path.c_str(), AVIO_FLAG_WRITE));
    AVDictionary* options = nullptr;
    if (quicktime) av_dict_set(&options, "movflags", "+faststart", 0);  // a browser plays it while it loads
    const int answer = avformat_write_header(file.get(), &options);
    av_dict_free(&options);
    require_written(answer);
}

void VideoEncoder::State::begin_frames() {
    picture = frame_of(codec->width, codec->height, AV_PIX_FMT_RGB0);
    frame = frame_of(codec->width, codec->height, codec->pix_fmt);
    frame->color_primaries = codec->color_primaries;
    frame->color_trc = codec->color_trc;
    frame->colorspace = codec->colorspace;
    frame->color_range = codec->color_range;
    frame->chroma_location = codec->chroma_sample_location;
    frame->quality = codec->global_quality;
}

void VideoEncoder::State::put(const Image& image) {
    // The rows of `picture` are padded, because the converter reads beyond their ends.
    const int row = 4 * image.width;
    av_image_copy_plane(picture->data[0], picture->linesize[0], image.pixels.data(), row, row, image.height);
    if (av_frame_make_writable(frame.get()) < 0) throw std::bad_alloc();
    sws_scale(scaler.get(), picture->data, picture->linesize, 0, image.height, frame->data, frame->linesize);
    frame->pts = frames++;
    encode(frame.get());
}

/// Null: there are no more.
void VideoEncoder::State::encode(const AVFrame* next) {
    if (const int answer = avcodec_send_frame(codec.get(), next); answer < 0)
        throw cannot_write(shown, "a frame cannot be encoded: " + words_of(answer));
    write_packets();
}

void VideoEncoder::State::write_packets() {
    for (;;) {
        const int answer = avcodec_receive_packet(codec.get(), packet.get());
        if (answer == AVERROR(EAGAIN) || answer == AVERROR_EOF) return;
        if (answer < 0) throw cannot_write(shown, "a frame cannot be encoded: " + words_of(answer));
        if (packet->duration == 0) packet->duration = 1;
        av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
        packet->stream_index = stream->index;
        const int written = av_write_frame(file.get(), packet.get());
        av_packet_unref(packet.get());
        require_written(written);
    }
}

VideoEncoder::VideoEncoder(const fs::path& file, const VideoFormat& format, fs::path shown)
    : state_(std::make_unique<State>(file, format, shown.empty() ? file : std::move(shown))) {
    be_quiet();
    state_->open();
}

VideoEncoder::~VideoEncoder() = default;

void VideoEncoder::add(const Image& image) {
    assert(image.width == state_->format.size.x && image.height == state_->format.size.y);
    state_->put(image);
}

void VideoEncoder::finish() {
    state_->encode(nullptr);
    state_->require_written(av_write_trailer(state_->file.get()));
    state_->require_written(avio_closep(&state_->file->pb));
}

}  // namespace lapfx::output
