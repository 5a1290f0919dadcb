#include "ui/canvas/pixels.h"

#include <glm/gtc/color_space.hpp>
#include <limits>

#include "ui/canvas/drag_handle.h"
#include "ui/core/node.h"
#include "ui/value/number.h"
#include "ui/widgets/color_field.h"

namespace lapfx::ui {

namespace {

constexpr int magnified = 11;             // pixels across the magnifier
constexpr float magnified_pixel = 0.55F;  // em
// What lies behind transparency, whatever the theme: smoke is light, and would not be seen on light squares.
constexpr Color checker_light = rgb(0x3b4048), checker_dark = rgb(0x2b2e35);

/// Where the pointer moved to since the last build, if it did and is over the node.
bool pointer_moved(const Node& node, const Response& response, Ui& ui) {
    struct Memory {
        glm::vec2 last{-1e9F};
    };
    glm::vec2& last = ui.memory<Memory>(node.id).last;
    const bool moved = last != response.pointer;
    last = response.pointer;
    return moved && (response.hovered || response.held);
}

glm::ivec2 way_of(Key key) {
    switch (key) {
        case Key::left:
            return {-1, 0};
        case Key::right:
            return {1, 0};
        case Key::up:
            return {0, -1};
        case Key::down:
            return {0, 1};
        default:
            return {0, 0};
    }
}

std::string_view number_text(Ui& ui, float value, int decimals) {
    char buffer[32];
    const bool whole = value == std::round(value);
    return ui.copy(format_number(buffer, static_cast<double>(value), whole ? 0 : decimals));
}

/// Draws dark and light lines, so that one of them is visible on any picture.
void draw_grid(Painter& painter, const View& view, const Rect& seen) {
    const Color dark = with_alpha(painter.theme().canvas, 0.35F),
                light = with_alpha(painter.theme().text_on_accent, 0.15F);
    const glm::ivec2 low = glm::max(view.pixel_at(seen.at()), glm::ivec2(0));
    const glm::ivec2 high = glm::min(view.pixel_at(seen.at() + seen.size()) + 1, view.size);
    for (int x = low.x; x <= high.x; ++x) {
        const auto at = static_cast<float>(std::round(view.to_screen({x, 0}).x));
        painter.fill({at - 1, seen.y, 1, seen.h}, dark);
        painter.fill({at, seen.y, 1, seen.h}, light);
    }
    for (int y = low.y; y <= high.y; ++y) {
        const auto at = static_cast<float>(std::round(view.to_screen({0, y}).y));
        painter.fill({seen.x, at - 1, seen.w, 1}, dark);
        painter.fill({seen.x, at, seen.w, 1}, light);
    }
}

/// Draws a light box within a dark one, which is visible on any picture.
void draw_box(Painter& painter, const Rect& box) {
    const float line = painter.hairline();
    painter.frame(box.inset(-line), painter.theme().canvas, line);
    painter.frame(box, canvas_ink(painter.theme()), line);
}

/// Light of a code value.
class LinearPixels : public PickSource {
  public:
    explicit LinearPixels(const PickSource& source) : source_(source) {}
    glm::vec4 pixel(glm::ivec2 at) const override {
        return {glm::convertSRGBToLinear(glm::vec3(source_.pixel(at)) / 255.0F), 1};
    }

  private:
    const PickSource& source_;
};

void draw_magnifier(Painter& painter, const Rect& place, const Readout& readout) {
    const float scale = place.w / static_cast<float>(magnified);
    const glm::vec2 low = glm::vec2(readout.at - magnified / 2);
    painter.fill(place, painter.theme().canvas);
    painter.push_clip(place);
    const glm::vec2 corner = place.at() - low * scale;
    painter.image(
        {corner.x, corner.y, static_cast<float>(readout.size.x) * scale, static_cast<float>(readout.size.y) * scale},
        readout.image, true);
    const glm::vec2 box = place.at() + (glm::vec2(readout.at - readout.side / 2) - low) * scale;
    const float side = static_cast<float>(readout.side) * scale;
    draw_box(painter, {box.x, box.y, side, side});
    painter.pop_clip();
}

}  // namespace

glm::vec4 mean_of(const PickSource& source, glm::ivec2 size, glm::ivec2 at, int side) {
    const glm::ivec2 low = glm::max(at - side / 2, glm::ivec2(0)), high = glm::min(at + side / 2, size - 1);
    glm::dvec4 sum(0);
    int count = 0;
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) sum += glm::dvec4(source.pixel({x, y})), ++count;
    }
    return count == 0 ? glm::vec4(0) : glm::vec4(sum / static_cast<double>(count));
}

Color picked_color(const PickSource& source, glm::ivec2 size, glm::ivec2 at, int side) {
    const glm::vec3 light(mean_of(LinearPixels(source), size, at, side));
    return color_of(glm::vec4(255.0F * glm::convertLinearToSRGB(light), 255));
}

void move_pick(Ui& ui, const Node& node, const Response& response, Pick& pick, std::span<const View> views,
               ViewState& state) {
    if (views.empty()) return;
    if (pointer_moved(node, response, ui) || !pick.by_keys) {
        pick = {};
        for (const View& view : views) {
            const glm::ivec2 at = view.pixel_at(response.pointer);
            if (response.hovered && view.area.contains(response.pointer) && view.has_pixel(at))
                pick = {true, false, at};
        }
    }
    ui.events_of(node.id, [&](const Event& event) {
        const glm::ivec2 way = event.kind == EventKind::key ? way_of(event.key) : glm::ivec2(0);
        if (way == glm::ivec2(0)) return;
        const View& view = views.front();
        if (!pick.on) pick.at = view.pixel_at(view.area.center()) - way;  // the first arrow only shows the place
        const glm::ivec2 next = pick.at + way * (has(event.mods, Mods::shift) && pick.on ? 10 : 1);
        pick = {true, true, glm::clamp(next, glm::ivec2(0), view.size - 1)};
        show_pixel(state, view.area, view.size, pick.at);
    });
    if (pick.by_keys && !response.focused) pick = {};
}

bool eyedropper_clicked(Ui& ui, Id id) {
    bool clicked = false;
    ui.events_of(id, [&](const Event& event) {
        clicked |= event.kind == EventKind::press && event.button == Button::left && !ui.key_down(Key::space);
        clicked |= event.kind == EventKind::key && event.key == Key::enter;
    });
    return clicked;
}

std::string_view pixel_text(Ui& ui, const glm::vec4& value, int decimals) {
    return ui.join({"R ", number_text(ui, value.r, decimals), "  G ", number_text(ui, value.g, decimals), "  B ",
                    number_text(ui, value.b, decimals), "  A ", number_text(ui, value.a, decimals)});
}

std::string_view place_text(Ui& ui, glm::ivec2 at) {
    return ui.join({number_text(ui, static_cast<float>(at.x), 0), ", ", number_text(ui, static_cast<float>(at.y), 0)});
}

Color color_of(const glm::vec4& code_value) {
    const glm::vec4 c = glm::clamp(glm::round(code_value), 0.0F, 255.0F);
    return {static_cast<std::uint8_t>(c.r), static_cast<std::uint8_t>(c.g), static_cast<std::uint8_t>(c.b), 255};
}

std::string_view picked_text(Ui& ui, Color picked, glm::ivec2 at) {
    char hex[9];
    return ui.join({format_hex(hex, picked, false), "   ", place_text(ui, at)});
}

glm::vec2 beside(const Rect& area, const Rect& measured, glm::vec2 size) {
    const glm::vec2 end = area.at() + area.size(), after = measured.at() + measured.size(),
                    before = measured.at() - size, level = measured.center() - size / 2.0F;
    glm::vec2 best = after;
    float least = std::numeric_limits<float>::infinity();
    for (const glm::vec2 corner :
         {after, glm::vec2(before.x, after.y), glm::vec2(after.x, before.y), before, glm::vec2(after.x, level.y),
          glm::vec2(before.x, level.y), glm::vec2(level.x, after.y), glm::vec2(level.x, before.y)}) {
        const glm::vec2 at = glm::max(glm::min(corner, end - size), area.at());
        const Rect both = intersect({at.x, at.y, size.x, size.y}, measured);
        const float covered = std::max(both.w, 0.0F) * std::max(both.h, 0.0F);
        if (covered < least) least = covered, best = at;
    }
    return best;
}

Rect room_beside(const Rect& area, const Rect& keep_off, glm::vec2 size) {
    const Rect off = intersect(area, keep_off);
    if (off.empty()) return area;
    Rect above = area, below = area, left = area, right = area;
    above.h = off.y - area.y, left.w = off.x - area.x;
    below.cut_top(off.bottom() - area.y), right.cut_left(off.right() - area.x);
    Rect best;
    for (const Rect& room : {above, below, left, right})
        if (room.w >= size.x && room.h >= size.y && room.w * room.h > best.w * best.h) best = room;
    return best;
}

void draw_readout(Painter& painter, const View& view, const Readout& readout) {
    const Theme& t = painter.theme();
    const TextStyle style = painter.number_style();
    const float pad = painter.em(0.4F), row = painter.em(1.35F);
    const auto box_reach = static_cast<float>(view.zoom * readout.side / 2);
    const float away = painter.em(0.8F) + box_reach;
    const float swatch = readout.swatch.a > 0 ? row + pad : 0;
    float width = 0;
    for (int i = 0; i < readout.line_count; ++i)
        width = std::max(width, std::ceil(painter.fonts().run(readout.lines[i], style).width));
    width += swatch;
    const float glass = readout.image != 0 ? painter.em(magnified_pixel) * static_cast<float>(magnified) : 0;
    const glm::vec2 size(std::max(width, glass) + 2 * pad,
                         static_cast<float>(readout.line_count) * row + (glass > 0 ? glass + pad : 0) + 2 * pad);
    const Rect room = room_beside(view.area, readout.keep_off, size);
    if (room.empty()) return;
    const glm::vec2 middle(view.to_screen(glm::dvec2(readout.at) + 0.5));
    const glm::vec2 corner = glm::floor(beside(room, {middle.x - away, middle.y - away, 2 * away, 2 * away}, size));
    Rect box{corner.x, corner.y, size.x, size.y};
    painter.shadow(box, t.shadow, painter.em(0.4F), painter.em(t.radius));
    painter.fill(box, t.raised, painter.em(t.radius));
    painter.frame(box, t.border, painter.hairline(), painter.em(t.radius));
    box = box.inset(pad);
    if (glass > 0) {
        const Rect strip = box.cut_top(glass);
        draw_magnifier(painter, {strip.x, strip.y, glass, glass}, readout);
        box.cut_top(pad);
    }
    if (swatch > 0) {
        const Rect square = box.cut_left(swatch);
        painter.fill({square.x, square.y, row, box.h}, readout.swatch, painter.em(0.2F));
        painter.frame({square.x, square.y, row, box.h}, t.border, painter.hairline(), painter.em(0.2F));
    }
    for (int i = 0; i < readout.line_count; ++i)
        painter.text(box.cut_top(row), readout.lines[i], style, i == 0 ? t.text : t.text_dim);
}

void draw_picture(Painter& painter, const View& view, const PictureLook& look) {
    const Theme& t = painter.theme();
    const Rect rect = view.rect(), seen = intersect(rect, view.area);
    painter.push_clip(view.area);
    if (look.picture.image == 0) {
        painter.text(view.area, "No picture", painter.text_style(), canvas_ink(t, 0.6F), Align::center);
        return painter.pop_clip();
    }
    const bool pixels = view.zoom >= grid_zoom;
    if (look.picture.transparent) painter.checker(seen, checker_light, checker_dark, painter.em(0.6F));
    if (look.second != 0) {
        CompareLook compare = look.compare;
        compare.nearest = pixels;
        painter.compare(rect, look.picture.image, look.second, compare);
    } else {
        painter.image(rect, look.picture.image, pixels);
    }
    if (look.grid && pixels) draw_grid(painter, view, seen);
    if (look.pick.on && (view.zoom >= 2 || look.pick.by_keys)) {
        Rect box = view.pixel_rect(look.pick.at - look.side / 2, glm::ivec2(look.side));
        if (view.zoom * look.side < 4) box = box.inset(-painter.em(0.4F));  // far too small to be seen
        draw_box(painter, box);
    }
    painter.pop_clip();
}

}  // namespace lapfx::ui
