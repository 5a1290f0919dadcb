#include "commands/help_layout.h"

#include <algorithm>

#include "lapfx/authoring/utf8.h"

namespace lapfx::commands {

namespace {

constexpr std::size_t columns = 100;
constexpr std::size_t name_column = 26;  // where the text about a name begins

/// "  name      meaning"; on a line of its own where the name is long.
std::string listed(const std::string& name, std::string_view meaning) {
    const std::string head = "  " + name;
    const std::string lines = wrapped(meaning, name_column);
    if (count_characters(head) + 2 > name_column) return head + '\n' + lines;
    return head + std::string(name_column - count_characters(head), ' ') +
           lines.substr(std::min(name_column, lines.size()));
}

/// What is inside a cell of a Markdown table.
std::string cell(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
    return out;
}

std::string code(const std::string& text) {
    return text.empty() ? "" : '`' + text + '`';
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t indent) {
    std::string out, line;
    const auto end_line = [&] {
        if (!line.empty()) out += std::string(indent, ' ') + line + '\n';
        line.clear();
    };
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.empty() && indent + count_characters(line) + 1 + count_characters(word) > columns) end_line();
        if (!line.empty()) line += ' ';
        line += word;
    }
    end_line();
    return out;
}

std::string terminal_text(const HelpSection& section) {
    std::string out = section.title + '\n' + std::string(count_characters(section.title), '-') + '\n';
    for (const std::string& paragraph : section.paragraphs) out += '\n' + wrapped(paragraph, 0);
    if (!section.rows.empty()) out += '\n';
    for (const HelpRow& row : section.rows) {
        out += listed(row.name, row.facts.empty() ? row.meaning : row.facts);
        if (!row.facts.empty()) out += wrapped(row.meaning, name_column + 2);
    }
    return out;
}

std::string markdown(const HelpSection& section) {
    std::string out = "### " + section.title + "\n\n";
    for (const std::string& paragraph : section.paragraphs) out += paragraph + "\n\n";
    if (section.rows.empty()) return out;
    const bool facts = !section.facts_title.empty();
    out += facts ? "| name | " + section.facts_title + " | meaning |\n| --- | --- | --- |\n"
                 : std::string("| name | meaning |\n| --- | --- |\n");
    for (const HelpRow& row : section.rows)
        out +=
            "| " + code(cell(row.name)) + " | " + (facts ? cell(row.facts) + " | " : "") + cell(row.meaning) + " |\n";
    return out + '\n';
}

std::string meaning_of(const Option& option) {
    return option.help + (option.standard.empty() ? "" : "; default: " + option.standard);
}

std::string usage_of(const Verb& verb, const std::string& name) {
    std::string out = "Usage: " + name;
    for (const Option& option : verb.options) {
        const std::string argument = option.names + (option.is_list() ? "..." : "");
        if (option.is_argument())
            out += ' ' + (option.rules.required ? argument : '[' + argument + ']');
        else if (option.rules.required)
            out += ' ' + option.split_names().back() + ' ' + option.takes;
    }
    if (!verb.parts.empty()) out += verb.is_program ? " COMMAND ..." : " PART";
    return out + " [OPTIONS]";
}

std::string listed_verb(std::string_view name, std::string_view help) {
    return listed(std::string(name), help);
}

std::string help_text(const Verb& verb, const std::string& name) {
    std::string arguments, options, parts;
    for (const Option& option : verb.options)
        (option.is_argument() ? arguments : options) +=
            listed(option.names + (option.takes.empty() ? "" : ' ' + option.takes), meaning_of(option));
    for (const Verb& part : verb.parts) parts += listed_verb(part.name, part.help);
    std::string out = verb.help + "\n\n" + usage_of(verb, name) + '\n';
    for (const auto& [title, list] : {std::pair{"Positionals", &arguments},
                                      {"Options", &options},
                                      {verb.is_program ? "Commands" : "Parts", &parts}})
        if (!list->empty()) out += std::string("\n") + title + ":\n" + *list;
    return out + '\n' + (verb.footer.empty() ? "" : verb.footer + '\n');
}

}  // namespace lapfx::commands
