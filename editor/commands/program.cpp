// commands/help.cpp says what exit codes, stdout and stderr mean.
#include "commands/program.h"

#include <malloc.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "commands/command.h"
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

void run(const Verb& program, std::vector<std::string> words) {
    std::vector<std::string> verbs;
    for (const Verb& verb : program.parts) verbs.push_back(verb.name);
    require_values(words);
    words = with_verb(std::move(words), verbs);
    // A new command is guarded like all others. The editor saves what it has opened.
    guard_files(words.front() == "edit" ? FileGuard::note : FileGuard::refuse);
    parse(program, std::move(words), LAPFX_VERSION)();
}

/// Pictures, textures and decoded frames come from the system and go back to it. Left alone, glibc takes the first of
/// them that is freed for a sign that such blocks belong on the heap, up to 32 MB each, where what is freed between
/// others stays: a tenth of the editor's memory. A plane of a small video's frame is large.
void give_large_blocks_back() {
    constexpr int large = 1 << 18;
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
}

/// `verb`: the first of the words, where the program does one alone; else empty.
int run_with(int argc, const char* const* argv, const std::string& verb, const std::function<Verb()>& made) {
    give_large_blocks_back();
    try {
        std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
        if (!verb.empty()) words.insert(words.begin(), verb);
        const Verb program = made();
        run(program, std::move(words));
        return 0;
    } catch (const Error& error) {
        for (const Fault& fault : error.faults()) fail(0, fault.text());
        return exit_code(error.failure());
    } catch (const std::exception& error) {
        return fail(1, printable(error.what()));
    }
}

}  // namespace

int run_program(int argc, const char* const* argv, Verb (*made)()) {
    return run_with(argc, argv, {}, made);
}

int run_verb(int argc, const char* const* argv, Verb (*made)()) {
    return run_with(argc, argv, made().name, [made] { return program_of({made()}); });
}

}  // namespace lapfx::commands
