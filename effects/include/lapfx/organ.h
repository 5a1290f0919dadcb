// An organ: a triangle surface with textures, lengths in mm, whatever file it came from.
//
//     lapfx::Organ organ = lapfx::load_organ("stomach.glb");    // throws lapfx::Error
//     for (const auto& warning : organ.warnings) std::cerr << warning << '\n';
//
// glTF 2.0 (.glb, .gltf), OBJ (with its MTL), PLY, STL and OFF. Every vertex has a normal, a tangent, UVs and a colour;
// lapfx computes those that the file lacks. Input that cannot be drawn (degenerate or duplicate triangles, NaN, indices
// out of range, unreferenced vertices) is left out, with a warning that names and counts it. Plain data; load from any
// thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/api.h"

namespace lapfx {

/// What a texture shows beyond its edges.
enum class Wrap : std::uint8_t {
    repeat,  ///< its other side
    clamp,   ///< the texels of the edge
    mirror,  ///< itself, mirrored in every second repetition
};

/// 8-bit pixels, rows from the top, RGBA. Colour images are sRGB, normal maps are not.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;  ///< width * height * 4
    std::string name;
    Wrap wrap_u = Wrap::repeat;  ///< left and right
    Wrap wrap_v = Wrap::repeat;  ///< above and below
};

struct Material {
    std::string name;
    glm::vec4 base_color{1.0f};  ///< linear, multiplies the texture and the vertex colour
    float roughness = 0.5f;
    float normal_scale = 1.0f;
    int base_color_image = -1;  ///< index into Organ::images, or -1
    int normal_image = -1;      ///< tangent space, y up (glTF convention)
    bool double_sided = false;
};

/// A run of triangles with one material.
struct Part {
    std::string name;
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    int material = 0;
};

/// What became of the triangles of a file: read == kept + dropped(). A polygon of n corners counts as n - 2 triangles.
struct TriangleCounts {
    std::size_t read = 0;          ///< triangles that the faces of the file make
    std::size_t kept = 0;          ///< triangles that are drawn
    std::size_t unreadable = 0;    ///< left out: corners are missing or are not numbers
    std::size_t out_of_range = 0;  ///< left out: corners are vertices that the file does not have
    std::size_t not_finite = 0;    ///< left out: coordinates are NaN, infinite, or beyond 1e9 mm
    std::size_t without_area = 0;  ///< left out: the corners lie on a line
    std::size_t repeated = 0;      ///< left out: the file already had the same triangle
    std::size_t sewn = 0;          ///< repaired: vertices moved to the other side of a seam that rounding had torn

    std::size_t dropped() const { return unreadable + out_of_range + not_finite + without_area + repeated; }
};

/// A triangle mesh with its materials. It has to be complete: make_organ() and load_organ() make it so, and one that is
/// filled by hand and whose arrays do not fit together is refused where it is used, with Error (bad_input).
struct Organ {
    std::string name;
    std::vector<glm::vec3> positions;    ///< mm
    std::vector<glm::vec3> normals;      ///< unit
    std::vector<glm::vec4> tangents;     ///< unit xyz, w = +1 or -1: bitangent = w * cross(normal, tangent)
    std::vector<glm::vec2> uvs;          ///< origin top left, as in glTF
    std::vector<glm::vec4> colors;       ///< linear RGBA, white where the file has none
    std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise from outside
    std::vector<Part> parts;             ///< cover all indices, in order
    std::vector<Material> materials;     ///< there is at least one
    std::vector<Image> images;
    std::vector<std::string> warnings;         ///< what was repaired or left out, a line each
    std::vector<std::filesystem::path> files;  ///< the files that it was read from, the mesh first; all are in its
                                               ///< folder or below, but for OrganOptions::texture
    std::vector<std::filesystem::path>
        unread_files;      ///< files that it names inside that folder, but that are missing or not what they should be
    bool has_uvs = false;  ///< the file had texture coordinates (else they were made)
    bool has_colors = false;  ///< the file had vertex colours
    double scale = 1.0;       ///< mm per unit of the file, as it was applied
    TriangleCounts counts;    ///< triangles of the file; all 0 for an organ that was not read from one

    std::size_t triangle_count() const { return indices.size() / 3; }
};

struct OrganOptions {
    double scale = 0.0;        ///< mm per unit of the file; 0 = by format: 1000 for glTF (metres), 1 for others
    glm::dvec3 rotation{0.0};  ///< degrees about x, then y, then z, applied after the scale
    std::filesystem::path texture = {};  ///< a picture in place of all base colour textures; empty: its own
};

/// Throws Error: bad_input (missing, not a plain file, empty, truncated, malformed, no triangles, an
/// extension we cannot read: each named).
LAPFX_API Organ load_organ(const std::filesystem::path& path, const OrganOptions& options = {});

/// A surface of the host's own. What is empty is made; the rest has one element for each position.
struct Mesh {
    std::span<const glm::vec3> positions;     ///< of OrganOptions::scale mm, 1 where that is 0
    std::span<const std::uint32_t> indices;   ///< three per triangle, counter-clockwise from outside
    std::span<const glm::vec3> normals = {};  ///< of any length; zero = missing
    std::span<const glm::vec2> uvs = {};      ///< origin top left
    std::span<const glm::vec4> colors = {};   ///< linear RGBA, 0..1
    std::string_view name = "organ";
    Material material = {};
    std::span<const Image> images = {};  ///< of the material
};

/// The organ with that surface. Its vertices are those of the mesh, in their order, so that Effects::bleed_buffer() and
/// set_shape() fit the host's; triangles without area are left out, with a warning. Throws Error (bad_input) for what
/// does not fit together, values that are not numbers or are beyond 1e9 mm, no triangles, and more than 20,000,000.
LAPFX_API Organ make_organ(const Mesh& mesh, const OrganOptions& options = {});

}  // namespace lapfx
