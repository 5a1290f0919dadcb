// A preset: the tuned parameters of bleeding and smoke, as JSON. It is all that a simulator takes from the editor.
//
//     lapfx::Preset preset = lapfx::load_preset("brisk_bleed.json");  // throws lapfx::Error: every fault
//     preset.bleeding.speed = 6.0;                                    // mm/s
//     std::string json = lapfx::write_preset(preset);                 // its text, to be kept
//
// Lengths are mm, times s, colours sRGB 0..1, thresholds 8-bit levels (0 to 255). Ranges and help: the rows in
// effects/bleeding/parameters.cpp, effects/cautery/parameters.cpp and effects/smoke/parameters.cpp.
// Plain data: copy freely; no thread of its own.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "lapfx/parameter.h"

namespace lapfx {

/// Blood spreading over the organ (paper: "Simulation of bleeding").
/// Formulas: effects/bleeding/parameters.cpp.
struct BleedingParameters {
    double speed = 4.0;
    double max_extent = 16.0;
    double threshold = 0.3;
    double noise_scale = 4.5;
    double noise_strength = 3.0;
    int noise_octaves = 2;
    double gravity_bias = 0.35;
    double crease_bias = 0.5;
    double bridge_gap = 1.0;
    double rivulets = 0.7;
    double pulse_rate = 0.0;
    double pulse_strength = 0.0;
    double coagulation_time = 1.5;
    double suction_radius = 8.0;
    double irrigation_radius = 15.0;
    glm::dvec3 color_thin{0.45, 0.03, 0.035};
    glm::dvec3 color_deep{0.22, 0.015, 0.02};
    double deep_at = 5.0;
    double opacity = 0.9;
    double thickness = 0.6;
    double gloss = 0.85;
    double clot_darkening = 0.85;
};

/// Where the organ's texture shows vessels (paper: figure 9). By default a cut bleeds where there are vessels, and more
/// strongly where they are denser. Formulas: effects/bleeding/vessel_parameters.cpp.
struct VesselParameters {
    double vessel_low = 0.2;
    double vessel_high = 0.4;
    double vessel_width = 1.25;
    glm::dvec3 vessel_color{0.36, 0.42, 0.6};
    double vessel_tolerance = 0.0;
    double fat_low = 56.0;
    double fat_high = 66.0;
    double smoothing = 0.4;
    double region = 2.0;
    double vessel_threshold = 0.01;
    double vessel_reference = 0.1;
    double vessel_strength = 0.7;

    friend bool operator==(const VesselParameters&, const VesselParameters&) = default;
};

enum class HeatModel { radial, bioheat };

/// Heat under the tool (paper: "Bleeding and Smoke in a Virtual LAGB Simulator").
/// Formulas: effects/cautery/parameters.cpp.
struct CauteryParameters {
    HeatModel model = HeatModel::radial;
    double heat_rate = 220.0;
    double tip_radius = 1.5;
    double cut_temperature = 180.0;
    double coagulation_temperature = 60.0;
    double char_temperature = 150.0;
    double heat_spread = 0.2;
    double cooling_time = 4.0;
    double maximum_temperature = 400.0;
    double diffusivity = 0.13;
    double perfusion = 0.02;
    double clip_length = 9.0;
    double clip_reach = 3.0;

    friend bool operator==(const CauteryParameters&, const CauteryParameters&) = default;
};

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

struct Preset {
    std::string name;
    std::string description;
    std::string tags;  ///< comma separated: "slow, venous"
    BleedingParameters bleeding;
    VesselParameters vessels;
    CauteryParameters cautery;
    SmokeParameters smoke;

    std::filesystem::path folder;  ///< where it was loaded from; clips are looked up here first; not written
};

/// The root table of a preset document.
const Table& preset_table();

/// Reads and validates. `name` names the source in faults. Throws Error (bad_input) listing every fault at
/// once (the first 200). At most 4 MiB of text, 100000 values and 32 levels.
Preset parse_preset(std::string_view json, const std::string& name, const std::filesystem::path& folder = {});
Preset load_preset(const std::filesystem::path& path);

/// The JSON text: every key, in table order, two-space indent, final newline.
/// write(parse(write(p))) == write(p).
std::string write_preset(const Preset& preset);

}  // namespace lapfx
