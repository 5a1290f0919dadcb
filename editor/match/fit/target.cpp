#include "match/fit/target.h"

#include <algorithm>
#include <cmath>

#include "match/compare/likeness.h"

namespace lapfx::match {

namespace {

constexpr double mistaken_for = 1.0;  // s: a shadow or an instrument that is taken for blood seldom stays longer
constexpr double rounding = 1e-9;     // s
constexpr double most_around = 0.25;  // s: the scene is drawn at one moment
constexpr double hidden_by_veil = 0.1, usual_likeness = 0.75;

double hidden_blood_of(const FrameAmounts& frame) {
    const double unseen = std::max(1.0 - frame.likeness, 0.0) / (1.0 - usual_likeness);
    return hidden_by_veil * unseen * std::max(frame.veil.value, 0.0);
}

struct Mean {
    Amount sum;
    int count = 0;
    void add(const Amount& amount) {
        sum.value += amount.value, sum.low += amount.low, sum.high += amount.high;
        ++count;
    }
    std::optional<Amount> get() const {
        if (count == 0) return {};
        return Amount{sum.value / count, sum.low / count, sum.high / count};
    }
};

}  // namespace

std::vector<TargetPoint> target_of(std::span<const FrameAmounts> reference, const TargetOptions& options) {
    const double length = options.to - options.from;
    if (!(length > 0.0) || reference.empty()) return {};
    const auto steps = std::clamp(static_cast<std::size_t>(std::ceil(length / options.step - 1e-9)), std::size_t{1},
                                  std::max(options.most, std::size_t{2}) - 1);
    const double step = length / static_cast<double>(steps);
    const double around = std::min(0.5 * step, most_around);
    std::vector<TargetPoint> target;
    for (std::size_t i = 0; i <= steps; ++i) {
        const double time = options.from + length * static_cast<double>(i) / static_cast<double>(steps);
        const auto first = std::lower_bound(reference.begin(), reference.end(), time + options.offset - around,
                                            [](const FrameAmounts& frame, double at) { return frame.time < at; });
        Mean blood, veil, plume;
        double hidden = 0.0;
        int frames = 0;
        for (auto frame = first; frame != reference.end() && frame->time <= time + options.offset + around; ++frame) {
            hidden += hidden_blood_of(*frame), ++frames;
            if (measurable(*frame, Curve::blood)) blood.add(frame->blood);
            if (measurable(*frame, Curve::veil)) veil.add(frame->veil);
            if (frame->plume) plume.add(*frame->plume);
        }
        if (frames > 0)
            target.push_back({.time = time,
                              .blood = blood.get(),
                              .veil = veil.get(),
                              .plume = plume.get(),
                              .hidden_blood = hidden / frames});
    }
    if (target.size() < 2) target.clear();
    return target;
}

std::vector<double> compared_times(std::span<const FrameAmounts> reference, double offset, double from, double to) {
    TargetOptions options{.offset = offset, .from = from, .to = to};
    options.most = std::max(options.most, static_cast<std::size_t>(std::ceil((to - from) / longest_gap)));
    std::vector<double> times;
    for (const TargetPoint& point : target_of(reference, options)) times.push_back(point.time);
    return times;
}

double course_error(const Amount& amount, const CourseError& course) {
    constexpr double deviates = 1.645;  // half a 90 % interval, in standard errors
    const double most = std::min(course.none + course.share * std::max(amount.value, 0.0), course.most);
    return std::clamp((amount.high - amount.low) / (2.0 * deviates), course.least, most);
}

bool shows_blood(std::span<const TargetPoint> target) {
    std::optional<double> last;
    double seen = 0.0;
    for (const TargetPoint& aim : target) {
        const bool is_seen = aim.blood && aim.blood->low > 0.0;
        // Where it is not measurable nothing is known: that neither ends what is seen nor is it a time of bleeding.
        if (is_seen && last) seen += std::min(aim.time - *last, mistaken_for);
        if (aim.blood && !is_seen) seen = 0.0;
        last = is_seen ? std::optional(aim.time) : std::nullopt;
        if (seen >= mistaken_for - rounding) return true;
    }
    return false;
}

std::optional<double> misfit(std::span<const TargetPoint> target, std::span<const FrameAmounts> shown,
                             std::optional<Amount> TargetPoint::*amount) {
    const Curve curve = amount == &TargetPoint::blood ? Curve::blood : Curve::veil;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < target.size() && i < shown.size(); ++i) {
        const std::optional<Amount>& aim = target[i].*amount;
        if (!aim || !measurable(shown[i], curve)) continue;
        const double off = (curve == Curve::blood ? shown[i].blood : shown[i].veil).value - aim->value;
        sum += off * off, ++count;
    }
    if (count == 0) return {};
    return std::sqrt(sum / count);
}

}  // namespace lapfx::match
