#include "app/reference/reference_picture.h"

#include "app/preview/pick_color.h"
#include "lapfx/authoring/placed_picture.h"

namespace lapfx::app {

/// The frame that is shown; with a size, it is sampled as if it had that many pixels.
class ReferencePicture::Pixels : public ui::PickSource {
  public:
    explicit Pixels(std::function<const Image&()> image) : image_(std::move(image)) {}
    glm::ivec2 size{0};
    glm::vec4 pixel(glm::ivec2 at) const override {
        const Image& image = image_();
        if (size.x < 1 || size.y < 1) return pixel_of(image, at);
        const glm::dvec2 scale = glm::dvec2(image.width, image.height) / glm::dvec2(size);
        return pixel_of(image, glm::ivec2((glm::dvec2(at) + 0.5) * scale));
    }

  private:
    const std::function<const Image&()> image_;
};

ReferencePicture::ReferencePicture(const VideoFeed& feed, const document::Document& document, ui::ImageStore& images)
    : feed_(feed),
      document_(document),
      images_(images),
      pixels_(std::make_unique<Pixels>([this]() -> const Image& { return feed_.image(); })),
      stored_pixels_(std::make_unique<Pixels>([this]() -> const Image& { return feed_.image(); })),
      placed_pixels_(std::make_unique<Pixels>([this]() -> const Image& { return placed_; })) {}

ReferencePicture::~ReferencePicture() {
    if (image_ != 0) images_.remove(image_);
    if (placed_image_ != 0) images_.remove(placed_image_);
}

void ReferencePicture::show_newest() {
    if (!has_frame()) return;
    ++shown_;
    upload();
    place_newest();
}

void ReferencePicture::follow() {
    follow_counted();
    place_newest();
}

/// 0 where it is not wanted, too.
std::uint64_t ReferencePicture::counted_now(Image* picture) const {
    return shows_counted && count_ ? count_(feed_.video()->time_of(feed_.frame()), picture) : 0;
}

/// With what was counted in it, where that is wanted and known.
void ReferencePicture::upload() {
    const Image* image = &feed_.image();
    if (shows_counted && count_) overlaid_ = feed_.image();
    overlaid_by_ = {shown_, counted_now(&overlaid_)};
    if (counted_shown()) image = &overlaid_;
    const glm::ivec2 size(image->width, image->height);
    if (image_ == 0)
        image_ = images_.add(size, image->pixels);
    else
        images_.update(image_, size, image->pixels);
}

/// It was switched, or has been measured.
void ReferencePicture::follow_counted() {
    if (!has_frame() || feed_.video() == nullptr) return;
    if (overlaid_by_ == std::pair(shown_, counted_now(nullptr))) return;
    upload();
    placed_by_.first = 0;  // it is placed again
}

bool ReferencePicture::is_placed() const {
    return document_.scene().reference.placement.moved() && placed_image_ != 0;
}

/// Made anew when the frame, the scene's placement or the shape has changed.
void ReferencePicture::place_newest() {
    const Image& image = feed_.image();
    const ReferencePlacement& now = document_.scene().reference.placement;
    const glm::dvec2 shape(size());
    const double aspect = shape.x / shape.y;
    const std::pair by{feed_.frame() < 0 ? 0 : shown_, Place{now.right, now.up, now.scale, now.rotation, aspect}};
    if (by == placed_by_) return;
    const bool same_frame = by.first == placed_by_.first;
    placed_by_ = by;
    if (same_frame) placed_by_.first = ++shown_;  // scopes count it again
    if (!now.moved() || !has_frame()) return;
    placed_ = lapfx::placed(image, now, aspect);
    Image with_counted;
    if (counted_shown()) with_counted = lapfx::placed(overlaid_, now, aspect);
    const Image& shown = counted_shown() ? with_counted : placed_;
    const glm::ivec2 size(shown.width, shown.height);
    placed_image_ != 0 ? images_.update(placed_image_, size, shown.pixels)
                       : void(placed_image_ = images_.add(size, shown.pixels));
}

ui::Picture ReferencePicture::whole() const {
    if (feed_.frame() < 0 || image_ == 0) return {};
    pixels_->size = size();
    return {.image = image_, .size = size(), .pixels = pixels_.get()};
}

ui::Picture ReferencePicture::placed() const {
    ui::Picture shown = whole();
    if (shown.image != 0 && is_placed()) shown.image = placed_image_;
    return shown;
}

ui::Picture ReferencePicture::placed_in(glm::ivec2 size) const {
    Pixels& pixels = is_placed() ? *placed_pixels_ : *stored_pixels_;
    pixels.size = size;
    return {.image = is_placed() ? placed_image_ : image_, .size = size, .pixels = &pixels};
}

glm::ivec2 ReferencePicture::size() const {
    return size_with(document_.scene().reference.aspect);
}

/// The side that is stretched grows, so that no pixel is lost.
glm::ivec2 ReferencePicture::size_with(double aspect) const {
    if (feed_.image().width < 1) return without_video;  // that of `lapfx render`
    const glm::dvec2 stored = glm::max(glm::dvec2(feed_.image().width, feed_.image().height), glm::dvec2(1));
    if (!(aspect > 0)) return glm::ivec2(stored);
    return glm::max(glm::ivec2(glm::round(glm::max(stored, {stored.y * aspect, stored.x / aspect}))), glm::ivec2(1));
}

}  // namespace lapfx::app
