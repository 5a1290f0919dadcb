// One of a few choices, side by side. Tab goes to the chosen one, arrows choose its neighbours.
#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {

namespace {

struct ChoiceLook {
    bool chosen, first, last;
};

void draw_segment(Painter& painter, const Node& node, const ChoiceLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled), hovered = has(node.is, Is::hovered) && !disabled;
    const float radius = painter.em(t.radius);
    Color ground = hovered ? t.control_hover : t.control, ink = t.text;
    if (look.chosen) ground = hovered ? t.accent_hover : t.accent, ink = t.text_on_accent;
    if (disabled) ground = look.chosen ? t.control : t.field, ink = t.text_disabled;
    // Only the outer corners are round: the inner ones are outside of the drawn part.
    Rect rect = node.rect();
    painter.push_clip(rect);
    if (!look.first) rect.x -= radius, rect.w += radius;
    if (!look.last) rect.w += radius;
    painter.fill(rect, ground, radius);
    painter.pop_clip();
    if (!look.first && !look.chosen) {
        Rect edge = node.rect().inset(0, painter.em(0.35F));
        painter.fill(edge.cut_left(painter.hairline()), t.border);
    }
    painter.text(node.rect().inset(painter.em(0.4F), 0), node.shown, painter.text_style(), ink, Align::center);
}

/// The choice that a key leads to from choice `at` of `count`; arrows wrap around.
int step(Key key, int at, int count) {
    switch (key) {
        case Key::left:
        case Key::up:
            return (at + count - 1) % count;
        case Key::right:
        case Key::down:
            return (at + 1) % count;
        case Key::home:
            return 0;
        case Key::end:
            return count - 1;
        default:
            return at;
    }
}

void lay_segment(Ui& ui, Node& node) {
    // Each gets a share according to its text, so that all are cut together where there is too little room, and none
    // extends over its neighbours.
    const float wish = std::ceil(ui.text_width(node.shown)) + 2 * ui.em(0.6F);
    node.size[0] = grow(wish);
    node.minimum[0] = ui.em(1.5F);
    node.padding[0] = node.padding[2] =
        static_cast<std::uint8_t>(std::min(std::ceil(wish / 2), 255.0F));  // makes the width that it wants
    if (const float had = ui.rect_before(node.id).w; had > 0 && had + 1 < wish) node.tip = node.shown;
}
Edit choose(Ui& ui, int& chosen, std::span<const std::string_view> choices) {
    const int count = static_cast<int>(choices.size());
    if (count == 0) return {};
    chosen = std::clamp(chosen, 0, count - 1);
    int next = chosen;
    Id* ids = static_cast<Id*>(ui.arena().take(choices.size() * sizeof(Id), alignof(Id)));
    bool by_key = false;
    for (int i = 0; i < count; ++i) {
        // Tab stops only at the chosen one.
        Sense sense = Sense::hover | Sense::press | Sense::activate;
        if (i == chosen) sense = sense | Sense::focus | Sense::arrows_x | Sense::arrows_y | Sense::extremes;
        Node& node = ui.leaf(Role::radio, choices[static_cast<std::size_t>(i)], sense);
        node.size[1] = px(ui.row_height());
        lay_segment(ui, node);
        ids[i] = node.id;
        node.is |= when(i == chosen, Is::checked);
        if (ui.respond(node).clicked) next = i;
        if (!has(node.is, Is::disabled)) {
            ui.events_of(node.id, [&](const Event& event) {
                if (event.kind != EventKind::key) return;
                next = step(event.key, i, count);
                by_key = true;
            });
        }
        ui.draw_with<draw_segment>(node, ChoiceLook{i == chosen, i == 0, i == count - 1});
    }
    if (next == chosen) return {};
    chosen = next;
    ui.set_focus(ids[next], by_key);  // this also asks for another build, which shows it
    return Edit::once();
}

}  // namespace

Edit segmented(Ui& ui, std::string_view label, int& chosen, std::span<const std::string_view> choices) {
    Node& node = ui.open(Role::group, label, Axis::x);
    node.size[0] = grow();
    const Edit edit = choose(ui, chosen, choices);
    ui.close();
    return edit;
}

}  // namespace lapfx::ui
