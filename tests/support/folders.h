// Where a test finds the project, asked when it runs: a path that is compiled in would differ in each clone, and the
// compiler cache would miss.
#pragma once

#include <filesystem>

namespace lapfx::test {

/// The build folder: test programs lie at its top, beside `lapfx`.
inline std::filesystem::path build_folder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

/// The project's source folder, by the link that the build folder has for the programs (CMakeLists.txt).
inline std::filesystem::path source_folder() {
    return std::filesystem::canonical(build_folder() / "share" / "lapfx");
}

/// The shipped files with smaller textures and videos, and of the organ what the camera sees (light_samples.cpp).
inline std::filesystem::path light_folder() {
    return build_folder() / "light";
}

}  // namespace lapfx::test
