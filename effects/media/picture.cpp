#include "media/picture.h"

namespace lapfx::media {

ColorMatrix color_matrix(float red, float blue, bool full_range) {
    const float green = 1.0f - red - blue;
    // ITU-R BT.601 and BT.709: luma uses 219 of the 255 steps from 16 on and chroma 224 around 128, unless the range is
    // full.
    const float luma = full_range ? 1.0f : 255.0f / 219.0f, chroma = full_range ? 1.0f : 255.0f / 224.0f;
    const float cb = chroma * 2.0f * (1.0f - blue), cr = chroma * 2.0f * (1.0f - red);
    ColorMatrix color;
    color.matrix =
        glm::mat3(glm::vec3(luma), glm::vec3(0.0f, -cb * blue / green, cb), glm::vec3(cr, -cr * red / green, 0.0f));
    color.offset = {full_range ? 0.0f : 16.0f, 128.0f, 128.0f};
    return color;
}

}  // namespace lapfx::media
