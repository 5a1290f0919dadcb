#include "ui/support/gl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <glad/gl.h>

namespace lapfx::ui::test {

namespace {

/// Never undone: the process ends with it.
std::string make_context() {
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
        return "EGL has no display without a window";
    }
    eglBindAPI(EGL_OPENGL_API);
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT || eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
        return "the driver gives no OpenGL 4.5 core context";
    }
    return gladLoadGL(eglGetProcAddress) != 0 ? "" : "OpenGL's functions are not there";
}

}  // namespace

std::string missing_context() {
    static const std::string reason = make_context();
    return reason;
}

void GlTest::SetUp() {
    if (const std::string reason = missing_context(); !reason.empty()) GTEST_SKIP() << reason;
    while (glGetError() != GL_NO_ERROR) {
    }
}

void GlTest::TearDown() {
    if (missing_context().empty()) {
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

}  // namespace lapfx::ui::test
