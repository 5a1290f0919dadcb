#include "ui/core/paragraph.h"

#include "ui/value/utf8.h"

namespace lapfx::ui {

namespace {

constexpr float unbounded = 1e30F;            // px
constexpr std::size_t shaped_as_whole = 128;  // bytes

/// Calls `each(line, width)` for every line of `text`, from the top, with all that it ends with. Allocates nothing.
template <typename Each>
void each_line(LineBreaker& breaker, std::string_view text, float width, Each&& each) {
    while (true) {
        const LineBreaker::Line line = breaker.first_line(text, width);
        const std::string_view part = text.substr(0, line.bytes);
        each(part, line.width);
        text.remove_prefix(line.bytes);
        if (text.empty() && !part.ends_with('\n')) return;
    }
}

/// The same of a paragraph. Most lines are short and fit: those are shaped as a whole, as they will be drawn.
template <typename Each>
void each_paragraph_line(Fonts& fonts, std::string_view text, const TextStyle& style, float width, Each&& each) {
    LineBreaker breaker(fonts, style);
    while (true) {
        const std::size_t stop = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, stop);
        const float shaped = stop <= shaped_as_whole ? fonts.run(line, style).width : 2 * unbounded;
        shaped <= width + 0.5F ? each(line, shaped) : each_line(breaker, line, width, each);
        if (stop == text.size()) return;
        text.remove_prefix(stop + 1);
    }
}

}  // namespace

float LineBreaker::width_of(std::string_view character) {
    const auto c = static_cast<unsigned char>(character.front());
    if (c >= 128 || character.size() > 1) return fonts_.run(character, style_).width;
    if (ascii_[c] < 0) ascii_[c] = fonts_.run(character, style_).width;
    return ascii_[c];
}

LineBreaker::Line LineBreaker::first_line(std::string_view text, float width) {
    float x = 0, x_after_space = 0;
    std::size_t after_space = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t bytes = next_character(text, at);
        const std::string_view character = text.substr(at, bytes);
        if (character.front() == '\n') return {at + bytes, x};
        const float next = x + width_of(character);
        const bool is_space = character == " ";  // those at the end may stand out
        if (!is_space && next > width + 0.5F && at > 0)
            return after_space > 0 ? Line{after_space, x_after_space} : Line{at, x};
        x = next, at += bytes;
        if (is_space) after_space = at, x_after_space = x;
    }
    return {text.size(), x};
}

void break_lines(Fonts& fonts, std::string_view text, const TextStyle& style, float width,
                 std::vector<std::uint32_t>& begins) {
    begins.clear();
    std::size_t at = 0;
    LineBreaker breaker(fonts, style);
    each_line(breaker, text, width, [&](std::string_view line, float) {
        begins.push_back(static_cast<std::uint32_t>(at));
        at += line.size();
    });
}

float paragraph_height(Fonts& fonts, std::string_view text, const TextStyle& style, float width) {
    float height = 0;
    const float line = fonts.metrics(style).height;
    each_paragraph_line(fonts, text, style, width, [&](std::string_view, float) { height += line; });
    return height;
}

float paragraph_width(Fonts& fonts, std::string_view text, const TextStyle& style) {
    float widest = 0;
    each_paragraph_line(fonts, text, style, unbounded,
                        [&](std::string_view, float wide) { widest = std::max(widest, wide); });
    return widest;
}

void draw_paragraph(Painter& painter, const Rect& rect, std::string_view text, const TextStyle& style, Color color,
                    Align align) {
    const float height = painter.fonts().metrics(style).height;
    float y = rect.y;
    each_paragraph_line(painter.fonts(), text, style, rect.w, [&](std::string_view part, float) {
        const Rect line{rect.x, y, rect.w, height};
        y += height;
        if (!line.overlaps(painter.clip())) return;
        while (part.ends_with(' ')) part.remove_suffix(1);
        const Run& run = painter.fonts().run(part, style);
        const float beyond = std::max(0.0F, std::ceil(run.width) - rect.w);  // kerning: no reason to cut it
        const float left = align == Align::end ? beyond : align == Align::center ? whole(beyond / 2) : 0.0F;
        painter.text({line.x - left, line.y, line.w + beyond, height}, part, run, style, color, align);
    });
}

}  // namespace lapfx::ui
