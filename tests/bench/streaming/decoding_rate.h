// How fast clips are decoded, with nothing played.
#pragma once

#include <filesystem>
#include <span>

namespace lapfx::bench {

/// Measures how many frames per second the decoding threads reach on this machine. They decode all `clips` at the same
/// time into planes in main memory, for `loops` times the longest clip. `threads`: 0 for as many as there are cores.
/// Throws Error (bad_input).
double decoding_rate(std::span<const std::filesystem::path> clips, int loops, int threads = 0);

}  // namespace lapfx::bench
