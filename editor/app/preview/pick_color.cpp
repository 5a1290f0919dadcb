#include "app/preview/pick_color.h"

#include <algorithm>
#include <glm/gtc/color_space.hpp>

namespace lapfx::app {

namespace {

/// Light of a code value.
class LinearPixels : public ui::PickSource {
  public:
    explicit LinearPixels(const ui::PickSource& source) : source_(source) {}
    glm::vec4 pixel(glm::ivec2 at) const override {
        return {glm::convertSRGBToLinear(glm::vec3(source_.pixel(at)) / 255.0F), 1};
    }

  private:
    const ui::PickSource& source_;
};

}  // namespace

glm::vec4 pixel_of(const Image& image, glm::ivec2 at) {
    if (at.x < 0 || at.y < 0 || at.x >= image.width || at.y >= image.height) return glm::vec4(0);
    const auto row = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(image.width);
    const std::uint8_t* p = image.pixels.data() + 4 * (row + static_cast<std::size_t>(at.x));
    return {p[0], p[1], p[2], p[3]};
}

ui::Color color_around(const ui::PickSource& source, glm::ivec2 size, glm::ivec2 at) {
    const glm::vec3 light(ui::mean_of(LinearPixels(source), size, at, picked_side));
    return ui::color_of(glm::vec4(255.0F * glm::convertLinearToSRGB(light), 255));
}

}  // namespace lapfx::app
