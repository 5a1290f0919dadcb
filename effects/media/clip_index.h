// Which frames a clip has and when they are shown, found from its packets without decoding.
//
// FFMS2 also makes such an index, but it opens files by name, and so playlists and what they name. It does not report
// that a file ends early, nor where decoding may start so that frames are the same to the last bit, and it takes
// longer.
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
    std::int64_t position = 0;  ///< byte in the file; times may start again after a jump
};

/// What else Decoder knows about a clip after looking through it. It never changes.
struct ClipIndex {
    /// The times of the frames in the file, ascending, in the unit of the file. Empty when some are missing: frames are
    /// then counted from the start.
    std::vector<std::int64_t> stamps;
    std::vector<SeekPoint> points;  ///< ascending; none without `stamps`
    std::vector<double> times;      ///< s, from 0, as ClipInfo
    double duration = 0.0;          ///< s
    std::string warning;
    ClipColor color;
    std::optional<ImageSequence>
        sequence;  ///< everything above is empty for a sequence, except `color`, `times` and `duration`

    /// The frame at the file's time `pts`, or the nearest one.
    int frame_at(std::int64_t pts) const;
};

/// Reads the file to its end, and leaves the position there. Throws Error (bad_input): no frame, more than `maximum`.
ClipIndex index_clip(MediaFile& file, const std::filesystem::path& path, int maximum, const work::Stages& stages = {});

/// Warnings of one file are one line.
void add_warning(std::string& all, const std::string& one);

/// The index of a sequence of images, which has no times.
ClipIndex index_sequence(const ImageSequence& sequence);

}  // namespace lapfx::media
