// Pictures that the UI makes or is handed as bytes (scopes, thumbnails, a colour square). The renderer keeps a texture
// for each and sends what changed.
#pragma once

#include <span>
#include <vector>

#include "ui/draw/draw_list.h"

namespace lapfx::ui {

/// RGBA8, sRGB, straight alpha, rows from the top.
struct StoredImage {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> pixels;
    std::uint32_t serial = 0;  ///< another one after every change, never used twice by a store; 0: removed
};

class ImageStore {
  public:
    /// Adds an image with sides of at most 8192 pixels (assert).
    ImageHandle add(glm::ivec2 size, std::span<const std::uint8_t> rgba);
    /// The same size keeps its memory. A handle of this store (assert).
    void update(ImageHandle image, glm::ivec2 size, std::span<const std::uint8_t> rgba);
    void remove(ImageHandle image);
    const StoredImage* find(ImageHandle image) const;             ///< null: not of this store, or removed
    std::span<const StoredImage> all() const { return images_; }  ///< index i is handle own_images + i

  private:
    std::vector<StoredImage> images_;
    std::vector<std::uint32_t> free_;
    std::uint32_t last_serial_ = 0;
};

}  // namespace lapfx::ui
