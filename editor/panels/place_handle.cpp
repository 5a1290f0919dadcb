#include "panels/place_handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/core/node.h"

namespace lapfx::panels {

namespace {

constexpr double finest = 1e-4;
constexpr float edge = 0.5F;  // em

struct DragMemory {
    glm::dvec2 start{0};
    glm::vec2 shift{0};  ///< px that the handle was put into sight by
    bool changed = false;
};

glm::vec2 on_screen(const ui::View& view, glm::dvec2 place) {
    return glm::vec2(view.to_screen(place * glm::dvec2(view.size)));
}

/// px by which a handle at the edge of the view is put inside, where it can be grabbed. None where it is out of sight.
glm::vec2 into_sight(ui::Ui& ui, const ui::View& view, glm::dvec2 place) {
    const glm::vec2 at = on_screen(view, place);
    if (!view.area.inset(-1).contains(at)) return {0, 0};
    const ui::Rect room = view.area.inset(std::min(ui.em(edge), std::min(view.area.w, view.area.h) / 2));
    return glm::clamp(at, room.at(), room.at() + room.size()) - at;
}

}  // namespace

double rounded_place(double fraction) {
    return std::round(fraction / finest) * finest;
}

ui::HandleMoves put_place(ui::Ui& ui, const ui::View& view, std::string_view label, std::string_view tip,
                          glm::dvec2 place, ui::Cursor cursor) {
    const glm::vec2 at = on_screen(view, place) + into_sight(ui, view, place) - view.area.at();
    const ui::HandleMoves moves = ui::put_handle(ui, {.label = label, .tip = tip, .at = at, .cursor = cursor});
    char text[64];
    std::snprintf(text, sizeof text, "%.1f %% from the left, %.1f %% from the top", 100 * place.x, 100 * place.y);
    ui.last().text = ui.copy(text);
    return moves;
}

ui::Edit edit_place(ui::Ui& ui, const ui::View& view, const ui::HandleMoves& moves,
                    const ui::FunctionRef<glm::dvec2(glm::dvec2)>& clamp, glm::dvec2& place) {
    ui::Edit edit;
    if (moves.id == 0) return edit;
    DragMemory& memory = ui.memory<DragMemory>(moves.id);
    const glm::dvec2 size(view.size), before = place;
    if (moves.steps != glm::dvec2(0)) {
        // Shift gives the larger step here, since there is nothing finer than a pixel.
        const double stride = std::abs(moves.steps.x) + std::abs(moves.steps.y) < 1 ? 100 : 1;
        place = clamp(place + glm::dvec2(moves.steps.x, -moves.steps.y) * stride / size);
        return place != before ? ui::Edit::once() : edit;
    }
    if (moves.dragged) {
        if (!memory.changed) memory.shift = into_sight(ui, view, before);
        const glm::dvec2 at = view.to_picture(moves.to - memory.shift + view.area.at()) / size;
        place = clamp({rounded_place(at.x), rounded_place(at.y)});
        edit.changed = place != before;
        if (edit.changed && !memory.changed) memory.start = before, edit.began = true;
        memory.changed |= edit.changed;
    }
    if (memory.changed && moves.released) edit.committed = true;
    if (memory.changed && moves.cancelled) place = memory.start, edit.cancelled = true, edit.changed = true;
    if (moves.released || moves.cancelled) memory.changed = false;
    return edit;
}

}  // namespace lapfx::panels
