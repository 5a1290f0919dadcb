// What the effects keep in memory, by purpose.
//
//     const lapfx::MemoryUse use = effects.memory_use();
//     std::printf("clips: %.0f MB of %.0f MB\n", use.clips / 1e6, use.total() / 1e6);
//
// Bytes that were asked for. A driver rounds up, and without a GPU its memory is main memory, too. The memory of the
// driver (compiled shaders) and of FFmpeg while it decodes is not included. What several objects share (a
// PreparedOrgan) counts for each of them.
#pragma once

#include <cstddef>

namespace lapfx {

struct MemoryUse {
    std::size_t surface = 0;    ///< main memory: vertices, the joined surface
    std::size_t pixels = 0;     ///< main memory: textures that are decoded, and their files for decoding them again
    std::size_t densities = 0;  ///< main memory: maps of vessels and fat
    std::size_t geometry = 0;   ///< GPU: vertices, with blood and burns
    std::size_t textures = 0;   ///< GPU: textures of organ and instrument; densities while an overlay shows them
    std::size_t clips = 0;      ///< frames of clips, within StreamingOptions::memory: nearly all on the GPU
    std::size_t targets = 0;    ///< GPU: targets that are drawn into on the way to a picture

    std::size_t total() const { return surface + pixels + densities + geometry + textures + clips + targets; }
};

}  // namespace lapfx
