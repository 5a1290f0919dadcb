// Fits to real videos in which nothing bleeds: whatever such a video moves or hides, a fit is to leave bleeding alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "bench/fit/cases.h"
#include "lapfx/authoring/preview.h"

namespace lapfx::bench {

/// How much a fit to a video may draw.
struct BloodlessEffort {
    std::uint32_t seed = 1;
    int side = 160;       ///< px of the longer side of its pictures
    double step = 0.5;    ///< s between the times that are drawn
    int rounds = 2;       ///< of the search
    double apart = 0.08;  ///< s between measured frames of the video, about
};

struct BloodlessFit {
    std::string video;                    ///< the name of its file
    bool fitted = false;                  ///< else the video shows nothing to fit to, and `why` says why
    std::string why = {};                 ///< also what the fit says of the speed of bleeding
    bool left_alone = false;              ///< no parameter of bleeding was changed and no cut moved, silenced or added
    double most_blood = 0.0;              ///< share of the view, of what was measured
    double above_error = 0.0;             ///< s in which the interval of blood is above 0
    std::optional<double> veil_rms = {};  ///< of the fitted scene and the measured video; nothing: not measurable
    double seconds = 0.0;                 ///< that measuring and fitting took
};

/// Fits the scene from beginning to end of the video. Throws Error (bad_input) where it cannot be read.
BloodlessFit fit_bloodless(const std::filesystem::path& video, const CaseScene& scene, const PreviewOptions& preview,
                           const BloodlessEffort& effort);

}  // namespace lapfx::bench
