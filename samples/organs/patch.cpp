#include "patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace organs {
namespace {

std::size_t index_of(const Patch& patch, int column, int row) {
    return static_cast<std::size_t>(row * patch.columns + column);
}

bool all_hidden(const Patch& patch, int column, int row) {
    if (patch.hidden.empty()) return false;
    return patch.hidden[index_of(patch, column, row)] && patch.hidden[index_of(patch, column + 1, row)] &&
           patch.hidden[index_of(patch, column, row + 1)] && patch.hidden[index_of(patch, column + 1, row + 1)];
}

dvec3 column_step(const Patch& patch, int column, int row) {
    const int left = std::max(column - 1, 0);
    const int right = std::min(column + 1, patch.columns - 1);
    return (patch.at(right, row).position - patch.at(left, row).position) / static_cast<double>(right - left);
}

dvec3 row_step(const Patch& patch, int column, int row) {
    const int above = std::max(row - 1, 0);
    const int below = std::min(row + 1, patch.rows - 1);
    return (patch.at(column, below).position - patch.at(column, above).position) / static_cast<double>(below - above);
}

}  // namespace

Patch make_patch(int columns, int rows, const std::function<dvec3(double, double)>& position) {
    Patch patch;
    patch.columns = columns;
    patch.rows = rows;
    patch.vertices.resize(static_cast<std::size_t>(columns * rows));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            Vertex& vertex = patch.at(column, row);
            vertex.position =
                position(static_cast<double>(column) / (columns - 1), static_cast<double>(row) / (rows - 1));
            vertex.rest = vertex.position;
        }
    }
    update_normals(patch);
    return patch;
}

void update_normals(Patch& patch) {
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            const dvec3 normal = glm::cross(row_step(patch, column, row), column_step(patch, column, row));
            const double length = glm::length(normal);
            if (length > 1e-12) patch.at(column, row).normal = normal / length;
        }
    }
}

void displace(Patch& patch, const std::function<double(const Vertex&)>& distance) {
    for (Vertex& vertex : patch.vertices) vertex.position += vertex.normal * distance(vertex);
    update_normals(patch);
}

void relax(Patch& patch, int passes) {
    for (int pass = 0; pass < passes; ++pass) {
        const std::vector<Vertex> before = patch.vertices;
        for (int row = 1; row + 1 < patch.rows; ++row) {
            for (int column = 1; column + 1 < patch.columns; ++column) {
                const dvec3 mean = 0.25 * (before[index_of(patch, column - 1, row)].position +
                                           before[index_of(patch, column + 1, row)].position +
                                           before[index_of(patch, column, row - 1)].position +
                                           before[index_of(patch, column, row + 1)].position);
                Vertex& vertex = patch.at(column, row);
                vertex.position = glm::mix(vertex.position, mean, 0.5);
            }
        }
    }
    update_normals(patch);
}

SurfacePoint sample(const Patch& patch, double u, double v) {
    const double x = clamp01(u) * (patch.columns - 1);
    const double y = clamp01(v) * (patch.rows - 1);
    const int column = std::min(static_cast<int>(x), patch.columns - 2);
    const int row = std::min(static_cast<int>(y), patch.rows - 2);
    const double s = x - column;
    const double t = y - row;
    const std::array<const Vertex*, 4> corner = {&patch.at(column, row), &patch.at(column + 1, row),
                                                 &patch.at(column, row + 1), &patch.at(column + 1, row + 1)};
    const std::array<double, 4> weight = {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
    SurfacePoint point;
    point.vertex = {dvec3(0.0), dvec3(0.0), dvec3(0.0), 0.0, 0.0};
    for (std::size_t i = 0; i < 4; ++i) {
        point.vertex.rest += weight[i] * corner[i]->rest;
        point.vertex.position += weight[i] * corner[i]->position;
        point.vertex.normal += weight[i] * corner[i]->normal;
        point.vertex.mask += weight[i] * corner[i]->mask;
        point.vertex.light += weight[i] * corner[i]->light;
    }
    point.vertex.normal = glm::normalize(point.vertex.normal);
    point.du = glm::mix(corner[1]->position - corner[0]->position, corner[3]->position - corner[2]->position, t);
    point.dv = glm::mix(corner[2]->position - corner[0]->position, corner[3]->position - corner[1]->position, s);
    point.du *= patch.columns - 1;
    point.dv *= patch.rows - 1;
    return point;
}

namespace {

void add_vertex(Mesh& mesh, const Patch& patch, int column, int row) {
    const Vertex& vertex = patch.at(column, row);
    const dvec3 along = column_step(patch, column, row);
    const dvec3 tangent = along - vertex.normal * glm::dot(vertex.normal, along);
    const double length = glm::length(tangent);
    const dvec2 uv(static_cast<double>(column) / (patch.columns - 1), static_cast<double>(row) / (patch.rows - 1));
    mesh.positions.push_back(vertex.position);
    mesh.normals.push_back(vertex.normal);
    mesh.tangents.push_back(length > 1e-12 ? tangent / length : dvec3(1.0, 0.0, 0.0));
    mesh.uvs.push_back(glm::mix(patch.uv_min, patch.uv_max, uv));
    mesh.light.push_back(vertex.light);
}

}  // namespace

void append(Mesh& mesh, const Patch& patch) {
    std::vector<std::uint32_t> number(patch.vertices.size(), UINT32_MAX);
    const auto use = [&](std::size_t i) {
        if (number[i] == UINT32_MAX) {
            number[i] = static_cast<std::uint32_t>(mesh.positions.size());
            add_vertex(mesh, patch, static_cast<int>(i) % patch.columns, static_cast<int>(i) / patch.columns);
        }
        mesh.indices.push_back(number[i]);
    };
    const auto place = [&](std::size_t i) { return patch.vertices[i].position; };
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        if (glm::length(glm::cross(place(b) - place(a), place(c) - place(a))) < 1e-6) return;
        for (const std::size_t i : {a, b, c}) use(i);
    };
    for (int row = 0; row + 1 < patch.rows; ++row) {
        for (int column = 0; column + 1 < patch.columns; ++column) {
            if (all_hidden(patch, column, row)) continue;
            const std::size_t a = index_of(patch, column, row);
            const std::size_t b = index_of(patch, column + 1, row);
            const std::size_t c = index_of(patch, column, row + 1);
            const std::size_t d = index_of(patch, column + 1, row + 1);
            // The shorter diagonal: folds bend along it.
            if (glm::distance(place(a), place(d)) < glm::distance(place(b), place(c))) {
                triangle(a, c, d);
                triangle(a, d, b);
            } else {
                triangle(a, c, b);
                triangle(b, c, d);
            }
        }
    }
}

void hide_islands(Patch& patch) {
    std::vector<int> island(patch.vertices.size(), -1);
    std::vector<std::size_t> sizes;
    for (std::size_t start = 0; start < island.size(); ++start) {
        if (patch.hidden[start] || island[start] >= 0) continue;
        const int number = static_cast<int>(sizes.size());
        std::vector<std::size_t> reached = {start};
        island[start] = number;
        for (std::size_t next = 0; next < reached.size(); ++next) {
            const int column = static_cast<int>(reached[next]) % patch.columns;
            const int row = static_cast<int>(reached[next]) / patch.columns;
            for (int k = 0; k < 9; ++k) {
                const int x = column + k % 3 - 1;
                const int y = row + k / 3 - 1;
                if (x < 0 || y < 0 || x >= patch.columns || y >= patch.rows) continue;
                const std::size_t i = index_of(patch, x, y);
                if (patch.hidden[i] || island[i] >= 0) continue;
                island[i] = number;
                reached.push_back(i);
            }
        }
        sizes.push_back(reached.size());
    }
    if (sizes.empty()) return;
    const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
    for (std::size_t i = 0; i < island.size(); ++i) patch.hidden[i] = island[i] != largest;
}

void weld_normals(std::vector<Patch*> patches) {
    using Key = std::array<long long, 3>;
    std::map<Key, dvec3> sums;
    const auto key = [](const dvec3& p) {
        return Key{std::llround(p.x * 1e4), std::llround(p.y * 1e4), std::llround(p.z * 1e4)};
    };
    for (const Patch* patch : patches) {
        for (const Vertex& vertex : patch->vertices) sums[key(vertex.position)] += vertex.normal;
    }
    for (Patch* patch : patches) {
        for (Vertex& vertex : patch->vertices) {
            const dvec3 sum = sums[key(vertex.position)];
            if (glm::length(sum) > 1e-6) vertex.normal = glm::normalize(sum);
        }
    }
}

}  // namespace organs
