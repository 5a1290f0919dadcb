// Divides pictures of a clip into background, what changes, and what stands still, in small blocks. Pure; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lapfx/smoke_parameters.h"
#include "smoke/keying.h"

namespace lapfx::smoke {

inline constexpr float least_chroma =
    24.0f;  // distance from grey, in code values, from which a background is keyed by chroma

/// Distance as keying sees it, luma and chroma separately.
inline float difference(glm::vec3 a, glm::vec3 b) {
    return std::max(std::abs(luma(a) - luma(b)), glm::distance(chroma(a), chroma(b)));
}

/// One block in one picture.
struct Block {
    glm::vec3 mean{0.0f};  ///< R'G'B'
    float weight = 1.0f;
    bool background = false;
};

enum class BlockKind { changing, quiet, mark };

/// The data of the survey, step by step.
struct Study {
    std::size_t blocks = 0;           ///< a picture
    int edge = 0;                     ///< a block's side, pixels
    glm::ivec2 size{0};               ///< of the frame
    glm::ivec2 low{0}, high{0};       ///< of it, what the crop leaves
    glm::ivec2 pitch{0};              ///< from block to block
    std::vector<glm::ivec2> corners;  ///< upper left, of the blocks
    std::size_t pixels = 0;           ///< a block
    std::vector<Block> all;           ///< picture after picture
    std::vector<BlockKind> kinds;     ///< a block's, over time
    glm::vec3 background{0.0f};
    bool plain = true;           ///< one was found; otherwise black is assumed
    double share = 0.0;          ///< that is background
    double concentration = 0.0;  ///< share of the blocks similar to the background that are almost equal to it
    double marks = 0.0;          ///< share of the picture

    std::size_t pictures() const { return blocks > 0 ? all.size() / blocks : 0; }
    const Block& at(std::size_t picture, std::size_t block) const { return all[picture * blocks + block]; }
};

/// Finds the blocks of the background, and its colour: not the most frequent colour, but the most likely of the
/// frequent ones, because smoke may fill almost all of a clip. Without a plain background it is black.
void find_background(Study& study);
/// What each block shows over time.
void find_kinds(Study& study);
/// Rectangles around logos in front of the background, as fractions of the frame; the largest first.
std::vector<ClipMask> masks_of(const Study& study);

}  // namespace lapfx::smoke
