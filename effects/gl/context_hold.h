// What makes an object of the core outlive its Context, and be destroyed while another context is current.
#pragma once

#include "gl/context_owner.h"

namespace lapfx::gl {

/// The first member of an object that owns names of OpenGL: it is destroyed last. Any thread may have contexts.
class ContextHold {
  public:
    /// Holds the context of Context::create() that is current, so that it lives as long as this object. A context of
    /// the host's cannot be held: the host makes it current.
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

/// Makes a context known to ContextHold for as long as it lives. Throws Error (no_gl) as require_same_functions().
std::shared_ptr<Context::Owner> keep(std::unique_ptr<Context::Owner> owner);
/// Throws Error (no_gl) while a context lives whose functions those of `name` would replace: they are loaded once for
/// the process.
void require_same_functions(Context::GetProcAddress get_proc_address, const std::string& name);

}  // namespace lapfx::gl
