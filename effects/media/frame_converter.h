// From FFmpeg's frames, of whatever pixel format and size, to a clip's pictures. Not thread safe.
#pragma once

#include <memory>
#include <span>

#include "media/clip_index.h"
#include "media/frame_scaler.h"
#include "media/libav.h"
#include "media/picture.h"
#include "media/sdr_converter.h"

namespace lapfx::media {

/// The colours of a frame's planes, or of the planes that it is converted to: YCbCr keeps its colour space and range,
/// everything else, HDR and wide gamuts too (sdr_converter.h), becomes BT.601 of full range.
ClipColor color_of(const AVFrame& frame);
ColorMatrix matrix_of(const ClipColor& color);

bool has_alpha(int pixel_format);
/// Whether all of a frame is opaque, although it has opacity.
bool is_opaque(const AVFrame& frame);

class FrameConverter {
  public:
    FrameConverter(PictureFormat format, ClipColor color)
        : format_(format), color_(color), scaler_(target(format), color) {}

    const PictureFormat& format() const { return format_; }
    const ClipColor& color() const { return color_; }

    /// Writes the frame, scaled to the format's size, into `into`, which has the format's bytes; it is written once, in
    /// order, and not read. Throws std::bad_alloc, or Error for what cannot be converted.
    void convert(const AVFrame& frame, std::span<std::uint8_t> into);
    /// A picture that shows nothing.
    void make_black(std::span<std::uint8_t> into) const;

    double convert_seconds() const { return convert_seconds_; }
    double copy_seconds() const { return copy_seconds_; }

  private:
    bool fits(const AVFrame& frame) const;
    static AVPixelFormat target(const PictureFormat& format);
    void copy_planar(const AVFrame& frame, std::uint8_t* into) const;
    void copy_rgb(const AVFrame& frame, std::uint8_t* into) const;

    PictureFormat format_;
    ClipColor color_;
    FrameScaler scaler_;
    std::unique_ptr<SdrConverter> sdr_;  ///< once there was a frame that needs it
    double convert_seconds_ = 0.0, copy_seconds_ = 0.0;
};

}  // namespace lapfx::media
