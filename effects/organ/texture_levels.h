// The textures of an organ with their mip levels, as they are sent to a GPU: made here and not by the driver, because
// that takes longer than a frame and this can be done on another thread. Any thread.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "lapfx/organ.h"
#include "organ/pixels.h"

namespace lapfx::organ {

/// A texture that an organ needs. An image that is both base colour and normal map is two.
struct TextureUse {
    std::size_t image;  ///< index
    bool color;         ///< base colour, sRGB; otherwise a normal map
};
/// Those of images that a material uses.
std::vector<TextureUse> texture_uses(const Organ& organ);

struct TextureLevels {
    TextureUse use{};
    std::shared_ptr<const Image> whole;  ///< null: there are no pixels
    std::vector<Image> smaller;          ///< levels 1, 2, ...: half the size, rounded down, to 1x1
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    std::size_t count() const { return 1 + smaller.size(); }
    const Image& level(std::size_t i) const { return i == 0 ? *whole : smaller[i - 1]; }
};
/// `pixels`: those of images that have none themselves. The organ has to outlive the result.
TextureLevels texture_levels(const Organ& organ, const PixelList& pixels, const TextureUse& use);

/// Each level is the mean over the areas of its texels, of light for a colour and of the values otherwise; sides that
/// are odd lose no texel. `image`: RGBA.
std::vector<Image> smaller_levels(const Image& image, bool color);

}  // namespace lapfx::organ
