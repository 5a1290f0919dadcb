// Numbers that are dragged, stepped and typed: what a tuning tool is made of.
//
//     param(u, "Speed", speed, {.maximum = 60, .step = 0.5, .unit = "mm/s", .standard = 12});
//     range_param(u, "Luma", low, high, {.maximum = 255, .step = 1});
//
// A press alone changes nothing. A drag of the field changes the value relative to where it was; it begins after 3 px
// and has no bounds, with the pointer hidden. Shift is a tenth as fast, Ctrl goes by steps, both together go by tenths
// of a step; without them a drag takes the roundest number within half a pixel. Esc or the right button puts the value
// back. A double click on the field, Enter, or typing the first character of a number opens an entry, which takes
// expressions and units; Tab takes the number and opens the next field. Backspace, under the pointer or with the focus,
// and a double click on the label go back to the standard, Shift+Backspace to the default. Arrows step, Shift by
// tenths, Page keys by ten; Ctrl+Home and Ctrl+End go to the ends. The wheel steps with Ctrl; without it only when the
// field has the focus and nothing was scrolled for half a second. Ctrl+C and Ctrl+V copy and paste. An entry that is
// not a number is refused. Shares: see percent().
#pragma once

#include "ui/core/ui.h"
#include "ui/widgets/param_value.h"

namespace lapfx::ui {

/// What was chosen in the context menu for the program to do. If it is passed, the menu has these items.
struct ParamActions {
    bool copy_path = false;
    bool toggle_lock = false;
    bool toggle_favourite = false;
    std::optional<ParamLimits> range;  ///< the new soft range, as shown
};

/// A row: label, field. The number shown, also in the semantic tree, is `value` times options.display.
Edit param(Ui& ui, std::string_view label, double& value, const ParamOptions& options = {},
           ParamActions* actions = nullptr);
Edit param(Ui& ui, std::string_view label, float& value, const ParamOptions& options = {},
           ParamActions* actions = nullptr);
Edit param(Ui& ui, std::string_view label, int& value, const ParamOptions& options = {},
           ParamActions* actions = nullptr);

/// The field alone, the label dim inside it: for tables and colours.
Edit number_field(Ui& ui, std::string_view label, double& value, const ParamOptions& options = {});

/// Two numbers, low <= high, in one field: "Label/Low" and "Label/High". Neither passes the other; a press takes the
/// handle that is nearer to the pointer. `standards`: of low and high, or empty.
Edit range_param(Ui& ui, std::string_view label, double& low, double& high, const ParamOptions& options = {},
                 std::span<const double> standards = {});

/// Two to four numbers in one row: "Label/X", "Label/Y" and so on. `standards`: of each, or empty. `letters`: their
/// names.
Edit vector_param(Ui& ui, std::string_view label, std::span<double> values, const ParamOptions& options = {},
                  std::span<const double> standards = {}, std::string_view letters = "XYZW");

}  // namespace lapfx::ui
