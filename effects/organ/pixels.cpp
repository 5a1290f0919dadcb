#include "organ/pixels.h"

#include <utility>

#include "organ/image.h"

namespace lapfx::organ {

namespace {

/// Calls `make` for each image that a material has its base colour from.
template <typename Make>
PixelList of_base_colors(const Organ& organ, const Make& make) {
    PixelList list(organ.images.size());
    for (const Material& material : organ.materials) {
        if (material.base_color_image < 0) continue;
        const auto i = static_cast<std::size_t>(material.base_color_image);
        if (!list[i]) list[i] = make(organ.images[i]);
    }
    return list;
}

}  // namespace

Pixels::Pixels(Image image, Encoded encoded)
    : encoded_(std::move(encoded)), kept_(std::make_shared<const Image>(std::move(image))), lent_(kept_) {}

Pixels::Pixels(const Image& borrowed)
    : borrowed_(true), kept_(std::shared_ptr<const Image>(), &borrowed), lent_(kept_) {}

std::shared_ptr<const Image> Pixels::get() const {
    const std::lock_guard lock(mutex_);
    if (kept_) return kept_;
    if (std::shared_ptr<const Image> image = lent_.lock()) return image;
    auto image = std::make_shared<Image>();
    if (!decode_image(*encoded_, *image).empty()) *image = {};
    lent_ = image;
    return image;
}

void Pixels::let_go() const {
    const std::lock_guard lock(mutex_);
    if (encoded_) kept_.reset();
}

std::size_t Pixels::memory() const {
    const std::lock_guard lock(mutex_);
    if (borrowed_) return 0;
    const std::shared_ptr<const Image> image = lent_.lock();
    return (image ? image->pixels.size() : 0) + (encoded_ ? encoded_->size() : 0);
}

PixelList take_pixels(Organ& organ, const std::vector<Encoded>& encoded) {
    PixelList list;
    for (std::size_t i = 0; i < organ.images.size(); ++i) {
        Image& image = organ.images[i];
        Image taken{.width = image.width,
                    .height = image.height,
                    .pixels = std::exchange(image.pixels, {}),
                    .name = image.name};
        list.push_back(std::make_shared<const Pixels>(std::move(taken), i < encoded.size() ? encoded[i] : nullptr));
    }
    return list;
}

PixelList copied_pixels(const Organ& organ) {
    return of_base_colors(organ, [](const Image& image) { return std::make_shared<const Pixels>(image, nullptr); });
}

PixelList borrowed_pixels(const Organ& organ) {
    return of_base_colors(organ, [](const Image& image) { return std::make_shared<const Pixels>(image); });
}

}  // namespace lapfx::organ
