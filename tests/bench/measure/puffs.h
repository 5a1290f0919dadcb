// Real videos of a puff of smoke whose times a person told by eye, beside those of the measured veil.
//
//     for (const KnownPuff& puff : bench::known_puffs("puffs.csv")) measured.push_back(measured_puff(puff));
//     add_puffs(report, measured);
//
// Any thread; no OpenGL.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "bench/report.h"

namespace lapfx::bench {

/// Onset, peak and end, s of the video; nothing: it is not known. The end is when half of the peak's veil is gone, as
/// in what `lapfx measure` tells (match::Episode).
using PuffTimes = std::array<std::optional<double>, 3>;
inline constexpr std::array<const char*, 3> puff_times = {"onset", "peak", "end"};  ///< their names

struct KnownPuff {
    std::filesystem::path video;
    PuffTimes by_eye = {};
};

struct MeasuredPuff {
    KnownPuff known;
    PuffTimes measured = {};  ///< of the curve as it is, whatever its intervals say
    bool told = false;        ///< `lapfx measure` tells them: the veil changes by more than its intervals
    /// Measured minus by eye, s; nothing where one of both is not known.
    std::optional<double> error(std::size_t time) const;
};

/// CSV whose first line is "video,onset,peak,end"; a time may be empty, but not all of one video. Paths are those
/// from the folder of the file. Throws Error (bad_input) that names the line: other columns or values, times that do
/// not ascend, and a file without videos.
std::vector<KnownPuff> known_puffs(const std::filesystem::path& file);

/// Measures every frame of the video. Throws as match::measure() and VideoReader.
MeasuredPuff measured_puff(const KnownPuff& known);

/// So many errors are at most so large, of those that are known by eye: what is not measured is none.
struct PuffsWithin {
    int within = 0, known = 0;
};
PuffsWithin puffs_within(std::span<const MeasuredPuff> puffs, std::size_t time, double seconds);

/// A row for each puff with its errors, one of the class, and a table.
void add_puffs(BenchReport& report, std::span<const MeasuredPuff> puffs);

}  // namespace lapfx::bench
