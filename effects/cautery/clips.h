// What a clip applier leaves (ToolAction::clip): metal clips that stay where the stroke began, and tissue under them
// that does not bleed any more. It is a function of the contacts: a clip exists from its contact's time on. One thread
// at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cautery/grid.h"
#include "cautery/track.h"
#include "cautery/wound_list.h"
#include "organ/surface.h"

namespace lapfx::cautery {

/// It points along the stroke if that is longer than ClipList::aim mm, otherwise as close to the x axis of organ space
/// as the surface permits.
struct Clip {
    double time = 0.0;              ///< time from which it exists, s
    SurfacePoint middle;            ///< triangle of the rest surface with which it moves
    SurfacePoint ends[2];           ///< under its ends
    std::uint32_t stay = 0;         ///< the stay of the track that has set it
    std::uint32_t aimed_by = none;  ///< the stay that gives its direction; none: no stay does

    static constexpr std::uint32_t none = 0xffffffff;
};

/// Where it is on a surface that may have moved.
struct ClipPose {
    glm::vec3 position{0.0f};                                 ///< its middle on the tissue, mm
    glm::vec3 along{1.0f, 0.0f, 0.0f}, up{0.0f, 1.0f, 0.0f};  ///< unit
    friend bool operator==(const ClipPose&, const ClipPose&) = default;
};
ClipPose pose_of(const Clip& clip, TriangleMesh now);

class ClipList {
  public:
    static constexpr double aim = 3.0;  ///< length of a stroke's path that gives the direction of its clip, mm

    /// Keeps a reference.
    explicit ClipList(const Surface& surface) : surface_(surface) {}

    /// The track's stays from `first` on have changed. `changed`: redo bits; with redo::metal_clips the parameters are
    /// taken, and all clips are new. Returns the time, s, from which sealed_at() may answer differently; never: nothing
    /// has changed.
    double set(const Track& track, std::size_t first, const CauteryParameters& parameters, unsigned changed);

    /// In the order of their times.
    std::span<const Clip> clips() const { return clips_; }
    /// Changes when they do.
    std::uint64_t version() const { return version_; }
    /// The time, s, from which a clip holds the place: it is within clip_reach of the clip's middle line. An open wound
    /// there stops at once, and what is cut there later does not bleed.
    double sealed_at(const glm::dvec3& place);

  private:
    void put(Clip& clip, const glm::dvec3& direction) const;
    void enter(std::uint32_t clip);
    void leave(std::uint32_t clip);
    void turn(std::uint32_t clip, const glm::dvec3& direction);

    const Surface& surface_;
    double length_ = CauteryParameters{}.clip_length, reach_ = CauteryParameters{}.clip_reach;  // mm
    std::vector<Clip> clips_, before_;
    Grid grid_{8.0};  // clips lie in each cell that they reach
    std::vector<std::uint32_t> near_;
    std::uint64_t version_ = 0;
};

}  // namespace lapfx::cautery
