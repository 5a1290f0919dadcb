// What keeps a headless context alive; one implementation per backend.
#pragma once

#include <memory>
#include <string>

#include "lapfx/context.h"

namespace lapfx {

struct Context::Owner {
    virtual ~Owner() = default;
    virtual GetProcAddress get_proc_address() const = 0;
    virtual std::string name() const = 0;
};

namespace gl {

/// Null, with the reason, when the backend is not available.
std::unique_ptr<Context::Owner> make_egl(std::string& reason);
std::unique_ptr<Context::Owner> make_osmesa(std::string& reason);

}  // namespace gl
}  // namespace lapfx
