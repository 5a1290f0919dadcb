// Whether an organ's arrays fit together: a host may have filled them by hand.
#pragma once

#include <span>
#include <string_view>

#include "lapfx/organ.h"

namespace lapfx::organ {

inline constexpr double farthest = 1e9;  ///< mm; as of a file

// Each throws Error (bad_input) in the name of the organ, naming the place and what is allowed. Pure; any thread.

/// Corners that are below the number of positions, three for each triangle.
void require_corners(std::string_view name, std::span<const std::uint32_t> indices, std::size_t positions);
/// An index of an image, or -1.
void require_image(std::string_view name, const std::string& place, int image, std::size_t images);

/// All of it.
void require_complete(const Organ& organ);

}  // namespace lapfx::organ
