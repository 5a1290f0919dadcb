#include "cautery/power.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "preset/usable_contact.h"

namespace lapfx::cautery {

void PowerCurve::set(std::span<const CurvePoint> points) {
    curve_ = FactorCurve(points, 1.0);
    make_steps(1);
}

/// With a step of `coarser` times the largest; the points themselves always stay.
void PowerCurve::make_steps(int coarser) {
    coarser_ = coarser;
    steps_.clear();
    const std::span<const CurvePoint> points = curve_.points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        steps_.push_back(points[i].time);
        if (i + 1 == points.size()) break;
        const double length = points[i + 1].time - points[i].time;
        const double wanted = std::ceil(std::abs(points[i + 1].value - points[i].value) / (coarser * largest_step));
        const int count = static_cast<int>(std::min(wanted, std::floor(length / shortest)));
        for (int k = 1; k < count; ++k) steps_.push_back(points[i].time + length * k / count);
    }
}

std::size_t PowerCurve::count_parts(std::span<const ToolContact> contacts) const {
    std::size_t count = 0;
    for (const ToolContact& contact : contacts) {
        ++count;
        if (!contact.hot() || !(contact.duration > 0.0)) continue;
        const auto first = std::upper_bound(steps_.begin(), steps_.end(), contact.time);
        count += static_cast<std::size_t>(std::lower_bound(first, steps_.end(), contact.end()) - first);
    }
    return count;
}

std::span<const ToolContact> PowerCurve::apply(std::span<const ToolContact> contacts) {
    if (curve_.even()) return contacts;
    if (coarser_ > 1) make_steps(1);
    const std::size_t room = std::max(most_parts, 2 * contacts.size());
    while (count_parts(contacts) > room && coarser_ < 64) make_steps(2 * coarser_);
    // Hundreds of points, all within thousands of contacts: each is one part then, with the mean of its time.
    if (count_parts(contacts) > room) steps_.clear();
    parts_.clear();
    for (const ToolContact& contact : contacts) {
        const auto good = contact.hot() ? usable(contact) : std::nullopt;
        if (good)
            add_parts(*good);
        else
            parts_.push_back(contact);  // what it is not used for, others say
    }
    if (steps_.empty()) coarser_ = std::numeric_limits<int>::max();
    return parts_;
}

void PowerCurve::add_parts(const ToolContact& contact) {
    const double end = contact.end();
    auto next = std::upper_bound(steps_.begin(), steps_.end(), contact.time);
    double from = contact.time;
    while (true) {
        const bool last = next == steps_.end() || *next >= end;
        const double to = last ? end : *next;
        ToolContact part = contact;
        part.time = from;
        part.duration = to - from;
        part.position = contact.tip(from);
        part.to = last ? contact.to : contact.tip(to);
        if (from == contact.time) part.position = contact.position;
        // All of the step that it lies in, not only what of it the contact fills: a contact that grows keeps its parts.
        const bool between = next != steps_.begin() && next != steps_.end();
        part.power *= between ? factor_from(*(next - 1), *next) : factor_from(from, to);
        parts_.push_back(part);
        if (last) return;
        from = to;
        ++next;
    }
}

double PowerCurve::factor_from(double begin, double end) const {
    return end > begin ? curve_.integral(begin, end) / (end - begin) : curve_.at(begin);
}

}  // namespace lapfx::cautery
