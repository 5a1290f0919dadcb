#include "ui/draw/images.h"

#include <cassert>

namespace lapfx::ui {

namespace {

std::size_t bytes_of(glm::ivec2 size) {
    assert(size.x > 0 && size.y > 0 && size.x <= 8192 && size.y <= 8192);
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4;
}

}  // namespace

ImageHandle ImageStore::add(glm::ivec2 size, std::span<const std::uint8_t> rgba) {
    std::size_t index = images_.size();
    if (free_.empty()) {
        images_.emplace_back();
    } else {
        index = free_.back();
        free_.pop_back();
    }
    images_[index].serial = ++last_serial_;  // in use, as update() asks for
    const ImageHandle handle = own_images + index;
    update(handle, size, rgba);
    return handle;
}

void ImageStore::update(ImageHandle image, glm::ivec2 size, std::span<const std::uint8_t> rgba) {
    assert(find(image) != nullptr);
    assert(rgba.size() == bytes_of(size));
    StoredImage& stored = images_[image - own_images];
    stored.size = size;
    stored.pixels.assign(rgba.begin(), rgba.end());
    stored.serial = ++last_serial_;
}

void ImageStore::remove(ImageHandle image) {
    assert(find(image) != nullptr);
    images_[image - own_images] = {};
    free_.push_back(static_cast<std::uint32_t>(image - own_images));
}

const StoredImage* ImageStore::find(ImageHandle image) const {
    if (image < own_images || image - own_images >= images_.size()) return nullptr;
    const StoredImage& stored = images_[image - own_images];
    return stored.serial == 0 ? nullptr : &stored;
}

}  // namespace lapfx::ui
