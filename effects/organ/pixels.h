// The pixels of an organ's images. Decoded pixels are most of the memory of a textured organ, so they are kept while
// somebody needs them, and decoded again later if necessary. Any thread.
//
//     Pixels pixels(std::move(image), encoded);
//     pixels.let_go();                           // they have been sent to the GPU
//     const auto image = pixels.get();           // decoded, until `image` goes
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx::organ {

/// The whole file that an image was decoded from (media/image.h); null: it came from elsewhere.
using Encoded = std::shared_ptr<const std::vector<std::uint8_t>>;

/// A texture with a longer side is shrunk while it is read: no preview shows more of it, and the largest that a file
/// may have would take gigabytes.
constexpr int longest_texture = 8192;

/// Decodes the file of a texture into `image`, which has its name, and appends a line to `warnings` if it was shrunk.
/// Returns the reason of a failure, or an empty string.
std::string decode_texture(std::span<const std::uint8_t> file, Image& image, std::vector<std::string>& warnings);

class Pixels {
  public:
    /// Without `encoded` they are always kept.
    Pixels(Image image, Encoded encoded);
    /// Pixels of somebody who outlives this object.
    explicit Pixels(const Image& borrowed);

    /// Always gives the same bytes. Throws std::bad_alloc when there is not enough memory to decode them.
    std::shared_ptr<const Image> get() const;
    /// From now on they are kept only as long as somebody has the result of get().
    void let_go() const;
    /// Bytes, including pixels that are being decoded; borrowed ones do not count. Never waits for a decoder.
    std::size_t memory() const;
    /// Whether they belong to an image of that name and size.
    bool are_of(const Image& image) const {
        return image.name == name_ && image.width == width_ && image.height == height_;
    }

  private:
    const Encoded encoded_;
    const bool borrowed_ = false;
    const std::string name_;
    const int width_, height_;
    mutable std::mutex mutex_;
    mutable std::condition_variable decoded_;
    mutable bool decoding_ = false;  // one thread decodes, without holding the mutex
    mutable std::shared_ptr<const Image> kept_;
    mutable std::weak_ptr<const Image> lent_;
};

/// For each image of an organ. Null: nobody needs it.
using PixelList = std::vector<std::shared_ptr<const Pixels>>;

/// Moves the pixels out of the organ's images, which keep their names and sizes. `encoded`: by image, or empty.
PixelList take_pixels(Organ& organ, const std::vector<Encoded>& encoded);
/// Copies of the base-colour images of an organ that somebody else may free.
PixelList copied_pixels(const Organ& organ);
/// The same for an organ that has replaced another one: an image with a size and without pixels takes those of `former`
/// if index, name and size are the same.
PixelList copied_pixels(const Organ& organ, const PixelList& former);
/// The same for an organ that outlives them.
PixelList borrowed_pixels(const Organ& organ);

void let_go(const PixelList& list);
std::size_t memory_of(const PixelList& list);  ///< bytes

}  // namespace lapfx::organ
