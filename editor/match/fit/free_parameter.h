// The parameters that a fit may change: numbers of a preset or of its scene, each within bounds of its own.
//
//     document::Content tuned{scene, preset};
//     for (FreeParameter& p : free_parameters(tuned, {"bleeding.speed", "smoke.haze.ventilation=0.02..0.5"}))
//         p.set(tuned, p.value(p.coordinate(p.get(tuned)) + 0.1));
//
// Pure functions, any thread.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document/content.h"

namespace lapfx::match {

struct FreeParameter {
    std::string key = {};                 ///< as `--set` takes it: "smoke.haze.ventilation", "events.0.time"
    bool of_scene = false;                ///< of the scene, else of the preset
    const Parameter* row = nullptr;       ///< a number
    double minimum = 0.0, maximum = 0.0;  ///< within those of the row

    double get(const document::Content& tuned) const;
    /// Beyond the bounds it is the nearer bound.
    void set(document::Content& tuned, double value) const;
    /// Where the search is: equal steps are equally large changes. Values that are not negative are there by their
    /// logarithm, those below one step of the row (Parameter::step) about linearly; times in s, and the others in units
    /// of a quarter of the row's range.
    double coordinate(double value) const;
    double value(double coordinate) const;
};

/// What most videos can tell: what is free unless somebody says otherwise.
inline constexpr std::array<std::string_view, 5> usual_parameters = {"bleeding.speed", "bleeding.max_extent",
                                                                     "smoke.haze.accumulation",
                                                                     "smoke.haze.ventilation", "smoke.plume.density"};

/// Keys of the preset, else of the scene; each may have bounds of its own, KEY=LOW..HIGH. Throws Error (bad_input) with
/// place "--parameters": every key that is unknown, named twice or no number, bounds that are reversed or beyond those
/// of the row, and a value of `tuned` outside of them; and where `keys` is empty.
std::vector<FreeParameter> free_parameters(const document::Content& tuned, std::span<const std::string> keys);

}  // namespace lapfx::match
