// A curve that is drawn with the pointer and the keyboard.
//
//     ui::curve_editor(u, "Response", curve, {.x_name = "Age", .x_unit = "s", .standard = &preset, .live = age});
//
// A double click on the ground inserts a point and starts to drag it; a drag on the ground selects with a box (Shift
// adds to the selection). A drag on a point moves all selected points (Shift: a tenth of the way, Ctrl: in steps).
// Shift+click adds to the selection. A double click or a typed digit opens an entry ("0.5" is y, "0.2; 0.5" is x and y;
// Enter takes it, Esc leaves it). Arrows move by a step (Shift: a tenth, Ctrl: ten), Delete and Backspace erase, I
// inserts a point half-way to the next one. Esc and the other button cancel a drag.
//
// Each point is a node: "Response/Point 3".
#pragma once

#include <limits>

#include "ui/canvas/axis.h"
#include "ui/canvas/curve.h"
#include "ui/core/ui.h"

namespace lapfx::ui {

struct CurveEditorOptions {
    Span x = {}, y = {};  ///< what is shown and what points can be moved to; low < high (assert)
    double x_step = 0.01, y_step = 0.01;
    std::string_view x_name = {}, x_unit = {}, y_name = {}, y_unit = {};
    const Curve* standard = nullptr;  ///< drawn as a ghost; must outlive the frame
    double live =
        std::numeric_limits<double>::quiet_NaN();  ///< the input of this moment: a dot on the curve; NaN: none
    Size width = {SizeKind::grow, 1};
    Size height = {SizeKind::fit, 0};  ///< fit: 14 em
    std::string_view tip = {};
};

/// `curve` must outlive the frame.
Edit curve_editor(Ui& ui, std::string_view label, Curve& curve, const CurveEditorOptions& options = {});

}  // namespace lapfx::ui
