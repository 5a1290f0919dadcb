// Known veils and blood over real clear frames (composite.h), as another camera and encoder would leave
// them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/measure/camera.h"

namespace lapfx::bench {

/// What files are taken to be of one operation: the name of the folder, and that of the file up to its last "_".
std::string operation_of(const std::filesystem::path& file);

struct OverCounts {
    int views = 0;          ///< baselines
    int refused = 0;        ///< of these not measurable: nothing is laid over their frames
    int missing = 0;        ///< frames that the file cannot give
    int without_later = 0;  ///< files too short for a baseline 1 s old
};

/// Of one video or picture: `composites` pictures over the frame that is also their baseline, compressed apart, and as
/// many over frames 1 to 4 s later, with the clear frames that lead to them. One light of the smoke in all of them.
/// Throws Error (bad_input) when it cannot be read.
std::vector<KnownView> known_over(const std::filesystem::path& file, std::uint32_t seed, int number, int composites,
                                  OverCounts& counts);

}  // namespace lapfx::bench
