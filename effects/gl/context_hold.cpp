#include "gl/context_hold.h"

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

void require_same_functions(const Context::Owner& owner, const Context::Owner& in_use) {
    if (owner.any_function == in_use.any_function) return;
    throw Error(Failure::no_gl, Fault{.file = "",
                                      .place = "",
                                      .reason = owner.name() + " has other OpenGL functions than " + in_use.name() +
                                                ", which is in use; one backend per process"});
}

}  // namespace

std::shared_ptr<Context::Owner> keep(std::unique_ptr<Context::Owner> owner) {
    std::shared_ptr<Context::Owner> shared = std::move(owner);
    shared->any_function = reinterpret_cast<void*>(shared->get_proc_address()("glDrawArrays"));
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    std::erase_if(all.owners, [](const auto& other) { return other.expired(); });
    for (const auto& other : all.owners)
        if (const auto in_use = other.lock()) require_same_functions(*shared, *in_use);
    all.owners.push_back(shared);
    return shared;
}

std::shared_ptr<Context::Owner> current_owner() {
    return find([](const Context::Owner& owner) { return !owner.of_host() && owner.is_current(); });
}

ContextHold::ContextHold() : owner_(current_owner()) {
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
