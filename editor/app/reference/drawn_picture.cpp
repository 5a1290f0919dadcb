#include "app/reference/drawn_picture.h"

#include "app/preview/pick_color.h"

namespace lapfx::app {

void DrawnPicture::resize(glm::ivec2 size) {
    if (copy_.target.size() == size) return;
    copy_.target.resize(size);
    copy_.revision = 0;
}

bool DrawnPicture::draw(PreviewHost& preview, const Shot& shot) {
    if (!preview.draw_into(copy_, shot)) return false;
    ++serial_;
    return true;
}

const Image& DrawnPicture::image() const {
    if (read_ != serial_) {
        copy_.target.read(image_);
        read_ = serial_;
    }
    return image_;
}

glm::vec4 DrawnPicture::pixel(glm::ivec2 at) const {
    const Image& image = this->image();
    const glm::dvec2 scale = glm::dvec2(image.width, image.height) / glm::dvec2(counted);
    return pixel_of(image, glm::ivec2((glm::dvec2(at) + 0.5) * scale));
}

}  // namespace lapfx::app
