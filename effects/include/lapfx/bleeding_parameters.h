// The parts of a preset (preset.h) that bleeding is made with.
#pragma once

#include <glm/glm.hpp>

namespace lapfx {

/// Blood spreading over the organ (paper: "Simulation of bleeding").
/// Units, ranges and meaning of each value: lapfx-preset(5), presets/REFERENCE.md.
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

    friend bool operator==(const BleedingParameters&, const BleedingParameters&) = default;
};

/// Where the organ's texture shows vessels (paper: figure 9). By default a cut bleeds where there are vessels, and more
/// strongly where they are denser.
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

}  // namespace lapfx
