#include "ui/text/glyphs.h"

#include <algorithm>

namespace lapfx::ui {

namespace {

constexpr int first_side = 1024, last_side = 2048;
constexpr std::uint64_t box_face = 0xffff;

/// One step of mixing (Fibonacci hashing); different values stay different.
std::uint64_t mixed(std::uint64_t value) {
    value *= 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio
    return value ^ (value >> 32);
}

/// Different for all that looks different.
std::uint64_t key_of(std::uint64_t face, std::uint32_t glyph, std::uint16_t size_quarters, int phase) {
    const std::uint64_t key =
        face << 48 | std::uint64_t{glyph} << 16 | std::uint64_t{size_quarters} << 2 | static_cast<std::uint64_t>(phase);
    return mixed(mixed(key));  // one to one, so the hash stands for the key
}

// Rows of 3 px from the top, 3 bits each, of the digits 0 to F.
constexpr std::uint16_t digit_rows[16] = {
    0b111'101'101'101'111, 0b010'110'010'010'111, 0b111'001'111'100'111, 0b111'001'011'001'111,
    0b101'101'111'001'001, 0b111'100'111'001'111, 0b111'100'111'101'111, 0b111'001'010'010'010,
    0b111'101'111'101'111, 0b111'101'111'001'111, 0b010'101'111'101'101, 0b110'101'110'101'110,
    0b111'100'100'100'111, 0b110'101'101'101'110, 0b111'100'110'100'111, 0b111'100'110'100'100};

/// Two rows of digits within a frame, one dot between all of them.
struct Box {
    Box(char32_t codepoint, std::uint16_t size_quarters)
        : columns(codepoint > 0xffff ? 3 : 2), dot(size_quarters < 44 ? 0 : std::max(1, size_quarters / 56)) {
        // Below 11 px nobody could read them: an empty box in the proportions of a letter.
        width = dot > 0 ? (columns * 4 + 3) * dot : size_quarters / 8 + 1;
        height = dot > 0 ? 15 * dot : size_quarters * 3 / 16 + 1;
    }
    int columns, dot;  ///< dot: px of a dot of the digits; 0: without digits
    int width, height;
};

}  // namespace

glm::ivec2 Shelves::place(int width, int height) {
    Shelf* best = nullptr;
    for (Shelf& shelf : shelves_) {
        if (shelf.height < height || side_ - shelf.x - 1 < width) continue;
        if (best == nullptr || shelf.height < best->height) best = &shelf;
    }
    const int bottom = shelves_.empty() ? 1 : shelves_.back().y + shelves_.back().height + 1;
    // A shelf of its own, unless one fits well enough or the square is used up. Heights in steps keep shelves few.
    const int own_height = std::min((height + 3) & ~3, side_ - bottom - 1);
    const bool room = own_height >= height && width + 2 <= side_;
    if (room && (best == nullptr || best->height > own_height + own_height / 4)) {
        best = &shelves_.emplace_back(Shelf{bottom, own_height, 1});
    }
    if (best == nullptr) return {-1, -1};
    const glm::ivec2 corner{best->x, best->y};
    best->x += width + 1;
    return corner;
}

Glyphs::Glyphs() : shelves_(first_side) {
    atlas_.size = glm::ivec2(first_side);
    atlas_.pixels.resize(std::size_t{first_side} * first_side);
    glyphs_.reserve(512);
}

const Glyph* Glyphs::find(Face& face, std::uint32_t glyph, std::uint16_t size_quarters, int phase) {
    const std::uint64_t hash = key_of(face.id(), glyph, size_quarters, phase);
    const std::uint32_t known = table_.find(hash, [](std::uint32_t) { return true; });
    if (known != IndexTable::none) return &glyphs_[known];
    const Face::Bitmap& bitmap = face.rasterise(glyph, size_quarters, phase);
    return add(hash, bitmap.left, bitmap.top, bitmap.width, bitmap.height, bitmap.coverage);
}

float Glyphs::box_advance(char32_t codepoint, std::uint16_t size_quarters) {
    const Box box(codepoint, size_quarters);
    return static_cast<float>(box.width + 2 * std::max(1, box.dot));
}

const Glyph* Glyphs::box(char32_t codepoint, std::uint16_t size_quarters) {
    const std::uint64_t hash = key_of(box_face, codepoint, size_quarters, 0);
    const std::uint32_t known = table_.find(hash, [](std::uint32_t) { return true; });
    if (known != IndexTable::none) return &glyphs_[known];

    const Box box(codepoint, size_quarters);
    const int line = std::max(1, box.dot);
    box_pixels_.assign(static_cast<std::size_t>(box.width * box.height), 0);
    const auto fill = [&](int x0, int y0, int x1, int y1) {
        for (int y = y0; y < y1; ++y) {
            std::fill_n(box_pixels_.begin() + y * box.width + x0, x1 - x0, std::uint8_t{255});
        }
    };
    fill(0, 0, box.width, line);
    fill(0, box.height - line, box.width, box.height);
    fill(0, 0, line, box.height);
    fill(box.width - line, 0, box.width, box.height);
    for (int i = 0; i < (box.dot > 0 ? 2 * box.columns : 0); ++i) {
        const unsigned rows = digit_rows[codepoint >> (4 * (2 * box.columns - 1 - i)) & 0xf];
        const int left = 2 + i % box.columns * 4, top = 2 + i / box.columns * 6;
        for (int bit = 0; bit < 15; ++bit) {
            if ((rows >> (14 - bit) & 1) == 0) continue;
            const int x = (left + bit % 3) * box.dot, y = (top + bit / 3) * box.dot;
            fill(x, y, x + box.dot, y + box.dot);
        }
    }
    // In the middle of capitals, whose height is about 0.72 of the size.
    const int top = (size_quarters * 18 / 100 + box.height + 1) / 2;
    return add(hash, line, top, box.width, box.height, box_pixels_);
}

const Glyph* Glyphs::add(std::uint64_t hash, int left, int top, int width, int height,
                         std::span<const std::uint8_t> pixels) {
    // A glyph that would not even fit into an empty atlas (words as one character, at 400 px) is never drawn.
    if (width > last_side - 2 || height > last_side - 2) width = height = 0;
    Glyph glyph{.left = static_cast<std::int16_t>(left), .top = static_cast<std::int16_t>(top)};
    if (width > 0 && height > 0) {
        glm::ivec2 corner = shelves_.place(width, height);
        if (corner.x < 0 && shelves_.side() < last_side) {
            grow();
            corner = shelves_.place(width, height);
        }
        if (corner.x < 0) {
            full_ = true;
            return nullptr;
        }
        glyph.u = static_cast<std::uint16_t>(corner.x), glyph.v = static_cast<std::uint16_t>(corner.y);
        glyph.width = static_cast<std::uint16_t>(width), glyph.height = static_cast<std::uint16_t>(height);
        for (int y = 0; y < height; ++y) {
            std::copy_n(pixels.begin() + std::ptrdiff_t{y} * width, width,
                        atlas_.pixels.begin() + std::ptrdiff_t{corner.y + y} * atlas_.size.x + corner.x);
        }
        glm::ivec4& dirty = atlas_.dirty;
        const glm::ivec4 now(corner, corner + glm::ivec2(width, height));
        dirty = dirty.z == 0 ? now
                             : glm::ivec4(glm::min(glm::ivec2(dirty), corner),
                                          glm::max(glm::ivec2(dirty.z, dirty.w), glm::ivec2(now.z, now.w)));
        ++atlas_.serial;
    }
    table_.insert(hash, static_cast<std::uint32_t>(glyphs_.size()));
    return &glyphs_.emplace_back(glyph);
}

void Glyphs::grow() {
    std::vector<std::uint8_t> pixels(std::size_t{last_side} * last_side);
    for (int y = 0; y < atlas_.size.y; ++y) {
        std::copy_n(atlas_.pixels.begin() + std::ptrdiff_t{y} * atlas_.size.x, atlas_.size.x,
                    pixels.begin() + std::ptrdiff_t{y} * last_side);
    }
    atlas_.pixels.swap(pixels);
    atlas_.size = glm::ivec2(last_side);
    atlas_.dirty = {0, 0, last_side, last_side};
    ++atlas_.serial, ++atlas_.resets;
    shelves_.grow(last_side);
}

void Glyphs::clear() {
    std::fill(atlas_.pixels.begin(), atlas_.pixels.end(), std::uint8_t{0});
    atlas_.dirty = {0, 0, atlas_.size.x, atlas_.size.y};
    ++atlas_.serial, ++atlas_.resets;
    shelves_.clear();
    glyphs_.clear();
    table_.clear();
    full_ = false;
}

}  // namespace lapfx::ui
