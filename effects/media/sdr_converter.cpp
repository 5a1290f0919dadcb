#include "media/sdr_converter.h"

#include <algorithm>
#include <cmath>

#include "lapfx/authoring/srgb.h"

namespace lapfx::media {

namespace {

constexpr double white = 255 << 4;        // libswscale's largest of 12 bits, if it comes from YCbCr
constexpr double sdr_white = 203.0;       // cd/m2
constexpr double hlg_display = 1000.0;    // cd/m2
constexpr double hlg_system_gamma = 1.2;  // of such a display
constexpr PrimariesRow same{AVCOL_PRI_BT709, "", PrimariesRow::Gamut::usual, {}, {}, {}};

/// ITU-R BT.2100, table 4: 1 is 10,000 cd/m2.
double pq_light(double code) {
    constexpr double m1 = 2610.0 / 16384.0, m2 = 2523.0 / 4096.0 * 128.0;
    constexpr double c1 = 3424.0 / 4096.0, c2 = 2413.0 / 4096.0 * 32.0, c3 = 2392.0 / 4096.0 * 32.0;
    const double power = std::pow(code, 1.0 / m2);
    return std::pow(std::max(power - c1, 0.0) / (c2 - c3 * power), 1.0 / m1);
}

/// ITU-R BT.2100, table 5: light of the scene, 0..1.
double hlg_light(double code) {
    constexpr double a = 0.17883277, b = 1.0 - 4.0 * a;
    const double c = 0.5 - a * std::log(4.0 * a);
    return code <= 0.5 ? code * code / 3.0 : (std::exp((code - c) / a) + b) / 12.0;
}

/// 1 is the white of SDR; for HLG the light of the scene.
double light_of(const TransferRow& transfer, double code) {
    switch (transfer.curve) {
        case Curve::pq:
            return pq_light(code) * 10'000.0 / sdr_white;
        case Curve::hlg:
            return hlg_light(code);
        case Curve::srgb:
            return linear_of_srgb(code);
        case Curve::power:
            return std::pow(code, transfer.exponent);
        default:
            return code;
    }
}

/// SDR keeps its own curve, whatever that is: then grey stays as it is.
double code_of(const TransferRow& transfer, double light) {
    switch (transfer.curve) {
        case Curve::srgb:
        case Curve::linear:
            return srgb_of_linear(light);
        case Curve::power:
            return std::pow(light, 1.0 / transfer.exponent);
        default:
            return std::pow(light, 1.0 / display_exponent);
    }
}

/// A wide gamut without a word about the curve is that of video.
constexpr TransferRow video_transfer{AVCOL_TRC_BT709, "", Curve::power, display_exponent};

bool has_opacity(const AVFrame& frame) {
    const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
    return format != nullptr && (format->flags & AV_PIX_FMT_FLAG_ALPHA) != 0;
}

}  // namespace

void SdrConverter::prepare(const ColorTags& tags) {
    const TransferRow* transfer = tags.transfer != nullptr ? tags.transfer : &video_transfer;
    const PrimariesRow* primaries = tags.primaries != nullptr ? tags.primaries : &same;
    if (transfer == transfer_ && primaries == primaries_) return;
    for (std::size_t i = 0; i < codes; ++i)
        light_[i] = static_cast<float>(light_of(*transfer, std::min(static_cast<double>(i) / white, 1.0)));
    for (std::size_t i = 0; i < roots; ++i) {
        const double root = static_cast<double>(i) / (roots - 1), light = root * root;
        code_[i] = static_cast<std::uint8_t>(std::lround(255.0 * code_of(*transfer, light)));
        display_[i] = static_cast<float>(hlg_display / sdr_white * std::pow(light, hlg_system_gamma - 1.0));
    }
    gamut_ = to_bt709(*primaries);
    luminance_ = luminance_of(*primaries);
    transfer_ = transfer;
    primaries_ = primaries;
}

/// Planes are in FFmpeg's order: G, B, R.
template <bool hlg>
void SdrConverter::convert_row(const std::uint16_t* const (&from)[3], std::uint8_t* const (&into)[3], int width) const {
    const glm::mat3 m = gamut_;
    const glm::vec3 y = luminance_;
    constexpr float last = roots - 1;
    const auto code = [this](float light) {
        return code_[static_cast<std::size_t>(std::sqrt(std::clamp(light, 0.0f, 1.0f)) * last + 0.5f)];
    };
    constexpr std::size_t mask = codes - 1;
    for (int x = 0; x < width; ++x) {
        float g = light_[from[0][x] & mask], b = light_[from[1][x] & mask], r = light_[from[2][x] & mask];
        if constexpr (hlg) {
            const float root = std::sqrt(std::clamp(y.r * r + y.g * g + y.b * b, 0.0f, 1.0f));
            const float gain = display_[static_cast<std::size_t>(root * last + 0.5f)];
            r *= gain, g *= gain, b *= gain;
        }
        into[0][x] = code(m[0].g * r + m[1].g * g + m[2].g * b);
        into[1][x] = code(m[0].b * r + m[1].b * g + m[2].b * b);
        into[2][x] = code(m[0].r * r + m[1].r * g + m[2].r * b);
    }
}

void SdrConverter::make_frame(const AVFrame& like, bool alpha) {
    const AVPixelFormat format = alpha ? AV_PIX_FMT_GBRAP : AV_PIX_FMT_GBRP;
    if (made_ && made_->width == like.width && made_->height == like.height && made_->format == format) return;
    made_ = libav::frame_of(like.width, like.height, format);
    made_->color_range = AVCOL_RANGE_JPEG;
}

const AVFrame& SdrConverter::convert(const AVFrame& frame, const ClipColor& from) {
    const ColorTags tags = color_tags(frame);
    prepare(tags);
    const bool alpha = has_opacity(frame);
    std::optional<FrameScaler>& scaler = alpha ? with_opacity_ : colors_;
    if (!scaler)
        scaler.emplace(alpha ? AV_PIX_FMT_GBRAP12 : AV_PIX_FMT_GBRP12, ClipColor{SWS_CS_ITU601, /*full_range=*/true});
    const AVFrame& deep = scaler->convert(frame, from, {frame.width, frame.height});
    make_frame(frame, alpha);
    for (int y = 0; y < frame.height; ++y) {
        const auto deep_row = [&](int plane) {
            return reinterpret_cast<const std::uint16_t*>(deep.data[plane] + std::ptrdiff_t{y} * deep.linesize[plane]);
        };
        const auto row = [&](int plane) { return made_->data[plane] + std::ptrdiff_t{y} * made_->linesize[plane]; };
        const std::uint16_t* const deep_rows[] = {deep_row(0), deep_row(1), deep_row(2)};
        std::uint8_t* const rows[] = {row(0), row(1), row(2)};
        if (transfer_->curve == Curve::hlg)
            convert_row<true>(deep_rows, rows, frame.width);
        else
            convert_row<false>(deep_rows, rows, frame.width);
        if (!alpha) continue;
        const std::uint16_t* opacity = deep_row(3);
        std::transform(opacity, opacity + frame.width, row(3),
                       [](std::uint16_t a) { return static_cast<std::uint8_t>(a >> (depth - 8)); });
    }
    return *made_;
}

}  // namespace lapfx::media
