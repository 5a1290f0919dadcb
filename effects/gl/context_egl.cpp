// A context without a surface or a display: Mesa's surfaceless platform, otherwise the first EGL device (GPU drivers).
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "gl/context_hold.h"
#include "gl/context_owner.h"

namespace lapfx::gl {

namespace {

void release(EGLDisplay display) noexcept {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

struct EglCurrent : Context::Owner::Current {
    EGLDisplay display = eglGetCurrentDisplay();
    EGLSurface to = eglGetCurrentSurface(EGL_DRAW), from = eglGetCurrentSurface(EGL_READ);
    EGLContext context = eglGetCurrentContext();

    void make_current() const noexcept override { eglMakeCurrent(display, to, from, context); }
};

struct EglOwner : Context::Owner {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    // The display is not terminated: the process has only one of its kind, and other contexts on it, also the host's,
    // would end with it.
    ~EglOwner() override {
        if (context == EGL_NO_CONTEXT) return;
        if (is_current()) release(display);
        eglDestroyContext(display, context);
    }
    bool is_current() const noexcept override { return eglGetCurrentContext() == context; }
    bool make_current() const noexcept override {
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) return true;
        release(display);
        return false;
    }
    std::unique_ptr<Current> current() const override {
        auto now = std::make_unique<EglCurrent>();
        if (now->context == EGL_NO_CONTEXT) now->display = display;
        return now;
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
    const EGLenum before = eglQueryAPI();
    eglBindAPI(EGL_OPENGL_API);
    owner.context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    eglBindAPI(before);
    if (owner.context == EGL_NO_CONTEXT) {
        reason = "the driver offers no OpenGL 4.5 core context";
        return false;
    }
    const EglCurrent host;
    if (owner.make_current()) return true;
    if (host.context != EGL_NO_CONTEXT) host.make_current();
    reason = "its context cannot be made current: this thread may have a window's";
    return false;
}

}  // namespace

std::unique_ptr<Context::Owner> make_egl(std::string& reason) {
    require_same_functions(eglGetProcAddress, "EGL");
    for (const auto display : {surfaceless_display, device_display}) {
        auto owner = std::make_unique<EglOwner>();
        if (open(*owner, display(), reason)) return owner;
    }
    return nullptr;
}

}  // namespace lapfx::gl
