#include "support/gpu_test.h"

#include "gl/gl.h"
#include "lapfx/context.h"
#include "lapfx/error.h"

namespace lapfx::test {

namespace {

std::string reason;

const Context* context_of_tests() {
    // Never destroyed: other static objects may hold GL names until the process ends.
    static const Context* context = []() -> const Context* {
        try {
            return new Context(Context::create(Backend::automatic));
        } catch (const Error& error) {
            reason = error.what();
            return nullptr;
        }
    }();
    return context;
}

}  // namespace

std::string missing_context() {
    return context_of_tests() != nullptr ? "" : reason;
}

void GpuTest::SetUp() {
    if (const std::string reason = missing_context(); !reason.empty()) GTEST_SKIP() << reason;
    context_of_tests()->make_current();  // a test may have made others
    while (glGetError() != GL_NO_ERROR) {
    }
}

void GpuTest::TearDown() {
    if (missing_context().empty()) {
        context_of_tests()->make_current();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

}  // namespace lapfx::test
