// A grip on a canvas (a threshold, a corner, the line of a wipe): a node of its own, so that Tab, tests and screen
// readers find it.
#pragma once

#include <optional>

#include "ui/core/ui.h"

namespace lapfx::ui {

struct HandleOptions {
    std::string_view label;
    std::string_view tip = {};
    glm::vec2 at{0};              ///< px from the parent's upper left corner: where it points to
    glm::vec2 pivot{0.5F, 0.5F};  ///< of its rectangle: what lies there
    Cursor cursor = Cursor::move;
};

/// What was done with it since the last build.
struct HandleMoves {
    Id id = 0;
    bool dragged = false, released = false, cancelled = false;
    bool reset = false;    ///< double click, Backspace or Delete: to the saved value
    bool initial = false;  ///< Shift+Backspace or Shift+Delete: to the default
    bool whole = false;    ///< Ctrl: whole steps
    glm::vec2 to{0};      ///< px from the parent's upper left: where the drag takes `at`; with Shift a tenth of the way
    glm::dvec2 steps{0};  ///< arrows, right and up positive: 1, with Shift 0.1; page keys: 10 in y
    int extreme = 0;      ///< Home -1, End 1
    bool hovered = false, held = false;
};

/// px: even, so that a pivot in the middle lies on a whole px.
float handle_side(const Ui& ui);
/// Adds a handle to the open node, a square as high as a control; the caller then sets text, number and drawing of
/// ui.last().
HandleMoves put_handle(Ui& ui, const HandleOptions& options);

struct HandleRange {
    double minimum = 0, maximum = 1, step = 0.01;
    double reset = 0;                    ///< the saved value
    std::optional<double> initial = {};  ///< the default; none: `reset`
};
/// Turns the moves into an edit of one number, which is clamped. `dragged`: the value at moves.to; `steps`: the steps
/// along the axes that matter.
Edit edit_by_handle(Ui& ui, const HandleMoves& moves, const HandleRange& range, double steps, double dragged,
                    double& value);

/// A colour between the canvas (0) and white (1): canvases are dark in every theme.
inline Color canvas_ink(const Theme& theme, float strength = 0.9F) {
    return mix(theme.canvas, theme.text_on_accent, strength);
}

/// A round knob at the handle's pivot, lit when hovered or held.
struct KnobLook {
    Color color;
    glm::vec2 size{0.8F, 0.8F};  ///< em
    glm::vec2 pivot{0.5F, 0.5F};
};
void draw_knob(Painter& painter, const Node& node, const KnobLook& look);

}  // namespace lapfx::ui
