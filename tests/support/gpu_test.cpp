#include "support/gpu_test.h"

#include "gl/gl.h"
#include "lapfx/context.h"
#include "lapfx/error.h"

namespace lapfx::test {

std::string missing_context() {
    static std::string reason;
    // Never destroyed: other static objects may hold GL names until the process ends.
    static const Context* context = [&]() -> const Context* {
        try {
            return new Context(Context::create(Backend::automatic));
        } catch (const Error& error) {
            reason = error.what();
            return nullptr;
        }
    }();
    return context != nullptr ? "" : reason;
}

void GpuTest::SetUp() {
    if (const std::string reason = missing_context(); !reason.empty()) GTEST_SKIP() << reason;
    while (glGetError() != GL_NO_ERROR) {
    }
}

void GpuTest::TearDown() {
    if (missing_context().empty()) {
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

}  // namespace lapfx::test
