// Things in a sentence, one after another.
//
//     joined({"event 1", "event 2", "event 4"});  // "event 1, event 2 and event 4"
//
// Pure, any thread.
#pragma once

#include <span>
#include <string>

namespace lapfx::match {

/// "a", "a and b", "a, b and c"; of none it is empty.
std::string joined(std::span<const std::string> parts);

}  // namespace lapfx::match
