#include "cautery/diffusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lapfx::cautery {

namespace {

/// A triangle thinner than this, as area over the square of its longest side, counts as exactly this thin, so that its
/// element stays positive semidefinite and finite.
constexpr double thinnest = 1e-4;

/// How much of the mass is consistent; the rest is lumped. Lumped masses spread heat too slowly on even meshes,
/// consistent ones too fast on uneven ones; a quarter keeps both small.
constexpr double consistent = 0.25;

struct Shape {
    double area = 0.0;        // mm2
    double stiff_area = 0.0;  // not below the thinnest; 0: not a triangle
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
    for (const std::uint32_t p : field_.points) link_[p] = 0;
    field_ = field;
    for (std::uint32_t i = 0; i < field_.points.size(); ++i) link_[field_.points[i]] = i + 1;
    source_.assign(field_.points.size(), 0.0);
    stale_ = true;
}

void Diffusion::join(std::uint32_t point) {
    if (slot_of(point) != none) return;
    field_.points.push_back(point);
    link_[point] = static_cast<std::uint32_t>(field_.points.size());
    field_.now.push_back(0.0);
    field_.before.push_back(0.0);
    source_.push_back(0.0);
    if (stale_) return;
    assemble_row(point);
    // From now on the rows of its neighbours include it.
    for (const std::uint32_t other : surface_.neighbours_of(point)) {
        if (slot_of(other) == none || other == point) continue;
        const auto around = surface_.neighbours_of(other);
        const auto at = std::lower_bound(around.begin(), around.end(), point) - around.begin();
        entries_[row_start_[slot_of(other)] + static_cast<std::size_t>(at)].column = slot_of(point);
    }
}

void Diffusion::heat(std::uint32_t point, double rate) {
    join(point);
    source_[slot_of(point)] += rate;
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
        mass += shape.area * (1.0 / 3.0 - consistent / 6.0);
        stiffness += to_a + to_b;
        entry(a).mass += consistent * shape.area / 12.0;
        entry(a).stiffness -= to_a;
        entry(b).mass += consistent * shape.area / 12.0;
        entry(b).stiffness -= to_b;
    }
    // Points of triangles without area have no mass; this small mass keeps the matrix regular.
    mass_.push_back(std::max(mass, 1e-12));
    stiffness_.push_back(stiffness);
    for (std::size_t e = first; e < entries_.size(); ++e) entries_[e].column = slot_of(entries_[e].column);
    row_start_.push_back(static_cast<std::uint32_t>(entries_.size()));
}

void Diffusion::assemble() {
    entries_.clear();
    mass_.clear();
    stiffness_.clear();
    row_start_.assign(1, 0);
    for (const std::uint32_t p : field_.points) assemble_row(p);
    stale_ = false;
}

void Diffusion::apply(double a, double b, const std::vector<double>& x, std::vector<double>& out) const {
    out.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        double sum = (a * mass_[i] + b * stiffness_[i]) * x[i];
        for (std::uint32_t e = row_start_[i]; e < row_start_[i + 1]; ++e)
            if (entries_[e].column != none)
                sum += (a * entries_[e].mass + b * entries_[e].stiffness) * x[entries_[e].column];
        out[i] = sum;
    }
}

void Diffusion::solve(double a, double b, const std::vector<double>& right, std::vector<double>& x) {
    const std::size_t size = right.size();
    matrix_.resize(entries_.size());
    columns_.resize(entries_.size());
    for (std::size_t e = 0; e < matrix_.size(); ++e) {
        const bool in_play = entries_[e].column != none;
        matrix_[e] = in_play ? a * entries_[e].mass + b * entries_[e].stiffness : 0.0;
        columns_[e] = in_play ? entries_[e].column : 0;
    }
    diagonal_.resize(size);
    for (std::size_t i = 0; i < size; ++i) diagonal_[i] = a * mass_[i] + b * stiffness_[i];
    const auto multiply = [&](const std::vector<double>& of, std::vector<double>& out) {
        out.resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            double sum = diagonal_[i] * of[i];
            for (std::uint32_t e = row_start_[i]; e < row_start_[i + 1]; ++e) sum += matrix_[e] * of[columns_[e]];
            out[i] = sum;
        }
    };
    multiply(x, residual_);
    conditioned_.resize(size);
    const auto condition = [&] {
        for (std::size_t i = 0; i < size; ++i) conditioned_[i] = residual_[i] / diagonal_[i];
    };
    for (std::size_t i = 0; i < size; ++i) residual_[i] = right[i] - residual_[i];
    condition();
    direction_ = conditioned_;
    double norm = dot(residual_, conditioned_);
    // In the norm of the preconditioner: the error in degrees, weighted by area.
    const double enough = 1e-13 * std::max(dot(x, right), norm);
    for (int i = 0; i < 200 && norm > enough && norm > 1e-24; ++i) {
        multiply(direction_, applied_);
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

/// The logarithm is interpolated: around a tip rises are close to a Gaussian, whose logarithm is a paraboloid.
double Diffusion::level_of(std::uint32_t point, const std::vector<double>& rises) const {
    return slot_of(point) == none ? 0.0 : std::log1p(std::max(rises[slot_of(point)], 0.0));
}

/// Slope of the levels on the surface at a point: of the paraboloid through the point that fits its neighbours best
/// (least squares, in the tangent plane). The bend is held down a little, so that few or collinear neighbours do no
/// harm.
glm::dvec3 Diffusion::slope_at(std::uint32_t point, const std::vector<double>& rises) const {
    const glm::dvec3& centre = surface_.positions[point];
    glm::dvec3 normal(0.0);
    for (const std::uint32_t t : surface_.triangles_at(point)) {
        const auto& [a, b, c] = surface_.triangles[t];
        normal +=
            glm::cross(surface_.positions[b] - surface_.positions[a], surface_.positions[c] - surface_.positions[a]);
    }
    double scale = 0.0;
    for (const std::uint32_t other : surface_.neighbours_of(point))
        scale = std::max(scale, glm::distance(surface_.positions[other], centre));
    const double size = glm::length(normal);
    if (!(size > 0.0) || !(scale > 0.0)) return glm::dvec3(0.0);
    normal /= size;
    const glm::dvec3 off = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(normal, off)), up = glm::cross(normal, across);

    constexpr std::size_t unknowns = 5;
    std::array<std::array<double, unknowns + 1>, unknowns> m{};  // the normal equations
    const double here = level_of(point, rises);
    for (const std::uint32_t other : surface_.neighbours_of(point)) {
        const glm::dvec3 d = (surface_.positions[other] - centre) / scale;
        const double x = glm::dot(d, across), y = glm::dot(d, up);
        const std::array<double, unknowns + 1> row{x, y, x * x, x * y, y * y, level_of(other, rises) - here};
        for (std::size_t r = 0; r < unknowns; ++r)
            for (std::size_t c = 0; c <= unknowns; ++c) m[r][c] += row[r] * row[c];
    }
    for (std::size_t r = 0; r < unknowns; ++r) m[r][r] += r < 2 ? 1e-9 : 1e-3;
    // Symmetric and positive definite: Gauss needs no pivoting.
    for (std::size_t k = 0; k < unknowns; ++k)
        for (std::size_t r = k + 1; r < unknowns; ++r) {
            const double factor = m[r][k] / m[k][k];
            for (std::size_t c = k; c <= unknowns; ++c) m[r][c] -= factor * m[k][c];
        }
    std::array<double, unknowns> fit{};
    for (std::size_t r = unknowns; r-- > 0;) {
        fit[r] = m[r][unknowns];
        for (std::size_t c = r + 1; c < unknowns; ++c) fit[r] -= m[r][c] * fit[c];
        fit[r] /= m[r][r];
    }
    return (fit[0] * across + fit[1] * up) / scale;
}

double Diffusion::rise_at(const SurfacePoint& place, const std::vector<double>& rises) const {
    double level = 0.0, bend = 0.0;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t point = surface_.triangles[place.triangle][static_cast<std::size_t>(i)];
        level += place.weights[i] * level_of(point, rises);
        if (place.weights[i] > 0.0)
            bend +=
                0.5 * place.weights[i] * glm::dot(slope_at(point, rises), place.position - surface_.positions[point]);
    }
    return std::expm1(level + std::clamp(bend, -0.3, 0.3));
}

}  // namespace lapfx::cautery
