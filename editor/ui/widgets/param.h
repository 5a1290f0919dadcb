// Numbers that are dragged, stepped and typed: what a tuning tool is made of.
//
//     param(u, "Speed", speed, {.maximum = 60, .step = 0.5, .unit = "mm/s", .standard = 12});
//     param(u, "Tilt", radians, angle());
//     range_param(u, "Luma", low, high, {.maximum = 255, .step = 1});
//
// A press never changes anything. Dragging the field is relative and begins after 3 px, the pointer hidden and free to
// go on for ever; Shift goes a tenth as fast, Ctrl goes by steps, both by tenths of a step; else the roundest number
// within half a pixel is taken. Esc or the right button puts the value back. A double click on the field, Enter, or
// what a number or an expression begins with opens it for one, with units; Tab takes it and opens the next. Backspace,
// under the pointer or with the focus, and a double click on the label go back to the standard, Shift+Backspace to the
// default. Arrows step, Shift by tenths, Page keys by ten; Ctrl+Home and Ctrl+End go to the ends. The wheel steps with
// Ctrl; without it only when the field has the focus and nothing was scrolled for half a second. Ctrl+C and Ctrl+V copy
// and paste. What is not a number is refused. Angles and shares: see angle() and percent().
#pragma once

#include "ui/core/ui.h"
#include "ui/widgets/param_value.h"

namespace lapfx::ui {

/// What was chosen in the context menu and is the program's to do. Given: the menu has these items, too.
struct ParamActions {
    bool copy_path = false;
    bool toggle_lock = false;
    bool toggle_favourite = false;
    std::optional<ParamLimits> range;  ///< the new soft range, as shown
};

/// A row: label, field. `value` times options.display is what is shown and what the semantic tree has.
Edit param(Ui& ui, std::string_view label, double& value, const ParamOptions& options = {},
           ParamActions* actions = nullptr);
Edit param(Ui& ui, std::string_view label, float& value, const ParamOptions& options = {},
           ParamActions* actions = nullptr);
Edit param(Ui& ui, std::string_view label, int& value, const ParamOptions& options = {},
           ParamActions* actions = nullptr);

/// The field alone, the label dim inside it: for tables and colours.
Edit number_field(Ui& ui, std::string_view label, double& value, const ParamOptions& options = {});

/// Two numbers, low <= high, in one field: "Label/Low" and "Label/High". Each goes as far as the other; whichever
/// handle is nearer to the pointer is taken. `standards`: of low and high, or empty.
Edit range_param(Ui& ui, std::string_view label, double& low, double& high, const ParamOptions& options = {},
                 std::span<const double> standards = {});

/// Two to four numbers in one row: "Label/X", "Label/Y" and so on. `standards`: of each, or empty. `letters`: their
/// names.
Edit vector_param(Ui& ui, std::string_view label, std::span<double> values, const ParamOptions& options = {},
                  std::span<const double> standards = {}, std::string_view letters = "XYZW");
Edit param(Ui& ui, std::string_view label, glm::vec2& value, const ParamOptions& options = {},
           std::span<const double> standards = {});
Edit param(Ui& ui, std::string_view label, glm::vec3& value, const ParamOptions& options = {},
           std::span<const double> standards = {});

}  // namespace lapfx::ui
