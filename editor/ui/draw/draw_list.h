// What one frame of the UI looks like: a flat list of instances. No OpenGL here: ui/gl/renderer.h draws it, and a test
// can read it.
//
// An instance is 32 bytes: a rectangle (or a line), four 16-bit figures whose meaning depends on the kind, a colour,
// and the index of its clip rectangle. Order is depth: later covers earlier.
#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ui/value/geometry.h"

namespace lapfx::ui {

enum class InstanceKind : std::uint8_t {
    fill,  ///< rectangle with rounded corners; `border` > 0: only a frame of that width, inside the
    ///< rectangle; uv[2] 1: and within it the colour in uv[0..1] (low 16 bits first), which is under the frame, too
    glyph,     ///< coverage from the atlas; uv in texels of it
    line,      ///< x, y to w, h (both ends absolute); uv[0] = width in 1/64 px; round caps
    image,     ///< the batch's image over the whole rectangle; uv in 1/65535 of it; `border` 1: nearest, 0: linear
    gradient,  ///< from `rgba` to the colour in uv[0..1] (low 16 bits first); uv[2]: 0 left to right, 1 top to bottom
    checker,   ///< squares of uv[0] px, `rgba` over the colour in uv[2..3]: what lies behind transparency
    shadow,    ///< a soft rectangle: full inside, gone uv[0] px outside
    compare,   ///< the batch's two images: see CompareInstance in paint/painter.h
};

struct Instance {
    float x = 0, y = 0, w = 0, h = 0;
    std::uint16_t uv[4] = {};
    Color color;
    std::uint8_t radius = 0;  ///< px, at most half the shorter side counts
    std::uint8_t border = 0;
    InstanceKind kind = InstanceKind::fill;
    std::uint8_t clip = 0;  ///< index into the batch's clips
};
static_assert(sizeof(Instance) == 32);

/// A vector of instances that copies many at once as bytes: libstdc++ does so only for types without initialisers, and
/// most of what a frame costs is copying glyphs.
class Instances {
  public:
    Instances() = default;
    Instances(Instances&& other) noexcept
        : items_(std::move(other.items_)),
          size_(std::exchange(other.size_, 0)),
          capacity_(std::exchange(other.capacity_, 0)) {}
    Instances& operator=(Instances&& other) noexcept {
        std::swap(items_, other.items_), std::swap(size_, other.size_), std::swap(capacity_, other.capacity_);
        return *this;
    }
    Instance* data() { return items_.get(); }
    const Instance* data() const { return items_.get(); }
    std::size_t size() const { return size_; }
    std::size_t capacity() const { return capacity_; }
    bool empty() const { return size_ == 0; }
    Instance& operator[](std::size_t i) { return items_[i]; }
    const Instance& operator[](std::size_t i) const { return items_[i]; }
    Instance* begin() { return data(); }
    Instance* end() { return data() + size_; }
    const Instance* begin() const { return data(); }
    const Instance* end() const { return data() + size_; }
    Instance& back() { return items_[size_ - 1]; }
    const Instance& back() const { return items_[size_ - 1]; }
    void clear() { size_ = 0; }
    void shorten(std::size_t size) { size_ = std::min(size, size_); }
    void leave(std::size_t count) { room(count); }  ///< places that are written later, or not at all
    Instance& add() { return *new (room(1)) Instance; }
    Instance* add(std::size_t count) { return room(count); }  ///< the first of so many, to be written by the caller
    /// Returns the first of the copies.
    Instance* add(std::span<const Instance> more) {
        Instance* to = room(more.size());
        std::memcpy(static_cast<void*>(to), more.data(), more.size_bytes());
        return to;
    }

  private:
    Instance* room(std::size_t count) {
        if (size_ + count > capacity_) grow(size_ + count);
        Instance* to = items_.get() + size_;
        size_ += count;
        return to;
    }
    void grow(std::size_t least);

    std::unique_ptr<Instance[]> items_;
    std::size_t size_ = 0, capacity_ = 0;
};

/// A texture that the UI shows. Values below `own_images` are names of OpenGL textures of the host (a viewport, a video
/// frame), already display-encoded; from there on images of an ImageStore. 0 is none.
using ImageHandle = std::uint64_t;
inline constexpr ImageHandle own_images = 1ULL << 32;

/// Instances that are drawn with one call.
struct Batch {
    std::uint32_t first = 0, count = 0;
    std::uint32_t first_clip = 0, clips = 0;  ///< of DrawList::clips; at most 256
    ImageHandle images[2] = {};               ///< of `image` and `compare`
    friend bool operator==(const Batch&, const Batch&) = default;
};

struct Clear {
    Rect rect;
    Color color;
    friend bool operator==(const Clear&, const Clear&) = default;
};

/// A rectangle to which the painter clips.
struct ClipLevel {
    Rect rect;
    std::size_t batch = 0;  ///< number of the batch, from 1, whose table it is in; 0: none yet
    std::uint8_t index = 0;
};

struct DrawList {
    glm::ivec2 size{0};         ///< px of the framebuffer
    std::vector<Clear> clears;  ///< opaque backgrounds, first of all, in order: far cheaper than instances on llvmpipe
    Instances instances;
    std::vector<Rect> clips;
    std::vector<Batch> batches;
    std::vector<std::uint32_t>
        serials;  ///< of the atlas and of the images shown: they grow when what is in them changes

    std::vector<ClipLevel>
        clip_stack;  ///< of the painter, as is `elided`: kept, so that steady frames allocate nothing
    std::string elided;

    void reset(glm::ivec2 frame_size);
};

/// Whether both look the same, so that nothing has to be drawn. What is inside the host's own textures is not known
/// here. Comparing costs a fraction of a hash, which has to multiply for every word.
bool same_picture(const DrawList& a, const DrawList& b);
/// All but the instances, which are as many.
bool same_frame(const DrawList& a, const DrawList& b);

}  // namespace lapfx::ui
