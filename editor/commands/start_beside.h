// Programs that lie beside this one and do what it does not link.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace lapfx::commands {

/// This process becomes the program of the verb, lapfx_VERB in the folder of this one, which gets the words of the
/// command line behind the verb; what is printed so far goes out first. Throws Error (runtime) where it is not built,
/// with what builds it, or cannot be started.
[[noreturn]] void start_program_of(const std::string& verb);

/// The same for any program and arguments; `not_built`: the fault where there is none.
[[noreturn]] void start_beside(const std::string& name, std::span<const std::string> arguments,
                               const std::string& not_built);

/// That a verb's program is missing and what builds it: by name in `folder` where that is a build folder, else from the
/// source tree.
std::string not_built(const std::string& verb, const std::filesystem::path& folder);

}  // namespace lapfx::commands
