#include "media/frame_converter.h"

#include <algorithm>
#include <cstring>

#include "media/color_tags.h"
#include "work/stopwatch.h"

extern "C" {
#include <libavutil/pixdesc.h>
}

namespace lapfx::media {

namespace {

constexpr int high_definition = 720;  // rows from which BT.709 is assumed when the file does not say

bool is_planar_420(int format) {
    return format == AV_PIX_FMT_YUV420P || format == AV_PIX_FMT_YUVJ420P || format == AV_PIX_FMT_YUVA420P;
}

/// Whether it is one of the formats whose name says that their range is full.
bool is_full_range_format(int format) {
    return format == AV_PIX_FMT_YUVJ420P || format == AV_PIX_FMT_YUVJ422P || format == AV_PIX_FMT_YUVJ444P ||
           format == AV_PIX_FMT_YUVJ440P || format == AV_PIX_FMT_YUVJ411P;
}

bool is_rgb(const AVPixFmtDescriptor& format) {
    return (format.flags & (AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL)) != 0 || format.nb_components == 0;
}

int space_of(const AVFrame& frame) {
    switch (frame.colorspace) {
        case AVCOL_SPC_BT709:
            return SWS_CS_ITU709;
        case AVCOL_SPC_FCC:
            return SWS_CS_FCC;
        case AVCOL_SPC_BT470BG:
        case AVCOL_SPC_SMPTE170M:
            return SWS_CS_ITU601;
        case AVCOL_SPC_SMPTE240M:
            return SWS_CS_SMPTE240M;
        case AVCOL_SPC_BT2020_NCL:
        case AVCOL_SPC_BT2020_CL:
            return SWS_CS_BT2020;
        default:
            break;
    }
    const PrimariesRow* primaries = color_tags(frame).primaries;
    if (primaries != nullptr && primaries->primaries == AVCOL_PRI_BT2020) return SWS_CS_BT2020;
    return frame.height < high_definition ? SWS_CS_ITU601 : SWS_CS_ITU709;
}

void copy_rows(const std::uint8_t* from, std::ptrdiff_t stride, std::uint8_t* into, int width, int height) {
    for (int y = 0; y < height; ++y, from += stride, into += width)
        std::memcpy(into, from, static_cast<std::size_t>(width));
}

void interleave(const std::uint8_t* __restrict first, const std::uint8_t* __restrict second,
                std::uint8_t* __restrict into, int count) {
    constexpr int block = 32;  // a fixed number of steps, which the compiler turns into vector instructions
    int i = 0;
    for (; i + block <= count; i += block)
        for (int k = 0; k < block; ++k) {
            into[2 * (i + k)] = first[i + k];
            into[2 * (i + k) + 1] = second[i + k];
        }
    for (; i < count; ++i) {
        into[2 * i] = first[i];
        into[2 * i + 1] = second[i];
    }
}

void interleave(const std::uint8_t* __restrict first, const std::uint8_t* __restrict second,
                const std::uint8_t* __restrict third, std::uint8_t* __restrict into, int count) {
    for (int i = 0; i < count; ++i, into += 3) {
        into[0] = first[i];
        into[1] = second[i];
        into[2] = third[i];
    }
}

/// How the frame's own code values are to be read.
ClipColor stored_color_of(const AVFrame& frame) {
    const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
    if (format == nullptr || is_rgb(*format)) return {.space = SWS_CS_ITU601, .full_range = true};
    const bool gray = format->nb_components <= 2;  // with or without opacity; without chroma, which would have a range
    const bool full = frame.color_range == AVCOL_RANGE_JPEG || is_full_range_format(frame.format) ||
                      (gray && frame.color_range == AVCOL_RANGE_UNSPECIFIED);
    return {.space = space_of(frame), .full_range = full};
}

}  // namespace

ClipColor color_of(const AVFrame& frame) {
    if (color_tags(frame).converted()) return {.space = SWS_CS_ITU601, .full_range = true};
    return stored_color_of(frame);
}

ColorMatrix matrix_of(const ClipColor& color) {
    switch (color.space) {
        case SWS_CS_ITU709:
            return color_matrix(0.2126f, 0.0722f, color.full_range);
        case SWS_CS_FCC:
            return color_matrix(0.30f, 0.11f, color.full_range);
        case SWS_CS_SMPTE240M:
            return color_matrix(0.212f, 0.087f, color.full_range);
        case SWS_CS_BT2020:
            return color_matrix(0.2627f, 0.0593f, color.full_range);
        default:
            return color_matrix(0.299f, 0.114f, color.full_range);
    }
}

bool has_alpha(int pixel_format) {
    const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(pixel_format));
    return format != nullptr && (format->flags & AV_PIX_FMT_FLAG_ALPHA) != 0;
}

bool is_opaque(const AVFrame& frame) {
    if (!has_alpha(frame.format)) return true;
    const PictureFormat format{.size = {frame.width, frame.height}, .layout = Layout::planar, .alpha = true};
    std::vector<std::uint8_t> bytes(format.bytes());
    FrameConverter(format, color_of(frame)).convert(frame, bytes);
    const auto opacity = bytes.end() - static_cast<std::ptrdiff_t>(format.alpha_bytes());
    return std::all_of(opacity, bytes.end(), [](std::uint8_t a) { return a == 255; });
}

/// Whether a frame's planes can be used as those of a planar picture without conversion.
bool FrameConverter::fits(const AVFrame& frame) const {
    return format_.layout == Layout::planar && is_planar_420(frame.format) && frame.width == format_.size.x &&
           frame.height == format_.size.y && color_of(frame).full_range == color_.full_range;
}

AVPixelFormat FrameConverter::target(const PictureFormat& format) {
    if (format.layout == Layout::rgb) return format.alpha ? AV_PIX_FMT_GBRAP : AV_PIX_FMT_GBRP;
    return format.alpha ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
}

void FrameConverter::copy_planar(const AVFrame& frame, std::uint8_t* into) const {
    const glm::ivec2 size = format_.size, chroma = format_.chroma_size();
    copy_rows(frame.data[0], frame.linesize[0], into, size.x, size.y);
    into += format_.color_bytes();
    for (int y = 0; y < chroma.y; ++y, into += 2 * chroma.x)
        interleave(frame.data[1] + std::ptrdiff_t{y} * frame.linesize[1],
                   frame.data[2] + std::ptrdiff_t{y} * frame.linesize[2], into, chroma.x);
    if (!format_.alpha) return;
    if (has_alpha(frame.format))
        copy_rows(frame.data[3], frame.linesize[3], into, size.x, size.y);
    else
        std::memset(into, 255, format_.alpha_bytes());
}

void FrameConverter::copy_rgb(const AVFrame& frame, std::uint8_t* into) const {
    const glm::ivec2 size = format_.size;
    for (int y = 0; y < size.y; ++y, into += 3 * size.x) {
        const auto row = [&](int plane) { return frame.data[plane] + std::ptrdiff_t{y} * frame.linesize[plane]; };
        interleave(row(2), row(0), row(1), into, size.x);  // FFmpeg's order of planes is G, B, R
    }
    if (format_.alpha) copy_rows(frame.data[3], frame.linesize[3], into, size.x, size.y);
}

void FrameConverter::convert(const AVFrame& frame, std::span<std::uint8_t> into) {
    const AVFrame* from = &frame;
    if (color_tags(frame).converted()) {
        const work::Stopwatch watch(convert_seconds_);
        if (sdr_ == nullptr) sdr_ = std::make_unique<SdrConverter>();
        from = &sdr_->convert(frame, stored_color_of(frame));
    }
    if (!fits(*from)) {
        const work::Stopwatch watch(convert_seconds_);
        from = &scaler_.convert(*from, color_of(*from), format_.size);
    }
    const work::Stopwatch watch(copy_seconds_);
    if (format_.layout == Layout::planar)
        copy_planar(*from, into.data());
    else
        copy_rgb(*from, into.data());
}

void FrameConverter::make_black(std::span<std::uint8_t> into) const {
    const bool limited = format_.layout == Layout::planar && !color_.full_range;
    const std::span color = into.first(format_.color_bytes());
    const std::span chroma = into.subspan(color.size(), format_.chroma_bytes());
    std::memset(color.data(), limited ? 16 : 0, color.size());
    std::memset(chroma.data(), 128, chroma.size());
    std::memset(chroma.data() + chroma.size(), 0, format_.alpha_bytes());
}

}  // namespace lapfx::media
