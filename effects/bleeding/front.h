// The front of the blood of one wound: travel distance over the surface by fast marching (R. Kimmel, J. Sethian,
// "Computing geodesic paths on manifolds", PNAS 1998), with an update that is exact for a point source on a plane: the
// source is unfolded into the triangle's plane (M. Novotni, R. Klein, "Computing geodesic distances on triangular
// meshes", WSCG 2002). Distances follow the surface and not its edges, so they hardly depend on how fine the mesh is.
//
// The front marches only as far as needed, in rings of fixed width. A ring depends only on the rings before it, so any
// order of requests gives the same result to the last bit.
//
// Distance means cost in mm: a mm in a crease costs less, a mm across a ridge more (Terrain::slowness), and gravity
// shortens downhill and lengthens uphill travel. A constant drift added to a metric changes every path between two
// points by the same amount, so distance = length - gravity_bias * drop from the wound is exact (a Randers metric).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "bleeding/terrain.h"
#include "lapfx/bleeding_parameters.h"
#include "organ/surface.h"

namespace lapfx::bleeding {

/// Of one mm of a crease, in every direction.
inline constexpr double least_cost = 0.05;

struct Reached {
    std::uint32_t vertex;  ///< of the surface
    float distance;        ///< mm from the contact point
};

/// False for NaN and infinity.
bool is_place(const glm::dvec3& p);

/// What distance means.
struct Metric {
    double gravity_bias = 0.0;  ///< 0..0.9
    double crease_bias = 0.0;   ///< 0..1
    double bridge_gap = 0.0;    ///< mm; blood crosses to another component that is closer than this
    friend bool operator==(const Metric&, const Metric&) = default;
};
Metric metric_of(const BleedingParameters& bleeding);

/// Shared by all fronts on one surface: the terrain, and memory to march in.
class FrontRoom {
  public:
    FrontRoom(const Surface& on, glm::dvec3 down) : surface(on), terrain(on, down), cells_(on.positions.size()) {}

    const Surface& surface;
    Terrain terrain;

  private:
    friend class Front;
    struct Cell {
        double length = 0.0;      // mm, without gravity
        std::uint32_t stamp = 0;  // the value belongs to the loaded front if this equals the current stamp
        bool frozen = false;
    };
    std::vector<Cell> cells_;  // per point
    std::uint32_t stamp_ = 0, fronts_ = 0, loaded_ = 0;
};

class Front {
  public:
    static constexpr double ring_width = 0.5;  // mm; a frame marches a ring or two

    /// The contact is moved to the closest point of the surface, also inside a triangle. A contact that is NaN, or an
    /// empty surface, reaches nothing.
    Front(FrontRoom& room, const Metric& metric, const glm::dvec3& contact);

    /// Vertices with ring * ring_width < distance <= (ring + 1) * ring_width, in vertex order; the first ring also has
    /// the nearer ones. Empty beyond the last vertex that can be reached. Marches as far as needed.
    std::span<const Reached> ring(std::size_t ring, FrontRoom& room);
    bool ended(std::size_t ring) const { return done_ && ring >= rings_.size(); }
    /// The longest edge up to a ring that has been asked for, mm.
    double longest_edge(std::size_t ring) const { return rings_[ring].longest_edge; }

  private:
    struct Candidate {
        double distance;
        std::uint32_t vertex;
        bool operator<(const Candidate& other) const {
            // The smallest distance first; equal distances in vertex order, so that results repeat.
            return distance != other.distance ? distance > other.distance : vertex > other.vertex;
        }
    };
    struct Known {
        std::uint32_t vertex;
        double length;
    };
    struct Ring {
        std::size_t end;  // into reached_
        double longest_edge;
    };
    double distance_of(std::uint32_t vertex, double length, const FrontRoom& room) const;
    void load(FrontRoom& room);
    void march_ring(FrontRoom& room);
    void freeze(double limit, FrontRoom& room);
    void offer(std::uint32_t vertex, double length, FrontRoom& room);
    void spread_over(std::uint32_t triangle, std::uint32_t from, FrontRoom& room);
    void cross_bridge(std::uint32_t from, FrontRoom& room);

    Metric metric_;
    std::uint32_t id_;
    double start_drop_ = 0.0, longest_edge_ = 0.0;
    std::vector<Candidate> candidates_;  // a heap
    std::vector<Known> pending_;         // met, not frozen
    std::vector<Known> rim_;             // frozen, with a neighbour that is not
    std::vector<Reached> reached_;       // frozen, ring by ring
    std::vector<Ring> rings_;
    bool done_ = false;
};

/// Every surface vertex within `limit` mm of `contact`, nearest first: a whole front at once.
std::vector<Reached> march(FrontRoom& room, const Metric& metric, const glm::dvec3& contact, double limit);

}  // namespace lapfx::bleeding
