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

}  // namespace

std::shared_ptr<Context::Owner> keep(std::unique_ptr<Context::Owner> owner) {
    require_same_functions(owner->get_proc_address(), owner->name());
    std::shared_ptr<Context::Owner> shared = std::move(owner);
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    std::erase_if(all.owners, [](const auto& other) { return other.expired(); });
    all.owners.push_back(shared);
    return shared;
}

void require_same_functions(Context::GetProcAddress get_proc_address, const std::string& name) {
    constexpr const char* any = "glDrawArrays";
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    for (const auto& other : all.owners) {
        const auto owner = other.lock();
        if (owner == nullptr || owner->get_proc_address()(any) == get_proc_address(any)) continue;
        throw Error(Failure::no_gl, Fault{.file = "",
                                          .place = "",
                                          .reason = name + " has other OpenGL functions than " + owner->name() +
                                                    ", whose context is in use; one backend per process"});
    }
}

ContextHold::ContextHold() {
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    for (const auto& other : all.owners) {
        owner_ = other.lock();
        if (owner_ != nullptr && owner_->is_current()) return;
    }
    owner_ = nullptr;
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
