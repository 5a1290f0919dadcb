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

/// How decoded frames reach the GPU. With wait_for_clips all schemes show the same picture. The first two give
/// identical bytes, and so do the last two. Between these pairs colours differ by rounding, because RGB is converted on
/// the CPU and planes in the shader.
enum class Scheme {
    pipeline,  ///< the paper's first scheme: one RGB frame is decoded and sent in every cycle
    buffered,  ///< the paper's second scheme: frames are decoded ahead into buffers; after drawing, two RGB frames are
               ///< sent in one cycle and none in the next
    buffered_planar,  ///< the same with luma and chroma planes (4:2:0): half the bytes, no conversion on the CPU
    resident,         ///< planes sent once, then played from GPU memory; what does not fit is buffered_planar
};

/// What a late clip does when nothing waits for it (EffectsOptions::wait_for_clips).
enum class LateClips {
    repeat,  ///< shows its last frame again, then continues with the one after it: every frame is shown, if necessary
             ///< in slow motion
    /// The paper's: "consecutive video frames are skipped for performance enhancement". For `buffered` and
    /// `buffered_planar` only: while frames are not decoded in time, or the clip advances by more than one frame per
    /// cycle, it sends one frame instead of two and shows it for two cycles. It skips the next frame and so keeps its
    /// time.
    skip,
};

/// Where smoke is shaded.
enum class SmokeResolution {
    screen,    ///< each layer at the frame's resolution, directly over the frame: the paper's way
    clip,      ///< all layers off-screen, with as many pixels as the largest clip has, then laid over the frame once
    half,      ///< the same with half of the rows and columns
    balanced,  ///< plumes as `clip`, haze as `half`: wisps have edges, a veil has none
};

struct StreamingOptions {
    Scheme scheme = Scheme::resident;
    SmokeResolution resolution = SmokeResolution::balanced;
    /// Bytes for frames, on the GPU and decoded ahead in main memory together. Clips that are being decoded get their
    /// buffers first, at least two frames each, whatever the budget. The rest goes to resident clips, whole clips in
    /// the order of the preset. The budget does not include what FFmpeg's decoders keep while they decode, 10 to 13
    /// frames per clip; the decoder of a fully resident clip is closed.
    std::size_t memory = std::size_t{1} << 30;
    /// The part of these bytes that clips which have left the preset may keep, for a host that alternates between
    /// presets. They are evicted first, starting with the one drawn longest ago. At 0 they are freed at once and
    /// decoded again when they return.
    std::size_t kept_memory = 0;
    LateClips late = LateClips::repeat;
    int threads = 0;           ///< number of decoding threads; 0: as many as there are cores
    bool gpu_timings = false;  ///< time shading with timer queries, where the driver has them
};

/// One clip of the preset, in its order.
struct ClipStatus {
    std::string file;    ///< path that was opened
    glm::ivec2 size{0};  ///< pixels
    int frames = 0;
    double duration = 0.0;  ///< s
    bool alpha = false;     ///< the clip has its own opacity
    int resident = 0;       ///< frames that stay in GPU memory
    std::size_t memory =
        0;           ///< bytes of GPU and main memory; frames that several clips of one file share count for the first
    int broken = 0;  ///< frames so far that could not be decoded; the one before is shown instead
    std::uint64_t misses = 0;  ///< frames that came late, so that another one was shown instead
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
    std::uint64_t shaded = 0;  ///< number of frames in `shading`
};

}  // namespace lapfx
