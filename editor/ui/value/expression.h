// Evaluates what is typed into a number field: "12/2.2", "40%", "250 ms", "2*(3+pi)".
//
// Not muParser: units are only factors to it, so 1 cm * 2 cm is 200 and 2 mm + 3 s is 5; 1,5 is 5, 12/0 infinite, and
// x=7 sets x.
#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace lapfx::ui {

struct ExpressionContext {
    /// Unit of the field: "mm", "s", "mm/s", "%", "deg", "Hz", "px"... A typed unit that measures the same thing
    /// is converted (250 ms in a field of s is 0.25; 1.2 cm in mm is 12); another one is an error. "%" typed into a
    /// field of another unit is that share of `hundred_percent`.
    std::string_view unit = {};
    double hundred_percent = 1;  ///< the field's maximum, usually
    double current = 0;          ///< what "x", and a leading "+=", "-=", "*=", "/=" refer to
};

struct ExpressionError {
    std::size_t at = 0;  ///< byte the fault begins at
    std::string reason;  ///< "expected a number", "mm is not a time: allowed are s, ms, min"
};

/// + - * / ^ ( ), functions sqrt abs min max round, pi; decimal comma is taken as a point where no list can be meant.
/// At most 256 bytes, 64 brackets deep. Never NaN or infinity: that is an error.
std::variant<double, ExpressionError> evaluate(std::string_view text, const ExpressionContext& context = {});

}  // namespace lapfx::ui
