// A fixture for tests of the toolkit that need OpenGL. EGL makes one context without a window for the whole process; if
// it cannot, the tests are skipped and say why. It uses nothing of the effects core.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace lapfx::ui::test {

/// Empty when there is an OpenGL 4.5 core context, which is then current; otherwise the reason why there is none.
std::string missing_context();

class GlTest : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;  ///< fails the test when it left an OpenGL error behind
};

}  // namespace lapfx::ui::test
