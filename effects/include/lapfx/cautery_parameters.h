// The part of a preset (preset.h) that the tool's heat is made with.
#pragma once

namespace lapfx {

enum class HeatModel { radial, bioheat };

/// Heat under the tool (paper: "Bleeding and Smoke in a Virtual LAGB Simulator").
/// Units, ranges and meaning of each value: lapfx-preset(5), presets/REFERENCE.md.
struct CauteryParameters {
    HeatModel model = HeatModel::radial;
    double heat_rate = 220.0;
    double tip_radius = 1.5;
    double cut_temperature = 180.0;
    double coagulation_temperature = 60.0;
    double char_temperature = 150.0;
    double heat_spread = 0.5;
    double cooling_time = 4.4;
    double maximum_temperature = 400.0;
    double diffusivity = 0.13;
    double perfusion = 0.02;
    double clip_length = 9.0;
    double clip_reach = 3.0;

    friend bool operator==(const CauteryParameters&, const CauteryParameters&) = default;
};

}  // namespace lapfx
