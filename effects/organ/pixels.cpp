#include "organ/pixels.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "media/image.h"

namespace lapfx::organ {

namespace {

/// Calls `make` for each image that is the base colour of a material.
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

/// Null when there is not enough memory; the file itself has been decoded before.
std::shared_ptr<const Image> decoded(const Encoded& encoded) {
    try {
        const auto image = std::make_shared<Image>();
        if (media::decode_image(*encoded, *image, longest_texture).empty()) return image;
    } catch (const std::exception&) {
        return nullptr;
    }
    return nullptr;
}

}  // namespace

std::string decode_texture(std::span<const std::uint8_t> file, Image& image, std::vector<std::string>& warnings) {
    std::string fault = media::decode_image(file, image, longest_texture);
    media::ImageSize size;
    if (!fault.empty() || !media::image_size(file, size)) return fault;
    const auto text = [](std::int64_t width, std::int64_t height) {
        return std::to_string(width) + "x" + std::to_string(height);
    };
    if (size.width != image.width || size.height != image.height)
        warnings.push_back("texture " + image.name + ": its " + text(size.width, size.height) +
                           " pixels were shrunk to " + text(image.width, image.height) +
                           " while it was read; no side is longer than " + std::to_string(longest_texture));
    return fault;
}

Pixels::Pixels(Image image, Encoded encoded)
    : encoded_(std::move(encoded)),
      name_(image.name),
      width_(image.width),
      height_(image.height),
      kept_(std::make_shared<const Image>(std::move(image))),
      lent_(kept_) {}

Pixels::Pixels(const Image& borrowed)
    : borrowed_(true),
      name_(borrowed.name),
      width_(borrowed.width),
      height_(borrowed.height),
      kept_(std::shared_ptr<const Image>(), &borrowed),
      lent_(kept_) {}

std::shared_ptr<const Image> Pixels::get() const {
    std::unique_lock lock(mutex_);
    decoded_.wait(lock, [this] { return !decoding_; });
    if (kept_) return kept_;
    if (std::shared_ptr<const Image> image = lent_.lock()) return image;
    decoding_ = true;
    lock.unlock();
    std::shared_ptr<const Image> image = decoded(encoded_);
    lock.lock();
    decoding_ = false;
    lent_ = image;
    decoded_.notify_all();
    if (!image) throw std::bad_alloc();
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

PixelList copied_pixels(const Organ& organ, const PixelList& former) {
    PixelList list = copied_pixels(organ);
    for (std::size_t i = 0; i < std::min(list.size(), former.size()); ++i) {
        const Image& image = organ.images[i];
        const bool missing = image.pixels.empty() && image.width > 0 && image.height > 0;
        if (missing && former[i] && former[i]->are_of(image)) list[i] = former[i];
    }
    return list;
}

PixelList borrowed_pixels(const Organ& organ) {
    return of_base_colors(organ, [](const Image& image) { return std::make_shared<const Pixels>(image); });
}

void let_go(const PixelList& list) {
    for (const auto& one : list)
        if (one) one->let_go();
}

std::size_t memory_of(const PixelList& list) {
    std::size_t bytes = 0;
    for (const auto& one : list) bytes += one ? one->memory() : 0;
    return bytes;
}

}  // namespace lapfx::organ
