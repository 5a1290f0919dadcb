// Tests that need OpenGL: one headless context for the whole process; without one they skip and say why.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace lapfx::test {

/// Empty when there is a context; otherwise why there is none.
std::string missing_context();

class GpuTest : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;  ///< fails the test if it left an OpenGL error
};

}  // namespace lapfx::test
