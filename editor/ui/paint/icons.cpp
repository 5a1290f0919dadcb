// Icons as strokes on a grid of 24 by 24, one string an icon. A part is a letter and digits, each of which (0-9, then a
// = 10 to o = 24 and on) is one coordinate:
//     L x y x y ...   open polyline     Z x y x y ...   closed one   P x y x y ...   filled polygon
//     O x y r         circle            D x y r         disc         A x y r from to arc, 24ths of a turn
//     B x0 y0 x1 y1   solid rectangle   F x0 y0 x1 y1   its frame                    clockwise from the right
#include <array>

#include "ui/paint/painter.h"
#include "ui/value/closed_list.h"

namespace lapfx::ui {

namespace {

constexpr float grid = 24;
constexpr std::size_t most_points = 16;  // a part has no more, and an arc as drawn has no more

constexpr struct {
    Icon value;
    std::string_view name;
    const char* drawing;
} icons[] = {
    {Icon::none, "none", ""},
    {Icon::check, "check", "L4d9ik7"},
    {Icon::minus, "minus", "L5cjc"},
    {Icon::plus, "plus", "L5cjc Lc5cj"},
    {Icon::cross, "cross", "L66ii Li66i"},
    {Icon::chevron_right, "chevron right", "L95gc9j"},
    {Icon::chevron_down, "chevron down", "L59cgj9"},
    {Icon::chevron_up, "chevron up", "L5fc8jf"},
    {Icon::chevron_left, "chevron left", "Lf58cfj"},
    {Icon::search, "search", "Oaa7 Lffll"},
    {Icon::dot, "dot", "Dcc4"},
    {Icon::menu, "menu", "L46k6 L4ckc L4iki"},
    {Icon::lock, "lock", "B5bjl L8b88 Lgbg8 Ac84co"},
    {Icon::unlock, "unlock", "B5bjl L8b87 Ac74cn"},
    {Icon::play, "play", "P84jc8k"},
    {Icon::pause, "pause", "B64ak Be4ik"},
    {Icon::loop, "loop", "L4c47j7 Lf3j7fb Lkckh5h L9d5h9l"},
    {Icon::step_back, "step back", "B447k Pj5jj9c"},
    {Icon::step_forward, "step forward", "Bh4kk P555jfc"},
    {Icon::star, "star", "Zc2f9m9geilch6l8e2999"},
    {Icon::star_filled, "star filled", "Pc2f9m9geilch6l8e2999"},
    {Icon::undo, "undo", "L93489d L48e8 Aee6iu Lek8k"},
    {Icon::folder, "folder", "Z3595b8l8lj3j"},
    {Icon::file, "file", "Z53d3j9jl5l Ld3d9j9"},
    {Icon::eye, "eye", "Z2c4986c5g6k9mckfgicj8i4f Dcc3"},
    {Icon::eyedropper, "eyedropper", "Z3l4hd8gb7k Lb6id Di63"},
    {Icon::warning, "warning", "Zc3ml2l Lc9cf Lcici"},
    {Icon::error, "error", "Occa L88gg Lg88g"},
    {Icon::info, "info", "Occa Lcbch Lc7c7"},
    {Icon::reset, "reset", "Acc8ey L434898"},
    {Icon::copy, "copy", "F88ll Lg8g3333g8g"},
    {Icon::dice, "dice", "F33ll D882 Dcc2 Dgg2"},
    {Icon::link, "link", "A7c46i L78a8 L7gag Ahc4iu Le8h8 Leghg L8cgc"},
    {Icon::gear, "gear", "Occ7 Dcc2 Lc2c5 Lcjcm L2c5c Ljcmc L5577 Lhhjj Lj5h7 L7h5j"},
    {Icon::image, "image", "F34lk L4i9cdggdki Dg92"},
    {Icon::sort_up, "sort up", "P5gc8jg"},
    {Icon::sort_down, "sort down", "P58cgj8"},
};
static_assert(is_whole(icons) && std::size(icons) == icon_count);

int digit(char c) {
    return c <= '9' ? c - '0' : c - 'a' + 10;
}

using Points = std::array<glm::vec2, most_points>;

/// Puts the parts of one icon onto the pixels of one square.
class IconPen {
  public:
    IconPen(Painter& painter, const Rect& rect, Color color)
        : painter_(painter), color_(color), side_(std::floor(std::min(rect.w, rect.h))) {
        origin_ = glm::round(rect.center() - side_ / 2);
        unit_ = side_ / grid;
        whole_stroke_ = std::max(1.0F, std::round(0.09F * side_));
        stroke_ =
            std::max(1.2F, (0.09F * side_ + whole_stroke_) / 2);  // slanted ones need no whole px, but the same weight
    }

    void part(char kind, std::span<const int> v) {
        switch (kind) {
            case 'L':
                return lines(v, false);
            case 'Z':
                return lines(v, true);
            case 'P':
                return polygon(v);
            case 'O':
                return painter_.frame(round_box(v), color_, whole_stroke_, side_);
            case 'D':
                return painter_.fill(round_box(v), color_, side_);
            case 'A':
                return arc(v);
            case 'B':
                return painter_.fill(box(v), color_, whole_stroke_ / 2);
            default:
                return painter_.frame(box(v), color_, whole_stroke_, whole_stroke_);
        }
    }

  private:
    glm::vec2 at(int x, int y) const { return origin_ + unit_ * glm::vec2(x, y); }
    /// The nearest centre with which both edges of a straight stroke are between pixels.
    float crisp(float center) const { return std::round(center - whole_stroke_ / 2) + whole_stroke_ / 2; }

    Rect box(std::span<const int> v) const {
        const glm::vec2 low = glm::round(at(v[0], v[1])), high = glm::round(at(v[2], v[3]));
        return {low.x, low.y, high.x - low.x, high.y - low.y};
    }
    Rect round_box(std::span<const int> v) const {
        const float across = std::max(1.0F, std::round(2 * unit_ * static_cast<float>(v[2])));
        const glm::vec2 low = glm::round(at(v[0], v[1]) - across / 2);
        return {low.x, low.y, across, across};
    }

    /// Upright and level strokes, and only they, go to whole pixels; what is joined to them follows.
    void lines(std::span<const int> v, bool closed) {
        const std::size_t count = v.size() / 2, segments = closed ? count : count - 1;
        Points points;
        for (std::size_t i = 0; i < count; ++i) points[i] = at(v[2 * i], v[2 * i + 1]);
        for (std::size_t i = 0; i < segments; ++i) {
            const std::size_t j = (i + 1) % count;
            if (v[2 * i] == v[2 * j]) points[i].x = points[j].x = crisp(at(v[2 * i], 0).x);
            if (v[2 * i + 1] == v[2 * j + 1]) points[i].y = points[j].y = crisp(at(0, v[2 * i + 1]).y);
        }
        for (std::size_t i = 0; i < segments; ++i) {
            const glm::vec2 from = points[i], to = points[(i + 1) % count];
            painter_.line(from, to, from.x == to.x || from.y == to.y ? whole_stroke_ : stroke_, color_);
        }
    }

    void arc(std::span<const int> v) {
        const float whole_turn = 6.2831853F, radius = unit_ * static_cast<float>(v[2]);
        const glm::vec2 center(crisp(at(v[0], v[1]).x + radius) - radius, crisp(at(v[0], v[1]).y + radius) - radius);
        const float from = static_cast<float>(v[3]) / 24, turns = static_cast<float>(v[4] - v[3]) / 24;
        const std::size_t segments = std::min(
            most_points - 1, static_cast<std::size_t>(std::ceil(turns * (8 + side_ / 4))));  // 0.2 px off at most
        Points points;
        for (std::size_t i = 0; i <= segments; ++i) {
            const float angle = whole_turn * (from + turns * static_cast<float>(i) / static_cast<float>(segments));
            points[i] = center + radius * glm::vec2(std::cos(angle), std::sin(angle));
        }
        painter_.polyline(std::span(points).first(segments + 1), stroke_, color_);
    }

    /// A bar for each row of pixels, and a thin outline that makes the edges smooth.
    void polygon(std::span<const int> v) {
        const std::size_t count = v.size() / 2;
        Points points;
        for (std::size_t i = 0; i < count; ++i) points[i] = at(v[2 * i], v[2 * i + 1]);
        for (float row = origin_.y; row < origin_.y + side_; ++row) {
            std::array<float, most_points> crossings;
            std::size_t found = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const glm::vec2 a = points[i], b = points[(i + 1) % count];
                if ((a.y <= row + 0.5F) == (b.y <= row + 0.5F)) continue;
                crossings[found++] = glm::mix(a.x, b.x, (row + 0.5F - a.y) / (b.y - a.y));
            }
            std::sort(crossings.begin(), crossings.begin() + static_cast<std::ptrdiff_t>(found));
            for (std::size_t i = 0; i + 1 < found; i += 2) {
                painter_.fill({crossings[i], row, crossings[i + 1] - crossings[i], 1}, color_);
            }
        }
        for (std::size_t i = 0; i < count; ++i) painter_.line(points[i], points[(i + 1) % count], 1, color_);
    }

    Painter& painter_;
    Color color_;
    float side_, unit_ = 1, stroke_ = 1, whole_stroke_ = 1;
    glm::vec2 origin_{0};
};

}  // namespace

std::string_view name_of(Icon icon) {
    return icons[static_cast<std::size_t>(icon)].name;
}

void Painter::icon(const Rect& rect, Icon icon, Color color) {
    if (color.a == 0 || hidden(rect)) return;
    IconPen pen(*this, rect, color);
    for (const char* c = icons[static_cast<std::size_t>(icon)].drawing; *c != 0;) {
        const char kind = *c++;
        std::array<int, 2 * most_points> values;
        std::size_t count = 0;
        while (*c != 0 && *c != ' ') values[count++] = digit(*c++);
        while (*c == ' ') ++c;
        pen.part(kind, std::span(values).first(count));
    }
}

}  // namespace lapfx::ui
