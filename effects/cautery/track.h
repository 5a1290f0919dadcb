// The pieces of the tool's log, with places along them, for both heat models. The places of a stroke are at even
// distances along its path, however it is cut into pieces. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cautery/heat.h"
#include "organ/surface.h"
#include "tool/log.h"

namespace lapfx::cautery {

/// A place that a tip passes.
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
    std::uint32_t chain = 0;       ///< number of the first piece of its stroke
    double length = 0.0;           ///< mm of the stroke's path up to this piece's end
    std::uint64_t next_place = 0;  ///< number, along the stroke, of the first place that this piece did not reach
    std::uint32_t first_place = 0, end_place = 0;
    double latest_end = 0.0;  ///< latest end of this contact and all before
    double latest_hot = 0.0;  ///< latest end of the hot ones
};

class Track {
  public:
    /// Keeps a reference.
    explicit Track(const Surface& surface) : surface_(surface) { set_parameters({}); }

    /// After a change of what a track depends on (redo::tip_places). All stays are new with the next set().
    void set_parameters(const CauteryParameters& parameters);
    /// Makes a stay for each piece. Takes what has been written since the last call and gives the number of the first
    /// new stay.
    std::size_t set(const tool::Log& log);

    std::span<const Stay> stays() const { return stays_; }
    std::span<const Place> places() const { return places_; }
    std::span<const Place> places_of(const Stay& stay) const {
        return std::span(places_).subspan(stay.first_place, stay.end_place - stay.first_place);
    }
    /// Whether the tip of this stroke is within `radius` mm of `tip` at a time at which the stroke runs.
    bool is_near(std::uint32_t chain, double time, const glm::dvec3& tip, double radius) const;
    /// Whether a contact's own heat was there when heat divided the tissue of a wound.
    bool has_divided(const Stay& stay, const Burn& burn, double tip_radius) const {
        return burn.time < never && divides(stay.contact.action) &&
               is_near(stay.chain, burn.time, burn.tip, tip_radius);
    }
    /// mm between places: a whole fraction of the spacing of wounds.
    double spacing() const { return spacing_; }
    /// The time up to which the last set() has not changed what the tips did.
    double same_until() const { return same_until_; }
    /// Pieces and places that were worked on so far: the cost, as a count.
    std::uint64_t work() const { return work_; }

  private:
    void append(const tool::Piece& piece);

    const Surface& surface_;
    tool::Reader reader_;
    std::vector<Stay> stays_;
    std::vector<Place> places_;
    double spacing_ = 0.0;
    std::uint32_t per_wound_ = 1;
    double same_until_ = 0.0;
    std::uint64_t work_ = 0;
};

}  // namespace lapfx::cautery
