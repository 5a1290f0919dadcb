// Frames whose odd and even rows were recorded one after the other become whole ones: the rows of the field that came
// first stay, and those between are made anew, as they were at that moment. Not thread safe.
//
// Where nothing moves the rows between are those of the fields before and after. Elsewhere they are what is between the
// rows above and below, with the fine detail of those fields (the filter of three fields by Weston, BBC), as far as
// these allow it. FFmpeg's bwdif does the same; it is in libavfilter, which would bring two dozen more libraries with
// it.
#pragma once

#include "media/libav.h"

namespace lapfx::media {

bool is_interlaced(const AVFrame& frame);

class Deinterlacer {
  public:
    /// Whether frames of this pixel format are converted.
    static bool can(int pixel_format);

    /// `before` and `after`: the frames beside it, or null; without `before` only the frame's own rows are used. Valid
    /// until the next call; it is `frame` itself where its format cannot be converted.
    const AVFrame& convert(const AVFrame* before, const AVFrame& frame, const AVFrame* after);

  private:
    libav::Frame made_;
};

}  // namespace lapfx::media
