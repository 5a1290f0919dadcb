#include "bleeding/blood_amount.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "organ/above_zero.h"

namespace lapfx::bleeding {

namespace {

/// The edge's noise (shaders/bleeding.glsl) as values that are equally likely. The standard deviation of Perlin noise
/// at random places is 0.270; octaves are independent, and however many there are, the distribution has the same shape.
class EdgeNoise {
  public:
    static constexpr std::size_t count = 8;

    explicit EdgeNoise(const BleedingParameters& parameters) : strength_(parameters.noise_strength) {
        double amplitude = 1.0, sum = 0.0, squares = 0.0;
        for (int i = 0; i < parameters.noise_octaves; ++i, amplitude *= 0.5) {
            sum += amplitude;
            squares += amplitude * amplitude;
        }
        if (sum > 0.0) deviation_ = 0.270 * std::sqrt(squares) / sum;
    }

    /// mm by which the edge is moved, on tissue so steep (0..1, with rivulets).
    std::array<double, count> moves(double steep) const {
        std::array<double, count> found;
        for (std::size_t i = 0; i < count / 2; ++i) {
            const double x = std::min(deviation_ * parts_[i] * (1.0 + steep), 1.5);
            const double bent = std::min(x - steep * x * x * x / 6.75, 1.0);
            found[2 * i] = strength_ * bent;
            found[2 * i + 1] = -strength_ * bent;
        }
        return found;
    }
    double most() const { return strength_; }  ///< mm

  private:
    /// Means of its positive half in four parts of equal probability, in standard deviations. It is nearly a normal
    /// one, for which they would be 0.158, 0.491, 0.895 and 1.647.
    static constexpr std::array<double, count / 2> parts_{0.163, 0.509, 0.922, 1.638};

    double strength_, deviation_ = 0.0;
};

}  // namespace

void AmountSum::mark_triangles() noexcept {
    for (const std::uint32_t vertex : changed_.points())
        for (const std::uint32_t t : surface_.triangles_at(vertex))
            if (sums_.mark(t)) shapes_.push_back({.area = surface_.area(t), .steepness = steepness(t)});
    changed_.clear();
}

void AmountSum::clear() noexcept {
    changed_.clear();
    sums_.clear();
    shapes_.clear();
}

/// As the shader has it: none without rivulets, all on a wall.
double AmountSum::steepness(std::uint32_t triangle) const noexcept {
    const auto& c = surface_.triangles[triangle];
    const auto& p = surface_.positions;
    const glm::dvec3 across = glm::cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]);
    const double length = glm::length(across);
    return length > 0.0 ? glm::smoothstep(0.3, 0.9, glm::length(glm::cross(across / length, down_))) : 0.0;
}

BloodAmount AmountSum::measure(std::span<const glm::vec2> values, const BleedingParameters& parameters) noexcept {
    mark_triangles();
    const EdgeNoise noise(parameters);
    const auto above = [&](std::uint32_t v) { return values[v].x - parameters.threshold; };
    sums_.measure([&](std::uint32_t t, std::uint32_t number) {
        const auto& c = surface_.triangles[t];
        const Shape& shape = shapes_[number];
        std::array<double, 3> values_above{above(c[0]), above(c[1]), above(c[2])};
        std::sort(values_above.begin(), values_above.end());
        const auto [least, middle, most] = values_above;
        double share = 0.0, depth = 0.0;
        const auto add = [&](double move) {
            const organ::AboveZero wet = organ::above_zero({least - move, middle - move, most - move});
            share += wet.share;
            depth += wet.share * std::min(1.0, wet.mean / parameters.deep_at);
        };
        if (least >= noise.most() || most <= -noise.most()) {
            add(0.0);
        } else {
            for (const double move :
                 noise.moves(parameters.rivulets > 0.0 ? parameters.rivulets * shape.steepness : 0.0))
                add(move);
            share /= EdgeNoise::count;
            depth /= EdgeNoise::count;
        }
        return std::array{share * shape.area, parameters.thickness * depth * shape.area};
    });
    return {.area = sums_.sum(0), .volume = sums_.sum(1)};
}

}  // namespace lapfx::bleeding
