#include "media/deinterlacer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

extern "C" {
#include <libavutil/imgutils.h>
}

namespace lapfx::media {

namespace {

constexpr int least_rows = 4;

/// Rows of one plane, the first and last ones mirrored, so that each has the parity that was asked for.
template <class T>
struct Plane {
    const std::uint8_t* data;
    std::ptrdiff_t stride;
    int rows;

    const T* row(int y) const {
        if (y < 0) y = -y;
        if (y >= rows) y = 2 * (rows - 1) - y;
        return reinterpret_cast<const T*>(data + std::clamp(y, 0, rows - 1) * stride);
    }
};

/// Weights of the rows beside a missing one, by their distance.
constexpr float near_1 = 0.526f, near_3 = -0.026f;                      // of its own frame, with other fields
constexpr float field_0 = 0.170f, field_2 = -0.116f, field_4 = 0.031f;  // of the fields before and after
constexpr float alone_1 = 0.620f, alone_3 = -0.120f;                    // of its own frame alone

/// The row `y` from the rows of its own field alone.
template <class T>
void fill_alone(const Plane<T>& frame, int y, T* __restrict into, int width, float most) {
    const T *a1 = frame.row(y - 1), *b1 = frame.row(y + 1), *a3 = frame.row(y - 3), *b3 = frame.row(y + 3);
    for (int x = 0; x < width; ++x) {
        const float own = alone_1 * static_cast<float>(a1[x] + b1[x]) + alone_3 * static_cast<float>(a3[x] + b3[x]);
        into[x] = static_cast<T>(std::clamp(own, 0.0f, most) + 0.5f);
    }
}

/// The row `y` at the time of the rows beside it. Those of its own field were half a frame earlier, in `before`, and
/// half a frame later, in `frame`.
template <class T>
void fill(const Plane<T>& before, const Plane<T>& frame, const Plane<T>& after, int y, T* __restrict into, int width,
          float most) {
    const T *above = frame.row(y - 1), *below = frame.row(y + 1), *above_3 = frame.row(y - 3),
            *below_3 = frame.row(y + 3);
    const T *was_above = before.row(y - 1), *was_below = before.row(y + 1), *will_above = after.row(y - 1),
            *will_below = after.row(y + 1);
    const T *p0 = before.row(y), *n0 = frame.row(y), *pa2 = before.row(y - 2), *na2 = frame.row(y - 2),
            *pb2 = before.row(y + 2), *nb2 = frame.row(y + 2), *pa4 = before.row(y - 4), *na4 = frame.row(y - 4),
            *pb4 = before.row(y + 4), *nb4 = frame.row(y + 4);
    const auto sum = [](const T* p, const T* q, int x) { return static_cast<float>(p[x] + q[x]); };
    const auto apart = [](const T* p, const T* q, int x) { return std::abs(static_cast<float>(p[x] - q[x])); };
    for (int x = 0; x < width; ++x) {
        const float between = 0.5f * sum(p0, n0, x), moved = apart(p0, n0, x);
        const float since = 0.5f * (apart(was_above, above, x) + apart(was_below, below, x));
        const float until = 0.5f * (apart(will_above, above, x) + apart(will_below, below, x));
        const float change = std::max({0.5f * moved, since, until});
        // A field of fine rows also differs from its neighbours where nothing moves.
        const auto up = static_cast<float>(above[x]), down = static_cast<float>(below[x]);
        const float to_up = between - up, to_down = between - down;
        const float bent_up = 0.5f * sum(pa2, na2, x) - up, bent_down = 0.5f * sum(pb2, nb2, x) - down;
        const float high = std::max({to_up, to_down, std::min(bent_up, bent_down)});
        const float low = std::min({to_up, to_down, std::max(bent_up, bent_down)});
        const float allowed = change > 0.0f ? std::max({change, low, -high}) : 0.0f;

        const float own = up + down, own_3 = sum(above_3, below_3, x);
        const float detailed = near_1 * own + near_3 * own_3 + field_0 * sum(p0, n0, x) +
                               field_2 * (sum(pa2, na2, x) + sum(pb2, nb2, x)) +
                               field_4 * (sum(pa4, na4, x) + sum(pb4, nb4, x));
        const float plain = alone_1 * own + alone_3 * own_3;
        const float made = std::abs(up - down) > moved ? detailed : plain;
        const float bounded = std::min(std::max(made, between - allowed), between + allowed);
        into[x] = static_cast<T>(std::min(std::max(bounded, 0.0f), most) + 0.5f);
    }
}

/// A plane of the frames: its bytes a row, and its rows.
struct Extent {
    int number, bytes, rows;
};

template <class T>
void convert_plane(const AVFrame* before, const AVFrame& frame, const AVFrame* after, const Extent& extent, float most,
                   AVFrame& into) {
    const auto plane = [&](const AVFrame& of) {
        return Plane<T>{of.data[extent.number], of.linesize[extent.number], extent.rows};
    };
    const int first = frame.top_field_first != 0 ? 0 : 1;  // parity of the rows that stay
    const int width = extent.bytes / static_cast<int>(sizeof(T));
    const Plane<T> own = plane(frame);
    for (int y = 0; y < extent.rows; ++y) {
        auto* row = reinterpret_cast<T*>(into.data[extent.number] + std::ptrdiff_t{y} * into.linesize[extent.number]);
        if (y % 2 == first || extent.rows < least_rows)
            std::memcpy(row, own.row(y), static_cast<std::size_t>(extent.bytes));
        else if (before == nullptr)
            fill_alone(own, y, row, width, most);
        else
            fill(plane(*before), own, after == nullptr ? own : plane(*after), y, row, width, most);
    }
}

/// Bytes of the formats' numbers, 1 or 2; 0: they are not apart, or no whole numbers.
int number_bytes(const AVPixFmtDescriptor& format) {
    constexpr std::uint64_t others = AV_PIX_FMT_FLAG_PAL | AV_PIX_FMT_FLAG_BITSTREAM | AV_PIX_FMT_FLAG_HWACCEL |
                                     AV_PIX_FMT_FLAG_FLOAT | AV_PIX_FMT_FLAG_BAYER;
    if ((format.flags & others) != 0 || format.nb_components == 0) return 0;
    const std::span components(format.comp, format.nb_components);
    if (std::all_of(components.begin(), components.end(), [](const auto& c) { return c.depth == 8; })) return 1;
    const auto is_short = [](const auto& c) {
        return c.depth > 8 && c.depth <= 16 && c.step % 2 == 0 && c.offset % 2 == 0;
    };
    const bool shorts = std::all_of(components.begin(), components.end(), is_short);
    return shorts && (format.flags & AV_PIX_FMT_FLAG_BE) == 0 ? 2 : 0;
}

const AVPixFmtDescriptor* about(int pixel_format) {
    return av_pix_fmt_desc_get(static_cast<AVPixelFormat>(pixel_format));
}

/// The same pixels at another time.
bool is_like(const AVFrame* one, const AVFrame& other) {
    return one != nullptr && one->width == other.width && one->height == other.height && one->format == other.format;
}

}  // namespace

bool is_interlaced(const AVFrame& frame) {
    return frame.interlaced_frame != 0 && frame.height >= least_rows;
}

bool Deinterlacer::can(int pixel_format) {
    return about(pixel_format) != nullptr && number_bytes(*about(pixel_format)) != 0;
}

const AVFrame& Deinterlacer::convert(const AVFrame* before, const AVFrame& frame, const AVFrame* after) {
    if (!can(frame.format)) return frame;
    const AVPixFmtDescriptor& format = *about(frame.format);
    if (!is_like(made_.get(), frame)) made_ = libav::frame_of(frame.width, frame.height, frame.format);
    made_->color_range = frame.color_range;
    made_->colorspace = frame.colorspace;
    made_->color_trc = frame.color_trc;
    made_->color_primaries = frame.color_primaries;
    if (!is_like(before, frame)) before = nullptr;
    if (!is_like(after, frame)) after = nullptr;
    const int shift = format.comp[0].shift + format.comp[0].depth;
    const auto most = static_cast<float>((1 << shift) - 1);
    for (int number = 0; number < av_pix_fmt_count_planes(static_cast<AVPixelFormat>(frame.format)); ++number) {
        const bool chroma = (number == 1 || number == 2) && (format.flags & AV_PIX_FMT_FLAG_RGB) == 0;
        const Extent extent{
            .number = number,
            .bytes = av_image_get_linesize(static_cast<AVPixelFormat>(frame.format), frame.width, number),
            .rows = chroma ? AV_CEIL_RSHIFT(frame.height, format.log2_chroma_h) : frame.height};
        if (number_bytes(format) == 1)
            convert_plane<std::uint8_t>(before, frame, after, extent, most, *made_);
        else
            convert_plane<std::uint16_t>(before, frame, after, extent, most, *made_);
    }
    return *made_;
}

}  // namespace lapfx::media
