#include "tool/power_curve.h"

#include <algorithm>
#include <cmath>

namespace lapfx::tool {

PowerCurve::PowerCurve(std::span<const CurvePoint> points) : curve_(points, 1.0) {
    make_steps(1);
}

/// The points themselves stay until there are no steps at all.
void PowerCurve::make_steps(int coarser) {
    coarser_ = coarser;
    steps_.clear();
    if (coarser > coarsest) return;
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

std::size_t PowerCurve::count(const ToolContact& contact) const {
    if (steps_.empty() || !contact.hot() || !(contact.duration > 0.0)) return 1;
    const auto first = std::upper_bound(steps_.begin(), steps_.end(), contact.time);
    return 1 + static_cast<std::size_t>(std::lower_bound(first, steps_.end(), contact.end()) - first);
}

void PowerCurve::cut(const ToolContact& contact, std::vector<ToolContact>& parts) const {
    if (curve_.even() || !contact.hot()) return parts.push_back(contact);
    const double end = contact.end();
    auto next = std::upper_bound(steps_.begin(), steps_.end(), contact.time);
    double from = contact.time;
    while (true) {
        const bool last = next == steps_.end() || *next >= end;
        const double to = last ? end : *next;
        ToolContact part = contact;
        part.time = from;
        part.duration = to - from;
        part.position = from == contact.time ? contact.position : contact.tip(from);
        part.to = last ? contact.to : contact.tip(to);
        // All of the step that it lies in, not only what of it the contact fills: a contact that grows keeps its parts.
        const bool between = next != steps_.begin() && next != steps_.end();
        part.power *= between ? factor_from(*(next - 1), *next) : factor_from(from, to);
        parts.push_back(part);
        if (last) return;
        from = to;
        ++next;
    }
}

double PowerCurve::factor_from(double begin, double end) const {
    return end > begin ? curve_.integral(begin, end) / (end - begin) : curve_.at(begin);
}

}  // namespace lapfx::tool
