// Bars that were put around a clip's picture. Pure; any thread.
//
// The outermost lines of a side are a bar where they are of one colour in all pictures and the picture begins all at
// once behind them: along the whole line, or, before a background of the bar's own colour, where smoke comes and goes.
// Smoke that ends by itself fades, and not along one line; a logo stands still.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lapfx/preset.h"

namespace lapfx::smoke {

class BarSurvey {
  public:
    /// As KeyingSurvey::add().
    void add(glm::ivec2 size, std::span<const std::uint8_t> rgb);
    /// What to leave out: bars of at most a quarter of a side each, and the line that is mixed with them.
    ClipCrop crop() const;

  private:
    static constexpr int stretches = 64;  ///< that a line is cut into
    struct Line {
        std::array<float, stretches> least{}, most{};  ///< mean distance of a stretch from the bar's colour, over time
    };
    struct Side {
        glm::vec3 colour{0.0f};   ///< of the outermost line of the first picture
        std::vector<Line> lines;  ///< from outside
    };
    template <class PixelAt>
    void look(Side& side, int lines, int length, const PixelAt& pixel_at);
    double width(const Side& side) const;

    glm::ivec2 size_{0};
    int pictures_ = 0;
    std::array<Side, 4> sides_;  ///< left, top, right, bottom
};

}  // namespace lapfx::smoke
