// Text of more than one line: broken at spaces and line breaks, words that are too long anywhere.
#pragma once

#include "ui/draw/painter.h"

namespace lapfx::ui {

/// Calls `each(line)` for every line of `text` within `width` px, from the top.
template <typename Each>
void each_line(Fonts& fonts, std::string_view text, const TextStyle& style, float width, Each&& each);

float paragraph_height(Fonts& fonts, std::string_view text, const TextStyle& style, float width);
/// px of the longest line when only line breaks break it.
float paragraph_width(Fonts& fonts, std::string_view text, const TextStyle& style);
void draw_paragraph(Painter& painter, const Rect& rect, std::string_view text, const TextStyle& style, Color color,
                    Align align = Align::start);

template <typename Each>
void each_line(Fonts& fonts, std::string_view text, const TextStyle& style, float width, Each&& each) {
    while (true) {
        const std::size_t stop = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, stop);
        do {
            const Run& run = fonts.run(line, style);
            std::size_t fits = run.width <= width + 0.5F ? line.size() : run.bytes_within(width);
            if (fits < line.size()) {
                const std::size_t space = line.rfind(' ', fits);
                if (space != std::string_view::npos && space > 0) fits = space;
                if (fits == 0) fits = run.stops.size() > 1 ? run.stops[1].byte : line.size();  // narrower than a letter
            }
            each(line.substr(0, fits));
            line.remove_prefix(std::min(fits, line.size()));
            while (line.starts_with(' ')) line.remove_prefix(1);
        } while (!line.empty());
        if (stop == text.size()) return;
        text.remove_prefix(stop + 1);
    }
}

}  // namespace lapfx::ui
