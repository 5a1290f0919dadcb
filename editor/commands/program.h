// What main() of `lapfx` does, and of the programs that it starts for a verb (start_beside.h).
#pragma once

#include <functional>
#include <span>
#include <string>

namespace CLI {
class App;
}

namespace lapfx::commands {

using AddVerbs = std::function<void(CLI::App& app)>;

/// Guards files, parses, runs a verb; failures become lines on stderr. `words`: all but the program's name. The exit
/// code (commands/help.cpp).
int run_program(std::span<const std::string> words, const AddVerbs& add_verbs);

/// The same for a program that does one verb, whose words lack it.
int run_program(const std::string& verb, int argc, const char* const* argv, const AddVerbs& add_verb);

}  // namespace lapfx::commands
