#include "match/compare/region.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr int most_samples = 65536;
constexpr int cells_across = 40;  // of the picture's shorter side: what is near by for the dark channel

const std::array<float, 256>& linear_table() {
    static const auto table = [] {
        std::array<float, 256> all{};
        for (int i = 0; i < 256; ++i) all[static_cast<std::size_t>(i)] = linear_of(static_cast<float>(i));
        return all;
    }();
    return table;
}

struct Sums {
    glm::dvec3 light{0.0};
    double luma = 0.0, luma_squared = 0.0, darkest = 0.0, red = 0.0;
    int pixels = 0, cells = 0;
};

struct Box {
    int x0, y0, x1, y1;  // px; the last ones are outside
};

Box box_of(const Image& image, const ComparedRegion& region) {
    const auto px = [](double share, int length) {
        return std::clamp(static_cast<int>(std::lround(share * length)), 0, length);
    };
    Box box{px(region.x, image.width), px(region.y, image.height), px(region.x + region.width, image.width),
            px(region.y + region.height, image.height)};
    box.x0 = std::min(box.x0, image.width - 1), box.y0 = std::min(box.y0, image.height - 1);
    box.x1 = std::max(box.x1, box.x0 + 1), box.y1 = std::max(box.y1, box.y0 + 1);
    return box;
}

/// One cell of the dark channel.
void add(const Image& image, const Box& cell, int every, const BloodQualifier& blood, Sums& sums) {
    const std::array<float, 256>& linear = linear_table();
    int darkest = 255;
    for (int y = cell.y0; y < cell.y1; y += every)
        for (int x = cell.x0; x < cell.x1; x += every) {
            const std::uint8_t* p =
                image.pixels.data() +
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
            const double luma = (0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]) / 255.0;
            const double redness = redness_of_code<double>(p[0], p[1], p[2]);
            sums.light += glm::dvec3(linear[p[0]], linear[p[1]], linear[p[2]]);
            sums.luma += luma, sums.luma_squared += luma * luma;
            sums.red += redness >= blood.redness && p[0] <= 255.0 * blood.brightness ? 1.0 : 0.0;
            darkest = std::min({darkest, static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2])});
            ++sums.pixels;
        }
    sums.darkest += darkest / 255.0, ++sums.cells;
}

/// CIE L*a*b* under D65 of an sRGB colour.
glm::dvec3 lab_of(const glm::dvec3& srgb) {
    glm::dvec3 rgb;
    for (int c = 0; c < 3; ++c) rgb[c] = static_cast<double>(linear_of(static_cast<float>(255.0 * srgb[c])));
    const glm::dvec3 xyz(0.4124564 * rgb.r + 0.3575761 * rgb.g + 0.1804375 * rgb.b,
                         0.2126729 * rgb.r + 0.7151522 * rgb.g + 0.0721750 * rgb.b,
                         0.0193339 * rgb.r + 0.1191920 * rgb.g + 0.9503041 * rgb.b);
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const double x = f(xyz.x / 0.95047), y = f(xyz.y), z = f(xyz.z / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

}  // namespace

RegionFigures figures_of(const Image& image, const ComparedRegion& region, const BloodQualifier& blood) {
    if (image.width < 1 || image.height < 1 || image.pixels.empty()) return {};
    const Box box = box_of(image, region);
    const double area = static_cast<double>(box.x1 - box.x0) * (box.y1 - box.y0);
    const int every = std::max(1, static_cast<int>(std::sqrt(area / most_samples)));
    const int side = std::max(every, std::min(image.width, image.height) / cells_across);
    Sums sums;
    for (int y = box.y0; y < box.y1; y += side)
        for (int x = box.x0; x < box.x1; x += side)
            add(image, {x, y, std::min(x + side, box.x1), std::min(y + side, box.y1)}, every, blood, sums);
    const double n = sums.pixels, mean = sums.luma / n;
    RegionFigures found{.contrast = std::sqrt(std::max(0.0, sums.luma_squared / n - mean * mean)),
                        .veil = sums.darkest / sums.cells,
                        .red = sums.red / n};
    for (int c = 0; c < 3; ++c)
        found.color[c] = static_cast<double>(code_of(static_cast<float>(sums.light[c] / n))) / 255.0;
    return found;
}

double distance(const RegionFigures& a, const RegionFigures& b) {
    return glm::distance(lab_of(a.color), lab_of(b.color));
}

}  // namespace lapfx::match
