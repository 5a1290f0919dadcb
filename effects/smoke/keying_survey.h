// Keying thresholds out of pictures of a clip. Pure; any thread.
//
// 1. The background is where the colours of small blocks crowd, those at the border counting more: smoke moves and is
// soft,
//    a plain background is one colour in many places for a long time.
// 2. How far its pixels stray (sensor, encoder) is measured in blocks that stay background all the time; the lower
// threshold
//    lies where 99 % of them end, and the upper one comes down by as much: half smoke stays half.
// 3. A coloured background is keyed by chroma alone. Smoke is near to grey, so whole smoke lies as far from the key as
// grey
//    does: |key|, whatever its light. That needs no guess.
// 4. Black, grey and white are keyed by luma. How bright whole smoke is shows only where there is some: then lumas
// crowd at
//    their upper end. Luma is opacity times brightness: that end is whole smoke which is dim, or thin smoke which is
//    bright, and nothing in the clip tells which. No smoke is brighter than white, so its opacity is at least that of
//    white smoke; the middle between that and 1 is taken, and the bounds are told. Thin smoke does not pile up; then
//    `assumed_white` (or, for dark smoke, `assumed_black`) is taken, or what is brighter.
// 5. What stands still and is not background (a mark of the maker) is left out of all this, and told; so are bars
// beside the
//    picture (bars.h). A mark with background around it gets a mask.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/authoring/suggest.h"
#include "smoke/bars.h"

namespace lapfx::smoke {

/// Luma of whole smoke where none is seen. Of four clips of real smoke on black the brightest is 224, 226, 237 and 255
/// (with an opacity of 1 where that is known): exposure is set for smoke to come just short of white.
constexpr double assumed_white = 232.0;
/// The same of soot before something bright: black of a camera under light is not 0.
constexpr double assumed_black = 32.0;

/// Takes pictures of one clip in and suggests. Keeps small samples only: 1 MB a picture at most.
class KeyingSurvey {
  public:
    /// A picture of `size` pixels, all of one clip the same, R'G'B' code values, rows tightly packed.
    void add(glm::ivec2 size, std::span<const std::uint8_t> rgb);

    /// Without a picture: defaults and no confidence.
    KeyingSuggestion suggest() const;

  private:
    glm::ivec2 size_{0};
    BarSurvey bars_;
    std::vector<glm::ivec2> corners_;                 ///< of the blocks that are looked at, pixels
    int edge_ = 0;                                    ///< pixels
    std::vector<std::vector<glm::u8vec3>> pictures_;  ///< pixels of the blocks, block after block
};

}  // namespace lapfx::smoke
