#include "organ/mend.h"

#include <bit>
#include <cstdio>

#include "organ/weld.h"

namespace lapfx::organ {

namespace {

/// Coordinates beyond this, mm, count as infinite; products of three smaller ones fit a float.
constexpr double largest_coordinate = 1e9;

struct Counts : TriangleCounts {
    std::size_t not_finite_vertices = 0, unused = 0;
};

/// Which positions have usable numbers.
struct Usable {
    double largest;  ///< units of the file

    bool operator()(const glm::vec3& p) const {
        // False for NaN as well.
        return std::abs(p.x) < largest && std::abs(p.y) < largest && std::abs(p.z) < largest;
    }
};

bool finite(glm::vec4 v) {
    return std::isfinite(v.x + v.y + v.z + v.w);
}

template <class Vector>
void append(std::vector<Vector>& to, const std::vector<Vector>& from, std::size_t count, Vector fill) {
    const std::size_t start = to.size();
    to.resize(start + count, fill);
    if (from.size() == count) std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(start));
}

void append_triangles(Organ& organ, const RawPart& part, std::uint32_t base, Counts& counts) {
    const auto size = static_cast<std::uint32_t>(part.positions.size());
    organ.indices.reserve(organ.indices.size() + part.indices.size());
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
        const std::uint32_t a = part.indices[i], b = part.indices[i + 1], c = part.indices[i + 2];
        if (a >= size || b >= size || c >= size)
            ++counts.out_of_range;
        else
            organ.indices.insert(organ.indices.end(), {base + a, base + b, base + c});
    }
}

Organ join(RawOrgan& raw, Missing& missing, Counts& counts) {
    Organ organ;
    for (RawPart& part : raw.parts) {
        const auto base = static_cast<std::uint32_t>(organ.positions.size());
        const std::size_t count = part.positions.size();
        const auto first = static_cast<std::uint32_t>(organ.indices.size());
        append(organ.positions, part.positions, count, glm::vec3(0.0f));
        append(organ.normals, part.normals, count, glm::vec3(0.0f));
        append(organ.tangents, part.tangents, count, glm::vec4(0.0f));
        append(organ.uvs, part.uvs, count, glm::vec2(0.0f));
        append(organ.colors, part.colors, count, glm::vec4(1.0f));
        append_triangles(organ, part, base, counts);
        missing.uvs.push_back(part.uvs.size() != count);
        organ.has_uvs |= count > 0 && part.uvs.size() == count;
        organ.has_colors |= count > 0 && part.colors.size() == count;
        organ.parts.push_back(
            {part.name, first, static_cast<std::uint32_t>(organ.indices.size()) - first, part.material});
        part = {};  // frees its memory, which is not needed any more
    }
    return organ;
}

/// Remembers triangles by their three points; a reversed triangle is a different one.
class Seen {
  public:
    explicit Seen(std::size_t triangles) : slots_(std::bit_ceil(triangles * 2 + 1)) {}

    /// False when the same triangle was added before.
    bool add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        while (b < a || c < a) std::swap(a, b), std::swap(b, c);  // the smallest first, order kept
        std::uint64_t h = (std::uint64_t{a} << 32 | b) * 0x9e3779b97f4a7c15ull;
        h = (h ^ (h >> 29) ^ c) * 0xbf58476d1ce4e5b9ull;
        std::size_t slot = (h ^ (h >> 32)) & (slots_.size() - 1);
        const std::array<std::uint32_t, 3> key{a + 1, b, c};  // 0 = free
        while (slots_[slot][0] != 0) {
            if (slots_[slot] == key) return false;
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = key;
        return true;
    }

  private:
    std::vector<std::array<std::uint32_t, 3>> slots_;
};

/// Twice the area is less than 1e-7 of the longest side squared: float coordinates cannot distinguish that from a line.
bool has_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double area = glm::length(glm::cross(b - a, c - a));
    const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
    return area > 1e-7 * std::max({square(b - a), square(c - b), square(a - c)});
}

/// Leaves out triangles that cannot be drawn, and those that exist already in any part. Each part keeps the range of
/// its remaining triangles.
void drop_triangles(Organ& organ, const Usable& usable, Counts& counts) {
    const Weld weld = weld_positions(organ.positions);
    Seen seen(organ.triangle_count());
    std::uint32_t out = 0;
    for (Part& part : organ.parts) {
        const std::uint32_t first = out;
        for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; i += 3) {
            const std::array<std::uint32_t, 3> v{organ.indices[i], organ.indices[i + 1], organ.indices[i + 2]};
            const glm::vec3 &a = organ.positions[v[0]], &b = organ.positions[v[1]], &c = organ.positions[v[2]];
            if (!usable(a) || !usable(b) || !usable(c))
                ++counts.not_finite;
            else if (!has_area(a, b, c))
                ++counts.without_area;
            else if (!seen.add(weld.point[v[0]], weld.point[v[1]], weld.point[v[2]]))
                ++counts.repeated;
            else
                for (const std::uint32_t index : v) organ.indices[out++] = index;
        }
        part.first_index = first;
        part.index_count = out - first;
    }
    organ.indices.resize(out);
}

/// Moves the used vertices to the front and removes the rest.
void drop_vertices(Organ& organ, const Usable& usable, Counts& counts) {
    constexpr std::uint32_t unused = 0xffffffff;
    std::vector<std::uint32_t> target(organ.positions.size(), unused);
    for (const std::uint32_t index : organ.indices) target[index] = 0;
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < target.size(); ++i) {
        if (target[i] == unused) {
            ++(usable(organ.positions[i]) ? counts.unused : counts.not_finite_vertices);
            continue;
        }
        target[i] = out;
        organ.positions[out] = organ.positions[i];
        organ.normals[out] = organ.normals[i];
        organ.tangents[out] = organ.tangents[i];
        organ.uvs[out] = organ.uvs[i];
        organ.colors[out] = organ.colors[i];
        ++out;
    }
    for (std::uint32_t& index : organ.indices) index = target[index];
    organ.positions.resize(out);
    organ.normals.resize(out);
    organ.tangents.resize(out);
    organ.uvs.resize(out);
    organ.colors.resize(out);
}

/// The two sides of a torn seam get the same coordinates, so that everything later sees one place.
void close_seams(Organ& organ, double scale, Counts& counts) {
    const Weld weld = weld_surface(organ.positions, organ.indices);
    if (weld.sewn == 0) return;
    const std::vector<std::uint32_t> first = first_vertices(weld);
    for (std::size_t v = 0; v < organ.positions.size(); ++v) {
        const glm::vec3& place = organ.positions[first[weld.point[v]]];
        counts.sewn += organ.positions[v] != place;
        organ.positions[v] = place;
    }
    char gap[32];
    std::snprintf(gap, sizeof gap, "%.2g", weld.gap * scale);
    organ.warnings.push_back("gaps along seams closed: " + counted(counts.sewn, "vertex", "vertices") +
                             " moved by up to " + gap + " mm");
}

void drop_empty_parts(Organ& organ, Missing& missing) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < organ.parts.size(); ++i) {
        if (organ.parts[i].index_count == 0) continue;
        missing.uvs[out] = missing.uvs[i];
        organ.parts[out++] = organ.parts[i];
    }
    organ.parts.resize(out);
    missing.uvs.resize(out);
}

/// Every part gets a material, and every colour is a number.
void settle_materials(Organ& organ) {
    const bool bare = std::any_of(organ.parts.begin(), organ.parts.end(), [](const Part& p) { return p.material < 0; });
    if (bare || organ.materials.empty()) {
        for (Part& part : organ.parts)
            if (part.material < 0) part.material = static_cast<int>(organ.materials.size());
        organ.materials.push_back({});
        organ.materials.back().name = "default";
    }
    std::size_t wrong_colors = 0, wrong_uvs = 0;
    for (glm::vec4& color : organ.colors) {
        wrong_colors += !finite(color);
        color = finite(color) ? glm::clamp(color, 0.0f, 1.0f) : glm::vec4(1.0f);
    }
    for (glm::vec2& uv : organ.uvs)
        if (!finite(glm::vec4(uv, 0, 0)) || std::abs(uv.x) > 1e6f || std::abs(uv.y) > 1e6f) {
            ++wrong_uvs;
            uv = glm::vec2(0.0f);
        }
    if (wrong_colors > 0)
        organ.warnings.push_back(counted(wrong_colors, "vertex colour is", "vertex colours are") +
                                 " not a number; made white");
    if (wrong_uvs > 0)
        organ.warnings.push_back(counted(wrong_uvs, "texture coordinate is", "texture coordinates are") +
                                 " not a number; made 0");
}

void warn(Organ& organ, const Counts& counts) {
    const auto say = [&](std::size_t count, const char* one, const char* many, const std::string& rest) {
        if (count > 0) organ.warnings.push_back(counted(count, one, many) + rest);
    };
    say(counts.out_of_range, "triangle refers to", "triangles refer to",
        " vertices that are not in the file; left out");
    say(counts.not_finite_vertices, "vertex has", "vertices have",
        " coordinates that are missing, not finite or beyond 1e9 mm; left out with " +
            counted(counts.not_finite, "triangle", "triangles"));
    say(counts.without_area, "triangle", "triangles", " without area left out");
    say(counts.repeated, "triangle is", "triangles are", " in the file more than once; drawn once");
    say(counts.unused, "vertex belongs", "vertices belong", " to no triangle; left out");
}

/// The reason why most of the triangles were left out, if all were.
std::string reason(const TriangleCounts& counts) {
    const std::pair<std::size_t, const char*> reasons[] = {
        {counts.unreadable, " without 3 readable corners"},
        {counts.out_of_range, " with vertices that are not in the file"},
        {counts.not_finite, " whose coordinates are missing, not finite or beyond 1e9 mm"},
        {counts.without_area, " without area"}};
    const auto most = std::max_element(std::begin(reasons), std::end(reasons),
                                       [](const auto& a, const auto& b) { return a.first < b.first; });
    return counted(most->first, "triangle", "triangles") + most->second +
           (most->first < counts.read ? " of " + std::to_string(counts.read) : "");
}

}  // namespace

Organ mend(RawOrgan&& raw, const std::string& file, double scale, Missing& missing) {
    std::size_t vertices = 0;
    Counts counts;
    counts.unreadable = raw.unreadable;
    counts.without_area = raw.without_area;
    counts.read = raw.unreadable + raw.without_area;
    for (const RawPart& part : raw.parts) {
        vertices += part.positions.size();
        counts.read += part.indices.size() / 3;
    }
    if (counts.read == 0)
        refuse(file, "",
               vertices == 0 ? "no triangles: the file contains " + (raw.holds.empty() ? "no surface" : raw.holds)
                             : "no triangles: the file contains " + counted(vertices, "point", "points") + " only");
    if (counts.read > maximum_triangles || vertices > 3 * maximum_triangles)
        refuse(file, "", "has more than 20 million triangles");

    const Usable usable{largest_coordinate / scale};
    Organ organ = join(raw, missing, counts);
    organ.materials = std::move(raw.materials);
    organ.images = std::move(raw.images);
    organ.warnings = std::move(raw.warnings);
    drop_triangles(organ, usable, counts);
    drop_vertices(organ, usable, counts);
    drop_empty_parts(organ, missing);
    counts.kept = organ.triangle_count();
    if (counts.kept == 0) refuse(file, "", "no triangles that can be drawn: " + reason(counts));
    warn(organ, counts);
    close_seams(organ, scale, counts);
    settle_materials(organ);
    organ.counts = counts;
    return organ;
}

}  // namespace lapfx::organ
