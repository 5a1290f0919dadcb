// make_organ(): an organ of arrays that a host has in memory.
#include "organ/check.h"
#include "organ/load.h"
#include "organ/mend.h"

namespace lapfx {

namespace {

using organ::farthest;
constexpr double farthest_uv = 1e6;  // a file has the same limit

class Check {
  public:
    explicit Check(std::string_view name) : name_(name) {}

    [[noreturn]] void refuse(const std::string& place, const std::string& reason) const {
        organ::refuse(name_, place, reason);
    }
    template <typename T>
    void values(std::span<const T> all, const char* place, std::size_t count, double most, double least) const {
        if (!all.empty() && all.size() != count)
            refuse(place, std::to_string(all.size()) + "; there are " + std::to_string(count) + " positions");
        for (std::size_t i = 0; i < all.size(); ++i)
            for (int k = 0; k < T::length(); ++k)
                if (!std::isfinite(all[i][k]) || all[i][k] > most || all[i][k] < least)
                    refuse(std::string(place) + "/" + std::to_string(i),
                           std::to_string(all[i][k]) + " is not a number from " + std::to_string(least) + " to " +
                               std::to_string(most));
    }
    void count(std::size_t positions) const {
        constexpr std::size_t most = 3 * organ::maximum_triangles;
        if (positions == 0 || positions > most)
            refuse("positions", std::to_string(positions) + "; expected 1 to " + std::to_string(most));
    }
    void triangles(std::span<const std::uint32_t> indices, std::size_t vertices) const {
        if (indices.empty() || indices.size() % 3 != 0 || indices.size() / 3 > organ::maximum_triangles)
            refuse("indices", std::to_string(indices.size()) + "; three for each of 1 to " +
                                  std::to_string(organ::maximum_triangles) + " triangles are needed");
        organ::require_corners(name_, indices, vertices);
    }
    void image(int index, const char* place, std::size_t images) const {
        organ::require_image(name_, place, index, images);
    }
    void material(const Material& m) const {
        const float values[] = {m.base_color.r, m.base_color.g, m.base_color.b, m.base_color.a, m.roughness};
        for (const float value : values)
            if (!(value >= 0.0F && value <= 1.0F))
                refuse("material", std::to_string(value) + " of colour or roughness is not a number from 0 to 1");
        if (!std::isfinite(m.normal_scale))
            refuse("material", "a normal scale of " + std::to_string(m.normal_scale) + " is no number");
    }
    void pixels(std::span<const Image> images) const {
        for (std::size_t i = 0; i < images.size(); ++i) {
            const Image& image = images[i];
            const bool sized = image.width > 0 && image.height > 0 && image.width <= 32768 && image.height <= 32768;
            if (!sized || image.pixels.size() != static_cast<std::size_t>(image.width) * image.height * 4U)
                refuse("images/" + std::to_string(i), std::to_string(image.width) + "x" + std::to_string(image.height) +
                                                          " with " + std::to_string(image.pixels.size()) +
                                                          " bytes; four for each pixel are needed, up to 32768x32768");
        }
    }

  private:
    std::string name_;
};

void check(const Mesh& mesh, const OrganOptions& options) {
    const Check check(mesh.name);
    organ::require_usable(options, std::string(mesh.name));
    const double scale = options.scale > 0.0 ? options.scale : 1.0;
    const std::size_t count = mesh.positions.size();
    check.count(count);
    check.triangles(mesh.indices, count);
    check.values(mesh.positions, "positions", count, farthest / scale, -farthest / scale);
    check.values(mesh.normals, "normals", count, farthest, -farthest);
    check.values(mesh.uvs, "uvs", count, farthest_uv, -farthest_uv);
    check.values(mesh.colors, "colors", count, 1.0, 0.0);
    check.material(mesh.material);
    check.image(mesh.material.base_color_image, "material/base_color_image", mesh.images.size());
    check.image(mesh.material.normal_image, "material/normal_image", mesh.images.size());
    check.pixels(mesh.images);
}

bool has_area(const Organ& organ, const std::uint32_t* corner) {
    const glm::dvec3 a(organ.positions[corner[0]]);
    const glm::dvec3 area =
        glm::cross(glm::dvec3(organ.positions[corner[1]]) - a, glm::dvec3(organ.positions[corner[2]]) - a);
    return glm::dot(area, area) > 0.0;
}

void add_triangles(Organ& organ, std::span<const std::uint32_t> indices) {
    organ.counts.read = indices.size() / 3;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        if (has_area(organ, &indices[i])) organ.indices.insert(organ.indices.end(), &indices[i], &indices[i] + 3);
    organ.counts.kept = organ.triangle_count();
    organ.counts.without_area = organ.counts.read - organ.counts.kept;
    if (organ.counts.kept == 0) organ::refuse(organ.name, "indices", "no triangle has an area");
    if (organ.counts.without_area > 0)
        organ.warnings.push_back(organ::counted(organ.counts.without_area, "triangle has", "triangles have") +
                                 " no area: left out");
}

/// Vertices without a triangle are not drawn, but all that is computed of vertices is computed of them, too.
void complete_unused(Organ& organ) {
    std::vector<char> used(organ.positions.size(), 0);
    for (const std::uint32_t vertex : organ.indices) used[vertex] = 1;
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (used[v] != 0) continue;
        organ.normals[v] = {0.0F, 0.0F, 1.0F};
        organ.tangents[v] = {1.0F, 0.0F, 0.0F, 1.0F};
    }
}

template <typename T>
std::vector<T> or_all(std::span<const T> given, std::size_t count, T value) {
    return given.empty() ? std::vector<T>(count, value) : std::vector<T>(given.begin(), given.end());
}

}  // namespace

Organ make_organ(const Mesh& mesh, const OrganOptions& options) {
    check(mesh, options);
    const std::size_t count = mesh.positions.size();
    Organ organ;
    organ.name = mesh.name;
    organ.positions.assign(mesh.positions.begin(), mesh.positions.end());
    organ.normals = or_all(mesh.normals, count, glm::vec3(0.0F));
    organ.uvs = or_all(mesh.uvs, count, glm::vec2(0.0F));
    organ.colors = or_all(mesh.colors, count, glm::vec4(1.0F));
    organ.tangents.assign(count, glm::vec4(0.0F));
    organ.has_colors = !mesh.colors.empty();
    organ.materials = {mesh.material};
    organ.images.assign(mesh.images.begin(), mesh.images.end());
    add_triangles(organ, mesh.indices);
    organ.parts = {{.name = organ.name,
                    .first_index = 0,
                    .index_count = static_cast<std::uint32_t>(organ.indices.size()),
                    .material = 0}};
    organ.scale = options.scale > 0.0 ? options.scale : 1.0;
    organ::place(organ, options, nullptr);
    organ::complete(organ, {.uvs = {mesh.uvs.empty() ? char{1} : char{0}}});
    complete_unused(organ);
    return organ;
}

}  // namespace lapfx
