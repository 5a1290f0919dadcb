#include "media/frame_reader.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

extern "C" {
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
}

namespace lapfx::media {

namespace {

constexpr int silent = 100;  // above every level of FFmpeg's messages

/// FFmpeg's own VP8 and VP9 decoders ignore the opacity; those of the libvpx project, if FFmpeg was built with them, do
/// not.
const AVCodec* find_decoder(const AVStream& video, std::string& warning) {
    const AVCodecID id = video.codecpar->codec_id;
    const AVDictionaryEntry* alpha = av_dict_get(video.metadata, "alpha_mode", nullptr, 0);
    if (alpha != nullptr && std::string_view(alpha->value) == "1" && (id == AV_CODEC_ID_VP8 || id == AV_CODEC_ID_VP9)) {
        if (const AVCodec* codec = avcodec_find_decoder_by_name(id == AV_CODEC_ID_VP8 ? "libvpx" : "libvpx-vp9"))
            return codec;
        warning = "its opacity is not used: this FFmpeg has no libvpx";
    }
    return avcodec_find_decoder(id);
}

/// Whether the decoder has repaired the frame.
bool is_broken(const AVFrame& frame) {
    return (frame.flags & AV_FRAME_FLAG_CORRUPT) != 0 || frame.decode_error_flags != 0;
}

/// Decoders that leave the parts of a frame that they cannot decode as they are. Others repair the frame and report it.
bool leaves_gaps(AVCodecID codec) {
    switch (codec) {
        case AV_CODEC_ID_H264:
        case AV_CODEC_ID_HEVC:
        case AV_CODEC_ID_AV1:
        case AV_CODEC_ID_VP8:
        case AV_CODEC_ID_VP9:
        case AV_CODEC_ID_MPEG1VIDEO:
        case AV_CODEC_ID_MPEG2VIDEO:
        case AV_CODEC_ID_MPEG4:
            return false;
        default:
            return true;
    }
}

/// Gives the decoder black memory for a frame instead of the remains of an earlier frame, so that the bytes are always
/// the same.
int black_buffer(AVCodecContext* codec, AVFrame* frame, int flags) {
    const int result = avcodec_default_get_buffer2(codec, frame, flags);
    if (result < 0) return result;
    for (const AVBufferRef* buffer : frame->buf)
        if (buffer != nullptr) std::memset(buffer->data, 0, buffer->size);
    const ptrdiff_t strides[4] = {frame->linesize[0], frame->linesize[1], frame->linesize[2], frame->linesize[3]};
    av_image_fill_black(frame->data, strides, static_cast<AVPixelFormat>(frame->format), frame->color_range,
                        frame->width, frame->height);
    return result;
}

}  // namespace

FrameReader::FrameReader(const std::filesystem::path& path)
    : path_(path), file_(path), packet_(libav::made(av_packet_alloc())) {
    open_codec();
}

void FrameReader::open_codec() {
    const AVStream& video = file_.video();
    const AVCodec* decoder = find_decoder(video, warning_);
    if (decoder == nullptr) throw bad_clip(path_, not_decodable);
    libav::Codec codec(libav::made(avcodec_alloc_context3(decoder)));
    if (avcodec_parameters_to_context(codec.get(), video.codecpar) < 0) throw bad_clip(path_, not_decodable);
    codec->thread_count = 1;  // each clip has its own thread
    codec->pkt_timebase = video.time_base;
    codec->max_pixels = maximum_pixels;
    codec->log_level_offset = silent;
    if (leaves_gaps(video.codecpar->codec_id)) codec->get_buffer2 = black_buffer;
    if (video.codecpar->codec_id == AV_CODEC_ID_MJPEG) codec->err_recognition |= AV_EF_EXPLODE;  // faults fail
    // OpenEXR holds light, everything else code values.
    if (video.codecpar->codec_id == AV_CODEC_ID_EXR)
        av_opt_set_int(codec->priv_data, "apply_trc", AVCOL_TRC_IEC61966_2_1, 0);
    if (avcodec_open2(codec.get(), decoder, nullptr) < 0) throw bad_clip(path_, not_decodable);
    codec_ = std::move(codec);
}

void FrameReader::restart() {
    held_ = resets_ = drained_ = false;
    fresh_ = true;
    last_ = -1;
    count_ = 0;
    codec_.reset();  // there must be no decoder of another file if the file is not a video any more
    file_.restart();
    open_codec();
}

bool FrameReader::reach(const SeekPoint& point, std::int64_t stamp) noexcept {
    if (!file_.seek(stamp)) return false;
    while (file_.next(*packet_)) {
        if (packet_->pts == point.pts && packet_->dts == point.dts && packet_->pos == point.position) return true;
        if (packet_->dts != AV_NOPTS_VALUE && packet_->dts > point.dts) return false;
    }
    return false;
}

bool FrameReader::seek(const SeekPoint& point) noexcept {
    if (!codec_) return false;
    avcodec_flush_buffers(codec_.get());
    resets_ = drained_ = false;
    fresh_ = true;
    // Some containers seek by the time of showing, others by the time of decoding.
    held_ = reach(point, point.pts) || (point.dts != point.pts && reach(point, point.dts));
    last_ = point.frame - 1;
    return held_;
}

/// Whether the decoder is emptied before packet_. The repairs of FFmpeg's H.264 decoder use earlier frames, even across
/// IDR pictures; a damaged clip must show the same bytes wherever decoding has started.
bool FrameReader::starts_anew(const ClipIndex& index) const noexcept {
    if (fresh_ || codec_->codec_id != AV_CODEC_ID_H264) return false;
    const auto point = std::lower_bound(index.points.begin(), index.points.end(), packet_->pts,
                                        [](const SeekPoint& p, std::int64_t pts) { return p.pts < pts; });
    return point != index.points.end() && point->pts == packet_->pts;
}

/// The next packet to the decoder; false when there is nothing more to give it.
bool FrameReader::feed(const ClipIndex& index) noexcept {
    if (drained_) return false;
    if (!held_ && !file_.next(*packet_)) {
        drained_ = true;
        avcodec_send_packet(codec_.get(), nullptr);
        return true;
    }
    if (starts_anew(index)) {
        held_ = resets_ = true;
        avcodec_send_packet(codec_.get(), nullptr);
        return true;
    }
    fresh_ = false;
    const AVCodecDescriptor* known = codec_->codec_descriptor;
    const bool alone = known != nullptr && (known->props & AV_CODEC_PROP_INTRA_ONLY) != 0;
    if (alone && (packet_->flags & AV_PKT_FLAG_CORRUPT) != 0) {  // half a picture, which no other packet needs
        held_ = false;
        return true;
    }
    // A packet that the decoder refuses is lost; the next one may do.
    held_ = avcodec_send_packet(codec_.get(), packet_.get()) == AVERROR(EAGAIN);
    if (!held_) ++packets_;
    return true;
}

Step FrameReader::next(const ClipIndex& index, AVFrame& frame, int& number, const std::atomic<bool>* stop) noexcept {
    if (!codec_) return Step::end;
    const int frames = static_cast<int>(index.times.size());
    while (true) {
        if (stop != nullptr && stop->load(std::memory_order_relaxed)) return Step::stopped;
        const int result = avcodec_receive_frame(codec_.get(), &frame);
        if (result != 0) {
            if (resets_) {
                avcodec_flush_buffers(codec_.get());
                resets_ = false;
                fresh_ = true;
            }
            if ((result != AVERROR_EOF || !drained_) && feed(index)) continue;
            return Step::end;
        }
        int place = count_++;
        if (!index.stamps.empty() && frame.pts != AV_NOPTS_VALUE) place = index.frame_at(frame.pts);
        // Whether a frame is from before the place that was sought, or has the same time as an earlier one.
        if (place <= last_ || place >= frames || is_broken(frame)) continue;
        number = last_ = place;
        return Step::frame;
    }
}

}  // namespace lapfx::media
