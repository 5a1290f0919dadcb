// Keying thresholds for a clip, from what its histogram shows: the editor's "Suggest" and `lapfx inspect --keying`.
//
//     lapfx::KeyingSuggestion found = lapfx::suggest_keying("plume.mp4");  // throws lapfx::Error: not a clip
//     if (found.confidence > 0.5) clip.keying = found.keying, clip.polarity = found.polarity;
//     else log(found.reason);
//
// How it decides: effects/smoke/suggest_cpu.h. Any thread; no GL.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "lapfx/preset.h"

namespace lapfx {

struct KeyingSuggestion {
    KeyingParameters keying{};  ///< luma, chroma, key colour and spill as suggested; the rest as by default
    ClipPolarity polarity = ClipPolarity::light;
    bool alpha = false;             ///< the clip brings its own opacity: keying is not used
    double confidence = 0.0;        ///< 0..1; below 0.5 a person should look first
    double background_noise = 0.0;  ///< code values by which the background strays, 99 % of it
    double background_share = 0.0;  ///< of the clip's area over time, 0..1
    bool whole_smoke_seen = false;  ///< smoke that hides all is in the clip; otherwise its luma is assumed
    std::string reason;             ///< what was found, one line for people
};

/// From about 24 frames over the whole clip. Throws Error (bad_input) for what is not a clip.
KeyingSuggestion suggest_keying(const std::filesystem::path& clip);

}  // namespace lapfx
