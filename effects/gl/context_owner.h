// What keeps a headless context alive; one implementation per backend.
#pragma once

#include <memory>
#include <string>

#include "lapfx/context.h"

namespace lapfx {

struct Context::Owner {
    virtual ~Owner() = default;
    virtual bool of_host() const noexcept { return false; }
    virtual GetProcAddress get_proc_address() const = 0;
    virtual std::string name() const = 0;
    virtual bool is_current() const noexcept = 0;    ///< the driver says so, for this thread
    virtual bool make_current() const noexcept = 0;  ///< false: the driver refuses; nothing is then current
    /// What is current on this thread now, also a context of the host's if it is of this backend.
    struct Current {
        virtual ~Current() = default;
        virtual void make_current() const noexcept = 0;
    };
    virtual std::unique_ptr<Current> current() const = 0;
    /// Tells functions of one backend from those of another (gl::keep); a host's own way to find them may be gone.
    void* any_function = nullptr;
};

namespace gl {

/// Null, with the reason, when the backend is not available.
std::unique_ptr<Context::Owner> make_egl(std::string& reason);
std::unique_ptr<Context::Owner> make_osmesa(std::string& reason);

}  // namespace gl
}  // namespace lapfx
