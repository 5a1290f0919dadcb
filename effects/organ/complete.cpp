// Normals, texture coordinates and tangents for files that lack them.
#include <algorithm>
#include <map>
#include <utility>

#include "organ/mend.h"
#include "organ/weld.h"

namespace lapfx::organ {

namespace {

/// A made texture repeats after this length, mm.
constexpr float texture_repeat = 50.0f;

bool is_direction(glm::vec3 v) {
    const float length = glm::dot(v, v);
    return std::isfinite(length) && length > 1e-12f;
}

glm::dvec3 area_vector(const Organ& organ, std::size_t i) {
    const glm::dvec3 a(organ.positions[organ.indices[i]]);
    return glm::cross(glm::dvec3(organ.positions[organ.indices[i + 1]]) - a,
                      glm::dvec3(organ.positions[organ.indices[i + 2]]) - a);
}

/// Area-weighted over all triangles at a point, so that a split vertex stays smooth.
void make_normals(Organ& organ) {
    bool all_there = true;
    for (glm::vec3& normal : organ.normals) {
        normal = is_direction(normal) ? glm::normalize(normal) : glm::vec3(0.0f);
        all_there &= normal != glm::vec3(0.0f);
    }
    if (all_there) return;
    const Weld weld = weld_positions(organ.positions);
    std::vector<glm::dvec3> sums(weld.points, glm::dvec3(0.0));
    std::vector<double> areas(weld.points, 0.0);
    std::vector<glm::vec3> own(organ.positions.size());
    for (std::size_t i = 0; i < organ.indices.size(); i += 3) {
        const glm::dvec3 area = area_vector(organ, i);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = organ.indices[i + corner];
            sums[weld.point[vertex]] += area;
            areas[weld.point[vertex]] += glm::length(area);
            own[vertex] = glm::vec3(glm::normalize(area));
        }
    }
    for (std::size_t v = 0; v < organ.normals.size(); ++v) {
        if (organ.normals[v] != glm::vec3(0.0f)) continue;
        const glm::dvec3& sum = sums[weld.point[v]];
        // The two sides of a sheet cancel out; the vertex then takes the normal of one of its triangles.
        const bool cancelled = glm::length(sum) < 1e-6 * areas[weld.point[v]];
        organ.normals[v] = cancelled ? own[v] : glm::vec3(glm::normalize(sum));
    }
}

/// Six-sided box projection: the plane that the normal looks along most.
glm::vec2 box_uv(glm::vec3 p, glm::vec3 n) {
    const glm::vec3 size = glm::abs(n);
    p /= texture_repeat;
    if (size.z >= size.x && size.z >= size.y) return {n.z < 0 ? -p.x : p.x, -p.y};
    if (size.x >= size.y) return {n.x < 0 ? p.z : -p.z, -p.y};
    return {p.x, n.y < 0 ? -p.z : p.z};
}

/// Twice the signed area of a triangle in the texture.
float uv_area(const Organ& organ, std::size_t i) {
    const glm::vec2 a = organ.uvs[organ.indices[i]];
    const glm::vec2 e1 = organ.uvs[organ.indices[i + 1]] - a, e2 = organ.uvs[organ.indices[i + 2]] - a;
    return e1.x * e2.y - e2.x * e1.y;
}

/// Some files have the same texture coordinates everywhere, which is as good as none.
bool covers_texture(const Organ& organ, const Part& part) {
    std::size_t with_area = 0;
    for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; i += 3)
        with_area += std::abs(uv_area(organ, i)) > 1e-12f;
    return with_area * 100 >= part.index_count / 3;
}

/// Materials and images that repeat, for the parts whose texture coordinates are made: these leave 0..1 everywhere.
/// What another part uses with its own coordinates stays as it is, and those parts get a copy.
class Repeated {
  public:
    /// `kept`: by image, whether a part uses it with its own coordinates.
    Repeated(Organ& organ, std::vector<Encoded>* encoded, std::vector<char> kept)
        : organ_(organ), encoded_(encoded), kept_(std::move(kept)) {}

    /// The material that a part is to have in place of that one.
    int material(int index) {
        const auto [made, is_new] = materials_.try_emplace(index, index);
        if (!is_new) return made->second;
        Material own = organ_.materials[static_cast<std::size_t>(index)];
        const std::pair before(own.base_color_image, own.normal_image);
        own.base_color_image = image(own.base_color_image);
        own.normal_image = image(own.normal_image);
        if (before == std::pair(own.base_color_image, own.normal_image)) return index;
        organ_.materials.push_back(std::move(own));
        return made->second = static_cast<int>(organ_.materials.size()) - 1;
    }

  private:
    int image(int index) {
        if (index < 0) return index;
        const auto i = static_cast<std::size_t>(index);
        if (organ_.images[i].wrap_u == Wrap::repeat && organ_.images[i].wrap_v == Wrap::repeat) return index;
        const auto [made, is_new] = images_.try_emplace(index, index);
        if (is_new && kept_[i] != 0) made->second = copy(i);
        Image& repeated = organ_.images[static_cast<std::size_t>(made->second)];
        repeated.wrap_u = repeated.wrap_v = Wrap::repeat;
        return made->second;
    }
    int copy(std::size_t i) {
        if (encoded_ != nullptr) {
            encoded_->resize(organ_.images.size());
            encoded_->push_back(Encoded((*encoded_)[i]));
        }
        organ_.images.push_back(Image(organ_.images[i]));
        return static_cast<int>(organ_.images.size()) - 1;
    }

    Organ& organ_;
    std::vector<Encoded>* encoded_;
    std::vector<char> kept_;
    std::map<int, int> materials_, images_;  ///< of the file, and what takes their place
};

void make_uvs(Organ& organ, const Missing& missing, std::vector<Encoded>* encoded) {
    std::vector<char> own(organ.parts.size(), 0), kept(organ.images.size(), 0);
    for (std::size_t p = 0; p < organ.parts.size(); ++p) {
        const Part& part = organ.parts[p];
        if (missing.uvs[p] || !covers_texture(organ, part)) continue;
        own[p] = 1;
        const Material& material = organ.materials[static_cast<std::size_t>(part.material)];
        for (const int image : {material.base_color_image, material.normal_image})
            if (image >= 0) kept[static_cast<std::size_t>(image)] = 1;
    }
    Repeated repeated(organ, encoded, std::move(kept));
    for (std::size_t p = 0; p < organ.parts.size(); ++p) {
        if (own[p] != 0) continue;
        Part& part = organ.parts[p];
        part.material = repeated.material(part.material);
        const Material& material = organ.materials[static_cast<std::size_t>(part.material)];
        const bool textured = material.base_color_image >= 0 || material.normal_image >= 0;
        const char* why = !missing.uvs[p] ? "its texture coordinates cover no area; new ones were made"
                          : textured      ? "has a texture, but no texture coordinates; they were made"
                                          : nullptr;
        if (why) organ.warnings.push_back("part " + (part.name.empty() ? std::to_string(p) : part.name) + ": " + why);
        for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
            const std::uint32_t v = organ.indices[i];
            organ.uvs[v] = box_uv(organ.positions[v], organ.normals[v]);
        }
    }
    organ.has_uvs = std::ranges::find(own, char{1}) != own.end();
}

glm::vec3 any_orthogonal(glm::vec3 n) {
    const glm::vec3 axis = std::abs(n.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(axis - n * glm::dot(n, axis));
}

/// Directions of growing u and v on the surface, summed over the triangles at each vertex.
struct TextureAxes {
    std::vector<glm::vec3> u, v;
};

TextureAxes texture_axes(const Organ& organ) {
    TextureAxes axes{std::vector<glm::vec3>(organ.positions.size(), glm::vec3(0.0f)),
                     std::vector<glm::vec3>(organ.positions.size(), glm::vec3(0.0f))};
    for (std::size_t i = 0; i < organ.indices.size(); i += 3) {
        const std::uint32_t* t = &organ.indices[i];
        const glm::vec3 p1 = organ.positions[t[1]] - organ.positions[t[0]];
        const glm::vec3 p2 = organ.positions[t[2]] - organ.positions[t[0]];
        const glm::vec2 w1 = organ.uvs[t[1]] - organ.uvs[t[0]], w2 = organ.uvs[t[2]] - organ.uvs[t[0]];
        const float area = w1.x * w2.y - w2.x * w1.y;
        if (std::abs(area) < 1e-20f) continue;
        const float sign = area < 0 ? -1.0f : 1.0f;
        const glm::vec3 along_u = sign * (p1 * w2.y - p2 * w1.y), along_v = sign * (p2 * w1.x - p1 * w2.x);
        for (int corner = 0; corner < 3; ++corner) {
            axes.u[t[corner]] += along_u;
            axes.v[t[corner]] += along_v;
        }
    }
    return axes;
}

/// Length 1 after removing the part along the normal; zero when nothing remains.
glm::vec3 in_surface(glm::vec3 direction, glm::vec3 normal) {
    const float length = glm::length(direction);
    if (!(length > 0.0f) || !std::isfinite(length)) return glm::vec3(0.0f);
    direction /= length;
    direction -= normal * glm::dot(normal, direction);
    return glm::dot(direction, direction) > 1e-6f ? glm::normalize(direction) : glm::vec3(0.0f);
}

void make_tangents(Organ& organ) {
    bool all_there = true;
    for (std::size_t v = 0; v < organ.tangents.size(); ++v) {
        const glm::vec4 given = organ.tangents[v];
        const glm::vec3 t = given.w == 0.0f ? glm::vec3(0.0f) : in_surface(glm::vec3(given), organ.normals[v]);
        organ.tangents[v] = t == glm::vec3(0.0f) ? glm::vec4(0.0f) : glm::vec4(t, given.w < 0 ? -1.0f : 1.0f);
        all_there &= organ.tangents[v].w != 0.0f;
    }
    if (all_there) return;
    const TextureAxes axes = texture_axes(organ);
    for (std::size_t v = 0; v < organ.tangents.size(); ++v) {
        if (organ.tangents[v].w != 0.0f) continue;
        const glm::vec3 n = organ.normals[v];
        glm::vec3 t = in_surface(axes.u[v], n);
        if (t == glm::vec3(0.0f)) t = any_orthogonal(n);
        // v runs down in the image and a normal map's y runs up: the bitangent points against growing v.
        const bool mirrored = glm::dot(glm::cross(n, t), axes.v[v]) > 0.0f;
        organ.tangents[v] = glm::vec4(t, mirrored ? -1.0f : 1.0f);
    }
}

}  // namespace

void complete(Organ& organ, const Missing& missing, std::vector<Encoded>* encoded) {
    make_normals(organ);
    make_uvs(organ, missing, encoded);
    make_tangents(organ);
}

}  // namespace lapfx::organ
