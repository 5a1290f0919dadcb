#include "ui/canvas/viewport.h"

#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

constexpr float still = 3;  // px at scale 1 that the pointer may move during a click
constexpr std::size_t most_keys = 16;

struct ViewportMemory {
    DragWay way;
    glm::vec2 pressed_at{0};
    bool moved = false;
};

void draw_viewport(Painter& painter, const Node& node, const ImageHandle& image) {
    if (image == 0) return painter.ground(node.rect(), painter.theme().canvas);
    painter.image(node.rect(), image);
}

void take(ViewportResult& result, ViewportMemory& memory, const Event& event, float tolerance) {
    result.drag += memory.way.take(event);
    memory.moved |= memory.way.on && glm::distance(event.at, memory.pressed_at) > tolerance;
    switch (event.kind) {
        case EventKind::press:
            result.pressed = true;
            result.clicks = event.clicks;
            memory.pressed_at = event.at;
            memory.moved = false;
            break;
        case EventKind::release:
            result.released = true;
            result.clicked |= !memory.moved && event.button == Button::left;
            result.context |= !memory.moved && event.button == Button::right;
            break;
        case EventKind::cancel:
            result.cancelled = true;
            break;
        case EventKind::wheel:
            result.wheel += event.delta.y;
            break;
        case EventKind::key:
            result.context |= event.key == Key::menu;
            break;
        default:
            break;
    }
}

std::span<const ViewportKey> keys_of(Ui& ui, Id id) {
    ViewportKey keys[most_keys];
    std::size_t count = 0;
    ui.events_of(id, [&](const Event& event) {
        if (event.kind == EventKind::key && count < most_keys) keys[count++] = {event.key, event.mods, event.repeat};
    });
    if (count == 0) return {};
    auto* kept = static_cast<ViewportKey*>(ui.arena().take(count * sizeof(ViewportKey), alignof(ViewportKey)));
    std::copy_n(keys, count, kept);
    return {kept, count};
}

}  // namespace

ViewportResult viewport(Ui& ui, std::string_view label, ImageHandle image, std::string_view tip, Size width,
                        Size height) {
    Node& node = ui.leaf(
        Role::canvas, label,
        Sense::hover | Sense::press | Sense::middle | Sense::context | Sense::focus | Sense::wheel | Sense::keys);
    node.size[0] = width, node.size[1] = height;
    node.tip = ui.copy(tip);
    ui.follow_size(node);
    const Rect rect = ui.rect_before(node.id);
    const Response r = ui.respond(node);
    ViewportResult result{.size = glm::ivec2(rect.size()), .hovered = r.hovered, .focused = r.focused, .mods = r.mods};
    result.pointer = ui.pointer() - rect.at();
    if (ui.has_events(node.id) || r.held) {
        ViewportMemory& memory = ui.memory<ViewportMemory>(node.id);
        ui.events_of(node.id, [&](const Event& event) { take(result, memory, event, still * ui.scale()); });
        result.dragging = memory.way.on;
        result.button = memory.way.button;
        result.pressed_at = memory.pressed_at - rect.at();
        result.keys = keys_of(ui, node.id);
    }
    ui.draw_with<draw_viewport>(node, image);
    return result;
}

}  // namespace lapfx::ui
