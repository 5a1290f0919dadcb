// A preset: the tuned parameters of bleeding and smoke, as JSON. It is all that a simulator takes from the editor.
//
//     lapfx::Preset preset = lapfx::load_preset("brisk_bleed.json");  // throws lapfx::Error: every fault
//     preset.bleeding.speed = 6.0;                                    // mm/s
//     std::string json = lapfx::write_preset(preset);                 // its text, to be kept
//
// Lengths are mm, times s, colours sRGB 0..1, thresholds 8-bit levels (0 to 255). Units, ranges and meaning of each
// value: lapfx-preset(5), presets/REFERENCE.md.
// Plain data: copy freely; no thread of its own.
// Each part has a header of its own, which comes with this one: bleeding_parameters.h, cautery_parameters.h,
// smoke_parameters.h.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "lapfx/api.h"
#include "lapfx/bleeding_parameters.h"
#include "lapfx/cautery_parameters.h"
#include "lapfx/parameter.h"
#include "lapfx/smoke_parameters.h"

namespace lapfx {

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
LAPFX_API const Table& preset_table();

/// Reads and validates. `name` names the source in faults. Throws Error (bad_input) listing every fault at
/// once (the first 200). At most 4 MiB of text, 100000 values and 32 levels.
LAPFX_API Preset parse_preset(std::string_view json, const std::string& name, const std::filesystem::path& folder = {});
LAPFX_API Preset load_preset(const std::filesystem::path& path);

/// The JSON text: every key, in table order, two-space indent, final newline.
/// write(parse(write(p))) == write(p).
LAPFX_API std::string write_preset(const Preset& preset);

}  // namespace lapfx
