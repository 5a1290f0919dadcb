#include "organ/soup.h"

#include "lapfx/authoring/srgb.h"
#include "organ/polygon.h"

namespace lapfx::organ {

namespace {

constexpr std::uint32_t none = 0xffffffff;

/// Copies the vertices of one part, once for each position, texture coordinate and colour of a face.
class PartBuilder {
  public:
    PartBuilder(const Soup& soup, RawPart& part, std::vector<std::uint32_t>& first_copy)
        : soup_(soup), part_(part), first_copy_(first_copy) {}

    /// The part's vertex for a corner of the soup, in a face of that colour.
    std::uint32_t vertex(std::size_t corner, const glm::vec4& color) {
        const std::uint32_t position = soup_.corners[corner];
        if (position >= soup_.positions.size()) return none;
        glm::vec2 uv(0.0f);
        if (!soup_.corner_uvs.empty()) {
            uv = soup_.corner_uvs[corner];
            if (std::isnan(uv.x))
                uv = glm::vec2(0.0f);
            else
                any_uv_ = true;
        } else if (!soup_.uvs.empty()) {
            uv = soup_.uvs[position];
            any_uv_ = true;
        }
        const glm::vec2 flipped(uv.x, 1.0f - uv.y);
        std::uint32_t copy = first_copy_[position];
        const auto differs = [&] {
            return part_.uvs[copy] != flipped || (colors_faces() && part_.colors[copy] != color);
        };
        while (copy != none && differs()) copy = next_copy_[copy];
        return copy != none ? copy : add(position, flipped, color);
    }

    std::uint32_t add(std::uint32_t position, glm::vec2 uv, const glm::vec4& color = glm::vec4(1.0f)) {
        const auto copy = static_cast<std::uint32_t>(part_.positions.size());
        part_.positions.push_back(soup_.positions[position]);
        part_.uvs.push_back(uv);
        if (!soup_.normals.empty()) part_.normals.push_back(soup_.normals[position]);
        if (!soup_.colors.empty()) part_.colors.push_back(soup_.colors[position]);
        if (colors_faces()) part_.colors.push_back(color);
        next_copy_.push_back(first_copy_[position]);
        sources_.push_back(position);
        first_copy_[position] = copy;
        return copy;
    }

    void add_face(std::size_t face) {
        const std::size_t begin = soup_.first[face], end = soup_.first[face + 1];
        ring_.clear();
        vertices_.clear();
        bool whole = true;
        const glm::vec4 color = colors_faces() ? soup_.face_colors[face] : glm::vec4(1.0f);
        for (std::size_t corner = begin; corner < end; ++corner) {
            const std::uint32_t v = vertex(corner, color);
            whole &= v != none;
            vertices_.push_back(v);
            ring_.push_back(v == none ? glm::vec3(0.0f) : part_.positions[v]);
        }
        local_.clear();
        if (!triangulate(ring_, local_) && whole) ++crossing_;
        // Adds as many triangles as it would have had; mend() counts them as out of range.
        for (const std::uint32_t i : local_) part_.indices.push_back(whole ? vertices_[i] : none);
    }

    std::size_t crossing() const { return crossing_; }  ///< faces that cross themselves

    /// Restores first_copy: clearing all of it for each of many small parts would take too long.
    void finish() {
        for (const std::uint32_t position : sources_) first_copy_[position] = none;
        if (!any_uv_) part_.uvs.clear();
    }

  private:
    bool colors_faces() const { return soup_.colors.empty() && !soup_.face_colors.empty(); }

    const Soup& soup_;
    RawPart& part_;
    std::vector<std::uint32_t>& first_copy_;  ///< soup position to part vertex
    std::vector<std::uint32_t> next_copy_;    ///< part vertex to the next one at the same position
    std::vector<std::uint32_t> sources_;      ///< soup position of each part vertex
    std::vector<glm::vec3> ring_;
    std::vector<std::uint32_t> vertices_, local_;
    std::size_t crossing_ = 0;
    bool any_uv_ = false;
};

}  // namespace

glm::vec4 linear_color(const glm::vec4& srgb) {
    glm::vec4 out = srgb;
    for (int c = 0; c < 3; ++c) out[c] = linear_of_srgb(srgb[c]);
    return out;
}

void add_parts(const Soup& soup, std::vector<RawPart> parts, RawOrgan& organ) {
    if (parts.empty()) parts.emplace_back();
    std::vector<std::vector<std::uint32_t>> faces_of(parts.size());
    for (std::size_t face = 0; face < soup.faces(); ++face)
        faces_of[soup.face_part.empty() ? 0 : soup.face_part[face]].push_back(static_cast<std::uint32_t>(face));
    std::vector<char> used(soup.positions.size(), 0);
    for (const std::uint32_t corner : soup.corners)
        if (corner < used.size()) used[corner] = 1;
    std::vector<std::uint32_t> first_copy(soup.positions.size(), none);
    std::size_t crossing = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        PartBuilder builder(soup, parts[p], first_copy);
        for (const std::uint32_t face : faces_of[p]) builder.add_face(face);
        if (p == 0)
            for (std::uint32_t v = 0; v < used.size(); ++v)
                if (!used[v]) builder.add(v, glm::vec2(0.0f));
        builder.finish();
        crossing += builder.crossing();
        organ.parts.push_back(std::move(parts[p]));
    }
    organ.unreadable += soup.unreadable_triangles;
    if (soup.unreadable_faces > 0)
        organ.warnings.push_back(counted(soup.unreadable_faces, "face", "faces") +
                                 " without 3 readable corners left out");
    if (crossing > 0)
        organ.warnings.push_back(counted(crossing, "polygon crosses itself", "polygons cross themselves") + ", or " +
                                 (crossing == 1 ? "has" : "have") +
                                 " more than 1024 corners: their triangles may overlap");
}

}  // namespace lapfx::organ
