// The pictures of glyphs in the atlas: rasterised when first asked for, packed in shelves. Private to text/.
#pragma once

#include <span>
#include <vector>

#include "ui/text/face.h"
#include "ui/text/index_table.h"

namespace lapfx::ui {

/// Places for rectangles in a square, a px apart from each other and from the edge: rows ("shelves") filled from the
/// left.
class Shelves {
  public:
    explicit Shelves(int side) : side_(side) {}

    /// Upper left corner, or {-1, -1} when there is no room.
    glm::ivec2 place(int width, int height);
    void grow(int side) { side_ = side; }
    int side() const { return side_; }
    void clear() { shelves_.clear(); }

  private:
    struct Shelf {
        int y, height, x;
    };
    std::vector<Shelf> shelves_;
    int side_;
};

/// A glyph in the atlas; width 0: nothing to draw. `left` and `top` lead from the pen to its upper left corner, y up.
struct Glyph {
    std::uint16_t u = 0, v = 0, width = 0, height = 0;
    std::int16_t left = 0, top = 0;
};

class Glyphs {
  public:
    Glyphs();

    /// nullptr: the atlas is full.
    const Glyph* find(Face& face, std::uint32_t glyph, std::uint16_t size_quarters, int phase);
    /// For a character that no font has: a box around the hexadecimal digits of its code point, where they can be read.
    const Glyph* box(char32_t codepoint, std::uint16_t size_quarters);
    static float box_advance(char32_t codepoint, std::uint16_t size_quarters);

    const Atlas& atlas() const { return atlas_; }
    void clear_dirty() { atlas_.dirty = {}; }
    bool full() const { return full_; }
    void clear();

  private:
    const Glyph* add(std::uint64_t hash, int left, int top, int width, int height,
                     std::span<const std::uint8_t> pixels);
    void grow();

    Atlas atlas_;
    Shelves shelves_;
    std::vector<Glyph> glyphs_;
    IndexTable table_{1024};
    std::vector<std::uint8_t> box_pixels_;
    bool full_ = false;
};

}  // namespace lapfx::ui
