// Text: faces found by fontconfig, shaped by HarfBuzz, rasterised by FreeType at the size they are shown at, kept in
// one atlas.
//
//     ui::Fonts fonts({.family = "Inter"});
//     const ui::Run& run = fonts.run("12.5 mm/s", {.size = 14, .tabular = true});
//
// One thread. Run references stay valid until the next call of next_frame().
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/draw/draw_list.h"

namespace lapfx::ui {

enum class Weight : std::uint8_t { regular, medium, bold };

struct TextStyle {
    float size = 14;  ///< px of the em square; 4 to 400, others are clamped
    Weight weight = Weight::regular;
    bool tabular = false;  ///< all digits as wide as each other: values do not dance
    bool monospace = false;
    friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

/// Whole px: lines stay on the pixel grid.
struct LineMetrics {
    float ascent = 0, descent = 0, height = 0;  ///< descent is positive, below the baseline
};

/// A place that the caret can have.
struct CaretStop {
    std::uint32_t byte = 0;  ///< offset into the text
    float x = 0;             ///< px from the start of the run
};

/// A run holds so much of a longer text, so that a pasted megabyte does not stop the frame. Its last stop is where the
/// text was cut.
inline constexpr std::size_t max_run_bytes = 16384;

/// One line of text, shaped, always from left to right. Tabs are drawn as spaces, other control characters and bytes
/// that are no UTF-8 as U+FFFD.
struct Run {
    std::vector<Instance>
        glyphs;  ///< kind glyph; x from the start of the run, y from the baseline; colour and clip not set
    std::vector<CaretStop> stops;  ///< ascending, from {0, 0} to {text.size(), width}: one a grapheme cluster at most
    LineMetrics metrics;           ///< of its style
    Rect ink{};                    ///< px around all glyphs, from the start of the run and the baseline
    float width = 0;               ///< px, not rounded

    float x_of(std::size_t byte) const;           ///< of the stop at or before
    std::size_t byte_at(float x) const;           ///< the nearest stop
    std::size_t bytes_within(float width) const;  ///< the most of the text, cut at a stop, that is no wider
};

enum class Hinting : std::uint8_t { from_system, none, slight, full };

struct FontOptions {
    std::string family =
        "Inter";  ///< fontconfig finds the nearest when it is missing; for other scripts, the best fallback
    std::string monospace = "DejaVu Sans Mono";
    Hinting hinting = Hinting::from_system;  ///< tests name one, so that they do not depend on the host
};

/// Coverage, 8 bits a texel.
struct Atlas {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> pixels;
    std::uint32_t serial = 0;  ///< grows with every change
    std::uint32_t resets = 0;  ///< grows when the size or places of glyphs changed: everything has to be sent again
    glm::ivec4 dirty{0};       ///< x0, y0, x1, y1 changed since clear_dirty()
};

class Fonts {
  public:
    /// Throws std::runtime_error when the system has no font at all.
    explicit Fonts(const FontOptions& options = {});
    ~Fonts();
    Fonts(const Fonts&) = delete;
    Fonts& operator=(const Fonts&) = delete;

    /// Cached: the second call with the same text and style allocates nothing.
    const Run& run(std::string_view text, const TextStyle& style);
    LineMetrics metrics(const TextStyle& style);
    /// Drops runs that have not been used for long. Packs a full atlas again, which never happens in the middle of a
    /// frame.
    void next_frame();
    const Atlas& atlas() const;
    /// The atlas had no room for some letters; they come after next_frame().
    bool full() const;
    void clear_dirty();
    /// File name of the face that draws this code point, for tests and `lapfx gallery`; empty: none has it.
    std::string file_for(char32_t codepoint, const TextStyle& style = {});

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace lapfx::ui
