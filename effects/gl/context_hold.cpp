#include "gl/context_hold.h"

#include <glad/gl.h>

#include <mutex>
#include <vector>

#include "lapfx/error.h"

namespace lapfx::gl {

namespace {

struct Kept {
    std::mutex mutex;
    std::vector<std::weak_ptr<Context::Owner>> owners;
};

Kept& kept() {
    static Kept all;
    return all;
}

/// The first one, or null.
template <typename Wanted>
std::shared_ptr<Context::Owner> find(const Wanted& wanted) {
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    for (const auto& other : all.owners)
        if (auto owner = other.lock(); owner != nullptr && wanted(*owner)) return owner;
    return nullptr;
}

void* any_function(Context::GetProcAddress functions) {
    return reinterpret_cast<void*>(functions("glDrawArrays"));
}

void require_same(void* function, const std::string& name, const Context::Owner& in_use) {
    if (function == in_use.any_function) return;
    throw Error(Failure::no_gl, Fault{.file = "",
                                      .place = "",
                                      .reason = name + " has other OpenGL functions than " + in_use.name() +
                                                ", which is in use; one backend per process"});
}

void require_current() {
    const auto no_gl = [](const char* reason) {
        return Error(Failure::no_gl, Fault{.file = "", .place = "", .reason = reason});
    };
    if (glad_glGetString == nullptr) throw no_gl("there is no lapfx::Context yet: it has to be made before");
    if (glGetString(GL_VERSION) == nullptr) throw no_gl("no OpenGL context is current on this thread");
}

}  // namespace

void require_same_functions(Context::GetProcAddress functions, const std::string& name) {
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    for (const auto& other : all.owners)
        if (const auto in_use = other.lock()) require_same(any_function(functions), name, *in_use);
}

std::shared_ptr<Context::Owner> keep(std::unique_ptr<Context::Owner> owner) {
    std::shared_ptr<Context::Owner> shared = std::move(owner);
    shared->any_function = any_function(shared->get_proc_address());
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    std::erase_if(all.owners, [](const auto& other) { return other.expired(); });
    for (const auto& other : all.owners)
        if (const auto in_use = other.lock()) require_same(shared->any_function, shared->name(), *in_use);
    all.owners.push_back(shared);
    return shared;
}

std::shared_ptr<Context::Owner> current_owner() {
    return find([](const Context::Owner& owner) { return !owner.of_host() && owner.is_current(); });
}

ContextHold::ContextHold() : owner_(current_owner()) {
    require_current();
    if (owner_ == nullptr) owner_ = find([](const Context::Owner& owner) { return owner.of_host(); });
}

void ContextHold::enter() noexcept {
    if (owner_ == nullptr || owner_->is_current()) return;
    before_ = owner_->current();
    owner_->make_current();
}

ContextHold::~ContextHold() {
    if (before_ != nullptr) before_->make_current();
}

}  // namespace lapfx::gl
