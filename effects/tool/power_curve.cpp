#include "tool/power_curve.h"

#include <algorithm>
#include <cmath>

namespace lapfx::tool {

PowerCurve::PowerCurve(std::span<const CurvePoint> points) : curve_(points, 1.0) {
    for (int level = 0; level + 1 < levels; ++level) steps_[static_cast<std::size_t>(level)] = steps_of(level);
}

/// The points themselves are always among them.
std::vector<double> PowerCurve::steps_of(int level) const {
    const double largest = (1 << level) * largest_step;
    std::vector<double> steps;
    const std::span<const CurvePoint> points = curve_.points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        steps.push_back(points[i].time);
        if (i + 1 == points.size()) break;
        const double length = points[i + 1].time - points[i].time;
        const double wanted = std::ceil(std::abs(points[i + 1].value - points[i].value) / largest);
        const int count = static_cast<int>(std::min(wanted, std::floor(length / shortest)));
        for (int k = 1; k < count; ++k) steps.push_back(points[i].time + length * k / count);
    }
    return steps;
}

std::uint32_t PowerCurve::count(const ToolContact& contact, int level) const {
    const std::vector<double>& steps = steps_[static_cast<std::size_t>(level)];
    if (steps.empty() || !contact.hot() || !(contact.duration > 0.0)) return 1;
    const auto first = std::upper_bound(steps.begin(), steps.end(), contact.time);
    return 1 + static_cast<std::uint32_t>(std::lower_bound(first, steps.end(), contact.end()) - first);
}

void PowerCurve::cut(const ToolContact& contact, int level, std::vector<ToolContact>& parts) const {
    if (curve_.even() || !contact.hot()) return parts.push_back(contact);
    const std::vector<double>& steps = steps_[static_cast<std::size_t>(level)];
    const double end = contact.end();
    auto next = std::upper_bound(steps.begin(), steps.end(), contact.time);
    double from = contact.time;
    while (true) {
        const bool last = next == steps.end() || *next >= end;
        const double to = last ? end : *next;
        ToolContact part = contact;
        part.time = from;
        part.duration = to - from;
        part.position = from == contact.time ? contact.position : contact.tip(from);
        part.to = last ? contact.to : contact.tip(to);
        // The mean of the whole step, not only of what the contact fills of it: a contact that grows keeps its parts.
        const bool between = next != steps.begin() && next != steps.end();
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
