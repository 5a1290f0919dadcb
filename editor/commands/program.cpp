// commands/help.cpp says what exit codes, stdout and stderr mean.
#include "commands/program.h"

#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "commands/help_layout.h"
#include "commands/verb.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/printable.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

int fail(int code, const std::string& line) {
    std::cerr << "lapfx: " << line << '\n';
    return code;
}

int run(std::span<const std::string> words, const AddVerbs& add_verbs) {
    CLI::App app{"Bleeding and surgical smoke for laparoscopic simulators: editor and headless commands.", "lapfx"};
    app.set_version_flag("--version", LAPFX_VERSION, "Print the version");
    app.require_subcommand(0, 1);
    app.formatter(std::make_shared<CommandFormatter>());
    add_verbs(app);
    std::vector<std::string> verbs;
    for (CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->group("Commands")->get_name());
    std::vector<std::string> arguments(words.begin(), words.end());
    require_values(arguments);
    arguments = with_verb(std::move(arguments), verbs);
    // A new command is guarded like all others. The editor saves what it has opened.
    guard_files(arguments.front() == "edit" ? FileGuard::note : FileGuard::refuse);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::Success& done) {  // --help, --version
        return app.exit(done);
    } catch (const CLI::ParseError& wrong) {
        return fail(2, printable(wrong.what()) + " (see lapfx help)");
    }
    return 0;
}

/// Pictures, textures and decoded frames come from the system and go back to it. Left alone, glibc takes the first of
/// them that is freed for a sign that such blocks belong on the heap, up to 32 MB each, where what is freed between
/// others stays: a tenth of the editor's memory. A plane of a small video's frame is large.
void give_large_blocks_back() {
    constexpr int large = 1 << 18;
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
}

}  // namespace

int run_program(std::span<const std::string> words, const AddVerbs& add_verbs) {
    give_large_blocks_back();
    try {
        return run(words, add_verbs);
    } catch (const Error& error) {
        for (const Fault& fault : error.faults()) fail(0, fault.text());
        return exit_code(error.failure());
    } catch (const std::exception& error) {
        return fail(1, printable(error.what()));
    }
}

int run_program(const std::string& verb, int argc, const char* const* argv, const AddVerbs& add_verb) {
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    words.insert(words.begin(), verb);
    return run_program(words, add_verb);
}

}  // namespace lapfx::commands
