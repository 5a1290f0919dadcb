// The OpenGL 4.5 core context that the effects draw with, by name.
//
//     auto context = lapfx::Context::create(lapfx::Backend::automatic);   // headless: EGL, else OSMesa
//     auto context = lapfx::Context::external(glfwGetProcAddress);        // the host's, already current
//
// One backend per process: GL functions are loaded once, and OSMesa and a windowing GL clash in one process.
// The context is current on the thread that made it, until it is destroyed; everything that draws belongs to
// that thread.
#pragma once

#include <memory>
#include <string>

#include "lapfx/api.h"

namespace lapfx {

enum class Backend {
    automatic,  ///< EGL, else OSMesa
    egl,        ///< EGL without a surface: a GPU, or Mesa's software renderer
    osmesa,     ///< Mesa's off-screen software renderer, opened with dlopen
};

class LAPFX_API Context {
  public:
    using Function = void (*)();
    using GetProcAddress = Function (*)(const char* name);

    /// Throws Error (no_gl) that says what is missing for each backend that was tried.
    static Context create(Backend backend);
    /// A context that the host made and has current; it stays the host's. Throws Error (no_gl) below
    /// OpenGL 4.5.
    static Context external(GetProcAddress get_proc_address);

    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    std::string renderer() const;                      ///< GL_RENDERER
    std::string version() const;                       ///< GL_VERSION
    bool software() const;                             ///< true for llvmpipe and softpipe
    GetProcAddress get_proc_address() const noexcept;  ///< finds this context's functions, for a host's own loader

    struct LAPFX_HIDDEN Owner;  ///< private: what has to be released

  private:
    LAPFX_HIDDEN Context(std::unique_ptr<Owner> owner, GetProcAddress functions);
    std::unique_ptr<Owner> owner_;
    GetProcAddress functions_;
};

}  // namespace lapfx
