#include "ui/core/paragraph.h"

namespace lapfx::ui {

float paragraph_height(Fonts& fonts, std::string_view text, const TextStyle& style, float width) {
    float height = 0;
    const float line = fonts.metrics(style).height;
    each_line(fonts, text, style, width, [&](std::string_view) { height += line; });
    return height;
}

float paragraph_width(Fonts& fonts, std::string_view text, const TextStyle& style) {
    float width = 0;
    each_line(fonts, text, style, 1e9F,
              [&](std::string_view line) { width = std::max(width, fonts.run(line, style).width); });
    return width;
}

void draw_paragraph(Painter& painter, const Rect& rect, std::string_view text, const TextStyle& style, Color color,
                    Align align) {
    const float height = painter.fonts().metrics(style).height;
    Rect line{rect.x, rect.y, rect.w, height};
    each_line(painter.fonts(), text, style, rect.w, [&](std::string_view part) {
        painter.text(line, part, style, color, align);
        line.y += height;
    });
}

}  // namespace lapfx::ui
