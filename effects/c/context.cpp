#include <utility>

#include "c/calls.h"
#include "c/objects.h"
#include "gl/context_hold.h"
#include "gl/gl.h"

namespace lapfx::c {

namespace {

/// The context in which this thread has begun a frame and not finished it.
thread_local const SharedContext* open_frame = nullptr;

static_assert(LAPFX_BACKEND_EGL == static_cast<int>(Backend::egl) &&
              LAPFX_BACKEND_OSMESA == static_cast<int>(Backend::osmesa));

std::unique_ptr<ContextObject> context_object(Context context, bool external) {
    auto object = std::make_unique<ContextObject>();
    object->shared = std::make_shared<SharedContext>(std::move(context), external);
    return object;
}

}  // namespace

void set_open_frame(const SharedContext* context) noexcept {
    open_frame = context;
}
bool is_open_frame(const SharedContext* context) noexcept {
    return open_frame == context;
}

void SharedContext::require_thread() const {
    if (std::this_thread::get_id() != thread)
        throw Misuse("called on another thread than that on which the context was made");
}

void SharedContext::require_current() const {
    require_thread();
    if (!external)
        context.make_current();
    else if (glGetString(GL_VERSION) == nullptr)
        throw Misuse("no OpenGL context is current on this thread: make the host's own current before");
    else if (gl::current_owner() != current_at_first.lock())
        throw Misuse("another context is current than when this one was made known: make that one current before");
}

void SharedContext::require_drawing() const {
    if (open_frame != nullptr && open_frame != this)
        throw Misuse("a frame of another context was begun and is not finished");
    require_current();
}

}  // namespace lapfx::c

using namespace lapfx::c;

lapfx_status lapfx_context_create(int backend, lapfx_context** context) {
    return make<ContextObject>(__func__, context, "context", [&] {
        const auto wanted = static_cast<lapfx::Backend>(choice("backend", backend, 3, "automatic, EGL, OSMesa"));
        return context_object(lapfx::Context::create(wanted), false);
    });
}

lapfx_status lapfx_context_external(lapfx_get_proc_address get_proc_address, lapfx_context** context) {
    return make<ContextObject>(__func__, context, "context", [&] {
        return context_object(lapfx::Context::external(given(get_proc_address, "get_proc_address")), true);
    });
}

lapfx_status lapfx_context_renderer(const lapfx_context* context, const char** text) {
    return call(__func__,
                [&] { *given(text, "text") = Held<ContextObject>(context, "context")->shared->renderer.c_str(); });
}

lapfx_status lapfx_context_functions(const lapfx_context* context, lapfx_get_proc_address* get_proc_address) {
    return call(__func__, [&] {
        *given(get_proc_address, "get_proc_address") =
            Held<ContextObject>(context, "context")->shared->context.get_proc_address();
    });
}

lapfx_status lapfx_context_make_current(lapfx_context* context) {
    return call(__func__, [&] {
        const Held<ContextObject> held(context, "context");
        if (held->shared->external) throw Misuse("the context is the host's: the host makes it current");
        held->shared->require_current();
    });
}

lapfx_status lapfx_context_destroy(lapfx_context* context) {
    return destroy<ContextObject>(__func__, context, "context",
                                  [](const ContextObject& object) { object.shared->require_thread(); });
}
