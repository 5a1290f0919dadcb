#include "app/preview/pick_color.h"

namespace lapfx::app {

glm::vec4 pixel_of(const Image& image, glm::ivec2 at) {
    if (at.x < 0 || at.y < 0 || at.x >= image.width || at.y >= image.height) return glm::vec4(0);
    const auto row = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(image.width);
    const std::uint8_t* p = image.pixels.data() + 4 * (row + static_cast<std::size_t>(at.x));
    return {p[0], p[1], p[2], p[3]};
}

ui::Color color_around(const ui::PickSource& source, glm::ivec2 size, glm::ivec2 at) {
    return ui::picked_color(source, size, at, picked_side);
}

}  // namespace lapfx::app
