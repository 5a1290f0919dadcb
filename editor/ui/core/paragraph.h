// Text of more than one line: broken at spaces and line breaks, words that are too long anywhere.
#pragma once

#include <array>
#include <vector>

#include "ui/paint/painter.h"

namespace lapfx::ui {

/// Finds where lines end, in one style. It goes by the widths of single characters, so that a long text is never shaped
/// as a whole, let alone once for every line of it; kerning makes a line differ from that by a pixel or two.
class LineBreaker {
  public:
    LineBreaker(Fonts& fonts, const TextStyle& style) : fonts_(fonts), style_(style) { ascii_.fill(-1); }
    struct Line {
        std::size_t bytes;  ///< the spaces or the line break at its end are counted, too
        float width;        ///< px, of its spaces too
    };
    /// How much of `text` fits into a line of `width` px; at least one character.
    Line first_line(std::string_view text, float width);

  private:
    float width_of(std::string_view character);

    Fonts& fonts_;
    TextStyle style_;
    std::array<float, 128> ascii_;
};

/// Finds the bytes at which the lines of `text` begin if none may be wider than `width` px. There is at least one line;
/// the first begins at 0. Lines end after spaces, which may extend over the edge, else anywhere between characters. A
/// line break always starts another line.
void break_lines(Fonts& fonts, std::string_view text, const TextStyle& style, float width,
                 std::vector<std::uint32_t>& begins);

/// px. The same lines as break_lines() makes.
float paragraph_height(Fonts& fonts, std::string_view text, const TextStyle& style, float width);
/// px of the longest line when only line breaks break it.
float paragraph_width(Fonts& fonts, std::string_view text, const TextStyle& style);
void draw_paragraph(Painter& painter, const Rect& rect, std::string_view text, const TextStyle& style, Color color,
                    Align align = Align::start);

}  // namespace lapfx::ui
