// A decoded frame of a clip in main memory. Plain data.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace lapfx::media {

enum class Layout {
    planar,  ///< luma plane; then Cb and Cr interleaved at half of the rows and columns, rounded up; 8 bit, 4:2:0
    rgb,     ///< R, G, B interleaved: the paper's raw RGB
};

/// What a picture's bytes are: planes one after the other, rows from the top, tightly packed; alpha last.
struct PictureFormat {
    glm::ivec2 size{0};  ///< pixels
    Layout layout = Layout::planar;
    bool alpha = false;  ///< a plane of opacity, 0..255, follows

    friend bool operator==(const PictureFormat&, const PictureFormat&) = default;
    glm::ivec2 chroma_size() const { return (size + 1) / 2; }
    std::size_t color_bytes() const { return area(size) * (layout == Layout::rgb ? 3 : 1); }
    std::size_t chroma_bytes() const { return layout == Layout::rgb ? 0 : 2 * area(chroma_size()); }
    std::size_t alpha_bytes() const { return alpha ? area(size) : 0; }
    std::size_t bytes() const { return color_bytes() + chroma_bytes() + alpha_bytes(); }

  private:
    static std::size_t area(glm::ivec2 s) { return static_cast<std::size_t>(s.x) * static_cast<std::size_t>(s.y); }
};

/// `bytes` has PictureFormat::bytes() elements, or none before it was first written; memory is kept for the next frame.
struct Picture {
    std::vector<std::uint8_t> bytes;
};

/// From code values of a clip's planes, 0..255, to R'G'B' code values 0..255: rgb = matrix * (ycbcr - offset). From the
/// clip's own colour space and range.
struct ColorMatrix {
    glm::mat3 matrix{1.0f};
    glm::vec3 offset{0.0f};
};

/// `red`, `blue`: the luma coefficients Kr and Kb (ITU-R BT.601: 0.299, 0.114; BT.709: 0.2126, 0.0722).
ColorMatrix color_matrix(float red, float blue, bool full_range);

}  // namespace lapfx::media
