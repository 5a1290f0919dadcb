// Where the smoke of a clip starts, out of its opacity over time. Pure; any thread.
//
// 1. A clip that begins without smoke shows it: where the first smoke is.
// 2. Else smoke stays at its source and moves away from it. The places that nearly always have smoke are taken, and of
// them those
//    that lie farthest against the way that it moves: the root of the plume. The way is the shift under which pictures
//    that follow each other are most alike; smoke that hardly moves as a whole is taken to rise.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lapfx::smoke {

/// Opacity 0..1 of one picture in cells, rows from the top; all of one clip the same size.
struct OpacityGrid {
    glm::ivec2 size{0};
    std::vector<float> cells;

    float at(glm::ivec2 cell) const { return cells[static_cast<std::size_t>(cell.y * size.x + cell.x)]; }
};

struct FoundSource {
    glm::dvec2 place{0.5, 0.92};  ///< fractions of the frame from its upper left corner
    bool found = false;           ///< there is smoke at all
    bool begins = false;          ///< the clip shows how it begins
    glm::dvec2 way{0.0, -1.0};    ///< unit, where it moves to
};

/// `pictures`: over the whole clip. `later`: a moment after each, for the way; parallel. `first`: of the clip's
/// beginning, close to each other; may be empty.
FoundSource find_source(std::span<const OpacityGrid> pictures, std::span<const OpacityGrid> later,
                        std::span<const OpacityGrid> first);

}  // namespace lapfx::smoke
