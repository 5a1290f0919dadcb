// Bleed value per vertex: b(x, t) = max over wounds of s_w(t) - d_w(x), mm; 0 and below is dry. d_w is the travel
// distance, shortened downhill and lengthened uphill: a constant drift g added to a metric changes every path
// between two points by the same amount, so d_w(x) = d(x) - gravity_bias * (drop from the wound to x) is the
// exact distance in that (Randers) metric. b is carried on below 0, as far as noise can
// move the edge and a triangle more: cut off at the vertices, the edge would move outwards, the farther the coarser
// the mesh, and noise could only ever take blood away. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/wound.h"
#include "organ/surface.h"

namespace lapfx::bleeding {

/// Half-open range of vertices whose value changed.
struct Dirty {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool empty() const { return begin >= end; }
};

class BleedField {
  public:
    /// Keeps a reference to `surface`. `down`: unit, organ space.
    BleedField(const Surface& surface, glm::dvec3 down);

    /// Distances are found for wounds at new places, and anew for all when blood can come farther or less far: the
    /// values depend on what is set, to the last bit, not on what was set before.
    void set(std::span<const Wound> wounds, const BleedingParameters& parameters);

    /// Values at `time`; nothing is computed, and the range is empty, when no source value has changed. The first range
    /// is that of all vertices.
    Dirty update(double time) noexcept;

    std::span<const glm::vec2> values() const { return values_; }  ///< per organ vertex: mm, 0 or less is dry; clot
    double area() const noexcept;                                  ///< mm2 of surface above the threshold, noise aside
    int growing(double time) const noexcept;                       ///< wounds that still grow

  private:
    struct Spread {
        glm::dvec3 position;
        double limit;                         ///< mm, how far the distances reach
        std::vector<std::uint32_t> vertices;  ///< of the surface
        std::vector<float> distances;         ///< mm on the surface, gravity not yet in
        std::vector<float> drops;             ///< mm, how much lower each vertex lies than the wound
    };
    Spread spread_from(glm::dvec3 position, double limit) const;
    Dirty write_values() noexcept;
    float driest() const;  // value of all vertices that blood cannot reach

    const Surface& surface_;
    glm::dvec3 down_;
    double longest_edge_;  // mm
    float dry_ = 1.0f;     // driest() at the last set
    bool told_ = false;    // an update has given the range of all vertices
    BleedingParameters parameters_;
    std::vector<Wound> wounds_;
    std::vector<Spread> spreads_;  // parallel to wounds_
    std::vector<double> sources_;  // parallel to wounds_, s_w at the last update
    std::vector<std::uint32_t>
        copies_of_;  // organ vertices of surface vertex v: copies_[copies_of_[v] .. copies_of_[v + 1]]
    std::vector<std::uint32_t> copies_;
    std::vector<float> surface_values_;   // per surface vertex
    std::vector<glm::vec2> values_;       // per organ vertex
    std::vector<std::uint32_t> touched_;  // surface vertices that some wound can reach
    bool stale_ = true;                   // parameters or wounds have changed since the last update
};

}  // namespace lapfx::bleeding
