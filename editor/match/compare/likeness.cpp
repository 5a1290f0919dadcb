#include "match/compare/likeness.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "match/frame/frame_amounts.h"

namespace lapfx::match {

namespace {

constexpr double mostly = 0.5;        // of the frames must have an amount for what is said of its course
constexpr double least_error = 1e-5;  // what five decimals of a file tell
constexpr double rounding = 1e-9;     // s

struct Measured {
    Curve curve;
    Amount FrameAmounts::*amount;
};
constexpr Measured of_blood{Curve::blood, &FrameAmounts::blood}, of_veil{Curve::veil, &FrameAmounts::veil};

Amount between(const Amount& a, const Amount& b, double share) {
    return {std::lerp(a.value, b.value, share), std::lerp(a.low, b.low, share), std::lerp(a.high, b.high, share)};
}

/// One amount of those frames that have it, at any time near them.
class AmountCurve {
  public:
    AmountCurve(std::span<const FrameAmounts> frames, const Measured& what) {
        for (const FrameAmounts& frame : frames)
            if (measurable(frame, what.curve)) points_.push_back({frame.time, frame.*what.amount});
    }
    std::optional<Amount> at(double time) const {
        const auto next = std::lower_bound(points_.begin(), points_.end(), time - rounding,
                                           [](const Point& point, double sought) { return point.time < sought; });
        if (next == points_.end()) return {};
        if (next->time <= time + rounding) return next->amount;
        if (next == points_.begin()) return {};
        const Point& last = *std::prev(next);
        const double gap = next->time - last.time;
        if (gap > longest_gap + rounding) return {};
        return between(last.amount, next->amount, (time - last.time) / gap);
    }

  private:
    struct Point {
        double time;
        Amount amount;
    };
    std::vector<Point> points_;
};

/// Both curves at the same times of the scene, one frame for each of the reference in the time that both span. Where
/// they are not compared both are flagged as missing.
struct Pairs {
    std::vector<FrameAmounts> preview, reference;
    std::vector<double> seconds;  ///< that each stands for
    int compared = 0;
};

struct Span {
    double from = 0.0, to = -1.0;
    bool empty() const { return to < from; }
    bool holds(double time) const { return time >= from - rounding && time <= to + rounding; }
};

Span common_span(std::span<const FrameAmounts> preview, std::span<const FrameAmounts> reference, double offset) {
    if (preview.empty() || reference.empty()) return {};
    return {std::max(preview.front().time, reference.front().time - offset),
            std::min(preview.back().time, reference.back().time - offset)};
}

double seconds_of(std::span<const FrameAmounts> frames, std::size_t i) {
    const auto half_way = [](double gap) { return 0.5 * std::min(gap, longest_gap); };
    return (i > 0 ? half_way(frames[i].time - frames[i - 1].time) : 0.0) +
           (i + 1 < frames.size() ? half_way(frames[i + 1].time - frames[i].time) : 0.0);
}

Pairs pairs_of(const AmountCurve& preview, std::span<const FrameAmounts> reference, double offset, const Span& span,
               const Measured& what) {
    Pairs pairs;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const double time = reference[i].time - offset;
        if (!span.holds(time)) continue;
        FrameAmounts of_preview{.time = time}, of_reference{.time = time};
        const std::optional<Amount> there = preview.at(time);
        if (there && measurable(reference[i], what.curve)) {
            of_preview.*what.amount = *there;
            of_reference.*what.amount = reference[i].*what.amount;
            ++pairs.compared;
        } else {
            of_preview.flags = of_reference.flags = told::missing;
        }
        pairs.preview.push_back(of_preview);
        pairs.reference.push_back(of_reference);
        pairs.seconds.push_back(seconds_of(reference, i));
    }
    return pairs;
}

/// Half widths of two intervals, of each that half which faces the other.
struct Facing {
    double of_preview, of_reference;
    /// How far two amounts may seem apart that are the same, if their errors have nothing in common.
    double joint() const { return std::max(std::hypot(of_preview, of_reference), least_error); }
    double larger() const { return std::max({of_preview, of_reference, least_error}); }
};
Facing facing(const Amount& preview, const Amount& reference) {
    if (preview.value >= reference.value) return {preview.value - preview.low, reference.high - reference.value};
    return {preview.high - preview.value, reference.value - reference.low};
}

/// Differences over time.
void compare_levels(AmountLikeness& found, const Pairs& pairs, const Measured& what) {
    double weights = 0.0, sum = 0.0, squares = 0.0, in_errors = 0.0, errors = 0.0, larger = 0.0;
    for (std::size_t i = 0; i < pairs.preview.size(); ++i)
        if (measurable(pairs.preview[i], what.curve)) found.seconds += pairs.seconds[i];
    for (std::size_t i = 0; i < pairs.preview.size(); ++i) {
        if (!measurable(pairs.preview[i], what.curve)) continue;
        const Amount &preview = pairs.preview[i].*what.amount, &reference = pairs.reference[i].*what.amount;
        const double weight = found.seconds > 0.0 ? pairs.seconds[i] : 1.0;  // of a single picture
        const double difference = preview.value - reference.value;
        const Facing halves = facing(preview, reference);
        const double error = halves.joint(), share = difference / error;
        weights += weight;
        sum += weight * difference;
        squares += weight * difference * difference;
        in_errors += weight * share * share;
        errors += weight * error * error;
        larger += weight * halves.larger();
    }
    if (weights == 0.0) return;
    found.bias = sum / weights;
    found.rms = std::sqrt(squares / weights);
    found.rms_over_error = std::sqrt(in_errors / weights);
    found.error = std::sqrt(errors / weights);
    found.larger_error = larger / weights;
}

/// The peak with the interval of the frame that has it; of a curve without change with that of all, on average.
Amount peak_of(const std::vector<FrameAmounts>& frames, const Episode& episode, const Measured& what) {
    double below = 0.0, above = 0.0, count = 0.0;
    for (const FrameAmounts& frame : frames) {
        if (!measurable(frame, what.curve)) continue;
        if (episode.peak_at && std::abs(frame.time - *episode.peak_at) > rounding) continue;
        const Amount& amount = frame.*what.amount;
        below += amount.value - amount.low;
        above += amount.high - amount.value;
        count += 1.0;
    }
    return {*episode.peak, *episode.peak - below / count, *episode.peak + above / count};
}

bool mostly_measurable(std::span<const FrameAmounts> frames, double offset, const Span& span, Curve curve) {
    std::size_t count = 0, have = 0;
    for (const FrameAmounts& frame : frames) {
        if (!span.holds(frame.time - offset)) continue;
        ++count;
        if (measurable(frame, curve)) ++have;
    }
    return count > 0 && static_cast<double>(have) >= mostly * static_cast<double>(count);
}

Presence presence_of(const std::vector<FrameAmounts>& frames, const Episode& episode, const Measured& what) {
    if (episode.peak_at) return Presence::shown;
    double above = 0.0, count = 0.0;
    for (const FrameAmounts& frame : frames) {
        if (!measurable(frame, what.curve)) continue;
        if ((frame.*what.amount).low > 0.0) above += 1.0;
        count += 1.0;
    }
    return above > mostly * count ? Presence::shown : Presence::none;
}

std::optional<double> difference(const std::optional<double>& preview, const std::optional<double>& reference) {
    if (!preview || !reference) return {};
    return *preview - *reference;
}

std::optional<double> ratio(const std::optional<double>& preview, const std::optional<double>& reference) {
    if (!preview || !reference || *reference <= 0.0) return {};
    return *preview / *reference;
}

/// Sums from which follows how much of one curve another one explains that is scaled and levelled.
struct Fit {
    double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
    void add(double of_preview, double of_reference) {
        count += 1.0;
        x += of_preview, y += of_reference;
        xx += of_preview * of_preview, yy += of_reference * of_reference, xy += of_preview * of_reference;
    }
    double spread() const { return yy - y * y / count; }  // of the reference
    /// Root mean square of what is left of the preview, as a share of its deviation; 1 where they go against each
    /// other or either is even.
    double unexplained() const {
        constexpr double even = 1e-12;
        const double of_preview = xx - x * x / count, both = xy - x * y / count;
        if (both <= 0.0 || of_preview < even || spread() < even) return 1.0;
        return std::sqrt(std::max(1.0 - both * both / (of_preview * spread()), 0.0));
    }
};

Fit fit_at(const AmountCurve& preview, const std::vector<FrameAmounts>& reference, const Measured& what, double shift) {
    constexpr std::size_t most_samples = 2000;
    Fit fit;
    for (std::size_t i = 0; i < reference.size(); i += 1 + reference.size() / most_samples) {
        if (!measurable(reference[i], what.curve)) continue;
        if (const auto there = preview.at(reference[i].time + shift))
            fit.add(there->value, (reference[i].*what.amount).value);
    }
    return fit;
}

/// The shift that leaves least unexplained; see AmountLikeness::late.
std::optional<double> best_shift(const AmountCurve& preview, const std::vector<FrameAmounts>& reference,
                                 const Measured& what) {
    constexpr double step = 0.05, least_kept = 0.5, tells = 0.05;
    constexpr int steps = static_cast<int>(farthest_shift / step);
    const Fit whole = fit_at(preview, reference, what, 0.0);
    double best = 2.0, worst = 0.0;  // unexplained
    int found = 0, first = steps + 1, last = -steps - 1;
    for (int i = -steps; i <= steps; ++i) {
        const Fit fit = fit_at(preview, reference, what, i * step);
        // An event that is shifted out of what both have is not explained.
        if (fit.count < least_kept * whole.count || fit.spread() < least_kept * whole.spread()) continue;
        first = std::min(first, i), last = i;
        worst = std::max(worst, fit.unexplained());
        if (fit.unexplained() < best) best = fit.unexplained(), found = i;
    }
    // At the end of what was tried the true one may be farther.
    if (worst - best < tells || found == first || found == last) return {};
    return found * step;
}

AmountLikeness compare(std::span<const FrameAmounts> preview, std::span<const FrameAmounts> reference, double offset,
                       const Span& span, const Measured& what) {
    AmountLikeness found;
    const AmountCurve curve(preview, what);
    const Pairs pairs = pairs_of(curve, reference, offset, span, what);
    found.frames = pairs.compared;
    compare_levels(found, pairs, what);
    const bool in_preview = mostly_measurable(preview, 0.0, span, what.curve);
    const bool in_reference = mostly_measurable(reference, offset, span, what.curve);
    if (pairs.compared == 0) return found;
    const Episode of_preview = episode_of(pairs.preview, what.curve);
    const Episode of_reference = episode_of(pairs.reference, what.curve);
    if (in_preview) found.in_preview = presence_of(pairs.preview, of_preview, what);
    if (in_reference) found.in_reference = presence_of(pairs.reference, of_reference, what);
    if (!in_preview || !in_reference) return found;
    found.preview = of_preview;
    found.reference = of_reference;
    const Amount high = peak_of(pairs.preview, of_preview, what), wanted = peak_of(pairs.reference, of_reference, what);
    found.peak_over_error = std::abs(high.value - wanted.value) / facing(high, wanted).joint();
    if (found.in_reference == Presence::shown) {
        found.peak_ratio = ratio(of_preview.peak, of_reference.peak);
        found.area_ratio = ratio(of_preview.mean, of_reference.mean);  // over the same time
    }
    found.late = difference(of_preview.onset, of_reference.onset);
    if (!found.late && of_preview.peak_at && of_reference.peak_at)
        found.late = best_shift(curve, pairs.reference, what);
    found.rise_difference = difference(of_preview.rise, of_reference.rise);
    found.decay_difference = difference(of_preview.decay, of_reference.decay);
    return found;
}

}  // namespace

bool AmountLikeness::lost_in_error() const {
    const double of_preview = preview.peak.value_or(0.0), of_reference = reference.peak.value_or(0.0);
    return (in_preview == Presence::shown && in_reference == Presence::none && of_reference > of_preview) ||
           (in_preview == Presence::none && in_reference == Presence::shown && of_preview > of_reference);
}

bool AmountLikeness::missing_in_preview() const {
    return in_preview == Presence::none && in_reference == Presence::shown && peak_over_error > 1.0 && !lost_in_error();
}

bool AmountLikeness::missing_in_reference() const {
    return in_preview == Presence::shown && in_reference == Presence::none && peak_over_error > 1.0 && !lost_in_error();
}

bool AmountLikeness::within_error() const {
    const bool neither = in_preview == Presence::none && in_reference == Presence::none;
    return peak_over_error && *rms_over_error <= 1.0 && (neither || *peak_over_error <= 1.0);
}

bool AmountLikeness::cannot_tell() const {
    const double peak = std::max(preview.peak.value_or(0.0), reference.peak.value_or(0.0));
    const double most = peak > told_peak ? std::min(peak, std::max(most_error, most_error_of_peak * peak)) : most_error;
    return within_error() && error.value_or(0.0) > most;
}

Likeness likeness_of(std::span<const FrameAmounts> preview, std::span<const FrameAmounts> reference, double offset) {
    const Span span = common_span(preview, reference, offset);
    if (span.empty()) return {};
    return {.overlap = span.to - span.from,
            .blood = compare(preview, reference, offset, span, of_blood),
            .veil = compare(preview, reference, offset, span, of_veil)};
}

}  // namespace lapfx::match
