// The pixels of an organ's images. Decoded they are the most of a textured organ: they are kept while somebody needs
// them, and decoded once more when somebody does again. Any thread.
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
#include <string>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx::organ {

/// A whole file that an image was decoded from (media/image.h); null: it came from elsewhere.
using Encoded = std::shared_ptr<const std::vector<std::uint8_t>>;

class Pixels {
  public:
    /// Without `encoded` they are kept for good.
    Pixels(Image image, Encoded encoded);
    /// Of somebody who outlives it.
    explicit Pixels(const Image& borrowed);

    /// The same bytes whenever it is asked for. Throws std::bad_alloc where there is no memory to decode them.
    std::shared_ptr<const Image> get() const;
    /// From now on they are kept as long as somebody has what get() gave.
    void let_go() const;
    /// Bytes, those that are decoded just now among them; borrowed ones are not counted. Never waits for a decoder.
    std::size_t memory() const;
    /// Whether they are an image's of that name and size.
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
    mutable bool decoding_ = false;  // by one thread, which does not hold the mutex meanwhile
    mutable std::shared_ptr<const Image> kept_;
    mutable std::weak_ptr<const Image> lent_;
};

/// By image of an organ. Null: nobody asks for it.
using PixelList = std::vector<std::shared_ptr<const Pixels>>;

/// Takes the pixels out of the organ's images, whose names and sizes stay. `encoded`: by image, or empty.
PixelList take_pixels(Organ& organ, const std::vector<Encoded>& encoded);
/// Copies of the base-colour images of an organ that somebody else may free.
PixelList copied_pixels(const Organ& organ);
/// The same of an organ that has taken another one's place: an image with a size and no pixels has those of `former` if
/// index, name and size are the same.
PixelList copied_pixels(const Organ& organ, const PixelList& former);
/// The same of an organ that outlives them.
PixelList borrowed_pixels(const Organ& organ);

void let_go(const PixelList& list);
std::size_t memory_of(const PixelList& list);  ///< bytes

}  // namespace lapfx::organ
