// Handles of the C API: numbers that lead to an object, never addresses. What a host passes by mistake (NULL, a handle
// whose object is gone, one of another type, an address) is known for what it is, and nothing is read through it.
//
//     const Held<FrameObject> frame(handle, "frame");  // throws Misuse; the object lives until `frame` goes
//     frame->begin(...);
//
// Any thread; holding an object is wait-free.
#pragma once

#include <memory>
#include <stdexcept>

namespace lapfx::c {

/// The program has to change, not its input.
class Misuse : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

enum class Kind : unsigned { context = 1, organ, preset, scene, effects, frame };

struct Object {
    Object() = default;
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;
    virtual ~Object() = default;
};

/// The handle of an object from now on. Throws Misuse when there are too many.
void* add(Kind kind, std::unique_ptr<Object> object);
/// The object of a handle; it is not destroyed before release(). `argument` names the handle in messages.
Object* hold(const void* handle, Kind kind, const char* argument);
void release(const void* handle) noexcept;
/// The handle leads nowhere any more. Waits until nobody holds the object. Throws Misuse.
std::unique_ptr<Object> take_out(const void* handle, Kind kind, const char* argument);

template <typename T>
class Held {
  public:
    Held(const typename T::Handle* handle, const char* argument)
        : handle_(handle), object_(static_cast<T*>(hold(handle, T::kind, argument))) {}
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    ~Held() { release(handle_); }

    T* operator->() const noexcept { return object_; }
    T& operator*() const noexcept { return *object_; }

  private:
    const void* handle_;
    T* object_;
};

}  // namespace lapfx::c
