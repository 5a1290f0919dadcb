// Tests of the toolkit that need OpenGL: one context without a window for the whole process, made through EGL; without
// one they skip and say why. Nothing of the effects core.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace lapfx::ui::test {

/// Empty when there is an OpenGL 4.5 core context, which then is current; else why there is none.
std::string missing_context();

class GlTest : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;  ///< fails the test when it left an OpenGL error behind
};

}  // namespace lapfx::ui::test
