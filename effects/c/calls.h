// What every call of the C API goes through: exceptions become a status and a message, arguments are checked.
//
//     lapfx_status lapfx_effects_seek(lapfx_effects* effects, double time) {
//         return call(__func__, [&] {
//             finite("time", time);
//             used(effects)->effects.seek(time);
//         });
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "c/handles.h"
#include "lapfx.h"
#include "lapfx/error.h"

namespace lapfx::c {

/// Whether this thread is inside the host's log: it may not call lapfx from there.
bool logging() noexcept;
enum class Told { logged, kept };
/// The status of the exception that is being handled; keeps its message, and logs it.
lapfx_status status_of_exception(const char* function, Told how = Told::logged) noexcept;
/// The status, with a message that is a literal; allocates nothing and is not logged.
lapfx_status quiet(lapfx_status status, const char* message) noexcept;
void warn(const char* function, const std::string& text);

template <typename Body>
lapfx_status call(const char* function, const Body& body, Told how = Told::logged) noexcept {
    if (logging()) return quiet(LAPFX_MISUSE, "lapfx was called from the log");
    try {
        body();
        return LAPFX_OK;
    } catch (...) {
        return status_of_exception(function, how);
    }
}

[[noreturn]] inline void refuse_value(const std::string& argument, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{.file = "", .place = argument, .reason = reason});
}

/// An argument that may not be NULL.
template <typename T>
T* given(T* pointer, const char* argument) {
    if (pointer == nullptr) throw Misuse(std::string(argument) + " is NULL");
    return pointer;
}

/// A struct that knows its size. There is one version of each so far.
template <typename T>
T& sized(T* data, const char* type, const char* argument) {
    if (given(data, argument)->size != sizeof(T))
        throw Misuse(std::string(argument) + ": size is " + std::to_string(data->size) + "; expected sizeof(" + type +
                     "), " + std::to_string(sizeof(T)));
    return *data;
}
#define LAPFX_SIZED(type, argument) lapfx::c::sized(argument, #type, #argument)

/// Calls that make an object: `body` gives it, and `out` becomes its handle, or NULL.
template <typename T, typename Body>
lapfx_status make(const char* function, typename T::Handle** out, const char* argument, const Body& body) noexcept {
    return call(function, [&] {
        *given(out, argument) = nullptr;
        std::unique_ptr<T> object = body();
        *out = static_cast<typename T::Handle*>(add(T::kind, std::move(object)));
    });
}

/// Calls that destroy one: `check` may refuse.
template <typename T, typename Check>
lapfx_status destroy(const char* function, typename T::Handle* handle, const char* argument,
                     const Check& check) noexcept {
    return call(function, [&] {
        if (handle == nullptr) return;
        {
            const Held<T> held(handle, argument);
            check(*held);
        }
        take_out(handle, T::kind, argument);
    });
}

void finite(const char* argument, double value);
void positive(const char* argument, double value);
void not_negative(const char* argument, double value);
void finite(const char* argument, std::span<const double> values);
void finite(const char* argument, std::span<const float> values);
/// A frame has pixels.
void positive_size(int width, int height);
/// "expected one of 0 to COUNT - 1 (WHAT)"
int choice(const char* argument, int value, int count, const char* what);
/// Numbers of elements that would lead beyond any array are mistakes, such as -1.
void at_most(const char* argument, std::size_t count, std::size_t most);
std::size_t index_below(std::size_t index, std::size_t count, const char* what);

}  // namespace lapfx::c
