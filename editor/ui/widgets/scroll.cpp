#include "ui/widgets/scroll.h"

#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

constexpr float bar_em = 0.85F;      // width of the part that reacts to the pointer
constexpr float thumb_em = 0.3F;     // width of the visible part at rest
constexpr float shortest_em = 1.7F;  // least length of a thumb

struct BarDrag {
    bool dragging = false;
    float from = 0;  // px, the offset at the press
};

/// Whether the vertical bar has room of its own. The height of content may grow with its width (a picture). Then the
/// bar may be needed while it has no room, and not be needed while it has. If removing the room makes the bar necessary
/// again, the room stays.
struct BarRoom {
    bool barred = false;
    glm::vec2 given_up_at{-1};  // px of the area without any bar when the room was removed as not needed
    float given_up_with = -1;   // height of the content then, px
};

bool keep_room(BarRoom& room, const ScrollState& state, float bar) {
    const bool needed = state.content.y - state.view.y >= 1;
    if (room.barred && !needed) {
        const glm::vec2 whole = state.view + glm::vec2(bar, 0);
        if (room.given_up_at == whole && std::abs(room.given_up_with - state.content.y) < 1) return true;
        room = {false, whole, state.content.y};
    } else if (!room.barred && !needed) {
        room = {};  // removing the room was right
    } else {
        room.barred = true;
    }
    return room.barred;
}

struct Thumb {
    float at = 0, length = 0;  // px along the track
    float per_px = 0;          // content px for one px of the thumb
};

Thumb thumb_of(const ScrollState& state, int a, float track, float shortest) {
    const float most = std::max(0.0F, state.content[a] - state.view[a]);
    if (state.content[a] <= 0 || most <= 0 || track <= 0) return {};
    const float length = std::min(track, std::max(shortest, track * state.view[a] / state.content[a]));
    const float room = track - length;
    return {room * state.offset[a] / most, length, room > 0 ? most / room : 0};
}

struct BarLook {
    const ScrollState* state;  // read when it is drawn, after the layout of this frame
    int axis;
};

void draw_bar(Painter& painter, const Node& node, const BarLook& look) {
    const Theme& t = painter.theme();
    const Rect rect = node.rect();
    const bool y = look.axis == 1, active = has(node.is, Is::hovered) || has(node.is, Is::held);
    const Thumb thumb = thumb_of(*look.state, look.axis, y ? rect.h : rect.w, painter.em(shortest_em));
    if (thumb.length <= 0) return;
    if (active) painter.fill(rect, with_alpha(t.window, 0.6F));
    const float thickness = painter.em(active ? 2 * thumb_em : thumb_em), edge = painter.hairline();
    const Rect mark = y ? Rect{rect.right() - thickness - edge, rect.y + thumb.at, thickness, thumb.length}
                        : Rect{rect.x + thumb.at, rect.bottom() - thickness - edge, thumb.length, thickness};
    const Color ink = has(node.is, Is::held) ? t.text : active ? t.text_dim : t.text_disabled;
    painter.fill({std::round(mark.x), std::round(mark.y), mark.w, mark.h}, ink, thickness / 2);
}

void put_bar(Ui& ui, ScrollState& state, int a, float top) {
    const float most = state.content[a] - state.view[a];
    if (most < 1) return;
    Node& node = ui.leaf(Role::scroll_bar, a == 0 ? "horizontal scroll bar" : "vertical scroll bar",
                         Sense::hover | Sense::press);
    node.size[a] = grow();
    node.size[1 - a] = px(ui.em(bar_em));
    node.placed = true;
    const glm::vec2 end = a == 0 ? glm::vec2(0, 1) : glm::vec2(1, 0);
    node.placement =
        ui.arena().make(Placement{.fraction = end, .offset = a == 0 ? glm::vec2(0) : glm::vec2(0, top), .pivot = end});
    node.number = ui.number(state.offset[a], 0, most, ui.row_height());
    ui.draw_with<draw_bar>(node, BarLook{&state, a});

    const Id id = node.id;
    const Response r = ui.respond(node);
    const Rect rect = ui.rect_before(id);
    const float low = a == 0 ? rect.x : rect.y, pressed = r.pressed_at[a] - low;
    const Thumb thumb = thumb_of(state, a, a == 0 ? rect.w : rect.h, ui.em(shortest_em));
    BarDrag& drag = ui.memory<BarDrag>(id);
    const float before = state.offset[a];
    if (r.pressed) {
        drag = {pressed >= thumb.at && pressed < thumb.at + thumb.length, state.offset[a]};
        if (!drag.dragging) state.offset[a] += pressed < thumb.at ? -state.view[a] : state.view[a];
    } else if ((r.held || r.released) && drag.dragging) {
        state.offset[a] = drag.from + (r.pointer[a] - r.pressed_at[a]) * thumb.per_px;
    }
    if (r.cancelled && drag.dragging) state.offset[a] = drag.from;
    if (r.cancelled || r.released) drag.dragging = false;
    state.offset[a] = std::clamp(state.offset[a], 0.0F, most);
    if (state.offset[a] != before) ui.build_again();  // rows were built for the earlier offset
}

}  // namespace

void scroll_bar(Ui& ui, ScrollState& state) {
    put_bar(ui, state, 1, 0);
}

ScrollArea::ScrollArea(Ui& ui, std::string_view label, const ScrollOptions& options)
    : ScrollArea(ui, ui.open(options.role, label, Axis::y, Sense::wheel | options.sense), options) {}

ScrollArea::ScrollArea(Ui& ui, Node& node, const ScrollOptions& options)
    : ui_(ui), id_(node.id), state_(ui.memory<ScrollState>(node.id)), top_(options.top) {
    node.size[0] = options.width;
    node.size[1] = options.height;
    node.gap = ui.em(options.gap);
    for (std::uint8_t& pad : node.padding)
        pad = static_cast<std::uint8_t>(std::clamp(ui.em(options.padding), 0.0F, 255.0F));
    node.padding[1] = static_cast<std::uint8_t>(std::clamp(node.padding[1] + options.top, 0.0F, 255.0F));
    // The bar must not cover anything that can be clicked.
    const bool barred = keep_room(ui.memory<BarRoom>(node.id), state_, ui.em(bar_em));
    node.padding[2] = static_cast<std::uint8_t>(std::min(255.0F, node.padding[2] + (barred ? ui.em(bar_em) : 0.0F)));
    node.rigid = false;
    node.clips = true;
    node.scrolls[0] = options.sideways;
    node.scrolls[1] = true;
    node.scroll = &state_;
    node.tip = ui.copy(options.tip);
    response_ = ui.respond(node);
    is_ = node.is;
}

ScrollArea::~ScrollArea() {
    put_bar(ui_, state_, 1, top_);
    if (ui_.parent().scrolls[0]) put_bar(ui_, state_, 0, 0);
    ui_.close();
}

LineWindow::LineWindow(Ui& ui, ScrollArea& area, std::size_t count, float height) : ui_(ui) {
    height = std::max(height, 1.0F);
    ScrollState& state = area.state();
    const float view = state.view.y > 0 ? state.view.y : ui.window().y, all = static_cast<float>(count) * height;
    state.offset.y = std::clamp(state.offset.y, 0.0F, std::max(0.0F, all - view));
    first_ = std::min(static_cast<std::size_t>(state.offset.y / height), count);
    last_ = std::min(static_cast<std::size_t>(std::ceil((state.offset.y + view) / height)), count);
    last_ = std::max(first_, last_);
    below_ = static_cast<float>(count - last_) * height;
    if (first_ == 0) return;
    ui.leaf(Role::none, {}).size[1] = px(static_cast<float>(first_) * height);
}

LineWindow::~LineWindow() {
    if (below_ > 0) ui_.leaf(Role::none, {}).size[1] = px(below_);
}

void LineWindow::show(ScrollArea& area, std::size_t line, float height) {
    ScrollState& state = area.state();
    const float from = static_cast<float>(line) * height, to = from + height;
    if (from < state.offset.y) state.offset.y = from;
    if (to > state.offset.y + state.view.y) state.offset.y = std::max(0.0F, to - state.view.y);
}

void open_line(Ui& ui, float height) {
    Node& line = ui.open(Role::none, {}, Axis::x);
    line.size[1] = px(height);
    line.cross = ChildAlign::center;
}

}  // namespace lapfx::ui
