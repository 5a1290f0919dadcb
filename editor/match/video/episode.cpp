#include "match/video/episode.h"

#include <algorithm>
#include <vector>

namespace lapfx::match {

namespace {

constexpr double smoothing = 0.2;  // s
constexpr double start = 0.1, done = 0.9, gone = 0.5;
constexpr double floor_share = 0.1;  // of the frames lie below the floor

struct Point {
    double time, value;
    std::size_t frame;  ///< in the measurement
};

/// Running mean over `smoothing`, and over three frames at least.
std::vector<Point> smoothed(const std::vector<Point>& raw) {
    std::vector<Point> points = raw;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        double sum = raw[i].value, count = 1.0;
        for (std::size_t d = 1; d <= i && i + d < raw.size(); ++d) {
            if (d > 1 && raw[i + d].time - raw[i - d].time > smoothing) break;
            sum += raw[i - d].value + raw[i + d].value;
            count += 2.0;
        }
        points[i].value = sum / count;
    }
    return points;
}

/// Where the line between two points passes `level`.
double crossing(const Point& from, const Point& to, double level) {
    const double whole = to.value - from.value;
    return whole == 0.0 ? to.time : from.time + (to.time - from.time) * (level - from.value) / whole;
}

/// The last time before `peak` at which the curve is below `level`.
std::optional<double> rises_past(const std::vector<Point>& points, std::size_t peak, double level) {
    for (std::size_t i = peak; i > 0; --i)
        if (points[i - 1].value < level) return crossing(points[i - 1], points[i], level);
    return {};
}

std::optional<double> falls_past(const std::vector<Point>& points, std::size_t peak, double level) {
    for (std::size_t i = peak + 1; i < points.size(); ++i)
        if (points[i].value <= level) return crossing(points[i - 1], points[i], level);
    return {};
}

/// Mean of what the points that are no higher than `level` have; there is one at least.
double mean_up_to(double level, const std::vector<Point>& points, const std::vector<double>& of) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].value > level) continue;
        sum += of[i];
        count += 1.0;
    }
    return sum / count;
}

}  // namespace

Episode episode_of(std::span<const FrameAmounts> frames, Curve curve) {
    std::vector<Point> raw;
    std::vector<double> below, above;  // from the amount to the ends of its interval
    for (const FrameAmounts& frame : frames) {
        if (!measurable(frame, curve)) continue;
        const Amount& amount = amount_of(frame, curve);
        raw.push_back({frame.time, amount.value, static_cast<std::size_t>(&frame - frames.data())});
        below.push_back(amount.value - amount.low);
        above.push_back(amount.high - amount.value);
    }
    Episode episode;
    if (raw.empty()) return episode;
    const std::vector<Point> points = smoothed(raw);
    double seconds = 0.0, area = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (points[i + 1].frame != points[i].frame + 1) continue;  // what lies between is not measurable
        const double length = points[i + 1].time - points[i].time;
        area += 0.5 * (points[i].value + points[i + 1].value) * length;
        seconds += length;
    }
    episode.area = area;
    episode.mean = seconds > 0.0 ? area / seconds : points.front().value;
    const auto highest = std::max_element(points.begin(), points.end(),
                                          [](const Point& a, const Point& b) { return a.value < b.value; });
    episode.peak = highest->value;

    std::vector<double> values;
    for (const Point& point : points) values.push_back(point.value);
    std::sort(values.begin(), values.end());
    const double floor = values[static_cast<std::size_t>(floor_share * static_cast<double>(values.size() - 1))];
    const double height = highest->value - floor;
    const auto peak = static_cast<std::size_t>(highest - points.begin());
    if (height <= below[peak] + mean_up_to(floor, points, above)) return episode;  // floor and peak overlap
    episode.peak_at = highest->time;
    episode.onset = rises_past(points, peak, floor + start * height);
    const auto risen = rises_past(points, peak, floor + done * height);
    if (episode.onset && risen) episode.rise = *risen - *episode.onset;
    if (const auto fallen = falls_past(points, peak, floor + gone * height)) episode.decay = *fallen - highest->time;
    return episode;
}

}  // namespace lapfx::match
