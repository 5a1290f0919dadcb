#include "height_map.h"

#include <algorithm>
#include <cmath>

namespace organs {
namespace {

constexpr double nothing = -150.0;  // mm: the height where nothing is visible

}  // namespace

View view_from(const dvec3& toward) {
    View view;
    view.toward = glm::normalize(toward);
    const dvec3 helper = std::abs(view.toward.y) < 0.99 ? dvec3(0.0, 1.0, 0.0) : dvec3(1.0, 0.0, 0.0);
    view.right = glm::normalize(glm::cross(helper, view.toward));
    view.up = glm::cross(view.toward, view.right);
    return view;
}

HeightMap::HeightMap(const View& view, double size, int cells)
    : view_(view), size_(size), cells_(cells), height_(static_cast<std::size_t>(cells * cells), nothing) {}

dvec2 HeightMap::cell(const dvec3& seen) const {
    return (dvec2(seen.x, seen.y) / size_ + 0.5) * static_cast<double>(cells_ - 1);
}

void HeightMap::add(const Patch& patch, bool facing) {
    for (int row = 0; row + 1 < patch.rows; ++row) {
        for (int column = 0; column + 1 < patch.columns; ++column) {
            const dvec3 a = view_.seen(patch.at(column, row).position);
            const dvec3 b = view_.seen(patch.at(column + 1, row).position);
            const dvec3 c = view_.seen(patch.at(column, row + 1).position);
            const dvec3 d = view_.seen(patch.at(column + 1, row + 1).position);
            triangle(a, c, b, facing);
            triangle(b, c, d, facing);
        }
    }
}

void HeightMap::triangle(const dvec3& a, const dvec3& b, const dvec3& c, bool facing) {
    const dvec2 p = cell(a);
    const dvec2 q = cell(b);
    const dvec2 r = cell(c);
    const double area = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
    if (std::abs(area) < 1e-12 || (facing && area < 0.0)) return;
    const int left = std::max(0, static_cast<int>(std::ceil(std::min({p.x, q.x, r.x}))));
    const int right = std::min(cells_ - 1, static_cast<int>(std::floor(std::max({p.x, q.x, r.x}))));
    const int low = std::max(0, static_cast<int>(std::ceil(std::min({p.y, q.y, r.y}))));
    const int high = std::min(cells_ - 1, static_cast<int>(std::floor(std::max({p.y, q.y, r.y}))));
    for (int y = low; y <= high; ++y) {
        for (int x = left; x <= right; ++x) {
            const double u = ((x - p.x) * (r.y - p.y) - (r.x - p.x) * (y - p.y)) / area;
            const double v = ((q.x - p.x) * (y - p.y) - (x - p.x) * (q.y - p.y)) / area;
            if (u < -1e-9 || v < -1e-9 || u + v > 1.0 + 1e-9) continue;
            double& height = height_[static_cast<std::size_t>(y * cells_ + x)];
            height = std::max(height, a.z + u * (b.z - a.z) + v * (c.z - a.z));
        }
    }
}

void HeightMap::drape(double radius) {
    const std::vector<double> under = height_;
    const int passes = std::max(1, static_cast<int>(radius * (cells_ - 1) / size_));
    // Relaxes a cloth that may rise above the tissue under it but not sink in.
    for (int pass = 0; pass < passes * passes; ++pass) {
        const std::vector<double> before = height_;
        for (int y = 1; y + 1 < cells_; ++y) {
            for (int x = 1; x + 1 < cells_; ++x) {
                const std::size_t i = static_cast<std::size_t>(y * cells_ + x);
                const std::size_t row = static_cast<std::size_t>(cells_);
                const double mean = 0.25 * (before[i - 1] + before[i + 1] + before[i - row] + before[i + row]);
                height_[i] = std::max(under[i], mean);
            }
        }
    }
}

double HeightMap::at(const dvec2& xy) const {
    const dvec2 p = glm::clamp(cell(dvec3(xy, 0.0)), dvec2(0.0), dvec2(cells_ - 1.001));
    const int x = static_cast<int>(p.x);
    const int y = static_cast<int>(p.y);
    const double s = p.x - x;
    const double t = p.y - y;
    const std::size_t i = static_cast<std::size_t>(y * cells_ + x);
    const std::size_t row = static_cast<std::size_t>(cells_);
    return (1 - s) * (1 - t) * height_[i] + s * (1 - t) * height_[i + 1] + (1 - s) * t * height_[i + row] +
           s * t * height_[i + row + 1];
}

void find_light(const std::vector<Patch*>& lit, const std::vector<const Patch*>& blockers, int directions,
                double reach) {
    std::vector<std::vector<double>> open;
    std::vector<std::vector<double>> total;
    for (const Patch* patch : lit) {
        open.emplace_back(patch->vertices.size(), 0.0);
        total.emplace_back(patch->vertices.size(), 1e-9);
    }
    for (int i = 0; i < directions; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / directions;
        const double angle = i * pi * (3.0 - std::sqrt(5.0));
        const double ring = std::sqrt(1.0 - z * z);
        HeightMap map(view_from({ring * std::cos(angle), ring * std::sin(angle), z}), 420.0, 420);
        for (const Patch* blocker : blockers) map.add(*blocker);
        for (std::size_t k = 0; k < lit.size(); ++k) {
            for (std::size_t j = 0; j < lit[k]->vertices.size(); ++j) {
                const Vertex& vertex = lit[k]->vertices[j];
                const double facing = glm::dot(vertex.normal, map.view().toward);
                if (facing <= 0.05) continue;
                const dvec3 seen = map.view().seen(vertex.position + 1.0 * vertex.normal);
                const double depth = map.at(dvec2(seen.x, seen.y)) - seen.z;
                const double blocked = depth > 1.0 ? std::exp(-depth / reach) : 0.0;
                open[k][j] += facing * (1.0 - blocked);
                total[k][j] += facing;
            }
        }
    }
    for (std::size_t k = 0; k < lit.size(); ++k) {
        for (std::size_t j = 0; j < lit[k]->vertices.size(); ++j) lit[k]->vertices[j].light = open[k][j] / total[k][j];
    }
}

}  // namespace organs
