// The contacts in the order of their times, as chains with places along them: what both heat models work on. A chain is a
// run of contacts that continue each other; its places are at even distances along its path, however it was cut into
// contacts. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cautery/heat.h"
#include "organ/surface.h"

namespace lapfx::cautery {

/// Where a tip comes by.
struct Place {
    glm::dvec3 tip{0.0};  ///< on the tip's path
    SurfacePoint point;   ///< nearest on the surface
    double arrival = 0.0;
    bool wound = false;  ///< whether a wound opens here when it is divided
};

/// Whether a tip at this place touches the surface. NaN: no.
inline bool touches(const Surface& surface, const glm::dvec3& tip) {
    return !surface.triangles.empty() && surface.closest_point(tip).distance <= farthest_touch;
}

struct Stay {
    ToolContact contact;
    std::uint32_t chain = 0;  ///< number of the first contact of its chain
    double chain_start = 0.0;
    double length = 0.0;           ///< mm of the chain's path up to this contact's end
    std::uint64_t next_place = 0;  ///< number, along the chain, of the first place that this contact did not reach
    std::uint32_t first_place = 0, end_place = 0;
    double latest_end = 0.0;  ///< of this contact and all before
    double latest_hot = 0.0;  ///< the same, of the hot ones
};

class Track {
  public:
    /// Keeps a reference.
    explicit Track(const Surface& surface) : surface_(surface) {}

    /// Takes the usable contacts in the order of their times. What was before the first difference stays; its number is
    /// returned. When the parameters differ in what a track depends on, all is new.
    std::size_t set(std::span<const ToolContact> contacts, const CauteryParameters& parameters);

    std::span<const Stay> stays() const { return stays_; }
    std::span<const Place> places() const { return places_; }
    std::span<const Place> places_of(const Stay& stay) const {
        return std::span(places_).subspan(stay.first_place, stay.end_place - stay.first_place);
    }
    /// mm between places: a whole fraction of the spacing of wounds.
    double spacing() const { return spacing_; }
    /// The time up to which the tips did the same in the last two lists.
    double same_until() const { return same_until_; }

  private:
    void append(const ToolContact& contact);

    const Surface& surface_;
    std::vector<ToolContact> wanted_;
    std::vector<Stay> stays_;
    std::vector<Place> places_;
    double spacing_ = 0.0;
    std::uint32_t per_wound_ = 1;
    double same_until_ = 0.0;
};

}  // namespace lapfx::cautery
