// What a fit has made worse: it brings the amounts nearer, and may do so at the cost of one of them, or of a colour.
//
//     for (const std::string& line : match::what_is_worse(result)) warn(line);  // before it is taken
//
// Pure, any thread.
#pragma once

#include <string>
#include <vector>

#include "match/fit/fit.h"

namespace lapfx::match {

/// A line for each figure that is farther from the reference than before, and by more than can be seen: "colour of
/// tissue: Delta E 6.5 before, 11.9 after". What was not measured before and after says nothing.
std::vector<std::string> what_is_worse(const FitResult& result);

}  // namespace lapfx::match
