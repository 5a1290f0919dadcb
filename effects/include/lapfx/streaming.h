// How frames of smoke clips reach the GPU (paper: "Smoke generation", figures 3 to 5, table 1), and what it costs.
//
//     lapfx::Effects effects(organ, preset, {.streaming = {.memory = std::size_t{2} << 30}});
//     for (const lapfx::ClipStatus& clip : effects.clips()) if (!clip.warning.empty()) log(clip.file, clip.warning);
//
// Plain data; any thread.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

namespace lapfx {

/// How decoded frames reach the GPU. Under Policy::wait all of them show the same picture: the first two the same
/// bytes, the last two as well, and between them rounding of colour apart (RGB is converted on the CPU, planes in the
/// shader).
enum class Scheme {
    pipeline,  ///< the paper's first: one RGB frame is decoded and sent in every cycle
    buffered,  ///< the paper's second: decoded ahead into buffers; two RGB frames in one cycle, none in the next, after
               ///< drawing
    buffered_planar,  ///< the same with luma and chroma planes (4:2:0): half the bytes, no conversion on the CPU
    resident,         ///< planes sent once, then played from GPU memory; what does not fit is buffered_planar
};

/// What a clip does that is late, where nothing waits for it (EffectsOptions::wait_for_clips).
enum class LateClips {
    repeat,  ///< shows its last frame again, then goes on with the one after it: every frame is shown, in slow motion
             ///< if need be
    skip,    ///< the paper's: "consecutive video frames are skipped for performance enhancement". Of `buffered` and
             ///< `buffered_planar`: while
    ///< frames are not decoded in time, or the clip goes on by more than one frame in each cycle, it sends one frame
    ///< where it would send two and shows it for two cycles; the one after is skipped, and the clip keeps its time
};

/// Where smoke is shaded.
enum class SmokeResolution {
    screen,    ///< each layer at the frame's resolution, straight over it: the paper's way
    clip,      ///< all layers off-screen, with as many pixels as the largest clip has, then laid over the frame once
    half,      ///< the same with half of the rows and columns
    balanced,  ///< plumes as `clip`, haze as `half`: wisps have edges, a veil has none
};

struct StreamingOptions {
    Scheme scheme = Scheme::resident;
    SmokeResolution resolution = SmokeResolution::balanced;
    /// Bytes for frames, on the GPU and decoded ahead in main memory together. Clips that are being decoded have their
    /// buffers first (at least two frames each, whatever the budget). What is left goes to resident clips, whole clips
    /// in the order of the preset. Not in it: what FFmpeg's decoders keep for themselves while they decode, 10 to 13
    /// frames a clip; once all of a clip is resident its decoder is closed.
    std::size_t memory = std::size_t{1} << 30;
    /// Of these bytes, for clips that are no longer in the preset, for a host that goes to and fro between presets:
    /// they are evicted first, the one drawn longest ago first. 0: they go at once, and are decoded again when they
    /// come back.
    std::size_t kept_memory = 0;
    LateClips late = LateClips::repeat;
    int threads = 0;           ///< that decode; 0: as many as there are cores
    bool gpu_timings = false;  ///< time shading with timer queries, where the driver has them
};

/// One clip of the preset, in its order.
struct ClipStatus {
    std::string file;    ///< path that was opened
    glm::ivec2 size{0};  ///< pixels
    int frames = 0;
    double duration = 0.0;     ///< s
    bool alpha = false;        ///< it has its own opacity
    int resident = 0;          ///< frames that are in GPU memory to stay
    std::size_t memory = 0;    ///< bytes, GPU and main memory; frames that clips of one file share count for the first
    int broken = 0;            ///< frames met so far that could not be decoded; the one before is shown in their place
    std::uint64_t misses = 0;  ///< frames that were late, so that another one was shown in their place
    std::string warning;       ///< one line for people, empty when all is well
};

/// Sums since the Effects was made (table 2 of the paper has their means); s of wall time unless said otherwise.
struct StreamingTimes {
    double open = 0.0;                        ///< clips opened and looked through
    double decode = 0.0;                      ///< on the decoding threads: frames decoded and converted
    double copy = 0.0;                        ///< on the decoding threads: frames copied into buffers
    double wait = 0.0;                        ///< on the render thread: waiting for a frame
    double upload = 0.0;                      ///< on the render thread: frames sent to the GPU
    double shading = 0.0;                     ///< on the GPU, by timer queries; 0 without StreamingOptions::gpu_timings
    std::uint64_t decoded = 0, uploaded = 0;  ///< frames
    std::uint64_t uploaded_bytes = 0;
    std::uint64_t shaded = 0;  ///< frames that `shading` is the sum of
};

}  // namespace lapfx
