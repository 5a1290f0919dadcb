// The clips of a preset, decoding and playing (paper: figures 3 to 5, table 1). Render thread, context current.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/clip_cache.h"
#include "lapfx/smoke_parameters.h"
#include "lapfx/streaming.h"
#include "media/clip_frame.h"
#include "media/decoder.h"
#include "media/policy.h"

namespace lapfx::media {

class ClipSet {
  public:
    /// `cache`: may be null.
    explicit ClipSet(const StreamingOptions& options, std::shared_ptr<ClipCache> cache = nullptr);
    ~ClipSet();

    /// Opens new clips and closes those that have left. Throws Error (bad_input) for a clip that cannot be used, and
    /// then keeps the previous clips.
    void set(std::span<const SmokeClip> clips, const std::filesystem::path& preset_folder,
             std::span<const std::filesystem::path> search_path);

    /// Whether a clip has its own opacity, if that is known without opening it.
    std::optional<bool> known_alpha(const SmokeClip& clip, const std::filesystem::path& preset_folder,
                                    std::span<const std::filesystem::path> search_path) const;

    std::size_t size() const;
    const ClipInfo& info(std::size_t clip) const;

    /// Frame `index` of a clip. `head`: 0, or 1 for the second place that a cross-fade plays at. Under Policy::latest,
    /// when the frame is late, the last one that this head showed (black at first). Call it once per clip and head in a
    /// cycle.
    ClipFrame frame(std::size_t clip, int head, int index, Policy policy) noexcept;
    /// What frame() gave last, and for which `index` (-1: none yet): for another view of the same cycle.
    ClipFrame shown(std::size_t clip, int head) const noexcept;
    int asked(std::size_t clip, int head) const noexcept;
    /// Call this at the end of each cycle, after drawing: the paper's FrameCoalescing, and the signal to continue
    /// decoding.
    void end_cycle() noexcept;

    /// Whether the last cycle had a frame other than the one that was asked for.
    bool late() const noexcept;
    std::size_t memory() const noexcept;  ///< bytes, of main memory and the GPU

    /// Valid until the next call. The memory is kept: asking again allocates nothing.
    std::span<const ClipStatus> status() const;
    StreamingTimes times() const noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx::media
