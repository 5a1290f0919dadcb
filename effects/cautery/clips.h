// What a clip applier leaves (ToolAction::clip): metal clips that stay where the stroke began, and the tissue under
// them, which bleeds no more. A function of the contacts: a clip is there from its contact's time on. One thread at a
// time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cautery/grid.h"
#include "cautery/track.h"
#include "cautery/wound_list.h"
#include "organ/surface.h"

namespace lapfx::cautery {

/// It lies along the stroke if that is longer than ClipList::aim mm, else as near to organ space's x as the surface
/// lets it.
struct Clip {
    double time = 0.0;              ///< s, from when on it is there
    SurfacePoint middle;            ///< of the surface at rest, which it moves with
    SurfacePoint ends[2];           ///< under its ends
    std::uint32_t stay = 0;         ///< of the track, that has set it
    std::uint32_t aimed_by = none;  ///< the stay that says where it points; none: nothing does

    static constexpr std::uint32_t none = 0xffffffff;
};

/// Where it is on a surface that may have moved.
struct ClipPose {
    glm::vec3 position{0.0f};                                 ///< mm, of its middle on the tissue
    glm::vec3 along{1.0f, 0.0f, 0.0f}, up{0.0f, 1.0f, 0.0f};  ///< unit
    friend bool operator==(const ClipPose&, const ClipPose&) = default;
};
ClipPose pose_of(const Clip& clip, TriangleMesh now);

class ClipList {
  public:
    static constexpr double aim = 3.0;  ///< mm of a stroke's path that say where its clip points

    /// Keeps a reference.
    explicit ClipList(const Surface& surface) : surface_(surface) {}

    /// The track's stays from `first` on are other ones than before. From when on, s, sealed_at() may answer otherwise;
    /// never: all is as it was.
    double set(const Track& track, std::size_t first, const CauteryParameters& parameters);

    /// In the order of their times.
    std::span<const Clip> clips() const { return clips_; }
    /// Changes when they do.
    std::uint64_t version() const { return version_; }
    /// From when on, s, a clip holds the place: it lies within clip_reach of the clip's middle line. What is open there
    /// stops at once, and what is cut there later does not bleed.
    double sealed_at(const glm::dvec3& place);

  private:
    void put(Clip& clip, const glm::dvec3& direction) const;
    void enter(std::uint32_t clip);
    void leave(std::uint32_t clip);
    void turn(std::uint32_t clip, const glm::dvec3& direction);

    const Surface& surface_;
    double length_ = 0.0, reach_ = 0.0;
    std::vector<Clip> clips_, before_;
    Grid grid_{8.0};  // of what each clip reaches
    std::vector<std::uint32_t> near_;
    std::uint64_t version_ = 0;
};

}  // namespace lapfx::cautery
