#include "smoke/haze.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lapfx::smoke {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

template <class Span>
bool counts(const Span& span) {
    return std::isfinite(span.start) && std::isfinite(span.end) && span.end > span.start;
}

/// The earliest time at which two lists of spans differ; `never` when they do not. If only an end has moved, it is the
/// earlier of both ends: what started before is unchanged.
template <class Span>
double first_difference(std::span<const Span> before, std::span<const Span> now) {
    double first = never;
    const auto starts = [&](const Span& span) {
        if (counts(span)) first = std::min(first, span.start);
    };
    const std::size_t both = std::min(before.size(), now.size());
    for (std::size_t i = 0; i < both; ++i) {
        if (before[i] == now[i]) continue;
        Span moved = before[i];
        moved.end = now[i].end;
        if (counts(before[i]) && counts(now[i]) && moved == now[i])
            first = std::min(first, std::min(before[i].end, now[i].end));
        else
            starts(before[i]), starts(now[i]);
    }
    std::for_each(before.begin() + static_cast<std::ptrdiff_t>(both), before.end(), starts);
    std::for_each(now.begin() + static_cast<std::ptrdiff_t>(both), now.end(), starts);
    return first;
}

/// The integral of s * exp(-loss * (passed - s)) over 0..passed.
double rising_integral(double loss, double passed) {
    const double x = loss * passed;
    if (x < 1e-3) return passed * passed * (0.5 + x * (-1.0 / 6.0 + x * (1.0 / 24.0 - x / 120.0)));
    return (passed + std::expm1(-x) / loss) / loss;
}

}  // namespace

/// Gives the earliest time from which they differ.
template <class Span>
double HazeCurve::List<Span>::replace(std::span<const Span> wanted, std::size_t same) {
    same = std::min({same, spans.size(), wanted.size()});
    const double from = first_difference(std::span<const Span>(spans).subspan(same), wanted.subspan(same));
    spans.resize(same);
    latest.resize(same);
    for (const Span& span : wanted.subspan(same)) {
        const double end = counts(span) ? span.end : -never;
        latest.push_back(latest.empty() ? end : std::max(latest.back(), end));
        spans.push_back(span);
    }
    return from;
}

/// Includes all that end at `time` or later.
template <class Span>
std::span<const Span> HazeCurve::List<Span>::after(double time) const {
    const auto first = std::lower_bound(latest.begin(), latest.end(), time) - latest.begin();
    return std::span<const Span>(spans).subspan(static_cast<std::size_t>(first));
}

void HazeCurve::set_parameters(const HazeParameters& haze) {
    accumulation_ = haze.accumulation, ventilation_ = haze.ventilation, suction_ = haze.suction;
    anew_ = true;
}

void HazeCurve::set_factor(const FactorCurve& factor) {
    if (factor == factor_) return;
    factor_ = factor;
    anew_ = true;
}

void HazeCurve::set(std::span<const Emission> emissions, std::span<const Suction> suctions, std::size_t same_emissions,
                    std::size_t same_suctions) {
    double from = std::min(emissions_.replace(emissions, same_emissions), suctions_.replace(suctions, same_suctions));
    if (std::exchange(anew_, false)) from = -never;

    while (!pieces_.empty() && pieces_.back().start >= from) pieces_.pop_back();
    events_.clear();
    const auto add = [&](double time, double power, int emission, int suction) {
        if (time >= from) events_.push_back({time, power, emission, suction});
    };
    for (const Emission& e : emissions_.after(from))
        if (counts(e) && std::isfinite(e.power)) add(e.start, e.power, 1, 0), add(e.end, -e.power, -1, 0);
    for (const Suction& s : suctions_.after(from))
        if (counts(s)) add(s.start, 0.0, 0, 1), add(s.end, 0.0, 0, -1);
    for (const CurvePoint& point : factor_.points()) add(point.time, 0.0, 0, 0);
    // Ties have a fixed order, whatever the order of the lists, so that sums of powers are the same to the last bit.
    std::sort(events_.begin(), events_.end());
    for (const Event& event : events_) {
        Piece piece = pieces_.empty() ? Piece{event.time, 0.0, 1.0, 0.0, 0.0, 0, 0} : pieces_.back();
        piece.density = at(piece, event.time);
        piece.start = event.time;
        piece.emissions += event.emissions;
        piece.suctions += event.suctions;
        piece.power = piece.emissions > 0 ? piece.power + event.power : 0.0;  // no rounding remains when all have ended
        piece.factor = factor_.at(event.time);
        piece.slope = factor_.slope_after(event.time);
        pieces_.push_back(piece);
    }
}

double HazeCurve::at(const Piece& piece, double time) const noexcept {
    const double passed = time - piece.start;
    const double loss = ventilation_ + (piece.suctions > 0 ? suction_ : 0.0);
    // The integral of exp(-loss * s) over the time passed; expm1 keeps it exact for small losses. At loss 0 it is the
    // time itself.
    const double integral = loss > 1e-9 ? -std::expm1(-loss * passed) / loss : passed;
    double made = piece.factor * integral;
    if (piece.slope != 0.0) made += piece.slope * rising_integral(loss, passed);
    return piece.density * std::exp(-loss * passed) + accumulation_ * piece.power * made;
}

/// None before the first.
const HazeCurve::Piece* HazeCurve::piece_at(double time) const noexcept {
    const auto next = std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                       [](double t, const Piece& piece) { return t < piece.start; });
    return next == pieces_.begin() ? nullptr : &*(next - 1);
}

double HazeCurve::density(double time) const noexcept {
    const Piece* piece = piece_at(time);
    return piece != nullptr ? at(*piece, time) : 0.0;
}

double HazeCurve::emission(double time) const noexcept {
    const Piece* piece = piece_at(time);
    return piece != nullptr ? piece->power * (piece->factor + piece->slope * (time - piece->start)) : 0.0;
}

}  // namespace lapfx::smoke
