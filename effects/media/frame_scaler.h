// From FFmpeg's frames to frames of one pixel format and size, by libswscale. Not thread safe.
#pragma once

#include <glm/glm.hpp>

#include "media/clip_index.h"
#include "media/libav.h"

namespace lapfx::media {

class FrameScaler {
  public:
    FrameScaler(AVPixelFormat format, ClipColor color) : format_(format), color_(color) {}

    /// The frame, whose code values are to be read as `from`, at this size; valid until the next call. Throws
    /// std::bad_alloc, or Error for what cannot be converted.
    const AVFrame& convert(const AVFrame& frame, const ClipColor& from, glm::ivec2 size);

  private:
    struct Source {
        int width = 0, height = 0, format = -1, space = 0;
        bool full_range = false;
        glm::ivec2 size{0};  ///< of what is made of it
        friend bool operator==(const Source&, const Source&) = default;
    };
    void prepare(const Source& source);

    AVPixelFormat format_;
    ClipColor color_;
    libav::Scaler scaler_;
    libav::Frame scaled_;
    Source source_;  ///< the conversion that scaler_ does
};

}  // namespace lapfx::media
