#include "commands/man_pages.h"

#include <algorithm>
#include <optional>
#include <utility>

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

/// Name and meaning of "  name   meaning"; nothing of other lines.
std::optional<std::pair<std::string, std::string>> list_row(std::string_view one) {
    const std::size_t name = one.find_first_not_of(' ');
    if (name == 0 || name == std::string_view::npos) return std::nullopt;
    const std::size_t end = one.find(' ', name);
    if (end == std::string_view::npos) return std::nullopt;
    const std::size_t meaning = one.find_first_not_of(' ', end);
    if (meaning == std::string_view::npos || meaning < end + 2) return std::nullopt;
    return std::pair(std::string(one.substr(name, end - name)), std::string(one.substr(meaning)));
}

/// Lines that were laid out for a terminal: text, and behind blanks a list ("  name   meaning") or what stays as it is.
std::string block(const std::vector<std::string>& lines) {
    std::string out = ".PP\n";
    bool as_it_is = false;
    const auto set = [&](bool now) {
        if (now != as_it_is) out += now ? ".RS 4\n.nf\n" : ".fi\n.RE\n";
        as_it_is = now;
    };
    for (const std::string& one : lines) {
        const auto row = list_row(one);
        set(one.starts_with(' ') && !row);
        out += row ? entry(bold(row->first), row->second)
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

std::string usage(const Verb& verb, const std::string& name) {
    const std::string text = usage_of(verb, name);
    return line(bold(name) + roff(text.substr(text.find(name) + name.size())));
}

std::string options(const Verb& verb, std::string_view macro, bool arguments) {
    std::string out;
    for (const Option& option : verb.options) {
        if (option.is_argument() != arguments) continue;
        std::string head;
        for (const std::string& name : split(option.names, ",")) head += (head.empty() ? "" : ", ") + bold(name);
        if (!option.takes.empty()) head += " \\fI" + roff(option.takes) + "\\fR";
        out += entry(head, meaning_of(option));
    }
    return out.empty() ? "" : heading(macro, arguments ? "ARGUMENTS" : "OPTIONS") + out;
}

/// What a page says of a command, or of a part of one. `macro`: of its headings.
std::string command(const Verb& verb, const std::string& name, std::string_view macro) {
    const Words words = words_of(verb.footer);
    std::string out = heading(macro, "SYNOPSIS") + usage(verb, name) + heading(macro, "DESCRIPTION") +
                      line(roff(verb.help + '.')) + words.about + options(verb, macro, true) +
                      options(verb, macro, false);
    return words.examples.empty() ? out : out + heading(macro, "EXAMPLES") + words.examples;
}

/// Section 5 has the topics about a file, section 7 the others.
char section_of(const HelpTopic& topic) {
    return topic.name == "preset" || topic.name == "scene" ? '5' : '7';
}

std::string pointer(const std::string& name, char section) {
    return bold(name) + '(' + section + ')';
}

std::string topic_name(const HelpTopic& topic) {
    return "lapfx-" + std::string(topic.name);
}

ManPage command_page(const Verb& verb) {
    const std::string dashed = "lapfx-" + verb.name, name = "lapfx " + verb.name;
    std::string text = begin(dashed, '1', verb.help) + command(verb, name, ".SH");
    for (const Verb& part : verb.parts) {
        const std::string part_name = name + ' ' + part.name;
        text += heading(".SH", part_name) + command(part, part_name, ".SS");
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

ManPage program_page(const Verb& program, std::string_view about) {
    const Words words = words_of(std::string(about));
    std::string text = begin("lapfx", '1', program.help) + heading(".SH", "SYNOPSIS") + usage(program, "lapfx") +
                       ".br\n" + line(bold("lapfx") + " [FILE...]") + heading(".SH", "DESCRIPTION") +
                       line(roff(program.help)) + words.about + heading(".SH", "COMMANDS");
    for (const Verb& verb : program.parts) text += entry(pointer("lapfx-" + verb.name, '1'), verb.help);
    text += heading(".SH", "TOPICS");
    for (const HelpTopic& topic : help_topics())
        text += entry(pointer(topic_name(topic), section_of(topic)), topic.help);
    return {"lapfx.1", text + options(program, ".SH", false) + heading(".SH", "EXIT STATUS") + words.exit_codes};
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

std::vector<ManPage> man_pages(const Verb& program, std::string_view about) {
    std::vector<ManPage> pages{program_page(program, about)};
    for (const Verb& verb : program.parts) pages.push_back(command_page(verb));
    for (const HelpTopic& topic : help_topics()) pages.push_back(topic_page(topic));
    return pages;
}

}  // namespace lapfx::commands
