// lapfx help: what the commands do, what the tables of the program say, and both as the reference page.
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands/command.h"
#include "commands/completion.h"
#include "commands/help_topics.h"
#include "commands/man_pages.h"
#include "commands/verb.h"
#include "lapfx/authoring/file.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::vector<std::string> words;
    std::string man, completion;
    bool page = false;
};

/// What the help of the program says below its lists.
constexpr std::string_view about =
    "lapfx FILE... alone opens the editor on a scene, a preset, an organ, a smoke clip or a surgery video.\n\n"
    "No command replaces a file that it reads, and a file gets its name when it is complete.\n\n"
    "Exit codes: 0 done, 1 failed while running, 2 wrong usage or bad input, 77 no usable OpenGL.\n"
    "Data goes to stdout, messages to stderr, one line for each fault:\n"
    "  lapfx: FILE: /bleeding/speed: -3 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)";

std::vector<std::string> names_of(const std::vector<Verb>& verbs) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs) names.push_back(verb.name);
    return names;
}

std::vector<std::string> known_words(const Verb& program) {
    std::vector<std::string> words = names_of(program.parts);
    for (const HelpTopic& topic : help_topics()) words.emplace_back(topic.name);
    return words;
}

const Verb* part_named(const Verb& verb, const std::string& name) {
    for (const Verb& part : verb.parts)
        if (part.name == name) return &part;
    return nullptr;
}

/// `words`: "render", or "bench" "streaming".
std::string command_help(const Verb& program, const std::vector<std::string>& words) {
    const Verb* verb = &program;
    std::string name = program.name;
    for (const std::string& word : words) {
        const Verb* const part = part_named(*verb, word);
        if (part == nullptr) throw unknown_word(word, "part of " + name, names_of(verb->parts));
        verb = part;
        name += ' ' + word;
    }
    return help_text(*verb, name);
}

std::string topic_text(const HelpTopic& topic) {
    std::string text;
    for (const HelpSection& section : topic.sections()) text += (text.empty() ? "" : "\n") + terminal_text(section);
    return text;
}

std::string fenced(const std::string& text) {
    return "```text\n" + text.substr(0, text.find_last_not_of('\n') + 1) + "\n```\n\n";
}

/// With one newline at the end.
std::string ended(const std::string& text) {
    return text.substr(0, text.find_last_not_of('\n') + 1) + '\n';
}

/// A topic as Markdown, below a title of the first order: editor/TOUR.md.
std::string topic_page(const HelpTopic& topic) {
    std::string text = "# lapfx help " + std::string(topic.name) + "\n\n" + std::string(topic.help) + ".\n\n";
    for (const HelpSection& section : topic.sections()) text += markdown(section);
    return text;
}

/// All of it as Markdown: presets/REFERENCE.md.
std::string page(const Verb& program) {
    std::string text =
        "# lapfx: reference\n\n"
        "Made by `build/lapfx help --page > presets/REFERENCE.md` from the tables of the program; a test keeps it "
        "current. The same by parts: `lapfx help COMMAND` and `lapfx help TOPIC`.\n\n"
        "## Commands\n\n" +
        fenced(help_text(program, program.name));
    for (const Verb& verb : program.parts) {
        const std::string name = program.name + ' ' + verb.name;
        text += "### " + name + "\n\n" + fenced(help_text(verb, name));
        for (const Verb& part : verb.parts) text += fenced(help_text(part, name + ' ' + part.name));
    }
    for (const HelpTopic& topic : help_topics()) text += '#' + topic_page(topic);
    return ended(text);
}

void write_man_pages(const Verb& program, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Error(
            Failure::runtime,
            Fault{.file = folder.string(), .place = "", .reason = "this folder cannot be made: " + error.message()});
    for (const ManPage& page : man_pages(program, about)) write_file(folder / page.name, page.text);
}

void print(const Verb& program, const Options& o) {
    if (!o.man.empty()) {
        write_man_pages(program, o.man);
        return;
    }
    if (!o.completion.empty()) {
        std::cout << bash_completion(program);
        return;
    }
    if (o.words.empty()) {
        std::cout << (o.page ? page(program) : help_text(program, program.name));
        return;
    }
    const std::string& first = o.words.front();
    for (const HelpTopic& topic : help_topics())
        if (topic.name == first && o.words.size() == 1) {
            std::cout << (o.page ? ended(topic_page(topic)) : topic_text(topic));
            return;
        }
    if (part_named(program, first) == nullptr)
        throw unknown_word(first, "command or topic of help", known_words(program));
    const std::string text = command_help(program, o.words);
    std::cout << (o.page ? ended(fenced(text)) : text);
}

}  // namespace

std::string overview_footer() {
    std::string text = "Topics of `lapfx help TOPIC`:\n";
    for (const HelpTopic& topic : help_topics()) text += listed_verb(topic.name, topic.help);
    return text + '\n' + std::string(about);
}

Verb help_verb() {
    const auto o = std::make_shared<Options>();
    Verb verb{.name = "help",
              .help = "Explain a command, the keys of presets and scenes, or the files",
              .footer =
                  "Examples:\n"
                  "  lapfx help render\n"
                  "  lapfx help preset\n"
                  "  lapfx help --man man\n"
                  "  lapfx help --completion bash",
              .run = [o] { print(program(), *o); }};
    verb.argument("WORD", "A command (render, bench streaming) or a topic; none: the list of both", &o->words);
    verb.flag("--page",
              "Print it as Markdown: without a WORD everything, as presets/REFERENCE.md is; of tour, editor/TOUR.md",
              &o->page);
    verb.option("--man", "DIR", "Write a man page of each command and topic into this folder", &o->man,
                {.excludes = {"WORD", "--page"}});
    verb.option("--completion", "bash", "Print what completes commands, options and files in this shell",
                &o->completion, {.words = {"bash"}, .excludes = {"WORD", "--page", "--man"}});
    return verb;
}

}  // namespace lapfx::commands
