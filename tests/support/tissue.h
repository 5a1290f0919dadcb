// Flat organs with a painted texture or painted vertices, with known vessels and fat.
#pragma once

#include <functional>
#include <random>

#include "support/meshes.h"

namespace lapfx::test {

/// sRGB, 0..255, at a place of the plane, mm.
using Paint = std::function<glm::dvec3(double x, double z)>;

constexpr glm::dvec3 serosa{217, 150, 130}, artery{168, 28, 30}, fat_tissue{240, 176, 96};

inline Image painted(int width, int height, double side, const Paint& paint) {
    Image image{.width = width, .height = height, .pixels = {}, .name = "painted"};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 color =
                glm::clamp(paint(((x + 0.5) / width - 0.5) * side, ((y + 0.5) / height - 0.5) * side), 0.0, 255.0);
            for (int c = 0; c < 3; ++c) image.pixels.push_back(static_cast<std::uint8_t>(std::lround(color[c])));
            image.pixels.push_back(255);
        }
    return image;
}

/// plane() with a texture over it: u runs along x, v along z.
inline Organ textured_plane(double side, Image image, std::uint32_t n = 4) {
    Organ organ = plane(side, n);
    for (std::size_t i = 0; i < organ.positions.size(); ++i)
        organ.uvs[i] = {organ.positions[i].x / side + 0.5, organ.positions[i].z / side + 0.5};
    organ.images = {std::move(image)};
    organ.materials[0].base_color = glm::vec4(1.0f);
    organ.materials[0].base_color_image = 0;
    organ.has_uvs = true;
    return organ;
}

inline float linear(double code) {
    const double s = code / 255.0;
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

/// plane() with colours at its vertices.
inline Organ painted_plane(double side, std::uint32_t n, const Paint& paint, Cut cut = Cut::regular) {
    Organ organ = plane(side, n, cut);
    for (std::size_t i = 0; i < organ.positions.size(); ++i) {
        const glm::dvec3 color = paint(organ.positions[i].x, organ.positions[i].z);
        organ.colors[i] = {linear(color.x), linear(color.y), linear(color.z), 1.0f};
    }
    organ.materials[0].base_color = glm::vec4(1.0f);
    organ.has_colors = true;
    return organ;
}

/// Fat where x > 0, serosa elsewhere.
inline glm::dvec3 half_fat(double x, double) {
    return x > 0.0 ? fat_tissue : serosa;
}

/// The share of a Gaussian of deviation `sigma` below x.
inline double below(double x, double sigma) {
    return 0.5 * (1.0 + std::erf(x / (sigma * std::sqrt(2.0))));
}

}  // namespace lapfx::test
