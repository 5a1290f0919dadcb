#include "render/clip_mesh.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lapfx::render {

namespace {

// Sizes of a closed medium-large titanium clip, mm. The jaws press into the tissue between them.
constexpr double jaw_width = 0.72, jaw_height = 1.0, sunk = 0.35;
constexpr double apart = 0.44;  // from a jaw's middle line to the clip's
constexpr double bow = 0.05;    // how far the jaws gape halfway along
constexpr int around = 16, along_jaw = 10, along_bend = 10;

struct Station {
    glm::dvec2 place, tangent;  // x and z
    double scale = 1.0;         // of the profile
};

/// The middle line of a jaw: from the tip to where the bend begins. `side`: 1 or -1.
Station jaw_at(double length, double share, double side) {
    const double tip = 0.5 * length, bend = -0.5 * length + apart + 0.5 * jaw_width;
    const double rounding = 1.0 - share * (tip - bend) / (0.5 * jaw_width);  // above 0 near the tip
    const double gape = bow * std::sin(std::numbers::pi * share), slope = bow * std::numbers::pi / (tip - bend);
    return {.place = {tip + share * (bend - tip), side * (apart + gape)},
            .tangent = glm::normalize(glm::dvec2(-1.0, side * slope * std::cos(std::numbers::pi * share))),
            .scale = rounding > 0.0 ? std::sqrt(std::max(1.0 - rounding * rounding, 0.0)) : 1.0};
}

std::vector<Station> middle_line(double length) {
    std::vector<Station> line;
    const auto share_of = [](int i) {  // closer together where the tip is rounded
        const double t = static_cast<double>(i) / along_jaw;
        return t * t;
    };
    for (int i = 0; i < along_jaw; ++i) line.push_back(jaw_at(length, share_of(i), 1.0));
    const glm::dvec2 centre(-0.5 * length + apart + 0.5 * jaw_width, 0.0);
    for (int i = 0; i <= along_bend; ++i) {
        const double angle = std::numbers::pi * (0.5 + static_cast<double>(i) / along_bend);
        const glm::dvec2 out(std::cos(angle), std::sin(angle));
        line.push_back({.place = centre + apart * out, .tangent = {-out.y, out.x}});
    }
    for (int i = along_jaw - 1; i >= 0; --i) {
        Station station = jaw_at(length, share_of(i), -1.0);
        station.tangent = -station.tangent;
        line.push_back(station);
    }
    return line;
}

/// A superellipse between an ellipse and a rectangle: its ridge draws a line of light. Place (across, up) and normal.
std::array<glm::dvec2, 2> profile_at(int i) {
    constexpr double exponent = 2.5;
    const double angle = 2.0 * std::numbers::pi * i / around, c = std::cos(angle), s = std::sin(angle);
    const auto raised = [](double v, double by) { return std::copysign(std::pow(std::abs(v), by), v); };
    const glm::dvec2 half(0.5 * jaw_width, 0.5 * jaw_height);
    const glm::dvec2 q(raised(c, 2.0 / exponent), raised(s, 2.0 / exponent));
    const glm::dvec2 slope(raised(q.x, exponent - 1.0), raised(q.y, exponent - 1.0));
    return {half * q, glm::normalize(slope / half)};
}

}  // namespace

ClipMesh clip_mesh(double length) {
    const std::vector<Station> line = middle_line(length);
    ClipMesh mesh;
    for (std::size_t s = 0; s < line.size(); ++s) {
        const Station& station = line[s];
        const glm::dvec2 across(station.tangent.y, -station.tangent.x);
        // At the rounded tip normals point along the jaw as the profile shrinks.
        const glm::dvec2 ahead = s < line.size() / 2 ? -station.tangent : station.tangent;
        const double facing = std::sqrt(std::max(1.0 - station.scale * station.scale, 0.0));
        for (int i = 0; i < around; ++i) {
            const auto [at, normal] = profile_at(i);
            const glm::dvec2 flat = station.place + station.scale * at.x * across;
            mesh.positions.emplace_back(flat.x, station.scale * at.y + 0.5 * jaw_height - sunk, flat.y);
            const glm::dvec2 out = station.scale * normal.x * across + facing * ahead;
            mesh.normals.push_back(glm::vec3(glm::normalize(glm::dvec3(out.x, station.scale * normal.y, out.y))));
        }
    }
    const auto stations = static_cast<std::uint32_t>(line.size());
    for (std::uint32_t s = 0; s + 1 < stations; ++s)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = s * around + i, b = s * around + (i + 1) % around, c = a + around, d = b + around;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
        }
    return mesh;
}

}  // namespace lapfx::render
