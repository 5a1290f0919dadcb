#include "ui/support/gl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <glad/gl.h>

namespace lapfx::ui::test {

namespace {

EGLDisplay surfaceless_display() {
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

/// The display of a driver that is not Mesa.
EGLDisplay device_display() {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (query == nullptr || query(1, &device, &count) != EGL_TRUE || count == 0) return EGL_NO_DISPLAY;
    return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

bool make_current(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return false;
    const EGLint core[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    eglBindAPI(EGL_OPENGL_API);
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, core);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

/// The context is never destroyed: it exists until the process ends.
std::string make_context() {
    if (!make_current(surfaceless_display()) && !make_current(device_display())) {
        return "EGL gives no OpenGL 4.5 core context without a window";
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
