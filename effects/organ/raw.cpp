#include "organ/raw.h"

namespace lapfx::organ {

namespace {

glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 1e-30 ? glm::vec3(v / length) : glm::vec3(0.0f);
}

/// Whether it mirrors.
template <class Mesh>
bool move(Mesh& mesh, const glm::dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    const double determinant = glm::determinant(linear);
    // Cofactors: the inverse transpose times the determinant. They exist for a flattening matrix too.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const double side = determinant < 0.0 ? -1.0 : 1.0;
    for (glm::vec3& p : mesh.positions) p = glm::vec3(glm::dvec3(matrix * glm::dvec4(p, 1.0)));
    for (glm::vec3& n : mesh.normals) n = unit_or_zero(side * (cofactors * glm::dvec3(n)));
    for (glm::vec4& t : mesh.tangents) {
        const glm::vec3 direction = unit_or_zero(linear * glm::dvec3(t));
        t = glm::vec4(direction, t.w * static_cast<float>(side));
    }
    return determinant < 0.0;
}

}  // namespace

void transform(RawPart& part, const glm::dmat4& matrix) {
    if (move(part, matrix))
        for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3)
            std::swap(part.indices[i + 1], part.indices[i + 2]);
}

void transform(Organ& organ, const glm::dmat4& matrix) {
    move(organ, matrix);
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace lapfx::organ
