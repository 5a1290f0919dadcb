#include "ui/canvas/view.h"

#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

constexpr double notches_for_double = 2;

glm::dvec2 middle(const Rect& area) {
    return {area.center()};
}

double least_zoom(const Rect& area, glm::ivec2 size) {
    return std::min(fit_zoom(area, size), 1.0) / 4;
}

/// Makes a fitted view movable. It starts with the zoom that it has.
void unfit(ViewState& state, const Rect& area, glm::ivec2 size) {
    if (state.fitted) state = {.fitted = false, .zoom = fit_zoom(area, size)};
}

/// A change of zoom that would skip 1:1 stops there.
double stop_at_one(double from, double to) {
    return (from < 1 && to > 1) || (from > 1 && to < 1) ? 1.0 : to;
}

struct SteerMemory {
    DragWay way;
    ViewState before;
    bool pans = false;
};

bool steer_by_key(ViewState& state, const Rect& area, glm::ivec2 size, Key key) {
    switch (static_cast<char>(static_cast<int>(key) < 128 ? static_cast<int>(key) : 0)) {
        case '+':
        case '=':
            step_zoom(state, area, size, 1, area.center());
            return true;
        case '-':
            step_zoom(state, area, size, -1, area.center());
            return true;
        case '0':
            state = {};
            return true;
        case '1':
            set_zoom(state, area, size, 1, area.center());
            return true;
        default:
            return false;
    }
}

}  // namespace

Rect View::rect() const {
    return pixel_rect({0, 0}, size);
}

Rect View::pixel_rect(glm::ivec2 low, glm::ivec2 count) const {
    const glm::dvec2 from = to_screen(low), extent = glm::dvec2(count) * zoom;
    return {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(extent.x),
            static_cast<float>(extent.y)};
}

double fit_zoom(const Rect& area, glm::ivec2 size) {
    const double zoom =
        std::min(static_cast<double>(area.w) / std::max(size.x, 1), static_cast<double>(area.h) / std::max(size.y, 1));
    return zoom > 0 ? zoom : 1;
}

View view_of(const ViewState& state, const Rect& area, glm::ivec2 size) {
    View view{.area = area, .size = glm::max(size, glm::ivec2(1))};
    view.zoom = state.fitted ? fit_zoom(area, view.size) : state.zoom;
    const glm::dvec2 center = state.fitted ? glm::dvec2(0.5) : state.center;
    view.corner = glm::floor(middle(area) - center * glm::dvec2(view.size) * view.zoom + 0.5);
    return view;
}

void set_zoom(ViewState& state, const Rect& area, glm::ivec2 size, double zoom, glm::vec2 about) {
    unfit(state, area, size);
    const double next = std::clamp(zoom, least_zoom(area, size), std::max(most_zoom, fit_zoom(area, size)));
    const glm::dvec2 away = (glm::dvec2(about) - middle(area)) / glm::dvec2(glm::max(size, glm::ivec2(1)));
    state.center = glm::clamp(state.center + away / state.zoom - away / next, 0.0, 1.0);
    state.zoom = next;
}

void step_zoom(ViewState& state, const Rect& area, glm::ivec2 size, int up, glm::vec2 about) {
    const double power = std::log2(view_of(state, area, size).zoom);
    const double next = up > 0 ? std::floor(power + 1e-6) + 1 : std::ceil(power - 1e-6) - 1;
    set_zoom(state, area, size, std::exp2(next), about);
}

void pan(ViewState& state, const Rect& area, glm::ivec2 size, glm::dvec2 px) {
    if (px == glm::dvec2(0)) return;
    unfit(state, area, size);
    state.center = glm::clamp(state.center - px / (glm::dvec2(glm::max(size, glm::ivec2(1))) * state.zoom), 0.0, 1.0);
}

void show_pixel(ViewState& state, const Rect& area, glm::ivec2 size, glm::ivec2 pixel) {
    const Rect box = view_of(state, area, size).pixel_rect(pixel, {1, 1});
    const auto way = [](float low, float high, float from, float to) {
        return low < from ? from - low : high > to ? to - high : 0.0F;
    };
    pan(state, area, size,
        {way(box.x, box.right(), area.x, area.right()), way(box.y, box.bottom(), area.y, area.bottom())});
}

glm::vec2 DragWay::take(const Event& event) {
    if (event.kind == EventKind::press) {
        *this = {true, event.button, event.at};
        return {0, 0};
    }
    if (!on) return {0, 0};
    if (event.kind == EventKind::release || event.kind == EventKind::cancel) on = false;
    if (event.kind != EventKind::pointer && event.kind != EventKind::release) return {0, 0};
    const glm::vec2 way = event.at - last;
    last = event.at;
    return way;
}

bool steer(Ui& ui, const Node& node, ViewState& state, const Rect& area, glm::ivec2 size, bool left_pans) {
    if (!ui.has_events(node.id) || area.empty()) return false;
    const ViewState at_first = state;
    SteerMemory& memory = ui.memory<SteerMemory>(node.id);
    ui.events_of(node.id, [&](const Event& event) {
        const glm::vec2 way = memory.way.take(event);
        switch (event.kind) {
            case EventKind::press:
                memory.before = state;
                memory.pans = event.button == Button::middle || left_pans || ui.key_down(Key::space);
                if (event.button == Button::left && event.clicks == 2 && left_pans) state = {};
                break;
            case EventKind::wheel: {
                const double zoom = view_of(state, area, size).zoom;
                const double wish = zoom * std::exp2(static_cast<double>(event.delta.y) / notches_for_double);
                if (event.delta.y != 0) set_zoom(state, area, size, stop_at_one(zoom, wish), ui.pointer());
                break;
            }
            case EventKind::key:
                steer_by_key(state, area, size, event.key);
                break;
            case EventKind::cancel:
                state = memory.before;
                break;
            default:
                break;
        }
        if (memory.pans) pan(state, area, size, way);
    });
    return state != at_first;
}

}  // namespace lapfx::ui
