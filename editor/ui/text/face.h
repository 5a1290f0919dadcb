// Font faces: which file draws which character (fontconfig), its outlines (FreeType) and its tables for shaping
// (HarfBuzz). Private to text/.
#pragma once

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <hb.h>
#include <algorithm>

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "ui/text/fonts.h"
#include FT_FREETYPE_H

namespace lapfx::ui {

template <auto destroy>
struct Destroy {
    template <typename T>
    void operator()(T* thing) const {
        destroy(thing);
    }
};
template <typename T, auto destroy>
using Owned = std::unique_ptr<T, Destroy<destroy>>;
using OwnedPattern = Owned<FcPattern, FcPatternDestroy>;

/// A TextStyle as caches use it: the size in quarters of a px, limited.
struct StyleKey {
    /// Not a number compares as false, so it is the smallest.
    explicit StyleKey(const TextStyle& style)
        : quarters(static_cast<std::uint16_t>(style.size > 4 ? std::min(style.size, 400.0F) * 4 + 0.5F : 16.0F)),
          base(static_cast<std::uint8_t>(static_cast<int>(style.weight) * 2 + (style.monospace ? 1 : 0))),
          tabular(style.tabular) {}
    float size() const { return static_cast<float>(quarters) / 4; }
    std::uint64_t bits() const { return std::uint64_t{quarters} << 16 | std::uint64_t{base} << 1 | tabular; }

    std::uint16_t quarters;  ///< 16 to 1600
    std::uint8_t base;       ///< which of Faces' base faces: weight and monospace
    bool tabular;
};

/// How outlines become pixels.
struct Rendering {
    Hinting hinting = Hinting::slight;  ///< never from_system
    bool smooth = true;                 ///< false: black and white
    bool automatic = false;             ///< FreeType's own hinter instead of the font's instructions
};

class Face {
  public:
    /// Throws std::runtime_error when the file is no font with outlines.
    Face(FT_Library library, const std::string& file, int index, const Rendering& rendering, std::uint16_t id);

    bool has(char32_t codepoint) const;
    /// px per unit of the font's design, at a size of the em square in px.
    float scale(float size) const { return size / static_cast<float>(units_per_em_); }
    LineMetrics metrics(float size) const;
    /// Horizontal positions a glyph is drawn at within a px.
    int phases(float size) const;
    /// Coverage of a glyph moved right by phase / phases px. Valid until the next call; no outline or nothing in it:
    /// width 0. `left` and `top` lead from the pen to the upper left corner, y up.
    struct Bitmap {
        int left = 0, top = 0, width = 0, height = 0;
        std::vector<std::uint8_t> coverage;
    };
    const Bitmap& rasterise(std::uint32_t glyph, std::uint16_t size_quarters, int phase);

    hb_font_t* shaping() const { return shaping_.get(); }
    std::uint16_t id() const { return id_; }
    const std::string& file() const { return file_; }
    int index() const { return index_; }  ///< as fontconfig counts
    int widest_digit =
        -1;  ///< design units, with the font's tabular digits if it has them; -1: the shaper has not asked yet

  private:
    std::string file_;
    int index_;
    std::uint16_t id_;
    Rendering rendering_;
    Owned<FT_FaceRec_, FT_Done_Face> outlines_;
    Owned<hb_font_t, hb_font_destroy> shaping_;
    std::uint32_t units_per_em_ = 1000;
    hb_font_extents_t extents_{};  ///< design units
    std::uint16_t size_set_ = 0;   ///< quarters of a px, of outlines_
    Bitmap bitmap_;
};

class Faces {
  public:
    explicit Faces(const FontOptions& options);

    static constexpr int bases = 6;  ///< three weights, each proportional and monospace
    Face& base(std::uint8_t which);
    /// The base face or, where it has not got the character, the first other that has; nullptr: none has it.
    Face* face_of(char32_t codepoint, std::uint8_t base);

  private:
    struct Base {
        Face* face = nullptr;
        OwnedPattern pattern;                          ///< what was asked for
        Owned<FcFontSet, FcFontSetDestroy> others;     ///< all fonts, best first; made when first needed
        std::unordered_map<char32_t, Face*> fallback;  ///< what was looked up in it
    };
    Base& opened(std::uint8_t which);
    const FcFontSet* sorted(Base& base);
    Face* open(FcPattern* font);
    Face* search(Base& base, char32_t codepoint);

    FontOptions options_;
    Owned<FcConfig, FcConfigDestroy> config_;
    Owned<FT_LibraryRec_, FT_Done_FreeType> library_;
    std::vector<std::unique_ptr<Face>> faces_;
    Base bases_[bases];
};

}  // namespace lapfx::ui
