// The part of a preset (preset.h) that smoke is made with: its clips, and how they are keyed, placed and coloured.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lapfx {

/// Smoke out of a clip's frame: luma and chroma thresholds, then noise on alpha (paper: figures 1 and 2).
struct KeyingParameters {
    double luma_low = 16.0;
    double luma_high = 200.0;
    glm::dvec3 key_color{0.0, 0.0, 0.0};
    double chroma_low = 0.0;
    double chroma_high = 0.0;
    double spill = 0.0;
    double choke = 0.0;
    double feather = 0.0;
    double noise_scale = 0.25;
    double noise_strength = 0.35;
    double noise_drift = 0.15;
};

/// Which smoke a clip shows, in the order of drawing: each role lies over those before it. Each has a row in the
/// table of roles.
enum class ClipRole { plume, haze };
enum class ClipPolarity { light, dark };
enum class ClipStart { seeded, beginning };
enum class ClipMirror { seeded, off, on };

/// The part that is left out at each side of a clip, such as bars around the picture, as fractions of its frame's width
/// and height.
struct ClipCrop {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    friend bool operator==(const ClipCrop&, const ClipCrop&) = default;
};

/// A rectangle of a clip's frame without smoke: a garbage mask. Fractions of the frame, from its upper left corner.
struct ClipMask {
    double x = 0.0, y = 0.0, width = 0.1, height = 0.1;
    friend bool operator==(const ClipMask&, const ClipMask&) = default;
};
inline constexpr std::size_t most_masks = 12;  ///< of a clip

/// One smoke video and how it is used. Places refer to its whole frame, whatever is cropped.
struct SmokeClip {
    std::string file;
    ClipRole role = ClipRole::plume;
    ClipPolarity polarity = ClipPolarity::light;
    double weight = 1.0;
    double speed = 1.0;
    double source_x = 0.5;   ///< where in the frame the smoke starts, 0 left .. 1 right
    double source_y = 0.92;  ///< 0 top .. 1 bottom
    double in = 0.0;         ///< s of the clip
    double out = 0.0;        ///< s of the clip; 0 = its end
    double crossfade = 0.0;  ///< s
    ClipStart start = ClipStart::seeded;
    ClipMirror mirror = ClipMirror::seeded;
    double rotation = 0.0;    ///< greatest angle to either side, degrees; the angle itself is seeded
    double edge_fade = 0.0;   ///< how far smoke fades at cropped edges and masks, as a part of the frame's smaller side
    bool own_keying = false;  ///< `keying` replaces the preset's for this clip
    KeyingParameters keying{};
    ClipCrop crop{};
    std::vector<ClipMask> masks{};
};

/// Source smoke at the tool tip.
struct PlumeParameters {
    double size = 110.0;
    double density = 0.35;
    double rise = 6.0;
    double growth = 0.25;
    double fade_in = 0.3;
    double fade_out = 1.2;
    double lean = 0.7;
    double softness = 6.0;
    double fat_gain = 0.5;
    glm::dvec3 color{0.62, 0.62, 0.68};
    glm::dvec3 extinction{0.85, 1.0, 1.1};
};

/// Environmental smoke over the whole view.
struct HazeParameters {
    double accumulation = 0.12;
    double ventilation = 0.05;
    double suction = 0.6;
    double unevenness = 0.5;
    glm::dvec3 color{0.46, 0.41, 0.46};
    glm::dvec3 extinction{0.80, 1.0, 1.12};
};

/// Specks of fat thrown off while fat burns (the paper's future work).
struct ParticleParameters {
    double rate = 0.0;
    double size = 0.4;
    double speed = 40.0;
    double lifetime = 0.7;
    glm::dvec3 color{0.86, 0.72, 0.45};
};

struct SmokeParameters {
    std::vector<SmokeClip> clips;
    KeyingParameters keying{};
    PlumeParameters plume;
    HazeParameters haze;
    ParticleParameters particles;
};

}  // namespace lapfx
