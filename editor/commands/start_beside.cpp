#include "commands/start_beside.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <vector>

#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

std::filesystem::path program_folder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

/// Of this process, without the program's name.
std::vector<std::string> own_words() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
    if (!words.empty()) words.erase(words.begin());
    return words;
}

}  // namespace

std::string not_built(const std::string& verb, const std::filesystem::path& folder) {
    const bool builds_here = std::filesystem::exists(folder / "CMakeCache.txt");
    return "not built: `lapfx " + verb + "` needs it; " +
           (builds_here ? "cmake --build " + folder.string()
                        : "it is built from the source tree: cmake --build build") +
           " --target lapfx_" + verb;
}

void start_beside(const std::string& name, std::span<const std::string> arguments, const std::string& not_built) {
    const std::filesystem::path program = program_folder() / name;
    if (!std::filesystem::exists(program))
        throw Error(Failure::runtime, Fault{.file = program.string(), .place = "", .reason = not_built});
    std::cout.flush();
    std::vector<const char*> words{program.c_str()};
    for (const std::string& argument : arguments) words.push_back(argument.c_str());
    words.push_back(nullptr);
    execv(program.c_str(), const_cast<char* const*>(words.data()));
    throw Error(Failure::runtime, Fault{.file = program.string(), .place = "", .reason = std::strerror(errno)});
}

void start_program_of(const std::string& verb) {
    std::vector<std::string> words = own_words();
    if (!words.empty() && words.front() == verb) words.erase(words.begin());
    start_beside("lapfx_" + verb, words, not_built(verb, program_folder()));
}

}  // namespace lapfx::commands
