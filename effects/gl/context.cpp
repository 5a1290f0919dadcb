#include "lapfx/context.h"

#include <cstdio>
#include <mutex>

#include "gl/context_hold.h"
#include "gl/gl.h"
#include "gl/state_guard.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/error.h"

namespace lapfx {

namespace {

Error no_gl(const std::string& reason) {
    return {Failure::no_gl, Fault{.file = "", .place = "", .reason = "no usable OpenGL: " + reason}};
}

/// Why the current context cannot be drawn with, behind "it", or empty.
std::string fault_of_version(Context::GetProcAddress get_proc_address) {
    const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(get_proc_address("glGetString"));
    if (get_string == nullptr) return "has no function glGetString";
    const auto* const version = reinterpret_cast<const char*>(get_string(GL_VERSION));
    if (version == nullptr) return "is not current on this thread";
    int major = 0, minor = 0;  // OpenGL ES, whose version begins with its name, gives 0
    if (std::sscanf(version, "%d.%d", &major, &minor) == 2 && std::pair(major, minor) >= std::pair(4, 5)) return "";
    return std::string("gives version ") + version + "; OpenGL 4.5 is needed";
}

/// Loads the functions, which are the same for all contexts (gl::keep). Why that cannot be, behind "it", or empty.
std::string load_functions(Context::GetProcAddress get_proc_address) {
    static std::mutex mutex;
    static bool loaded = false;
    if (std::string fault = fault_of_version(get_proc_address); !fault.empty()) return fault;
    const std::lock_guard lock(mutex);
    const auto one = reinterpret_cast<PFNGLDRAWARRAYSPROC>(get_proc_address("glDrawArrays"));
    if (loaded && glad_glDrawArrays == one) return "";  // others may be calling them
    for (const char* name : {"glDrawArrays", "glGetIntegerv", "glBindBufferRange", "glDispatchCompute",
                             "glClearTexImage", "glCreateBuffers", "glTextureStorage2D", "glNamedFramebufferTexture"})
        if (get_proc_address(name) == nullptr) return std::string("has no function ") + name;
    loaded = gladLoadGL(get_proc_address) != 0;
    if (!loaded) return "lacks functions of OpenGL";
    gl::load_polygon_offset_clamp(get_proc_address);
    return "";
}

/// A context that the host makes current: only its functions are known.
struct HostOwner : Context::Owner {
    explicit HostOwner(Context::GetProcAddress host_functions) : functions(host_functions) {}
    bool of_host() const noexcept override { return true; }
    Context::GetProcAddress get_proc_address() const override { return functions; }
    std::string name() const override { return "the host's context"; }
    bool is_current() const noexcept override { return true; }
    bool make_current() const noexcept override { return true; }
    std::unique_ptr<Current> current() const override { return nullptr; }
    Context::GetProcAddress functions;
};

std::string gl_text(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text == nullptr ? "" : text;
}

}  // namespace

Context Context::create(Backend backend) {
    std::string reasons;
    const auto attempt = [&](const char* name, std::unique_ptr<Owner> (*make)(std::string&)) {
        std::string reason;
        std::shared_ptr<Owner> kept;
        const auto before = gl::current_owner();
        try {
            if (auto owner = make(reason)) {
                kept = gl::keep(std::move(owner));
                reason = load_functions(kept->get_proc_address());
                if (reason.empty()) return kept;
                reason.insert(0, "it ");
            }
        } catch (const Error& error) {
            reason = error.what();
        }
        kept = nullptr;
        if (before != nullptr) before->make_current();
        reasons += (reasons.empty() ? "" : "; ") + std::string(name) + ": " + reason;
        return kept;
    };
    std::shared_ptr<Owner> owner;
    if (backend != Backend::osmesa) owner = attempt("EGL", gl::make_egl);
    if (!owner && backend != Backend::egl) owner = attempt("OSMesa", gl::make_osmesa);
    if (!owner) throw no_gl(reasons);
    const GetProcAddress functions = owner->get_proc_address();
    return {std::move(owner), functions};
}

Context Context::external(GetProcAddress get_proc_address) {
    if (get_proc_address == nullptr) throw no_gl("get_proc_address is null");
    std::shared_ptr<Owner> owner = gl::keep(std::make_unique<HostOwner>(get_proc_address));
    if (const std::string fault = load_functions(get_proc_address); !fault.empty())
        throw no_gl(owner->name() + ' ' + fault);
    return {std::move(owner), get_proc_address};
}

Context::Context(std::shared_ptr<Owner> owner, GetProcAddress functions)
    : owner_(std::move(owner)), functions_(functions) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

void Context::make_current() const {
    if (!owner_->is_current() && !owner_->make_current())
        throw Error(Failure::runtime,
                    Fault{.file = "",
                          .place = "",
                          .reason = owner_->name() + "'s context cannot be made current: another thread may have it"});
}

std::string Context::renderer() const {
    return gl_text(GL_RENDERER);
}
std::string Context::version() const {
    return gl_text(GL_VERSION);
}

Context::GetProcAddress Context::get_proc_address() const noexcept {
    return functions_;
}

bool Context::software() const {
    const std::string name = renderer();
    return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos;
}

Backend parse_backend(const std::string& word) {
    if (word == "auto") return Backend::automatic;
    if (word == "egl") return Backend::egl;
    if (word == "osmesa") return Backend::osmesa;
    throw Error(Failure::bad_input,
                Fault{.file = "", .place = "--backend", .reason = "\"" + word + "\" is not one of egl, osmesa, auto"});
}

}  // namespace lapfx
