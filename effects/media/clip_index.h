// Which frames a clip has and when they are shown, from its packets alone.
//
// Not FFMS2, which makes such an index too: it opens files by name, and with that playlists and what they name; it does
// not tell that a file ends early, nor where decoding may start so that the frames are the same to the last bit; and it
// takes longer.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "media/clip_file.h"
#include "media/media_file.h"
#include "work/stages.h"

namespace lapfx::media {

/// How to read a clip's code values.
struct ClipColor {
    int space = SWS_CS_ITU601;  ///< FFmpeg's number of the matrix
    bool full_range = false;
};

/// A packet where decoding can start, with nothing from before it.
struct SeekPoint {
    int frame = 0;
    std::int64_t pts = 0, dts = 0;
    std::int64_t position = 0;  ///< in the file; times alone may be counted anew after a jump
};

/// What else Decoder knows about a clip that it has looked through. Never changes once it is made.
struct ClipIndex {
    /// The frames' times as the file tells them, ascending, in its own unit. Empty when it does not tell them all: its
    /// frames are then counted from the start.
    std::vector<std::int64_t> stamps;
    std::vector<SeekPoint> points;  ///< ascending; none without `stamps`
    std::vector<double> times;      ///< s, from 0, as ClipInfo
    double duration = 0.0;          ///< s
    std::string warning;
    ClipColor color;
    std::optional<ImageSequence> sequence;  ///< then all of the above but `color`, `times` and `duration` is empty

    /// The frame of the file's time `pts`: this one or the nearest.
    int frame_at(std::int64_t pts) const;
};

/// Reads the file to its end, and leaves it there. Throws Error (bad_input): no frame, more than `maximum`.
ClipIndex index_clip(MediaFile& file, const std::filesystem::path& path, int maximum, const work::Stages& stages = {});

/// A sequence of images has no times of its own.
ClipIndex index_sequence(const ImageSequence& sequence);

}  // namespace lapfx::media
