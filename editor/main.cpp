// lapfx: the editor and its headless commands. commands/help.cpp says what exit codes, stdout and stderr mean.
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "commands/command.h"
#include "commands/help_layout.h"
#include "commands/verb.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/printable.h"
#include "lapfx/error.h"

namespace {

int fail(int code, const std::string& line) {
    std::cerr << "lapfx: " << line << '\n';
    return code;
}

int run(int argc, char** argv) {
    CLI::App app{"Bleeding and surgical smoke for laparoscopic simulators: editor and headless commands.", "lapfx"};
    app.set_version_flag("--version", LAPFX_VERSION, "Print the version");
    app.require_subcommand(0, 1);
    app.formatter(std::make_shared<lapfx::commands::CommandFormatter>());
    lapfx::commands::add_edit(app);
    lapfx::commands::add_render(app);
    lapfx::commands::add_sheet(app);
    lapfx::commands::add_picture(app);
    lapfx::commands::add_measure(app);
    lapfx::commands::add_fit(app);
    lapfx::commands::add_batch(app);
    lapfx::commands::add_compare(app);
    lapfx::commands::add_inspect(app);
    lapfx::commands::add_check(app);
    lapfx::commands::add_migrate(app);
    lapfx::commands::add_bench(app);
    lapfx::commands::add_gallery(app);
    lapfx::commands::add_help(app);
    std::vector<std::string> verbs;
    for (CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->group("Commands")->get_name());
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    lapfx::commands::require_values(arguments);
    arguments = lapfx::commands::with_verb(std::move(arguments), verbs);
    // A new command is guarded like all others. The editor saves what it has opened.
    lapfx::guard_files(arguments.front() == "edit" ? lapfx::FileGuard::note : lapfx::FileGuard::refuse);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::Success& done) {  // --help, --version
        return app.exit(done);
    } catch (const CLI::ParseError& wrong) {
        return fail(2, lapfx::printable(wrong.what()) + " (see lapfx help)");
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

int main(int argc, char** argv) {
    give_large_blocks_back();
    try {
        return run(argc, argv);
    } catch (const lapfx::Error& error) {
        for (const lapfx::Fault& fault : error.faults()) fail(0, fault.text());
        return lapfx::exit_code(error.failure());
    } catch (const std::exception& error) {
        return fail(1, lapfx::printable(error.what()));
    }
}
