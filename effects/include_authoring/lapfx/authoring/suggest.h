// Keying thresholds for a clip, from what its histogram shows: the editor's "Suggest" and `lapfx inspect --keying`.
//
//     lapfx::KeyingSuggestion found = lapfx::suggest_keying("plume.mp4");  // throws lapfx::Error: not a clip
//     if (found.confidence > 0.5) found.apply(clip);
//     else log(found.reason);
//
// How it decides: effects/smoke/keying_survey.h. Any thread; no GL.
#pragma once

#include <atomic>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "lapfx/preset.h"

namespace lapfx {

struct KeyingSuggestion {
    KeyingParameters keying{};  ///< luma, chroma, key colour and spill as suggested; the rest as by default
    ClipPolarity polarity = ClipPolarity::light;
    bool alpha = false;             ///< the clip has its own opacity: keying is not used
    double confidence = 0.0;        ///< 0..1; below 0.5 a person should check it
    double background_noise = 0.0;  ///< levels (0 to 255) within which 99 % of the background stays
    double background_share = 0.0;  ///< of the clip's area over time, 0..1
    bool whole_smoke_seen =
        false;  ///< much of the smoke is of one opacity, perhaps whole; otherwise its luma is assumed
    /// Least opacity that the thickest smoke can have, 0..1: that of smoke as bright as white. Keyed by luma, the value
    /// that is used is in the middle between this and 1. 1 where it is known: keyed by colour.
    double least_opacity = 1.0;
    ClipCrop crop{};                ///< bars at the picture's edges, where smoke would end in a straight line
    double edge_fade = 0.0;         ///< more than 0 where smoke reaches the picture's edges
    std::vector<ClipMask> masks{};  ///< logos and other marks, placed where smoke is rare
    std::string reason;             ///< what was found, one line for people

    /// Sets the clip's own keying, polarity, crop, fade and masks. Choke, feather and noise stay, and so do the masks
    /// that it has; a clip of haze gets no fade.
    void apply(SmokeClip& clip) const;
};

/// From about 24 frames over the whole clip. Throws Error: bad_input for what is not a clip, runtime when `stop` ended
/// it early.
KeyingSuggestion suggest_keying(const std::filesystem::path& clip, const std::atomic<bool>* stop = nullptr);

struct SourceSuggestion {
    glm::dvec2 place{0.5, 0.92};  ///< for source_x and source_y of the clip: fractions of its frame
    bool found = false;           ///< there is smoke; otherwise `place` is the default
    bool begins =
        false;  ///< the clip begins without smoke and shows where it comes from; otherwise the plume's root is taken
};

/// Where a clip's smoke starts, the point that is placed at the tool tip: with keying as suggested, from about 56
/// frames. How: effects/smoke/find_source.h. Throws Error (bad_input) for what is not a clip. `stop`, if given, ends it
/// early: Error (runtime), or any place.
SourceSuggestion suggest_source(const std::filesystem::path& clip, const std::atomic<bool>* stop = nullptr);

}  // namespace lapfx
