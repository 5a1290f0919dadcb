// Owners for the objects of FFmpeg.
#pragma once

#include <memory>
#include <new>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace lapfx::media::libav {

/// Throws for FFmpeg's allocating functions, which cannot: a null pointer from one of them means that there is no
/// memory.
template <class T>
T* made(T* object) {
    if (object == nullptr) throw std::bad_alloc();
    return object;
}

struct Free {
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVFormatContext* format) const { avformat_close_input(&format); }
    void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
    void operator()(AVIOContext* io) const {
        av_freep(&io->buffer);
        avio_context_free(&io);
    }
};

using Packet = std::unique_ptr<AVPacket, Free>;
using Frame = std::unique_ptr<AVFrame, Free>;
using Codec = std::unique_ptr<AVCodecContext, Free>;
using Format = std::unique_ptr<AVFormatContext, Free>;
using Scaler = std::unique_ptr<SwsContext, Free>;
using Io = std::unique_ptr<AVIOContext, Free>;

/// A frame with memory for its pixels. Throws std::bad_alloc, also for a size that cannot be.
inline Frame frame_of(int width, int height, int format) {
    Frame frame(made(av_frame_alloc()));
    frame->width = width;
    frame->height = height;
    frame->format = format;
    if (av_frame_get_buffer(frame.get(), 0) < 0) throw std::bad_alloc();
    return frame;
}

}  // namespace lapfx::media::libav

namespace lapfx::media {

/// FFmpeg prints a line for each fault of a file. A library should not write to its host's stderr, but the log level
/// belongs to the whole process: a host that has set a level, or a callback (which ignores the level), keeps it. INFO
/// is FFmpeg's default, ERROR the level that OpenCV sets.
inline void be_quiet() {
    const int level = av_log_get_level();
    if (level == AV_LOG_INFO || level == AV_LOG_ERROR) av_log_set_level(AV_LOG_QUIET);
}

}  // namespace lapfx::media
