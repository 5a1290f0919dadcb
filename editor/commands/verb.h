// Finds the command that the first word of `lapfx` names, and the message for an unknown word.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lapfx/error.h"

namespace lapfx::commands {

/// The arguments after the program's name with their verb in front: files and options alone, or nothing at all, are for
/// `edit`. Throws Error (bad_input), with the nearest verb, for a first word that is neither a verb nor could be a
/// file.
std::vector<std::string> with_verb(std::vector<std::string> arguments, std::span<const std::string> verbs);

/// Throws Error (bad_input) for an argument that is empty, or `--option=` with nothing behind it: an unset variable of
/// a shell is no wish to do without what the option names.
void require_values(std::span<const std::string> arguments);

/// `"shet" is not a command or topic of help; nearest is sheet (see lapfx help)`. `known` has at least one word.
Error unknown_word(const std::string& word, const std::string& what, std::span<const std::string> known);

}  // namespace lapfx::commands
