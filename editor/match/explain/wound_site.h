// Where a wound may open, and how large its blood is once it has travelled so far: found by asking the core, because
// only it knows whether a stroke opens a wound, when, and how strongly it bleeds there.
// One thread at a time.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/wound.h"
#include "match/explain/wounds.h"

namespace lapfx::match {

/// mm2 over mm, from (0, 0) on, ascending.
struct Growth {
    std::vector<double> extents = {0.0}, areas = {0.0};
    /// Between two extents the square root of the area is linear, as it is for a disc; beyond the last one it goes on
    /// so.
    double area(double extent) const;
};

/// A stroke of the scene that divides tissue, or a place of a new cut.
struct WoundSite {
    std::vector<std::size_t> contacts = {};  ///< numbers of events, in the order of time; none: a new cut
    glm::dvec3 position{0.0};
    double time = 0.0;      ///< s, of its first contact; 0 for a new cut
    double strength = 1.0;  ///< of its strongest contact; 1 where that is 0
    double delay = 0.0;     ///< s from the first contact to the first wound
    double factor = 1.0;    ///< strength of that wound over `strength`: vessels, and how it was divided
    Growth growth = {};

    glm::dvec3 opened{0.0};  ///< mm, where that wound is

    /// Its contacts when its wound opens at `start` and has that strength. No contact begins before 0 s.
    std::vector<ToolContact> contacts_at(double start, double of_strength, std::span<const ToolContact> events) const;
    /// When its wound opens among all that the core says: s; none: it does not, or closes at once. `made`:
    /// contacts_at().
    std::optional<double> opens(std::span<const WoundStatus> wounds, std::span<const ToolContact> made) const;
};

/// The strokes of the events that divide tissue, in the order of time, each with the numbers of its contacts.
std::vector<WoundSite> strokes_that_divide(std::span<const ToolContact> events);

/// Asks the core about the site alone: sets delay, factor and growth, up to `largest` mm2. False: it opens no wound, or
/// none that stays open.
bool probe(WoundSite& site, const WoundSearch& search, double largest);

}  // namespace lapfx::match
