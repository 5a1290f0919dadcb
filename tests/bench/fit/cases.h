// The cases of `lapfx bench fit`: a hidden scene that is filmed, and another one, with another organ, camera and light,
// that is to be fitted to it. In both a tool burns once and cuts once.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/measure/views.h"
#include "match/fit/free_parameter.h"

namespace lapfx::bench {

inline constexpr double case_aspect = 1.25;                ///< of the pictures, width over height
inline constexpr double case_duration = 14.0;              ///< s
inline constexpr std::size_t case_burn = 0, case_cut = 1;  ///< numbers of the events

/// A scene and its organ.
struct CaseScene {
    document::Content tuned;
    std::string label;  ///< its organ
    std::shared_ptr<const PreparedOrgan> organ;
};

struct FitCase {
    CaseScene hidden, fitted;
};

/// The most that a scene shows.
struct ShownPeaks {
    double depth = 0.0;  ///< optical depth of the mean veil
    double blood = 0.0;  ///< share of the view
};

/// Of what a hidden scene shows: what can be known of smoke is known for such peaks (how well emission, clearing and
/// onset come back from a veil measured within 0.03), and blood is measured within 0.015 of the view.
inline constexpr double least_peak_depth = 0.25, most_peak_depth = 1.2, least_peak_blood = 0.03;

/// `prepared`: organs that were prepared before. `peaks_of` draws a scene; that which is drawn last is the hidden one.
FitCase draw_fit_case(std::uint32_t seed, int number, PreparedViews& prepared,
                      const std::function<ShownPeaks(const CaseScene&)>& peaks_of);

/// What its curves are made of, in the terms of what a camera sees, so that scenes of different organs and cameras can
/// be compared.
struct SeenTruth {
    double burn_start = 0.0;    ///< s, when it begins to smoke
    double cut_start = 0.0;     ///< s, when the wound opens
    double smoke_rate = 0.0;    ///< b, 1/s: haze of the core that a second of burning adds
    double ventilation = 0.0;   ///< 1/s
    double plume = 0.0;         ///< share of the view, mean while it burns: what stands out of the veil (by pictures)
    double blood_pace = 0.0;    ///< how fast blood spreads, square roots of the view a second
    double blood_extent = 0.0;  ///< how far, square roots of the view
    double clears_for = 0.0;    ///< s from the end of the burning to the end of the scene
    bool blood_stops = false;   ///< it reaches its extent within the scene
};
SeenTruth seen_truth(const document::Content& tuned, const std::shared_ptr<const PreparedOrgan>& organ);

}  // namespace lapfx::bench
