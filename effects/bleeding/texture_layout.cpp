#include "bleeding/texture_layout.h"

#include <opencv2/imgproc.hpp>

namespace lapfx::bleeding {

namespace {

struct Corners {
    glm::dvec3 at[3];  // mm
    glm::dvec2 uv[3];
};

/// Calls `visit` for each triangle that shows the image and whose coordinates can be used.
template <class Visit>
void for_each_triangle(const Organ& organ, int image, const Visit& visit) {
    for (const Part& part : organ.parts) {
        if (organ.materials[static_cast<std::size_t>(part.material)].base_color_image != image) continue;
        for (std::size_t i = part.first_index; i + 2 < std::size_t(part.first_index) + part.index_count; i += 3) {
            Corners corners;
            bool usable = true;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t vertex = organ.indices[i + c];
                corners.at[c] = glm::dvec3(organ.positions[vertex]);
                corners.uv[c] = glm::dvec2(organ.uvs[vertex]);
                usable = usable && std::abs(corners.uv[c].x) < 1e6 && std::abs(corners.uv[c].y) < 1e6;
            }
            if (usable) visit(corners);
        }
    }
}

/// Lengths of the gradients of u and v over the triangle, per mm, and its area, mm2; area 0 means that there are none.
glm::dvec3 stretch(const Corners& t) {
    const glm::dvec3 a = t.at[1] - t.at[0], b = t.at[2] - t.at[0];
    const double aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b), square = aa * bb - ab * ab;
    if (!(square > 1e-12 * aa * bb)) return glm::dvec3(0.0);
    const auto length = [&](double along_a, double along_b) {  // gradient with these differences along a and b
        return std::sqrt(std::max(0.0, along_a * along_a * bb - 2 * along_a * along_b * ab + along_b * along_b * aa) /
                         square);
    };
    const glm::dvec2 da = t.uv[1] - t.uv[0], db = t.uv[2] - t.uv[0];
    return {length(da.x, db.x), length(da.y, db.y), 0.5 * std::sqrt(square)};
}

/// The triangle's texels, and those next to it, since filtering reaches them.
void fill(const Corners& triangle, cv::Mat& used) {
    constexpr int shift = 4;
    cv::Point points[3];
    for (std::size_t c = 0; c < 3; ++c) {
        points[c].x = static_cast<int>(std::lround((triangle.uv[c].x * used.cols - 0.5) * (1 << shift)));
        points[c].y = static_cast<int>(std::lround((triangle.uv[c].y * used.rows - 0.5) * (1 << shift)));
    }
    cv::fillConvexPoly(used, points, 3, cv::Scalar(255), cv::LINE_8, shift);
}

}  // namespace

TextureLayout layout_of(const Organ& organ, int image) {
    const Image& pixels = organ.images[static_cast<std::size_t>(image)];
    TextureLayout layout;
    layout.beyond = {.any = false, .u = pixels.wrap_u, .v = pixels.wrap_v};
    glm::dvec2 sum(0.0);
    double area = 0.0;
    for_each_triangle(organ, image, [&](const Corners& triangle) {
        const glm::dvec3 found = stretch(triangle);
        sum += glm::dvec2(found) * found.z;
        area += found.z;
        // A little past the edge is how some exporters write 1; it does not leave the texture.
        for (const glm::dvec2& uv : triangle.uv)
            if (uv.x < -0.01 || uv.y < -0.01 || uv.x > 1.01 || uv.y > 1.01) layout.beyond.any = true;
    });
    const glm::dvec2 found = sum / area * glm::dvec2(pixels.width, pixels.height);
    if (area > 0.0 && std::isfinite(found.x + found.y)) layout.texels_per_mm = found;
    layout.used.assign(static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height),
                       layout.beyond.any ? std::uint8_t{255} : std::uint8_t{0});
    if (layout.beyond.any) return layout;
    cv::Mat used(pixels.height, pixels.width, CV_8U, layout.used.data());
    for_each_triangle(organ, image, [&](const Corners& triangle) { fill(triangle, used); });
    return layout;
}

}  // namespace lapfx::bleeding
