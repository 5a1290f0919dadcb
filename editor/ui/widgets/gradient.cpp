#include "ui/widgets/gradient.h"

#include <charconv>

namespace lapfx::ui {

namespace {

constexpr float bar_height = 1.5F, handle_height = 1.2F;  // em
constexpr float side = 0.85F;                             // em beside the bar, so that handles at its ends are whole

/// Kept for each bar.
struct Gradient {
    std::vector<Id> handles;  ///< of the last build
    float start = 0;          ///< place when the drag began
    float dragged = 0;        ///< place that the pointer has led to, before it is held back by neighbours
    glm::vec2 pointer{0};
    bool held = false, moves = false, began = false;
};

struct BarLook {
    std::span<const GradientStop> stops;
};

Rect bar_of(const Rect& rect, float em) {
    Rect bar = rect.inset(std::round(side * em), 0);
    bar.cut_bottom(std::round(handle_height * em));
    return bar;
}

void draw_bar(Painter& painter, const Node& node, const BarLook& look) {
    const Theme& t = painter.theme();
    const Rect bar = bar_of(node.rect(), painter.em(1));
    bool opaque = true;
    for (const GradientStop& stop : look.stops) opaque &= stop.color.a == 255;
    if (!opaque) painter.checker(bar, rgb(0xbbbbbb), rgb(0x777777), painter.em(0.45F));
    const auto x_of = [&](float place) { return std::round(bar.x + bar.w * place); };
    float x = bar.x;
    Color color = gradient_at(look.stops, 0);
    for (const GradientStop& stop : look.stops) {
        painter.gradient({x, bar.y, x_of(stop.place) - x, bar.h}, color, stop.color, false);
        x = x_of(stop.place), color = stop.color;
    }
    painter.fill({x, bar.y, bar.right() - x, bar.h}, color);
    painter.frame(bar, has(node.is, Is::hovered) ? t.text_dim : t.border, painter.hairline());
}

void draw_handle(Painter& painter, const Node& node, const GradientStop* const& stop) {
    const Theme& t = painter.theme();
    const bool lit = has(node.is, Is::hovered) || has(node.is, Is::held) || has(node.is, Is::focused);
    const float half = painter.em(0.45F), middle = std::round(node.rect().center().x);
    const Rect body{middle - half, node.rect().bottom() - 2 * half, 2 * half, 2 * half};
    const Color edge = has(node.is, Is::focused) ? t.focus : lit ? t.text : t.text_dim;
    painter.fill({middle - painter.hairline(), node.at[1], 2 * painter.hairline(), body.y - node.at[1]}, edge);
    painter.fill(body, edge, painter.em(0.15F));
    draw_swatch(painter, body.inset(2 * painter.hairline()), stop->color);
}

struct Session {
    Ui& ui;
    Gradient& state;
    std::vector<GradientStop>& stops;
    const GradientOptions& options;
    float width;  ///< px of the bar
    Edit edit = {};

    /// Between its neighbours.
    void move(std::size_t i, float place) {
        const float low = i > 0 ? stops[i - 1].place : 0.0F;
        const float high = i + 1 < stops.size() ? stops[i + 1].place : 1.0F;
        const float kept = std::clamp(place, low, high);
        if (kept == stops[i].place) return;
        stops[i].place = kept;
        edit.began |= !state.began;
        state.began = edit.changed = true;
    }
    void commit() {
        edit.committed |= state.began;
        state.began = state.held = state.moves = false;
    }
    void remove(std::size_t i) {
        if (stops.size() <= options.least) return;
        stops.erase(stops.begin() + static_cast<std::ptrdiff_t>(i));
        if (i == stops.size()) ui.set_focus(state.handles[i - 1], true);
        edit |= Edit::once();
    }
    void add(float place) {
        if (stops.size() >= options.most) return;
        const auto at =
            std::find_if(stops.begin(), stops.end(), [&](const GradientStop& s) { return s.place > place; });
        stops.insert(at, {place, gradient_at(stops, place)});
        edit |= Edit::once();
    }
    /// In the middle of the widest gap.
    void add_somewhere() {
        float from = 0, to = stops.empty() ? 1.0F : stops.front().place;
        for (std::size_t i = 0; i < stops.size(); ++i) {
            const float next = i + 1 < stops.size() ? stops[i + 1].place : 1.0F;
            if (next - stops[i].place > to - from) from = stops[i].place, to = next;
        }
        add((from + to) / 2);
    }
    void key(std::size_t i, const Event& event) {
        const bool command = has(event.mods, Mods::command);
        const float step = has(event.mods, Mods::shift) ? 0.001F : command ? 0.1F : 0.01F;
        switch (event.key) {
            case Key::left:
                move(i, stops[i].place - step);
                break;
            case Key::right:
                move(i, stops[i].place + step);
                break;
            case Key::home:
                if (command) move(i, 0);
                break;
            case Key::end:
                if (command) move(i, 1);
                break;
            case Key::backspace:
            case Key::del:
                return remove(i);
            case Key::enter:
            case Key::space:
                return open_color_picker(ui, state.handles[i], stops[i].color);
            default:
                return;
        }
        commit();
    }
    void take(std::size_t i, const Event& event) {
        switch (event.kind) {
            case EventKind::press:
                if (event.button != Button::left) return;
                if (event.clicks == 2) open_color_picker(ui, state.handles[i], stops[i].color);
                state.held = true, state.moves = false, state.began = false;
                state.pointer = event.at;
                state.start = state.dragged = stops[i].place;
                return;
            case EventKind::pointer:
                if (!state.held || width <= 0) return;
                if (!state.moves && std::abs(event.at.x - state.pointer.x) <= 3 * ui.scale()) return;
                state.moves = true;  // from where it was pressed: the handle stays under the pointer
                state.dragged += (event.at.x - state.pointer.x) / width * (has(event.mods, Mods::shift) ? 0.1F : 1.0F);
                state.pointer = event.at;
                return move(i, state.dragged);
            case EventKind::release:
                return commit();
            case EventKind::cancel:
                if (state.began) stops[i].place = state.start, edit.changed = edit.cancelled = true;
                state.began = state.held = state.moves = false;
                return;
            case EventKind::key:
                if (!state.held) key(i, event);  // one edit at a time
                return;
            default:
                return;
        }
    }
};

void put_handle(Session& s, std::size_t i, const GradientStop* look) {
    Ui& ui = s.ui;
    char digits[8], hex[9];
    const char* end = std::to_chars(digits, digits + sizeof digits, i + 1).ptr;
    Node& node = ui.leaf(Role::handle, ui.join({"Stop ", {digits, static_cast<std::size_t>(end - digits)}}),
                         Sense::hover | Sense::press | Sense::focus | Sense::activate | Sense::arrows_x |
                             Sense::extremes | Sense::erase);
    const float place = s.stops[i].place;
    node.placed = true;
    node.placement = ui.arena().make(Placement{
        .fraction = {place, 1}, .offset = {std::round(ui.em(1) * side) * (1 - 2 * place), 0}, .pivot = {0.5F, 1}});
    node.size[0] = px(2 * std::round(ui.em(1) * side)), node.size[1] = px(ui.row_height());
    node.number = ui.number(place, 0, 1, 0.01);
    node.text = ui.copy(format_hex(hex, s.stops[i].color, s.options.alpha));
    ui.respond(node);
    ui.draw_with<draw_handle>(node, look);
    s.state.handles.push_back(node.id);
}

}  // namespace

Color gradient_at(std::span<const GradientStop> stops, float place) {
    if (stops.empty()) return {0, 0, 0, 0};
    const GradientStop* before = &stops.front();
    for (const GradientStop& stop : stops) {
        if (stop.place >= place) {
            const float way = stop.place - before->place;
            return way <= 0 ? stop.color : mix(before->color, stop.color, (place - before->place) / way);
        }
        before = &stop;
    }
    return before->color;
}

Edit gradient_bar(Ui& ui, std::string_view label, std::vector<GradientStop>& stops, const GradientOptions& options) {
    for (GradientStop& stop : stops) stop.place = std::isfinite(stop.place) ? std::clamp(stop.place, 0.0F, 1.0F) : 0.0F;
    const auto by_place = [](const GradientStop& a, const GradientStop& b) { return a.place < b.place; };
    if (!std::is_sorted(stops.begin(), stops.end(), by_place)) std::stable_sort(stops.begin(), stops.end(), by_place);

    Node& node = ui.open(Role::gradient, label, Axis::y, Sense::hover | Sense::press | Sense::focus | Sense::activate);
    node.size[0] = grow(), node.size[1] = px(ui.em(bar_height) + ui.em(handle_height));
    node.minimum[0] = ui.em(8);
    node.tip = ui.copy(options.tip);
    const Id id = node.id;
    const std::string_view name = node.label;
    const Response r = ui.respond(node);
    const Rect bar = bar_of(ui.rect_before(id), ui.em(1));
    Session s{ui, ui.memory<Gradient>(id), stops, options, bar.w};
    const std::size_t known = std::min(s.state.handles.size(), stops.size());
    for (std::size_t i = 0; i < known && stops.size() >= known; ++i)
        ui.events_of(s.state.handles[i], [&](const Event& event) {
            if (i < stops.size()) s.take(i, event);
        });
    if (r.pressed && r.clicks == 2 && bar.w > 0) s.add(std::clamp((r.pointer.x - bar.x) / bar.w, 0.0F, 1.0F));
    if (r.clicked && !r.released) s.add_somewhere();

    // Shown as they are at the end of this build, when a picker may have changed a colour once more.
    GradientStop* shown = nullptr;
    if (!stops.empty()) {
        shown = static_cast<GradientStop*>(ui.arena().take(stops.size() * sizeof(GradientStop), alignof(GradientStop)));
        std::copy(stops.begin(), stops.end(), shown);
    }
    ui.draw_with<draw_bar>(ui.parent(), BarLook{{shown, stops.size()}});
    const bool disabled = has(ui.parent().is, Is::disabled);
    s.state.handles.clear();
    for (std::size_t i = 0; i < stops.size(); ++i) put_handle(s, i, shown + i);
    ui.close();
    for (std::size_t i = 0; i < stops.size() && !disabled; ++i) {
        s.edit |= color_picker(ui, s.state.handles[i], name, stops[i].color,
                               {.alpha = options.alpha, .eyedropper = options.eyedropper});
        shown[i].color = stops[i].color;
    }
    return s.edit;
}

}  // namespace lapfx::ui
