#include "commands/man_pages.h"

#include <algorithm>
#include <regex>

#include "commands/help_layout.h"
#include "commands/help_topics.h"

namespace lapfx::commands {

namespace {

/// The words below the options of a command, as roff.
struct Words {
    std::string about, examples, exit_codes;
};

std::string bold(std::string_view text) {
    return "\\fB" + roff(text) + "\\fR";
}

/// A dot in front of a line would make it a request.
std::string line(const std::string& in_roff) {
    return (in_roff.starts_with('.') ? "\\&" : "") + in_roff + '\n';
}

std::string heading(std::string_view macro, std::string_view title) {
    return std::string(macro) + " \"" + roff(title) + "\"\n";
}

/// `head`: in roff.
std::string entry(const std::string& head, std::string_view meaning) {
    return ".TP\n" + line(head) + line(roff(meaning));
}

std::vector<std::string> split(const std::string& text, const std::string& at) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + at.size()) {
        end = text.find(at, begin);
        parts.push_back(text.substr(begin, end - begin));
    }
    return parts;
}

/// Lines that were laid out for a terminal: text, and behind blanks a list ("  name   meaning") or what stays as it is.
std::string block(const std::vector<std::string>& lines) {
    static const std::regex row(R"( +(\S+) {2,}(\S.*))");
    std::string out = ".PP\n";
    bool as_it_is = false;
    const auto set = [&](bool now) {
        if (now != as_it_is) out += now ? ".RS 4\n.nf\n" : ".fi\n.RE\n";
        as_it_is = now;
    };
    for (const std::string& one : lines) {
        std::smatch found;
        const bool listed = std::regex_match(one, found, row);
        set(one.starts_with(' ') && !listed);
        out += listed ? entry(bold(found[1].str()), found[2].str())
                      : line(roff(std::string_view(one).substr(std::min(one.find_first_not_of(' '), one.size()))));
    }
    set(false);
    return out;
}

Words words_of(const std::string& footer) {
    Words words;
    if (footer.empty()) return words;
    for (const std::string& paragraph : split(footer, "\n\n")) {
        std::vector<std::string> lines = split(paragraph, "\n");
        constexpr std::string_view exit_codes = "Exit codes: ";
        if (lines.front() == "Example:" || lines.front() == "Examples:") {
            lines.erase(lines.begin());
            words.examples += block(lines);
        } else if (lines.front().starts_with(exit_codes)) {
            lines.front().erase(0, exit_codes.size());
            words.exit_codes += block(lines);
        } else {
            words.about += block(lines);
        }
    }
    return words;
}

/// Under each heading: no hyphens in the words of options and keys, and no blanks stretched between them.
std::string begin(const std::string& name, char section, std::string_view meaning) {
    std::string upper = name;
    std::transform(upper.begin(), upper.end(), upper.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
    return ".TH " + roff(upper) + ' ' + section + " \"\" \"lapfx " LAPFX_VERSION "\" lapfx\n.nh\n.ad l\n.SH NAME\n" +
           roff(name) + " \\- " + roff(meaning.substr(0, meaning.find_last_not_of('.') + 1)) + '\n';
}

std::string usage(const CLI::App& app, const std::string& name) {
    const std::string text = CommandFormatter().make_usage(&app, name);
    const std::size_t at = text.find(name) + name.size();
    return line(bold(name) + roff(text.substr(at, text.size() - 1 - at)));
}

std::string options(const CLI::App& app, std::string_view macro, bool positional) {
    std::string out;
    const CommandFormatter formatter;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional() != positional) continue;
        std::string head;
        for (const std::string& name : split(formatter.make_option_name(option, positional), ","))
            head += (head.empty() ? "" : ", ") + bold(name);
        if (!option->get_option_text().empty()) head += " \\fI" + roff(option->get_option_text()) + "\\fR";
        out += entry(head, meaning_of(*option));
    }
    return out.empty() ? "" : heading(macro, positional ? "ARGUMENTS" : "OPTIONS") + out;
}

/// What a page says of a command, or of a part of one. `macro`: of its headings.
std::string command(const CLI::App& app, const std::string& name, std::string_view macro) {
    const Words words = words_of(app.get_footer());
    std::string out = heading(macro, "SYNOPSIS") + usage(app, name) + heading(macro, "DESCRIPTION") +
                      line(roff(app.get_description() + '.')) + words.about + options(app, macro, true) +
                      options(app, macro, false);
    return words.examples.empty() ? out : out + heading(macro, "EXAMPLES") + words.examples;
}

/// Of the file or of other things that a topic is about.
char section_of(const HelpTopic& topic) {
    return topic.name == "preset" || topic.name == "scene" ? '5' : '7';
}

std::string pointer(const std::string& name, char section) {
    return bold(name) + '(' + section + ')';
}

std::string topic_name(const HelpTopic& topic) {
    return "lapfx-" + std::string(topic.name);
}

ManPage command_page(const CLI::App& app) {
    const std::string dashed = "lapfx-" + app.get_name(), name = "lapfx " + app.get_name();
    std::string text = begin(dashed, '1', app.get_description()) + command(app, name, ".SH");
    for (const CLI::App* part : app.get_subcommands({})) {
        const std::string part_name = name + ' ' + part->get_name();
        text += heading(".SH", part_name) + command(*part, part_name, ".SS");
    }
    text += ".SH SEE ALSO\n" + pointer("lapfx", '1');
    for (const HelpTopic& topic : help_topics()) text += ",\n" + pointer(topic_name(topic), section_of(topic));
    return {dashed + ".1", text + '\n'};
}

ManPage topic_page(const HelpTopic& topic) {
    std::string text = begin(topic_name(topic), section_of(topic), topic.help);
    for (const HelpSection& section : topic.sections()) {
        text += heading(".SH", section.title);
        for (const std::string& paragraph : section.paragraphs) text += ".PP\n" + line(roff(paragraph));
        for (const HelpRow& row : section.rows) {
            text += entry(bold(row.name), row.facts.empty() ? row.meaning : row.facts);
            if (!row.facts.empty()) text += ".br\n" + line(roff(row.meaning));
        }
    }
    return {topic_name(topic) + '.' + section_of(topic), text + ".SH SEE ALSO\n" + pointer("lapfx", '1') + '\n'};
}

ManPage program_page(const CLI::App& app, std::string_view about) {
    const Words words = words_of(std::string(about));
    std::string text = begin("lapfx", '1', app.get_description()) + heading(".SH", "SYNOPSIS") + usage(app, "lapfx") +
                       ".br\n" + line(bold("lapfx") + " [FILE...]") + heading(".SH", "DESCRIPTION") +
                       line(roff(app.get_description())) + words.about + heading(".SH", "COMMANDS");
    for (const CLI::App* verb : app.get_subcommands({}))
        text += entry(pointer("lapfx-" + verb->get_name(), '1'), verb->get_description());
    text += heading(".SH", "TOPICS");
    for (const HelpTopic& topic : help_topics())
        text += entry(pointer(topic_name(topic), section_of(topic)), topic.help);
    return {"lapfx.1", text + options(app, ".SH", false) + heading(".SH", "EXIT STATUS") + words.exit_codes};
}

}  // namespace

std::string roff(std::string_view text) {
    std::string out;
    bool code = false;
    for (std::size_t i = 0; i < text.size(); ++i) switch (text[i]) {
            case '\\':
                out += "\\(rs";
                break;
            case '-':  // the minus of options: what is copied from a page works when it is pasted
                out += "\\-";
                break;
            case '\'':
                out += "\\(aq";
                break;
            case '"':
                out += "\\(dq";
                break;
            case '^':
                out += "\\(ha";
                break;
            case '~':
                out += "\\(ti";
                break;
            case '`':
                code = !code;
                out += code ? "\\fB" : "\\fR";
                break;
            case ',':
            case '|':  // a list of keys may be longer than a line, which may end behind each
                out += text[i];
                if (i + 1 < text.size() && text[i + 1] != ' ') out += "\\:";
                break;
            default:
                out += text[i];
        }
    return code ? out + "\\fR" : out;
}

std::vector<ManPage> man_pages(const CLI::App& app, std::string_view about) {
    std::vector<ManPage> pages{program_page(app, about)};
    for (const CLI::App* verb : app.get_subcommands({})) pages.push_back(command_page(*verb));
    for (const HelpTopic& topic : help_topics()) pages.push_back(topic_page(topic));
    return pages;
}

}  // namespace lapfx::commands
