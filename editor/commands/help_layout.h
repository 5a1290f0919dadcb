// How help looks: on a terminal, wrapped at 100 columns, and as Markdown on the reference page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "commands/command_line.h"

namespace lapfx::commands {

/// One line of a list: a key of a preset, an action of the tool, a format of files.
struct HelpRow {
    std::string name;
    std::string facts;  ///< what is allowed, and the default; may be empty
    std::string meaning;
};

/// A part of a topic: sentences, then a list. Either may be empty.
struct HelpSection {
    std::string title;
    std::vector<std::string> paragraphs;
    std::string facts_title;  ///< over the column of facts on the page
    std::vector<HelpRow> rows;
};

std::string terminal_text(const HelpSection& section);
std::string markdown(const HelpSection& section);

/// `text` in lines of at most 100 columns, each behind `indent` blanks, with a newline at the end of each.
std::string wrapped(std::string_view text, std::size_t indent);

/// What the help of an option says: what it does, and its default.
std::string meaning_of(const Option& option);
/// "Usage: lapfx render SCENE --output FILE [OPTIONS]". `name`: of the command, with the program's.
std::string usage_of(const Verb& verb, const std::string& name);
/// A command, a part of it or a topic in a list of such.
std::string listed_verb(std::string_view name, std::string_view help);
/// All that `name --help` prints.
std::string help_text(const Verb& verb, const std::string& name);

}  // namespace lapfx::commands
