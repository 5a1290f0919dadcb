#include "ui/widgets/splitter.h"

#include <utility>

#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

constexpr float gap_em = 0.3F, hit_em = 0.75F;

struct Drag {
    float from = 0, before = 0;  // px at the press; the fraction before
    bool began = false;
};

void draw_handle(Painter& painter, const Node& node, const Axis& axis) {
    const bool held = has(node.is, Is::held), hovered = has(node.is, Is::hovered) && !has(node.is, Is::disabled);
    const bool at_rest = !held && !hovered;
    const Rect rect = node.rect();
    const float thick = at_rest ? painter.hairline() : painter.em(gap_em);
    const Rect bar = axis == Axis::x ? Rect{std::round(rect.center().x - thick / 2), rect.y, thick, rect.h}
                                     : Rect{rect.x, std::round(rect.center().y - thick / 2), rect.w, thick};
    const Theme& t = painter.theme();
    painter.fill(bar, held ? t.focus : hovered ? t.control_hover : t.border);
}

}  // namespace

float Split::first(float fraction) const {
    const float least = first_minimum, most = room - second_minimum;
    if (room <= 0) return 0;
    if (least > most) return std::round(room * least / std::max(1.0F, first_minimum + second_minimum));
    const float wish = std::isfinite(fraction) ? fraction : standard;
    return std::round(std::clamp(wish * room, least, most));
}

float splitter_gap(const Ui& ui) {
    return ui.em(gap_em);
}

Edit drag_splitter(Ui& ui, Id id, Axis axis, const Split& split, float& fraction) {
    Edit edit;
    if (!ui.has_events(id) || split.room <= 0) return edit;
    Drag& drag = ui.memory<Drag>(id);
    const int a = static_cast<int>(axis);
    const auto set = [&](float first) {
        const float next = split.first(first / split.room) / split.room;
        if (next == split.first(fraction) / split.room) return false;
        fraction = next;
        return true;
    };
    const auto set_once = [&](float first) {
        if (set(first)) edit |= Edit::once();
    };
    ui.events_of(id, [&](const Event& event) {
        const float now = split.first(fraction), step = ui.em(1);
        if (event.kind == EventKind::press) {
            drag = {now - event.at[a], fraction, false};
            if (event.clicks == 2) set_once(split.standard * split.room);
            if (event.clicks == 2) drag = {split.first(fraction) - event.at[a], fraction, false};
        } else if (event.kind == EventKind::pointer && set(drag.from + event.at[a])) {
            edit.began |= !drag.began;
            edit.changed = drag.began = true;
        } else if (event.kind == EventKind::release && std::exchange(drag.began, false)) {
            edit.committed = true;
        } else if (event.kind == EventKind::cancel && std::exchange(drag.began, false)) {
            fraction = drag.before;
            edit.changed = edit.cancelled = true;  // the value has changed back
        } else if (event.kind == EventKind::key) {
            if (event.key == Key::left || event.key == Key::up) set_once(now - step);
            if (event.key == Key::right || event.key == Key::down) set_once(now + step);
            if (event.key == Key::home) set_once(0);
            if (event.key == Key::end) set_once(split.room);
            if (event.key == Key::backspace) set_once(split.standard * split.room);
        }
    });
    return edit;
}

void put_splitter(Ui& ui, std::string_view label, Axis axis, glm::vec2 at, float length, float fraction) {
    const int a = static_cast<int>(axis);
    const Sense arrows = axis == Axis::x ? Sense::arrows_x : Sense::arrows_y;
    Node& node = ui.leaf(Role::splitter, label,
                         Sense::hover | Sense::press | Sense::focus | Sense::extremes | Sense::erase | arrows);
    const float hit = ui.em(hit_em);
    node.size[a] = px(hit);
    node.size[1 - a] = px(length);
    at[a] += std::round((splitter_gap(ui) - hit) / 2);
    node.placed = true;
    node.placement = ui.arena().make(Placement{.offset = at});
    node.number = ui.number(fraction, 0, 1);
    const Response r = ui.respond(node);
    if ((r.hovered || r.held) && !ui.disabled()) ui.set_cursor(axis == Axis::x ? Cursor::resize_x : Cursor::resize_y);
    ui.draw_with<draw_handle>(node, axis);
}

Splitter::Splitter(Ui& ui, std::string_view label, Axis axis, float& fraction, const SplitterOptions& options)
    : ui_(ui), axis_(axis) {
    Node& outer = ui.open(Role::group, label, axis);
    outer.size[0] = options.width;
    outer.size[1] = options.height;
    outer.gap = splitter_gap(ui);
    outer.rigid = false;
    outer.clips = true;
    // This does not scroll. It only measures the room and causes another build when that changes.
    ScrollState& known = ui.memory<ScrollState>(outer.id);
    outer.scroll = &known;
    const float room = std::max(0.0F, known.view[static_cast<int>(axis)] - outer.gap);
    const Split split{room, ui.em(options.first_minimum), ui.em(options.second_minimum), options.standard};
    edit_ = drag_splitter(ui, ui.id_of("handle"), axis, split, fraction);
    first_ = split.first(fraction);
    second_ = room - first_;
    fraction_ = fraction;
    open_pane(first_);
}

void Splitter::open_pane(float length) {
    Node& pane = ui_.open(Role::none, {}, Axis::y);
    pane.size[static_cast<int>(axis_)] = px(length);
    pane.size[1 - static_cast<int>(axis_)] = grow();
    pane.gap = ui_.em(ui_.theme().gap);
    pane.rigid = false;
    pane.clips = true;
}

void Splitter::next() {
    ui_.close();
    open_pane(second_);
}

Splitter::~Splitter() {
    ui_.close();
    const Node& outer = ui_.parent();
    const glm::vec2 at = axis_ == Axis::x ? glm::vec2(first_, 0) : glm::vec2(0, first_);
    put_splitter(ui_, "handle", axis_, at, outer.scroll->view[1 - static_cast<int>(axis_)], fraction_);
    ui_.close();
}

}  // namespace lapfx::ui
