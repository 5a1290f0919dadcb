// A picture of a preview that is compared with another one: a texture of its own, and its pixels, read back from the
// GPU when they are asked for, once per picture. Context current.
#pragma once

#include <cstdint>

#include "app/preview/preview_host.h"
#include "ui/canvas/pixels.h"

namespace lapfx::app {

class DrawnPicture : public ui::PickSource {
  public:
    /// px that it is drawn with; another size makes another texture, in which nothing has been drawn yet.
    void resize(glm::ivec2 size);
    /// Draws if the picture would differ from the last one; gives whether it did. Nothing is drawn before resize().
    bool draw(PreviewHost& preview, const Shot& shot);
    /// Another preview draws it from now on.
    void forget() { copy_.revision = 0; }
    bool drawn() const { return copy_.revision != 0; }  ///< there is a picture
    std::uint64_t serial() const { return serial_; }    ///< how many pictures there have been
    unsigned texture() const { return copy_.target.texture(); }
    std::size_t memory() const { return copy_.target.memory(); }  ///< bytes on the GPU
    const Image& image() const;

    /// px that it is counted in where it is shown: pixel() samples it as if it had so many.
    glm::ivec2 counted{1};
    glm::vec4 pixel(glm::ivec2 at) const override;

  private:
    PreviewCopy copy_;
    std::uint64_t serial_ = 0;
    mutable Image image_;
    mutable std::uint64_t read_ = 0;  ///< serial of the picture in it
};

}  // namespace lapfx::app
