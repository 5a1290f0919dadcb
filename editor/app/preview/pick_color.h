// A colour from a picture that is shown, for a field of the presets or the scene: ui::Eyedropper asks, the panels with
// pictures give.
//
//     editor.eyedropper.picked = app::color_around(*picture.pixels, picture.size, at);
#pragma once

#include "lapfx/organ.h"
#include "ui/canvas/pixels.h"
#include "ui/draw/draw_list.h"

namespace lapfx::app {

/// Pixels a side that are averaged: noise and the blocks of a video weigh less.
inline constexpr int picked_side = 5;

/// The mean around `at`, worked out in linear light, of the pixels that lie inside of `size`; in sRGB, as colours of
/// presets are.
ui::Color color_around(const ui::PickSource& source, glm::ivec2 size, glm::ivec2 at);

/// Zero outside.
glm::vec4 pixel_of(const Image& image, glm::ivec2 at);

/// An image that was read back.
class ImagePixels : public ui::PickSource {
  public:
    explicit ImagePixels(const Image& image) : image_(image) {}
    glm::vec4 pixel(glm::ivec2 at) const override { return pixel_of(image_, at); }

  private:
    const Image& image_;
};

}  // namespace lapfx::app
