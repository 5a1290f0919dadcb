// What `lapfx inspect` says about an organ: its surface, and the effect of splitting it.
//
//     const lapfx::OrganReport found = lapfx::report(lapfx::load_organ("liver.obj"));
//     for (const std::string& warning : found.warnings) std::cerr << warning << '\n';
//
// Any thread.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx {

/// The longest side that one organ can have, mm: from the ovary of a child to the bowel in place. Any other is reported
/// as a likely mistake in the unit.
inline constexpr double shortest_organ = 5.0, longest_organ = 600.0;

/// Edges are counted after vertices at the same position, and along seams that rounding tore, have been joined: a
/// texture seam is not a boundary.
struct OrganReport {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t components = 0;
    std::size_t boundary_edges = 0;
    std::size_t non_manifold_edges = 0;
    glm::dvec3 minimum{0.0};  ///< mm
    glm::dvec3 maximum{0.0};
    std::vector<std::string> warnings;  ///< the organ's own warnings, and one if its size cannot be that of an organ
};
OrganReport report(const Organ& organ);

/// What refine() (refine.h) would make.
struct RefineReport {
    std::size_t triangles = 0;  ///< triangles after splitting; for a fine organ its own
    double longest_edge = 0.0;  ///< longest edge after splitting, mm; 0: no edge is too long
    bool bounded = false;       ///< 300,000 more triangles were not enough for 2 mm
};
RefineReport report_refine(const Organ& organ);

}  // namespace lapfx
