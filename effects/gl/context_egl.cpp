// A context without a surface or a display: Mesa's surfaceless platform, otherwise the first EGL device (GPU drivers).
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "gl/context_owner.h"

namespace lapfx::gl {

namespace {

struct EglOwner : Context::Owner {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~EglOwner() override {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }
    Context::GetProcAddress get_proc_address() const override { return eglGetProcAddress; }
    std::string name() const override { return "EGL"; }
};

EGLDisplay surfaceless_display() {
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

EGLDisplay device_display() {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (query == nullptr || query(1, &device, &count) != EGL_TRUE || count == 0) return EGL_NO_DISPLAY;
    return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

bool open(EglOwner& owner, EGLDisplay display, std::string& reason) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
        reason = "no display could be initialised";
        return false;
    }
    owner.display = display;
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    eglBindAPI(EGL_OPENGL_API);
    owner.context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (owner.context == EGL_NO_CONTEXT ||
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, owner.context) != EGL_TRUE) {
        reason = "the driver offers no OpenGL 4.5 core context";
        return false;
    }
    return true;
}

}  // namespace

std::unique_ptr<Context::Owner> make_egl(std::string& reason) {
    for (const auto display : {surfaceless_display, device_display}) {
        auto owner = std::make_unique<EglOwner>();
        if (open(*owner, display(), reason)) return owner;
    }
    return nullptr;
}

}  // namespace lapfx::gl
