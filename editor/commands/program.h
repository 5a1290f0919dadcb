// What main() of `lapfx` does, and of the programs that it starts for a verb (start_beside.h).
#pragma once

#include "commands/command_line.h"

namespace lapfx::commands {

/// Guards files, parses, runs a verb; failures become lines on stderr. `made`: the program with its verbs. The exit
/// code (commands/help.cpp).
int run_program(int argc, const char* const* argv, Verb (*made)());

/// The same for a program that does one verb, whose words lack it.
int run_verb(int argc, const char* const* argv, Verb (*made)());

}  // namespace lapfx::commands
