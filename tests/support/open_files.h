// How many files the program has open, to see that what rests holds none.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iterator>

namespace lapfx::test {

inline std::ptrdiff_t open_files() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
}

}  // namespace lapfx::test
