#include "match/fit/worse.h"

#include <cstdio>

namespace lapfx::match {

namespace {

constexpr double seen_of_view = 0.005;  // of the view: a curve that is farther by less is as near as it was
constexpr double seen_delta_e = 1.0;    // CIE Delta E 2000, about just noticeable

struct Line {
    const char* format;
    const std::optional<double>&before, &after;
    double seen;
    double unit = 1.0;
};

}  // namespace

std::vector<std::string> what_is_worse(const FitResult& result) {
    const ColorLikeness &before = result.colors_before, &after = result.colors_after;
    const Line lines[] = {
        {"blood: off by %.1f %% before, %.1f %% after", result.blood_before, result.blood_after, seen_of_view, 100.0},
        {"veil: off by %.1f %% before, %.1f %% after", result.veil_before, result.veil_after, seen_of_view, 100.0},
        {"colour of blood: Delta E %.1f before, %.1f after", before.blood, after.blood, seen_delta_e},
        {"colour of smoke: Delta E %.1f before, %.1f after", before.smoke, after.smoke, seen_delta_e},
        {"colour of tissue: Delta E %.1f before, %.1f after", before.tissue, after.tissue, seen_delta_e},
    };
    std::vector<std::string> worse;
    for (const Line& line : lines) {
        if (!line.before || !line.after || *line.after - *line.before <= line.seen) continue;
        char text[96];
        std::snprintf(text, sizeof text, line.format, line.unit * *line.before, line.unit * *line.after);
        worse.emplace_back(text);
    }
    return worse;
}

}  // namespace lapfx::match
