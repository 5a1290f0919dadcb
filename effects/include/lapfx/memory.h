// What the effects hold in memory, by what it is for.
//
//     const lapfx::MemoryUse use = effects.memory_use();
//     std::printf("clips: %.0f MB of %.0f MB\n", use.clips / 1e6, use.total() / 1e6);
//
// Bytes of what was asked for; a driver rounds up, and without a GPU what lies on it is main memory, too. Not in it:
// the driver's own (compiled shaders), FFmpeg's while it decodes. What several share (a PreparedOrgan) is in the
// numbers of each of them.
#pragma once

#include <cstddef>

namespace lapfx {

struct MemoryUse {
    std::size_t surface = 0;    ///< main memory: vertices, the joined surface
    std::size_t pixels = 0;     ///< main memory: textures that are decoded, and their files for decoding them again
    std::size_t densities = 0;  ///< main memory: maps of vessels and fat
    std::size_t geometry = 0;   ///< GPU: vertices, with blood and burns
    std::size_t textures = 0;   ///< GPU: of organ and instrument; densities while an overlay shows them
    std::size_t clips = 0;      ///< frames of clips, within StreamingOptions::memory: nearly all on the GPU
    std::size_t targets = 0;    ///< GPU: what is drawn into on the way to a picture

    std::size_t total() const { return surface + pixels + densities + geometry + textures + clips + targets; }
};

}  // namespace lapfx
