// The man pages of lapfx: the help of its commands and topics, as roff with the macros of man(7).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "commands/command_line.h"

namespace lapfx::commands {

struct ManPage {
    std::string name;  ///< of its file: "lapfx-render.1"
    std::string text;
};

/// A page of the program, one for each command (its parts are on it) and one for each topic of help: 5 for files, 7 for
/// all else. `about`: what the help of the program says below its lists.
std::vector<ManPage> man_pages(const Verb& program, std::string_view about);

/// `text` as it is written in roff so that it is printed as it is, but for what is between backticks: that is bold.
std::string roff(std::string_view text);

}  // namespace lapfx::commands
