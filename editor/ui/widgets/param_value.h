// The arithmetic of a param without a UI: limits, steps, drags, text. Pure functions. All numbers are as they are
// shown: the value times ParamOptions::display.
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "ui/core/event.h"
#include "ui/core/node_parts.h"
#include "ui/value/number.h"

namespace lapfx::ui {

/// All numbers are as they are shown.
struct ParamOptions {
    double minimum = 0, maximum = 1;  ///< soft: of the bar, of dragging and stepping
    double hard_minimum = -std::numeric_limits<double>::infinity();
    double hard_maximum = std::numeric_limits<double>::infinity();  ///< of whatever is done, typing and pasting too
    double step = 0;             ///< of arrows, wheel and Ctrl; 0: something round, about a hundredth of the range
    std::string_view unit = {};  ///< as in ExpressionContext
    std::string_view zero = {};  ///< shown in place of 0, for what that stands for: "automatic"
    ValueScale scale = ValueScale::linear;
    double smallest = 0;                    ///< as in ValueRange
    std::optional<double> standard = {};    ///< what the dot compares with and Backspace goes back to: the saved value
    std::optional<double> initial = {};     ///< the default, that Shift+Backspace goes to
    std::span<const double> initials = {};  ///< the same of each number of a range or a vector
    int decimals = -1;                      ///< -1: those of the step, and up to two more where the value needs them
    std::string_view tip = {};
    double display = 1;  ///< shown is the value times this: 180/pi for an angle kept in rad
    bool integer = false;
    bool single = false;     ///< the value is kept as a float: no more digits than that are meant
    bool locked = false;     ///< held fast for the fit; can still be edited
    bool favourite = false;  ///< for the context menu
    Size width = grow();
};

/// A share kept as 0 to 1, shown and limited in per cent.
ParamOptions percent(ParamOptions percents = {.minimum = 0, .maximum = 100, .step = 1});
/// s. Typed in ms or min just as well.
ParamOptions seconds(ParamOptions options);

/// The same with valid ranges: soft ends that are not numbers become 0 and 1, hard ones are dropped, and ends in the
/// wrong order are swapped.
ParamOptions sound(ParamOptions options);

struct ParamLimits {
    double low, high;
};
/// How far dragging and stepping may go: the soft range within the hard one. From a value outside of it they may only
/// go back to it.
ParamLimits limits_of(const ParamOptions& options, double from);

/// The step of `options`, or a round one if they have none. On scales that are not linear it depends on the place: it
/// is the power of ten below `value`.
double step_of(const ParamOptions& options, double value);
/// The value `count` steps farther; if `fine`, each is a tenth of a step.
double stepped(const ParamOptions& options, double value, double count, bool fine);

/// One move of a drag. `raw` is the exact value of the drag; it moves by `pixels` on a soft range that is `way` px
/// long, and stays within `limits`. Returns the value to show: the roundest number within half a pixel, or with Ctrl
/// (command) the nearest step. Shift: a tenth of the way, a tenth of the step. If range, scale or way change between
/// two moves, the value does not jump.
double dragged(const ParamOptions& options, double& raw, double pixels, double way, Mods mods,
               const ParamLimits& limits);

bool is_standard(const ParamOptions& options, double value);
/// The value without rounding errors in the last digits: 0.1F is 0.1, and an angle of pi/4 is 45.
double cleaned(const ParamOptions& options, double value);
int decimals_for(const ParamOptions& options, double value);
/// The value as it is shown, without its unit. `buffer` has 32 bytes.
std::string_view format_param(std::span<char> buffer, const ParamOptions& options, double value);
/// The value with all its digits, for copying and for the start of an entry.
std::string_view format_whole(std::span<char> buffer, const ParamOptions& options, double value);

}  // namespace lapfx::ui
