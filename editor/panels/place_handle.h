// Handles that stand for places of a picture: what a drag, the arrows and Esc make of such a place.
//
//     glm::dvec2 place = corner;
//     const ui::HandleMoves moves = panels::put_place(ui, view, "Corner", "A corner of the part", place);
//     const ui::Edit edit = panels::edit_place(ui, view, moves, [](glm::dvec2 p) { return glm::clamp(p, 0.0, 1.0); },
//                                              place);
//
// Places are fractions of the picture from its upper left corner.
#pragma once

#include "ui/canvas/drag_handle.h"
#include "ui/canvas/view.h"
#include "ui/widgets/rows.h"

namespace lapfx::panels {

/// What is dragged is not kept finer than a ten-thousandth of the picture.
double rounded_place(double fraction);

/// A handle over the picture; its text says where it is. The caller sets its drawing (ui.last()).
ui::HandleMoves put_place(ui::Ui& ui, const ui::View& view, std::string_view label, std::string_view tip,
                          glm::dvec2 place, ui::Cursor cursor = ui::Cursor::move);

/// One gesture of it. Arrows move by a pixel of the picture, with Shift by ten. `clamp` keeps a place where it may be.
ui::Edit edit_place(ui::Ui& ui, const ui::View& view, const ui::HandleMoves& moves,
                    const ui::FunctionRef<glm::dvec2(glm::dvec2)>& clamp, glm::dvec2& place);

}  // namespace lapfx::panels
