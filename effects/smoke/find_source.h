// Finds where the smoke of a clip starts, from its opacity over time. Pure; any thread.
//
// 1. In a clip that begins without smoke it is where the first smoke is.
// 2. Otherwise smoke stays at its source and moves away from it. Among the places that nearly always have smoke, those
//    farthest against its direction of movement are the root of the plume. The direction is the shift under which
//    consecutive pictures are most alike; smoke that hardly moves as a whole is assumed to rise.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lapfx::smoke {

/// Opacity 0..1 of one picture in cells, rows from the top; all pictures of a clip have the same size.
struct OpacityGrid {
    glm::ivec2 size{0};
    std::vector<float> cells;

    float at(glm::ivec2 cell) const { return cells[static_cast<std::size_t>(cell.y * size.x + cell.x)]; }
};

struct FoundSource {
    glm::dvec2 place{0.5, 0.92};  ///< fractions of the frame from its upper left corner
    bool found = false;           ///< smoke was found
    bool begins = false;          ///< the clip shows how it begins
    glm::dvec2 way{0.0, -1.0};    ///< unit, where it moves to
};

/// `pictures` are from the whole clip. `later` has for each a picture shortly after it, for the direction. `first` has
/// pictures from the beginning of the clip, close to each other; it may be empty.
FoundSource find_source(std::span<const OpacityGrid> pictures, std::span<const OpacityGrid> later,
                        std::span<const OpacityGrid> first);

}  // namespace lapfx::smoke
