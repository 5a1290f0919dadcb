// The result of a fit as one HTML file with pictures, for people.
//
//     FitReport report{.of = {.scene = "lagb.scene.json"}, .found = fit_scene(fit, curve)};
//     report.moments = report_moments(report.found.target);  // and a JPEG of each picture
//     write_file("report.html", report_html(report));
//
// The file stands alone: it has no script, and its Content-Security-Policy forbids whatever is not in it. It is HTML5
// that is well-formed XML too, so a strict parser reads it. Names in it may hold anything.
// Pure functions, any thread; nothing throws.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "match/fit/scene_fit.h"

namespace lapfx::match {

/// A moment that is shown in pictures.
struct ReportMoment {
    double time = 0.0;                                    ///< s of the scene; one of the target's times
    std::string name = {};                                ///< why this one: "most blood"
    std::string reference = {}, before = {}, after = {};  ///< JPEG, the bytes of a file; empty: there is no picture
};

inline constexpr int report_picture_side = 320;  ///< px, of the longer side of a picture, at most

/// With most blood, with most veil, and in the middle, of the times that the reference has; fewer where these are the
/// same. Without pictures.
std::vector<ReportMoment> report_moments(std::span<const TargetPoint> target);

/// What a report says besides what was found.
struct ReportOf {
    /// Names of files. No preset: it began with the built-in values. fitted, fitted_scene: what was written; empty:
    /// nothing was.
    std::string scene = {}, reference = {}, preset = {}, fitted = {}, fitted_scene = {};
    double seconds = 0.0;                 ///< that it took
    std::vector<std::string> notes = {};  ///< of measuring the reference, one line each
};

struct FitReport {
    ReportOf of = {};
    FittedScene found = {};  ///< with a result
    std::vector<ReportMoment> moments = {};
};

std::string report_html(const FitReport& report);

}  // namespace lapfx::match
