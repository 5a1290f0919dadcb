// Keying thresholds for a clip, from what its histogram shows: the editor's "Suggest" and `lapfx inspect --keying`.
//
//     lapfx::KeyingSuggestion found = lapfx::suggest_keying("plume.mp4");  // throws lapfx::Error: not a clip
//     if (found.confidence > 0.5) found.apply(clip);
//     else log(found.reason);
//
// What a video is for at all is told by suggest_use(): the editor asks it about files that are dropped or named.
//
// How it decides: effects/smoke/keying_survey.h. Any thread; no GL.
#pragma once

#include <atomic>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "lapfx/smoke_parameters.h"

namespace lapfx {

struct KeyingSuggestion {
    KeyingParameters keying{};  ///< suggested luma, chroma, key colour and spill; everything else has its default
    ClipPolarity polarity = ClipPolarity::light;
    bool alpha = false;             ///< the clip has its own opacity: keying is not used
    double confidence = 0.0;        ///< 0..1; below 0.5 a person should check it
    double background_noise = 0.0;  ///< levels (0 to 255) within which 99 % of the background stays
    double background_share = 0.0;  ///< share of the clip's area over time, 0..1
    bool whole_smoke_seen =
        false;  ///< much of the smoke has one opacity, perhaps 1; otherwise it is assumed from its luma
    /// Least opacity that the thickest smoke can have, 0..1: that of smoke as bright as white. Keying by luma uses the
    /// middle between this and 1. It is 1 for keying by colour, where the opacity is known.
    double least_opacity = 1.0;
    ClipCrop crop{};                ///< bars at the edges of the picture, where smoke would end in a straight line
    double edge_fade = 0.0;         ///< more than 0 where smoke reaches the picture's edges
    std::vector<ClipMask> masks{};  ///< logos and other marks, placed where smoke is rare
    std::string reason;             ///< what was found, one line for people

    /// Sets the clip's own keying, polarity, crop, fade and masks. Choke, feather, noise and existing masks stay; a
    /// haze clip gets no fade.
    void apply(SmokeClip& clip) const;
};

/// Looks at about 24 frames of the whole clip. Throws Error: bad_input for what is not a clip, runtime when `stop`
/// ended it early.
KeyingSuggestion suggest_keying(const std::filesystem::path& clip, const std::atomic<bool>* stop = nullptr);

struct SourceSuggestion {
    glm::dvec2 place{0.5, 0.92};  ///< source_x and source_y of the clip get it: fractions of its frame
    bool found = false;           ///< smoke was found; otherwise `place` is the default
    bool begins =
        false;  ///< the clip begins without smoke and shows where it comes from; otherwise it is the root of the plume
};

/// Finds where the smoke of a clip starts, which is the point that is placed at the tool tip. It keys about 56 frames
/// as suggested (effects/smoke/find_source.h). Throws Error (bad_input) for what is not a clip. If given, `stop` ends
/// it early, with Error (runtime) or any place.
SourceSuggestion suggest_source(const std::filesystem::path& clip, const std::atomic<bool>* stop = nullptr);

enum class VideoUse { reference, smoke };

/// What a video is for: a clip of smoke, or a surgery that the preview is compared with.
struct UseSuggestion {
    VideoUse use = VideoUse::reference;  ///< the likelier one
    bool sure = false;                   ///< otherwise a person should be asked
    std::string reason;                  ///< what was found, one line for people
};

/// Looks at about 16 frames of a video, or at an image: smoke has its own opacity, or a plain background of a key
/// colour, black or white behind it; a surgery fills the picture, perhaps inside the black surround of an endoscope.
/// Throws Error: bad_input for what is neither video nor image, runtime when `stop` ended it early.
UseSuggestion suggest_use(const std::filesystem::path& video, const std::atomic<bool>* stop = nullptr);

}  // namespace lapfx
