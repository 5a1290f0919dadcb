// The frame of the reference that is shown: as a texture, in the aspect that the scene gives it, with what was counted
// in it drawn over it where that is wanted, and a second one where the scene places it (SceneReference::placement).
//
//     picture.show_newest();   // another frame has come
//     picture.follow();        // in every build: the placement or what was counted may be others
//     ui::image_view(u, "Video", picture.whole(), view);
//
// UI thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>

#include "app/reference/video_feed.h"
#include "document/document.h"
#include "ui/canvas/pixels.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class ReferencePicture {
  public:
    static constexpr glm::ivec2 without_video{1280, 1024};  ///< px of size_with() as long as there is no frame

    /// All must outlive it.
    ReferencePicture(const VideoFeed& feed, const document::Document& document, ui::ImageStore& images);
    ~ReferencePicture();
    ReferencePicture(const ReferencePicture&) = delete;
    ReferencePicture& operator=(const ReferencePicture&) = delete;

    // --- shown -------------------------------------------------------------------------------------------------------
    /// The newest frame that has come. Its image is 0 while there is none.
    ui::Picture whole() const;
    /// whole() where the scene places it. What is read of a picture is read of the one that is seen: scopes, regions
    /// and the eyedropper take the placed one where both are compared, and black where it has nothing; the reference
    /// alone, what is measured of it, its plate and a proposal of the look are of the video as it is stored: they are
    /// about all of its tissue, wherever that lies.
    ui::Picture placed() const;
    /// placed(), counted in so many pixels.
    ui::Picture placed_in(glm::ivec2 size) const;
    bool is_placed() const;                     ///< placed() is another one than whole()
    glm::ivec2 size() const;                    ///< px of whole(), in the aspect that the scene gives it
    glm::ivec2 size_with(double aspect) const;  ///< the same in this aspect; 0: as stored

    // --- what was counted --------------------------------------------------------------------------------------------
    /// What was counted in the frame that is shown is drawn over it. Colours are read of the frame as it is.
    bool shows_counted = false;
    bool counted_shown() const { return overlaid_by_.second != 0; }
    /// Of the frame at that time, s: a number for what was counted there, 0 for nothing; drawn over the picture unless
    /// it is null (Measuring::counted).
    using Counted = std::function<std::uint64_t(double time, Image* picture)>;
    void set_counted(Counted draws) { count_ = std::move(draws); }

    // --- read --------------------------------------------------------------------------------------------------------
    std::uint64_t number() const { return shown_; }        ///< another one for each picture that has been shown
    const Image& placed_image() const { return placed_; }  ///< where is_placed(): the pixels of placed()
    /// The placement and the aspect; equal as long as the same part of the video lies in the same place.
    using Place = std::tuple<double, double, double, double, double>;
    const Place& place() const { return placed_by_.second; }

    // --- of the reference --------------------------------------------------------------------------------------------
    void show_newest();
    void follow();

  private:
    class Pixels;

    bool has_frame() const { return feed_.frame() >= 0 && !feed_.image().pixels.empty(); }
    std::uint64_t counted_now(Image* picture) const;
    void upload();
    void follow_counted();
    void place_newest();

    const VideoFeed& feed_;
    const document::Document& document_;
    ui::ImageStore& images_;
    std::unique_ptr<Pixels> pixels_, stored_pixels_, placed_pixels_;
    ui::ImageHandle image_ = 0, placed_image_ = 0;
    std::uint64_t shown_ = 0;  ///< how many pictures have been shown
    Counted count_;
    Image overlaid_;                                         ///< the frame with what was counted, where counted_shown()
    std::pair<std::uint64_t, std::uint64_t> overlaid_by_{};  ///< number of the frame, and of what is drawn over it
    Image placed_;
    std::pair<std::uint64_t, Place> placed_by_{};  ///< number of the frame, and where it lies
};

}  // namespace lapfx::app
