// What `lapfx inspect` says about an organ: its surface, and what would be split.
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

/// Longest sides that one organ can have, mm: from the ovary of a child to the bowel in place. Others are reported as a
/// likely mistake in the unit.
inline constexpr double shortest_organ = 5.0, longest_organ = 600.0;

/// Edges are counted on the surface after vertices at the same position, and those of
/// seams that rounding tore, have been joined: a texture seam is not a boundary.
struct OrganReport {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t components = 0;
    std::size_t boundary_edges = 0;
    std::size_t non_manifold_edges = 0;
    glm::dvec3 minimum{0.0};  ///< mm
    glm::dvec3 maximum{0.0};
    std::vector<std::string> warnings;  ///< the organ's own, and whether its size can be that of an organ
};
OrganReport report(const Organ& organ);

/// What refine() (refine.h) would make.
struct RefineReport {
    std::size_t triangles = 0;  ///< those of a fine organ: its own
    double longest_edge = 0.0;  ///< mm, then; 0: nothing is too long
    bool bounded = false;       ///< 400,000 more would not have done for 4.5 mm
};
RefineReport report_refine(const Organ& organ);

}  // namespace lapfx
