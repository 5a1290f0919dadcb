#include "cautery/diffusion_cpu.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lapfx::cautery {

namespace {

/// A triangle thinner than this, as area over the square of its longest side, is taken for one that is just so thin: its
/// element stays positive semidefinite and finite.
constexpr double thinnest = 1e-4;

struct Shape {
    double area = 0.0;        // mm2
    double stiff_area = 0.0;  // not below the thinnest; 0: no triangle at all
};

Shape shape_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a, bc = c - b;
    const double area = 0.5 * glm::length(glm::cross(ab, ac));
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    return {area, std::max(area, thinnest * longest)};
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

void Diffusion::restore(const Field& field) {
    slot_.resize(surface_.positions.size(), none);
    for (const std::uint32_t p : field_.points) slot_[p] = none;
    field_ = field;
    for (std::uint32_t i = 0; i < field_.points.size(); ++i) slot_[field_.points[i]] = i;
    source_.assign(field_.points.size(), 0.0);
    stale_ = true;
}

void Diffusion::join(std::uint32_t point) {
    if (slot_[point] != none) return;
    slot_[point] = static_cast<std::uint32_t>(field_.points.size());
    field_.points.push_back(point);
    field_.now.push_back(0.0);
    field_.before.push_back(0.0);
    source_.push_back(0.0);
    stale_ = true;
}

void Diffusion::heat(std::uint32_t point, double rate) {
    join(point);
    source_[slot_[point]] += rate;
}

void Diffusion::drop_cool() {
    const auto cool = [&](std::uint32_t p) { return std::abs(rise_of(p, field_.now)) < leaves_at; };
    Field kept;
    for (std::size_t i = 0; i < field_.points.size(); ++i) {
        const std::uint32_t p = field_.points[i];
        const auto around = surface_.neighbours_of(p);
        if (cool(p) && std::all_of(around.begin(), around.end(), cool)) continue;
        kept.points.push_back(p);
        kept.now.push_back(field_.now[i]);
        kept.before.push_back(field_.before[i]);
    }
    if (kept.points.size() < field_.points.size()) restore(kept);
}

/// The row of a point: cotangents of the angles opposite its edges, and its share of the triangles' areas.
void Diffusion::assemble_row(std::uint32_t point) {
    const auto around = surface_.neighbours_of(point);
    const auto first = static_cast<std::uint32_t>(entries_.size());
    double mass = 0.0, stiffness = 0.0;
    for (const std::uint32_t other : around) entries_.push_back({other, 0.0, 0.0});
    const auto entry = [&](std::uint32_t other) -> Entry& {
        const auto at = std::lower_bound(around.begin(), around.end(), other) - around.begin();
        return entries_[first + static_cast<std::size_t>(at)];
    };
    for (const std::uint32_t t : surface_.triangles_at(point)) {
        const auto& corners = surface_.triangles[t];
        const std::size_t i = corners[0] == point ? 0 : corners[1] == point ? 1 : 2;
        const std::uint32_t a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
        if (a == b || a == point || b == point) continue;
        const glm::dvec3 &p = surface_.positions[point], &pa = surface_.positions[a], &pb = surface_.positions[b];
        const Shape shape = shape_of(p, pa, pb);
        if (!(shape.stiff_area > 0.0)) continue;
        const double to_a = glm::dot(p - pb, pa - pb) / (4.0 * shape.stiff_area);
        const double to_b = glm::dot(p - pa, pb - pa) / (4.0 * shape.stiff_area);
        mass += shape.area / 4.0;
        stiffness += to_a + to_b;
        entry(a).mass += shape.area / 24.0;
        entry(a).stiffness -= to_a;
        entry(b).mass += shape.area / 24.0;
        entry(b).stiffness -= to_b;
    }
    // Points of triangles without any area have no mass; so little keeps the matrix regular.
    mass_.push_back(std::max(mass, 1e-12));
    stiffness_.push_back(stiffness);
    // Neighbours out of play are 0 and stay so.
    std::size_t kept = first;
    for (std::size_t e = first; e < entries_.size(); ++e)
        if (slot_[entries_[e].column] != none) {
            entries_[kept] = entries_[e];
            entries_[kept++].column = slot_[entries_[e].column];
        }
    entries_.resize(kept);
}

void Diffusion::assemble() {
    entries_.clear();
    mass_.clear();
    stiffness_.clear();
    row_start_.assign(1, 0);
    for (const std::uint32_t p : field_.points) {
        assemble_row(p);
        row_start_.push_back(static_cast<std::uint32_t>(entries_.size()));
    }
    stale_ = false;
}

void Diffusion::apply(double a, double b, const std::vector<double>& x, std::vector<double>& out) const {
    out.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        double sum = (a * mass_[i] + b * stiffness_[i]) * x[i];
        for (std::uint32_t e = row_start_[i]; e < row_start_[i + 1]; ++e)
            sum += (a * entries_[e].mass + b * entries_[e].stiffness) * x[entries_[e].column];
        out[i] = sum;
    }
}

void Diffusion::solve(double a, double b, const std::vector<double>& right, std::vector<double>& x) {
    const std::size_t size = right.size();
    apply(a, b, x, residual_);
    conditioned_.resize(size);
    const auto condition = [&] {
        for (std::size_t i = 0; i < size; ++i) conditioned_[i] = residual_[i] / (a * mass_[i] + b * stiffness_[i]);
    };
    for (std::size_t i = 0; i < size; ++i) residual_[i] = right[i] - residual_[i];
    condition();
    direction_ = conditioned_;
    double norm = dot(residual_, conditioned_);
    // In the norm of the preconditioner: the error in degrees, weighted by area.
    const double enough = 1e-18 * std::max(dot(x, right), norm);
    for (int i = 0; i < 200 && norm > enough && norm > 1e-24; ++i) {
        apply(a, b, direction_, applied_);
        const double step = norm / dot(direction_, applied_);
        for (std::size_t k = 0; k < size; ++k) {
            x[k] += step * direction_[k];
            residual_[k] -= step * applied_[k];
        }
        condition();
        const double next = dot(residual_, conditioned_);
        for (std::size_t k = 0; k < size; ++k) direction_[k] = conditioned_[k] + next / norm * direction_[k];
        norm = next;
    }
}

void Diffusion::step(double dt, double diffusivity, double perfusion) {
    for (std::size_t i = 0, size = field_.points.size(); i < size; ++i)
        if (std::abs(field_.now[i]) > joins_at || source_[i] * dt > joins_at)
            for (const std::uint32_t other : surface_.neighbours_of(field_.points[i])) join(other);
    if (stale_) assemble();
    const std::size_t size = field_.points.size();
    field_.before = field_.now;
    // Both stages have the same matrix: mass + c (diffusivity stiffness + perfusion mass).
    constexpr double gamma = 2.0 - std::numbers::sqrt2;
    const double c = 0.5 * gamma * dt, a = 1.0 + c * perfusion, b = c * diffusivity;
    // Trapezoidal rule to gamma dt ...
    middle_.resize(size);
    right_.resize(size);
    for (std::size_t i = 0; i < size; ++i)
        middle_[i] = (1.0 - c * perfusion) * field_.before[i] + gamma * dt * source_[i];
    apply(1.0, 0.0, middle_, right_);
    apply(0.0, -b, field_.before, applied_);
    for (std::size_t i = 0; i < size; ++i) right_[i] += applied_[i];
    middle_ = field_.before;
    solve(a, b, right_, middle_);
    // ... and from there with the second backward difference.
    constexpr double weight = 1.0 / (gamma * (2.0 - gamma)), past = weight * (1.0 - gamma) * (1.0 - gamma);
    for (std::size_t i = 0; i < size; ++i)
        field_.now[i] = weight * middle_[i] - past * field_.before[i] + c * source_[i];
    apply(1.0, 0.0, field_.now, right_);
    field_.now = middle_;
    solve(a, b, right_, field_.now);
    std::fill(source_.begin(), source_.end(), 0.0);
}

glm::dvec3 Diffusion::gradient_at(std::uint32_t point, const std::vector<double>& rises) const {
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const std::uint32_t t : surface_.triangles_at(point)) {
        const auto& [a, b, c] = surface_.triangles[t];
        const glm::dvec3 &pa = surface_.positions[a], &pb = surface_.positions[b], &pc = surface_.positions[c];
        const Shape shape = shape_of(pa, pb, pc);
        if (shape.area < shape.stiff_area || shape.area <= 0.0) continue;
        const glm::dvec3 normal = glm::normalize(glm::cross(pb - pa, pc - pa));
        // Of a linear function: its values times the edges opposite, turned by a right angle, over twice the area.
        sum += 0.5 * glm::cross(normal, rise_of(a, rises) * (pc - pb) + rise_of(b, rises) * (pa - pc) +
                                            rise_of(c, rises) * (pb - pa));
        area += shape.area;
    }
    return area > 0.0 ? sum / area : glm::dvec3(0.0);
}

double Diffusion::rise_at(const SurfacePoint& place, const std::vector<double>& rises) const {
    double rise = 0.0, bend = 0.0, highest = 0.0;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t point = surface_.triangles[place.triangle][static_cast<std::size_t>(i)];
        const double corner = rise_of(point, rises);
        rise += place.weights[i] * corner;
        highest = std::max(highest, std::abs(corner));
        bend +=
            0.5 * place.weights[i] * glm::dot(gradient_at(point, rises), place.position - surface_.positions[point]);
    }
    return rise + std::clamp(bend, -0.5 * highest, 0.5 * highest);
}

}  // namespace lapfx::cautery
