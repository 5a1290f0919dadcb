// Which of two recordings of the same view shows more smoke: real frames with and without smoke, or a video and what a
// program that removes smoke made of it. Nobody knows their true amounts, but everybody sees the order.
//
//     for (const bench::RankedPair& pair : bench::rank_pairs("smoky", "clear")) count += pair.right();
//
// Any thread; no OpenGL.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lapfx/progress.h"

namespace lapfx::bench {

struct RankedPair {
    std::string smoky, clear;                ///< names of the files
    int frames = 0;                          ///< that were compared; at least one
    int missing = 0;                         ///< that one of the files could not give: not compared
    int not_measurable = 0;                  ///< one is black, or neither shows the other's view: not compared
    int smoky_frames = 0, clear_frames = 0;  ///< of the whole files; only as many as both have are looked at
    /// Mean over the frames that were compared, each measured with the other as its baseline, veil density 0..1.
    double of_smoky = 0.0, of_clear = 0.0;
    bool right() const { return of_smoky > of_clear; }
    /// What a reader of the figures should know: files of other lengths, frames that were not compared. One line each.
    std::vector<std::string> notes() const;
};

/// Pictures and videos of two folders, paired in the order of their names, the numbers in them counted as numbers.
/// Every `every`-th frame of a video is measured, against the same frame of its partner. Throws Error: bad_input for a
/// folder that cannot be read, has no such file, or not as many as the other, a file whose pictures have another shape
/// than those of its partner, or that has no frame to compare; runtime when `progress` stopped it.
std::vector<RankedPair> rank_pairs(const std::filesystem::path& smoky, const std::filesystem::path& clear,
                                   int every = 4, const Progress& progress = {});

}  // namespace lapfx::bench
