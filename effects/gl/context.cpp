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

/// Throws Error (no_gl) unless the current context is one that can be drawn with.
void require_version(Context::GetProcAddress get_proc_address, const std::string& backend) {
    const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(get_proc_address("glGetString"));
    if (get_string == nullptr) throw no_gl(backend + ": its functions cannot be found: there is no glGetString");
    const auto* const version = reinterpret_cast<const char*>(get_string(GL_VERSION));
    if (version == nullptr) throw no_gl(backend + " is not current on this thread");
    int major = 0, minor = 0;  // OpenGL ES, whose version begins with its name, gives 0
    if (std::sscanf(version, "%d.%d", &major, &minor) != 2 || std::pair(major, minor) < std::pair(4, 5))
        throw no_gl(backend + " gives version " + version + "; OpenGL 4.5 is needed");
}

/// They are the same for all contexts (gl::require_same_functions).
void load_functions(Context::GetProcAddress get_proc_address, const std::string& backend) {
    static std::mutex mutex;
    static Context::GetProcAddress loaded_with = nullptr;
    require_version(get_proc_address, backend);
    const std::lock_guard lock(mutex);
    if (loaded_with == get_proc_address) return;
    if (gladLoadGL(get_proc_address) == 0) throw no_gl(backend + ": OpenGL functions are missing");
    gl::load_polygon_offset_clamp(get_proc_address);
    loaded_with = get_proc_address;
}

std::string gl_text(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text == nullptr ? "" : text;
}

}  // namespace

Context Context::create(Backend backend) {
    std::string reasons;
    const auto attempt = [&](const char* name, std::unique_ptr<Owner> (*make)(std::string&)) {
        std::string reason;
        auto owner = make(reason);
        if (!owner) reasons += (reasons.empty() ? "" : "; ") + std::string(name) + ": " + reason;
        return owner;
    };
    std::unique_ptr<Owner> owner;
    if (backend != Backend::osmesa) owner = attempt("EGL", gl::make_egl);
    if (!owner && backend != Backend::egl) owner = attempt("OSMesa", gl::make_osmesa);
    if (!owner) throw no_gl(reasons);
    std::shared_ptr<Owner> kept = gl::keep(std::move(owner));
    const GetProcAddress functions = kept->get_proc_address();
    load_functions(functions, kept->name());
    return {std::move(kept), functions};
}

Context Context::external(GetProcAddress get_proc_address) {
    constexpr const char* backend = "the host's context";
    if (get_proc_address == nullptr) throw no_gl("get_proc_address is null");
    gl::require_same_functions(get_proc_address, backend);
    load_functions(get_proc_address, backend);
    return {nullptr, get_proc_address};
}

Context::Context(std::shared_ptr<Owner> owner, GetProcAddress functions)
    : owner_(std::move(owner)), functions_(functions) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

void Context::make_current() const {
    if (owner_ != nullptr && !owner_->is_current() && !owner_->make_current())
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
