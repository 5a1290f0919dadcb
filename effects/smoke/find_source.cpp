#include "smoke/find_source.h"

#include <algorithm>
#include <cmath>

namespace lapfx::smoke {

namespace {

constexpr float smoke = 0.06f;       // opacity from which a cell has smoke
constexpr double nothing = 0.02;     // share of the most smoke in a picture below which the clip is empty
constexpr double begun = 0.04;       // share above which there is smoke
constexpr float persistent = 0.75f;  // share of the pictures in which the most persistent cell has smoke
constexpr double stray = 0.02;       // share of the persistent cells that are ignored at the far end
constexpr double root = 1.0;         // cells: how long the root is
constexpr int farthest = 4;          // cells that pictures are shifted by

double amount(const OpacityGrid& picture) {
    double sum = 0.0;
    for (const float cell : picture.cells) sum += static_cast<double>(cell);
    return sum;
}

/// Weighted by opacity, fractions of the frame.
glm::dvec2 middle_of(const OpacityGrid& picture) {
    glm::dvec2 sum(0.0);
    double weight = 0.0;
    for (int y = 0; y < picture.size.y; ++y)
        for (int x = 0; x < picture.size.x; ++x) {
            const auto opacity = static_cast<double>(picture.at({x, y}));
            if (opacity < static_cast<double>(smoke)) continue;
            sum += opacity * (glm::dvec2(x, y) + 0.5), weight += opacity;
        }
    return weight > 0.0 ? sum / weight / glm::dvec2(picture.size) : glm::dvec2(0.5);
}

/// Mean squared difference between a picture and a later one moved back by `shift`.
double unlikeness(const OpacityGrid& a, const OpacityGrid& b, glm::ivec2 shift) {
    double sum = 0.0;
    for (int y = farthest; y < a.size.y - farthest; ++y)
        for (int x = farthest; x < a.size.x - farthest; ++x) {
            const float apart = a.at({x, y}) - b.at(glm::ivec2(x, y) + shift);
            sum += static_cast<double>(apart * apart);
        }
    return sum;
}

glm::dvec2 way_of(std::span<const OpacityGrid> pictures, std::span<const OpacityGrid> later) {
    constexpr glm::dvec2 up(0.0, -1.0);
    if (pictures.empty() || glm::any(glm::lessThanEqual(pictures[0].size, glm::ivec2(2 * farthest)))) return up;
    glm::ivec2 best(0);
    double least = -1.0;
    for (int y = -farthest; y <= farthest; ++y)
        for (int x = -farthest; x <= farthest; ++x) {
            double sum = 0.0;
            for (std::size_t i = 0; i < std::min(pictures.size(), later.size()); ++i)
                sum += unlikeness(pictures[i], later[i], {x, y});
            if (least < 0.0 || sum < least) least = sum, best = {x, y};
        }
    return best == glm::ivec2(0) ? up : glm::normalize(glm::dvec2(best));
}

/// In how many pictures a cell has smoke, 0..1.
OpacityGrid persistence(std::span<const OpacityGrid> pictures) {
    OpacityGrid share{pictures[0].size, std::vector<float>(pictures[0].cells.size())};
    for (const OpacityGrid& picture : pictures)
        for (std::size_t i = 0; i < share.cells.size(); ++i)
            if (picture.cells[i] > smoke) share.cells[i] += 1.0f / static_cast<float>(pictures.size());
    return share;
}

glm::dvec2 root_of(std::span<const OpacityGrid> pictures, glm::dvec2 way) {
    const OpacityGrid share = persistence(pictures);
    const float most = *std::max_element(share.cells.begin(), share.cells.end());
    struct Cell {
        double along;
        glm::dvec2 place;
    };
    std::vector<Cell> cells;
    for (int y = 0; y < share.size.y; ++y)
        for (int x = 0; x < share.size.x; ++x)
            if (share.at({x, y}) >= persistent * most) {
                const glm::dvec2 place = glm::dvec2(x, y) + 0.5;
                cells.push_back({glm::dot(place, way), place});
            }
    std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.along < b.along; });
    const double back = cells[static_cast<std::size_t>(stray * static_cast<double>(cells.size()))].along;
    glm::dvec2 sum(0.0);
    std::size_t count = 0;
    for (; count < cells.size() && cells[count].along <= back + root; ++count) sum += cells[count].place;
    return sum / static_cast<double>(count) / glm::dvec2(share.size);
}

}  // namespace

FoundSource find_source(std::span<const OpacityGrid> pictures, std::span<const OpacityGrid> later,
                        std::span<const OpacityGrid> first) {
    FoundSource source;
    double most = 0.0;
    for (const OpacityGrid& picture : pictures) most = std::max(most, amount(picture));
    if (most <= 1.0) return source;  // less than one cell of full smoke
    source.found = true;
    source.way = way_of(pictures, later);
    if (!first.empty() && amount(first[0]) < nothing * most)
        for (const OpacityGrid& picture : first)
            if (amount(picture) >= begun * most) {
                source.begins = true;
                source.place = middle_of(picture);
                return source;
            }
    source.place = root_of(pictures, source.way);
    return source;
}

}  // namespace lapfx::smoke
