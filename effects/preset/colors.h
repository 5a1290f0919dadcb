// Colours in documents: "#rrggbb" where that is exact, else three numbers.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace lapfx::preset {

/// "#5d0f11" as sRGB 0..1.
std::optional<glm::dvec3> read_hex_color(std::string_view text);

/// "#rrggbb" when every channel is a whole number of 255ths, so that nothing is lost.
std::optional<std::string> hex_color(const glm::dvec3& color);

}  // namespace lapfx::preset
