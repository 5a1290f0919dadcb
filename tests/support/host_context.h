// A context that a host makes by itself, through EGL.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <initializer_list>

namespace lapfx::test {

/// Of the API and profile of the attributes; current when it has been made, EGL_NO_CONTEXT where the driver has none.
struct HostContext {
    HostContext(EGLenum api, std::initializer_list<EGLint> attributes) {
        eglInitialize(display, nullptr, nullptr);
        eglBindAPI(api);
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.begin());
        make_current();
    }
    ~HostContext() {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
    HostContext(const HostContext&) = delete;
    HostContext& operator=(const HostContext&) = delete;

    void make_current() const { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context); }

    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLContext context = EGL_NO_CONTEXT;
};

}  // namespace lapfx::test
