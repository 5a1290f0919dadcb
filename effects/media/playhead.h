// Which frames of a clip are shown at a time: in and out points, speed, loop by cross-fade, seeded start. Pure
// functions, any thread.
#pragma once

#include "lapfx/smoke_parameters.h"
#include "media/decoder.h"
#include "media/loop.h"

namespace lapfx::media {

struct Playhead {
    int frame = 0;
    int fading = -1;    ///< a second frame, from the end of the loop, that fades out; -1: none
    double fade = 0.0;  ///< its share, 0..1; the first frame has the rest
};

/// `time`: s, any. `chance`: a seeded random number, for a seeded start.
Playhead playhead(const ClipInfo& clip, const SmokeClip& settings, std::uint32_t chance, double time) noexcept;

/// The frames that Playhead::frame passes through.
Loop main_loop(const ClipInfo& clip, const SmokeClip& settings) noexcept;
/// The frames of Playhead::fading: the end of the clip, which fades over its beginning.
Loop fading_loop(const ClipInfo& clip, const SmokeClip& settings) noexcept;

}  // namespace lapfx::media
