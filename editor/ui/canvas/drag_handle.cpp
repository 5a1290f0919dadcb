#include "ui/canvas/drag_handle.h"

#include "ui/canvas/view.h"
#include "ui/core/node.h"
#include "ui/value/number.h"

namespace lapfx::ui {

namespace {

constexpr double fine = 0.1;
constexpr Sense handle_sense = Sense::hover | Sense::press | Sense::focus | Sense::arrows_x | Sense::arrows_y |
                               Sense::pages | Sense::extremes | Sense::erase;

struct HandleMemory {
    DragWay way;
    glm::vec2 to{0};
    bool changed = false;
    double start = 0;
};

void take_key(HandleMoves& moves, const Event& event) {
    const double step = has(event.mods, Mods::shift) ? fine : 1.0;
    switch (event.key) {
        case Key::left:
        case Key::right:
            moves.steps.x += event.key == Key::right ? step : -step;
            break;
        case Key::up:
        case Key::down:
            moves.steps.y += event.key == Key::up ? step : -step;
            break;
        case Key::page_up:
        case Key::page_down:
            moves.steps.y += event.key == Key::page_up ? 10 : -10;
            break;
        case Key::home:
        case Key::end:
            moves.extreme = event.key == Key::home ? -1 : 1;
            break;
        case Key::backspace:
        case Key::del:
            (has(event.mods, Mods::shift) ? moves.initial : moves.reset) = true;
            break;
        default:
            break;
    }
}

void take(HandleMoves& moves, HandleMemory& memory, const HandleOptions& options, const Event& event) {
    const glm::vec2 way = memory.way.take(event);
    switch (event.kind) {
        case EventKind::press:
            memory.to = options.at;
            memory.changed = false;
            if (event.clicks == 2) moves.reset = true, memory.way.on = false;
            break;
        case EventKind::release:
            moves.released = true;
            break;
        case EventKind::cancel:
            moves.cancelled = true;
            break;
        case EventKind::key:
            if (!memory.way.on) take_key(moves, event);
            break;
        default:
            break;
    }
    if (way == glm::vec2(0)) return;
    memory.to += has(event.mods, Mods::shift) ? way * static_cast<float>(fine) : way;
    moves.dragged = true;
    moves.whole = has(event.mods, Mods::command);
}

}  // namespace

float handle_side(const Ui& ui) {
    return 2 * std::ceil(ui.row_height() / 2);
}

HandleMoves put_handle(Ui& ui, const HandleOptions& options) {
    Node& node = ui.leaf(Role::handle, options.label, handle_sense);
    const float side = handle_side(ui);
    node.size[0] = px(side), node.size[1] = px(side);
    node.placed = true;
    node.placement = ui.arena().make(Placement{.offset = options.at, .pivot = options.pivot});
    node.tip = ui.copy(options.tip);
    const Response r = ui.respond(node);
    if (r.hovered || r.held) ui.set_cursor(options.cursor);
    HandleMoves moves{.id = node.id, .hovered = r.hovered, .held = r.held};
    if (!ui.has_events(node.id)) return moves;
    HandleMemory& memory = ui.memory<HandleMemory>(node.id);
    ui.events_of(node.id, [&](const Event& event) { take(moves, memory, options, event); });
    moves.to = memory.to;
    return moves;
}

Edit edit_by_handle(Ui& ui, const HandleMoves& moves, const HandleRange& range, double steps, double dragged,
                    double& value) {
    Edit edit;
    const bool by_key = steps != 0 || moves.extreme != 0;
    if (!moves.dragged && !moves.released && !moves.cancelled && !moves.reset && !moves.initial && !by_key) return edit;
    HandleMemory& memory = ui.memory<HandleMemory>(moves.id);
    const double before = value;
    const auto set = [&](double wish) {
        value = std::isfinite(wish) ? std::clamp(wish, range.minimum, std::max(range.minimum, range.maximum)) : value;
        return value != before;
    };
    if (moves.reset || moves.initial)
        return set(moves.initial ? range.initial.value_or(range.reset) : range.reset) ? Edit::once() : edit;
    if (by_key) {
        const double wish = moves.extreme < 0   ? range.minimum
                            : moves.extreme > 0 ? range.maximum
                                                : value + steps * range.step;
        return set(wish) ? Edit::once() : edit;
    }
    if (moves.dragged && set(moves.whole ? snap(dragged, range.step) : dragged)) {
        if (!memory.changed) memory.start = before, edit.began = true;
        memory.changed = true;
        edit.changed = true;
    }
    if (memory.changed && moves.released) edit.committed = true;
    if (memory.changed && moves.cancelled) value = memory.start, edit.cancelled = true, edit.changed = true;
    if (moves.released || moves.cancelled) memory.changed = false;
    return edit;
}

void draw_knob(Painter& painter, const Node& node, const KnobLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled), lit = !disabled && (has(node.is, Is::hovered | Is::held));
    const glm::vec2 size(painter.em(look.size.x), painter.em(look.size.y));
    const glm::vec2 corner = glm::floor(node.rect().at() + (node.rect().size() - size) * look.pivot);
    const Rect knob{corner.x, corner.y, size.x, size.y};
    const float radius = std::min(size.x, size.y) / 2;
    painter.shadow(knob, t.shadow, painter.em(0.2F), radius);
    painter.fill(knob, disabled ? t.control : look.color, radius);
    painter.frame(knob, lit ? t.focus : mix(look.color, t.text_dim, 0.6F), painter.hairline() * (lit ? 2 : 1), radius);
}

}  // namespace lapfx::ui
