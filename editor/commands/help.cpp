// lapfx help: what the commands do, what the tables of the program say, and both as the reference page.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

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

std::string overview_footer() {
    std::string text = "Topics of `lapfx help TOPIC`:\n";
    CommandFormatter formatter;
    for (const HelpTopic& topic : help_topics()) {
        const CLI::App line{std::string(topic.help), std::string(topic.name)};
        text += formatter.make_subcommand(&line);
    }
    return text + '\n' + std::string(about);
}

std::vector<std::string> known_words(const CLI::App& app) {
    std::vector<std::string> words;
    for (const CLI::App* command : app.get_subcommands({})) words.push_back(command->get_name());
    for (const HelpTopic& topic : help_topics()) words.emplace_back(topic.name);
    return words;
}

/// CLI::App::help() would give the help of the parsed command, which is `help`.
std::string help_of(const CLI::App& app, const std::string& name) {
    return app.get_formatter()->make_help(&app, name, CLI::AppFormatMode::Normal);
}

const CLI::App* part_named(const CLI::App& app, const std::string& name) {
    for (const CLI::App* command : app.get_subcommands({}))
        if (command->get_name() == name) return command;
    return nullptr;
}

/// `words`: "render", or "bench" "streaming".
std::string command_help(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App* command = &app;
    std::string name = app.get_name();
    for (const std::string& word : words) {
        const CLI::App* part = part_named(*command, word);
        if (part == nullptr) {
            std::vector<std::string> parts;
            for (const CLI::App* known : command->get_subcommands({})) parts.push_back(known->get_name());
            throw unknown_word(word, "part of " + name, parts);
        }
        command = part;
        name += ' ' + word;
    }
    return help_of(*command, name);
}

std::string topic_text(const HelpTopic& topic) {
    std::string text;
    for (const HelpSection& section : topic.sections()) text += (text.empty() ? "" : "\n") + terminal_text(section);
    return text;
}

std::string fenced(const std::string& text) {
    return "```text\n" + text.substr(0, text.find_last_not_of('\n') + 1) + "\n```\n\n";
}

/// All of it as Markdown: presets/REFERENCE.md.
std::string page(const CLI::App& app) {
    std::string text =
        "# lapfx: reference\n\n"
        "Made by `build/lapfx help --page > presets/REFERENCE.md` from the tables of the program; a test keeps it "
        "current. The same by parts: `lapfx help COMMAND` and `lapfx help TOPIC`.\n\n"
        "## Commands\n\n" +
        fenced(help_of(app, app.get_name()));
    for (const CLI::App* command : app.get_subcommands({})) {
        text += "### lapfx " + command->get_name() + "\n\n" + fenced(help_of(*command, "lapfx " + command->get_name()));
        for (const CLI::App* part : command->get_subcommands({}))
            text += fenced(help_of(*part, "lapfx " + command->get_name() + ' ' + part->get_name()));
    }
    for (const HelpTopic& topic : help_topics()) {
        text += "## lapfx help " + std::string(topic.name) + "\n\n" + std::string(topic.help) + ".\n\n";
        for (const HelpSection& section : topic.sections()) text += markdown(section);
    }
    return text.substr(0, text.find_last_not_of('\n') + 1) + '\n';
}

void write_man_pages(const CLI::App& app, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Error(
            Failure::runtime,
            Fault{.file = folder.string(), .place = "", .reason = "this folder cannot be made: " + error.message()});
    for (const ManPage& page : man_pages(app, about)) write_file(folder / page.name, page.text);
}

void print(const CLI::App& app, const Options& o) {
    if (!o.man.empty()) {
        write_man_pages(app, o.man);
        return;
    }
    if (!o.completion.empty()) {
        std::cout << bash_completion(app);
        return;
    }
    if (o.page) {
        std::cout << page(app);
        return;
    }
    if (o.words.empty()) {
        std::cout << help_of(app, app.get_name());
        return;
    }
    const std::string& first = o.words.front();
    for (const HelpTopic& topic : help_topics())
        if (topic.name == first && o.words.size() == 1) {
            std::cout << topic_text(topic);
            return;
        }
    if (part_named(app, first) == nullptr) throw unknown_word(first, "command or topic of help", known_words(app));
    std::cout << command_help(app, o.words);
}

}  // namespace

void add_help(CLI::App& app) {
    auto o = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("help", "Explain a command, the keys of presets and scenes, or the files");
    verb->add_option("WORD", o->words, "A command (render, bench streaming) or a topic; none: the list of both");
    auto* page = verb->add_flag("--page", o->page, "Print everything as one Markdown page: presets/REFERENCE.md")
                     ->excludes("WORD");
    auto* man = verb->add_option("--man", o->man, "Write a man page of each command and topic into this folder")
                    ->option_text("DIR")
                    ->excludes("WORD")
                    ->excludes(page);
    verb->add_option("--completion", o->completion, "Print what completes commands, options and files in this shell")
        ->option_text("bash")
        ->check(CLI::IsMember({"bash"}))
        ->excludes("WORD")
        ->excludes(page)
        ->excludes(man);
    verb->footer(
        "Examples:\n"
        "  lapfx help render\n"
        "  lapfx help preset\n"
        "  lapfx help --man man\n"
        "  lapfx help --completion bash");
    verb->callback([o, &app] { print(app, *o); });
    app.footer(overview_footer());
}

}  // namespace lapfx::commands
