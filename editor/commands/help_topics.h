// The topics of `lapfx help TOPIC`: the tables of the program, and the rules that are in no table.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "commands/help_layout.h"

namespace lapfx::commands {

struct HelpTopic {
    std::string_view name;  ///< "preset"
    std::string_view help;  ///< what it lists
    std::vector<HelpSection> (*sections)();
};

std::span<const HelpTopic> help_topics();

}  // namespace lapfx::commands
