// The picture of a plate (lapfx/scene.h): a clear frame of a video, alone or blended with its neighbours. Any thread.
#pragma once

#include <atomic>

#include "lapfx/authoring/video.h"
#include "lapfx/scene.h"
#include "media/valid_view.h"
#include "work/stages.h"

namespace lapfx::media {

struct PlatePicture {
    Image image;  ///< sRGB; alpha: ValidView::share
    ValidView view;
    double time = 0.0;  ///< s in the video, of the frame that the others are laid over
    int blended = 1;    ///< frames in it
    int left_out = 0;   ///< frames that could not be laid over it
};

/// Throws Error (bad_input, at /plate/time of no file) when the chosen time is outside the video; Stopped, also when
/// another thread sets `stop`, which ends a long search for a frame.
PlatePicture plate_picture(VideoReader& video, const ScenePlate& wanted, const work::Stages& stages = {},
                           const std::atomic<bool>* stop = nullptr);

/// The clearest frame: among up to 48, evenly from the whole video, that with much contrast and colour and a thin veil.
/// Dark ones do not count. Throws Stopped.
int clearest_frame(VideoReader& video, const work::Stages& stages = {}, const std::atomic<bool>* stop = nullptr);

/// How clear a picture is, in proportion; for comparing frames of one video.
struct Clearness {
    double contrast = 0.0;  ///< mean steepness
    double saturation = 0.0;
    double veil = 0.0;   ///< mean of the dark channel (He et al. 2009), 0..1
    double light = 0.0;  ///< mean luma, 0..1
    double value() const { return contrast * saturation * (1.0 - veil) * (1.0 - veil); }
};
Clearness clearness_of(const Image& picture, const ValidView& view);

/// Lays the others over the first picture and takes the median of each pixel and channel, where at least one of them
/// shows it. `left_out` counts those that cannot be laid over it.
Image blended(const std::vector<Image>& pictures, const ValidView& view, int& left_out,
              const work::Stages& stages = {});

}  // namespace lapfx::media
