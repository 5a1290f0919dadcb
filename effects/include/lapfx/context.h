// The OpenGL 4.5 core context that the effects draw with, by name.
//
//     auto context = lapfx::Context::create(lapfx::Backend::automatic);   // headless: EGL, else OSMesa
//     auto context = lapfx::Context::external(glfwGetProcAddress);        // the host's, already current
//
// There may be several contexts, each with objects of its own (Effects, Frame), on one thread or on one thread each.
// They are all of one backend: GL functions are loaded once for the process, and OSMesa and a windowing GL clash in one
// process. A context that create() made is current on the thread that made it, until another one is. Its objects hold
// it: it ends with the last of Context and objects, which may be destroyed in any order and while another context is
// current, on the thread that uses them. Every other call of an object wants its context current. A host's own context
// is current during every call, destructors too: lapfx cannot make it so.
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
    /// A context that the host made and has current; it stays the host's. A compatibility context will do: alpha test
    /// off, as it is at first. Throws Error (no_gl) below OpenGL 4.5, for OpenGL ES, if no context is current, and if
    /// get_proc_address lacks functions or finds other ones than those of a context that is in use. Any function with
    /// this type will do; glXGetProcAddressARB, which takes unsigned characters, has to be wrapped in one.
    static Context external(GetProcAddress get_proc_address);

    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    /// Makes a context of create() current on this thread, where no other thread has it. Throws Error (runtime).
    /// Nothing for the host's own.
    void make_current() const;

    std::string renderer() const;                      ///< GL_RENDERER
    std::string version() const;                       ///< GL_VERSION
    bool software() const;                             ///< true for llvmpipe and softpipe
    GetProcAddress get_proc_address() const noexcept;  ///< finds this context's functions, for a host's own loader

    struct LAPFX_HIDDEN Owner;  ///< private: what has to be released

  private:
    LAPFX_HIDDEN Context(std::shared_ptr<Owner> owner, GetProcAddress functions);
    std::shared_ptr<Owner> owner_;
    GetProcAddress functions_;
};

}  // namespace lapfx
