// Bars that were put around a clip's picture. Pure; any thread.
//
// The outermost lines of a side are a bar if they have one colour in all pictures and the picture begins suddenly
// behind them: along the whole line, or, if the background has the colour of the bar, where smoke comes and goes along
// half of it. Smoke that ends without a bar fades, and does not end along one line; smoke that begins at a source above
// a clean strip is narrow there; a logo stands still.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lapfx/smoke_parameters.h"

namespace lapfx::smoke {

class BarSurvey {
  public:
    /// The picture is one that KeyingSurvey::add() takes.
    void add(glm::ivec2 size, std::span<const std::uint8_t> rgb);
    /// The crop that removes the bars, each at most a quarter of a side, and the line that is mixed with them.
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
