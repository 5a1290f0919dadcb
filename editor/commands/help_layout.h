// How help looks: on a terminal, wrapped at 100 columns, and as Markdown on the reference page.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

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
std::string meaning_of(const CLI::Option& option);

/// Formats the help of commands. The option_text of an option ("WxH") says what it takes; its default follows its
/// description. Where it takes one of several words or kinds of files, '|' is between them ("dark|light"), and one of
/// files is FILE with their ending ("FILE.json"): bash is told so, too (completion.h).
class CommandFormatter : public CLI::Formatter {
  public:
    std::string make_usage(const CLI::App* app, std::string name) const override;
    std::string make_option(const CLI::Option* option, bool is_positional) const override;
    std::string make_subcommand(const CLI::App* command) const override;
};

}  // namespace lapfx::commands
