#include "organ/raw.h"

namespace lapfx::organ {

namespace {

glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 1e-30 ? glm::vec3(v / length) : glm::vec3(0.0f);
}

template <class Mesh>
void move(Mesh& mesh, const AffineMap& map) {
    for (glm::vec3& p : mesh.positions) p = map.point(p);
    for (glm::vec3& n : mesh.normals) n = map.normal(n);
    for (glm::vec4& t : mesh.tangents) t = map.tangent(t);
}

}  // namespace

AffineMap::AffineMap(const glm::dmat4& matrix)
    : matrix_(matrix),
      linear_(matrix),
      // The inverse transpose times the determinant. They exist for a flattening matrix too.
      cofactors_(glm::cross(linear_[1], linear_[2]), glm::cross(linear_[2], linear_[0]),
                 glm::cross(linear_[0], linear_[1])),
      side_(glm::determinant(linear_) < 0.0 ? -1.0 : 1.0) {}

glm::vec3 AffineMap::normal(const glm::vec3& n) const {
    return unit_or_zero(side_ * (cofactors_ * glm::dvec3(n)));
}

glm::vec4 AffineMap::tangent(const glm::vec4& t) const {
    return {unit_or_zero(linear_ * glm::dvec3(t)), t.w * static_cast<float>(side_)};
}

void transform(RawPart& part, const glm::dmat4& matrix) {
    const AffineMap map(matrix);
    move(part, map);
    if (map.mirrors())
        for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3)
            std::swap(part.indices[i + 1], part.indices[i + 2]);
}

void transform(Organ& organ, const glm::dmat4& matrix) {
    move(organ, AffineMap(matrix));
}

int copy_image(RawOrgan& organ, int image) {
    if (image < 0) return -1;
    const auto i = static_cast<std::size_t>(image);
    organ.images.push_back(Image(organ.images[i]));
    organ.encoded.push_back(Encoded(organ.encoded[i]));
    return static_cast<int>(organ.images.size()) - 1;
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace lapfx::organ
