// Finds keying thresholds from pictures of a clip. Pure; any thread.
//
// 1. The background is the colour that most small blocks have, where blocks at the border count more: smoke moves and
//    is soft, while a plain background has one colour in many places for a long time.
// 2. The spread of its pixels (sensor, encoder) is measured in blocks that are always background. The lower threshold
//    includes 99 % of them, and the upper one is lowered by the same amount, so that half smoke stays half.
// 3. A coloured background is keyed by chroma alone. Smoke is almost grey, so full smoke is as far from the key as grey
//    is: |key|, whatever its light. That is not a guess.
// 4. Black, grey and white are keyed by luma. The brightness of full smoke shows only if there is some: many pixels
//    then have the highest lumas. Luma is opacity times brightness, so these may be full smoke which is dim, or thin
//    smoke which is bright, and nothing in the clip says which. No smoke is brighter than white, so its opacity is at
//    least that of white smoke; the middle between that and 1 is used, and the bounds are reported. Thin smoke has no
//    such maximum; then `assumed_white` (or, for dark smoke, `assumed_black`) is used, or the highest luma if that is
//    brighter.
// 5. Things that stand still and are not background (a logo) are left out and reported; so are bars at the sides
//    (bars.h). A logo with background around it gets a mask.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/authoring/suggest.h"
#include "smoke/bars.h"
#include "smoke/suggest_study.h"

namespace lapfx::smoke {

/// Luma of full smoke where none is visible. In four clips of real smoke on black the brightest luma is 224, 226, 237
/// and 255 (with an opacity of 1 where that is known): the exposure makes smoke almost white.
constexpr double assumed_white = 232.0;
/// The same for soot before something bright: a camera does not show black under light as 0.
constexpr double assumed_black = 32.0;

/// What is in the pictures of a video, as far as it tells smoke from a surgery. Shares are 0..1.
struct ClipLook {
    bool plain = false;       ///< there is a plain background
    bool coloured = false;    ///< it has a colour to key by
    bool ends = false;        ///< it is coloured, black or white: smoke is filmed before these
    double background = 0.0;  ///< share of the picture over time
    double border = 0.0;      ///< the same of the picture's border
    double filled = 0.0;      ///< of what is not always background, what never is
    double odd_colour = 0.0;  ///< of what is not background, what has colours that smoke does not have
    double hard_edges = 0.0;  ///< of neighbouring pixels there, those that differ more than in smoke
    double colour = 0.0;      ///< its mean distance from grey, code values
    double tissue = 0.0;      ///< its share with the colours of tissue and blood: red over green and blue
};

/// Takes pictures of one clip and suggests thresholds. It keeps only small samples, at most 1 MB per picture.
class KeyingSurvey {
  public:
    /// A picture of `size` pixels, the same for all of a clip, R'G'B' code values, rows tightly packed.
    void add(glm::ivec2 size, std::span<const std::uint8_t> rgb);

    bool empty() const { return pictures_.empty(); }  ///< no picture
    /// Without pictures it suggests the defaults, with confidence 0.
    KeyingSuggestion suggest() const;
    /// What the pictures are of, smoke before a plain background or something else. Without pictures: all is 0.
    ClipLook look() const;

  private:
    struct Looked {
        Study study;
        std::vector<std::vector<glm::u8vec3>> pictures;  ///< pixels of the study's blocks
        ClipCrop crop{};
    };
    Looked study() const;

    glm::ivec2 size_{0};
    BarSurvey bars_;
    std::vector<glm::ivec2> corners_;                 ///< the blocks that are looked at start there, pixels
    int edge_ = 0;                                    ///< pixels
    std::vector<std::vector<glm::u8vec3>> pictures_;  ///< pixels of the blocks, block after block
};

/// What a video without opacity of its own is for. `look` is of at least one picture.
UseSuggestion use_of(const ClipLook& look);

}  // namespace lapfx::smoke
