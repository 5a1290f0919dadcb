// What completes the command line of lapfx in bash, made from the options of its commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "commands/command_line.h"

namespace lapfx::commands {

/// A script for bash that completes commands, their parts and options, and values: words where an option takes one of
/// some, and files of the kinds that are taken.
std::string bash_completion(const Verb& program);

/// What a value may be.
struct Values {
    std::vector<std::string> words;
    std::vector<std::string> endings;  ///< names of files end so; "" fits all files, "/" folders alone
};

/// By what an option or an argument says that it takes: "dark|light", "FILE.json", "VIDEO", "KEY=VALUE" (nothing).
Values values_of(std::string_view takes);

}  // namespace lapfx::commands
