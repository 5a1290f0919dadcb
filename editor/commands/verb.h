// What `lapfx` is to do, when it is not said by a verb.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace lapfx::commands {

/// The arguments after the program's name with their verb in front: files and options alone, or nothing at all, are for
/// `edit`, and `help VERB` asks `VERB --help`. Throws Error (bad_input), with the nearest verb, for a first word that
/// is neither a verb nor could be a file.
std::vector<std::string> with_verb(std::vector<std::string> arguments, std::span<const std::string> verbs);

}  // namespace lapfx::commands
