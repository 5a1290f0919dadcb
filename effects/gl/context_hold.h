// What makes an object of the core outlive its Context, and be destroyed while another context is current.
#pragma once

#include "gl/context_owner.h"

namespace lapfx::gl {

/// The first member of an object that owns names of OpenGL: it is destroyed last. Any thread may have contexts.
class ContextHold {
  public:
    /// Holds the context of Context::create() that is current, so that it lives as long as this object. If none is, the
    /// context is the host's, who makes it current; then only its functions stay in use. Throws Error (no_gl) when no
    /// context is current.
    ContextHold();
    ContextHold(const ContextHold&) = delete;
    ContextHold& operator=(const ContextHold&) = delete;
    ~ContextHold();

    /// For the destructor of the object: its context is current until this is destroyed. If the driver refuses (it is
    /// current on another thread), nothing is current meanwhile, and the names go with the context.
    void enter() noexcept;

  private:
    std::shared_ptr<Context::Owner> owner_;
    std::unique_ptr<Context::Owner::Current> before_;
};

/// Makes a context known to ContextHold for as long as it lives. Throws Error (no_gl) while a context is in use whose
/// functions its own would replace: they are loaded once for the process.
std::shared_ptr<Context::Owner> keep(std::unique_ptr<Context::Owner> owner);
/// The same check before a context is made: making one current may take the place of a host's for good.
void require_same_functions(Context::GetProcAddress functions, const std::string& name);
/// The context of Context::create() that is current on this thread, or null.
std::shared_ptr<Context::Owner> current_owner();

}  // namespace lapfx::gl
