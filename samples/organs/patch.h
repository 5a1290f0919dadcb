// A patch: a grid of points over the unit square, the piece from which every organ is made. Lengths mm. Seen
// from outside, u runs to the right and v down, as in the texture, so that the normal is cross(dv, du).
//
//     Patch patch = make_patch(80, 60, [](double u, double v) { return dvec3(100 * u, -70 * v, 0); });
//     displace(patch, [](const Vertex& at) { return 2.0 * fbm(at.rest * 0.1, 3, 5); });
#pragma once

#include <functional>
#include <vector>

#include "noise.h"

namespace organs {

/// `rest` is the position before displacement: noise for shape and colour is looked up there, so that creases in the
/// mesh and in the texture coincide.
struct Vertex {
    dvec3 rest{0.0};
    dvec3 position{0.0};
    dvec3 normal{0.0, 0.0, 1.0};
    double mask = 1.0;   ///< a value for the tissue, 0..1
    double light = 1.0;  ///< 1 = open, 0 = deep in a gap; becomes the vertex colour
};

struct Patch {
    int columns = 0;
    int rows = 0;
    std::vector<Vertex> vertices;  ///< row by row
    std::vector<bool> hidden;      ///< per vertex; a quad whose corners are all hidden is left out
    dvec2 uv_min{0.0};             ///< the patch's rectangle in its texture
    dvec2 uv_max{1.0};

    Vertex& at(int column, int row) { return vertices[static_cast<std::size_t>(row * columns + column)]; }
    const Vertex& at(int column, int row) const { return vertices[static_cast<std::size_t>(row * columns + column)]; }
};

/// The surface at (u, v), interpolated; du and dv are the derivatives, mm per whole patch.
struct SurfacePoint {
    Vertex vertex;
    dvec3 du{0.0};
    dvec3 dv{0.0};
};

Patch make_patch(int columns, int rows, const std::function<dvec3(double u, double v)>& position);
void update_normals(Patch& patch);

/// Moves every vertex along its normal, by mm, then computes the normals again.
void displace(Patch& patch, const std::function<double(const Vertex&)>& distance);

/// Evens out the spacing of the inner vertices.
void relax(Patch& patch, int passes);

SurfacePoint sample(const Patch& patch, double u, double v);

/// The mesh of one material: its patches, joined.
struct Mesh {
    std::vector<dvec3> positions;
    std::vector<dvec3> normals;
    std::vector<dvec3> tangents;
    std::vector<dvec2> uvs;
    std::vector<double> light;
    std::vector<std::uint32_t> indices;
};
void append(Mesh& mesh, const Patch& patch);

/// Hides all visible pieces except the largest connected one.
void hide_islands(Patch& patch);

/// Gives vertices at the same place in several patches one normal.
void weld_normals(std::vector<Patch*> patches);

}  // namespace organs
