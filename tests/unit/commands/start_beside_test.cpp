#include "commands/start_beside.h"

#include <gtest/gtest.h>

#include <fstream>

#include "unit/preset/support.h"

namespace lapfx::commands {
namespace {

/// A build folder is built by name; a program that was installed has none.
TEST(StartBeside, SaysHowWhatIsMissingIsBuilt) {
    const lapfx::test::Folder folder;
    EXPECT_EQ(not_built("bench", folder.path()),
              "not built: `lapfx bench` needs it; it is built from the source tree: cmake --build build --target "
              "lapfx_bench");
    std::ofstream(folder / "CMakeCache.txt") << "# here";
    EXPECT_EQ(not_built("bench", folder.path()),
              "not built: `lapfx bench` needs it; cmake --build " + folder.path().string() + " --target lapfx_bench");
}

TEST(StartBeside, WhatIsMissingIsOneFaultWithItsPlace) {
    const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    const auto faults = lapfx::test::faults_of([] { start_program_of("attic"); }, Failure::runtime);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0], (here / "lapfx_attic").string() + ": " + not_built("attic", here));
}

}  // namespace
}  // namespace lapfx::commands
