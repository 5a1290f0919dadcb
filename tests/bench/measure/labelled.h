// Real frames in which a person said where the blood is.
//
//     for (const KnownView& view : bench::known_labelled("surgblood")) measure_each(view, {}, add);
//
// Any thread; no OpenGL.
#pragma once

#include <filesystem>
#include <vector>

#include "bench/measure/camera.h"

namespace lapfx::bench {

/// The sequences of a folder: frame_S_0.png is the baseline of sequence S, before its bleeding, and frame_S_N.png a
/// later frame, whose blood is white in blood_S_N.png, a picture of the same size; S and N are whole numbers from 0.
/// Frames are in the order of N. Throws Error (bad_input) for a folder without such frames, a frame without its labels
/// or its baseline, and labels of another size.
std::vector<KnownView> known_labelled(const std::filesystem::path& folder);

}  // namespace lapfx::bench
