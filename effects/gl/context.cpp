#include "lapfx/context.h"

#include "gl/context_owner.h"
#include "gl/gl.h"
#include "gl/state_guard.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/error.h"

namespace lapfx {

namespace {

Error no_gl(const std::string& reason) {
    return {Failure::no_gl, Fault{.file = "", .place = "", .reason = "no usable OpenGL: " + reason}};
}

void load_functions(Context::GetProcAddress get_proc_address, const std::string& backend) {
    const int version = gladLoadGL(get_proc_address);
    if (version < GLAD_MAKE_VERSION(4, 5)) {
        const std::string found = version == 0 ? std::string("OpenGL functions are missing")
                                               : "OpenGL " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                                                     std::to_string(GLAD_VERSION_MINOR(version));
        throw no_gl(backend + " gives " + found + "; 4.5 core is needed");
    }
    gl::load_polygon_offset_clamp(get_proc_address);
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
    const GetProcAddress functions = owner->get_proc_address();
    load_functions(functions, owner->name());
    return {std::move(owner), functions};
}

Context Context::external(GetProcAddress get_proc_address) {
    load_functions(get_proc_address, "the host's context");
    return {nullptr, get_proc_address};
}

Context::Context(std::unique_ptr<Owner> owner, GetProcAddress functions)
    : owner_(std::move(owner)), functions_(functions) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

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
