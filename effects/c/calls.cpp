#include "calls.h"

#include <cmath>
#include <mutex>
#include <new>
#include <sstream>

namespace lapfx::c {

namespace {

thread_local const char* last_message = "";
thread_local bool inside_log = false;

/// The text that last_message shows, unless that is a literal.
std::string& kept_text() {
    thread_local std::string text;
    return text;
}

struct Log {
    std::recursive_mutex mutex;  // the host may set another log from its log
    lapfx_log log = nullptr;
    void* user = nullptr;

    /// What the host's log throws ends there: the call has its own fault to tell.
    void tell(int level, const std::string& lines) noexcept {
        const std::lock_guard lock(mutex);
        inside_log = true;
        try {
            std::istringstream text(lines);
            for (std::string line; log != nullptr && std::getline(text, line);) log(user, level, line.c_str());
        } catch (...) {
        }
        inside_log = false;
    }
};
Log& the_log() {
    static Log& kept = *new Log;  // other threads may tell something until the program ends
    return kept;
}

lapfx_status status_of(Failure failure) {
    switch (failure) {
        case Failure::bad_input:
            return LAPFX_BAD_INPUT;
        case Failure::no_gl:
            return LAPFX_NO_GL;
        case Failure::runtime:
            break;
    }
    return LAPFX_RUNTIME;
}

/// "lapfx_preset_load: " before each line.
std::string with_function(const char* function, const std::string& lines) {
    std::istringstream text(lines);
    std::string out;
    for (std::string line; std::getline(text, line);)
        out += (out.empty() ? "" : "\n") + std::string(function) + ": " + line;
    return out;
}

lapfx_status told(Told how, lapfx_status status, const char* function, const char* reason) {
    kept_text() = with_function(function, reason);
    last_message = kept_text().c_str();  // the log may ask for it
    if (how == Told::kept) return status;
    the_log().tell(LAPFX_LOG_ERROR, kept_text());
    last_message = kept_text().c_str();  // again: the log may have called lapfx in vain
    return status;
}

lapfx_status sorted(Told how, const char* function) {
    try {
        throw;
    } catch (const Misuse& misuse) {
        return told(how, LAPFX_MISUSE, function, misuse.what());
    } catch (const Error& error) {
        return told(how, status_of(error.failure()), function, error.what());
    } catch (const std::bad_alloc&) {
        return told(how, LAPFX_RUNTIME, function, "out of memory");
    } catch (const std::exception& failure) {
        return told(how, LAPFX_RUNTIME, function, failure.what());
    } catch (...) {
        return told(how, LAPFX_RUNTIME, function, "a failure without a message");
    }
}

template <typename T>
void all_finite(const char* argument, std::span<const T> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            refuse_value(argument, "element " + std::to_string(i) + " is " + std::to_string(values[i]) +
                                       "; expected finite numbers");
}

}  // namespace

bool logging() noexcept {
    return inside_log;
}

lapfx_status quiet(lapfx_status status, const char* message) noexcept {
    last_message = message;
    return status;
}

lapfx_status status_of_exception(const char* function, Told how) noexcept {
    try {
        return sorted(how, function);
    } catch (...) {
        return quiet(LAPFX_RUNTIME, "out of memory");
    }
}

void warn(const char* function, const std::string& text) {
    the_log().tell(LAPFX_LOG_WARNING, with_function(function, text));
}

void finite(const char* argument, double value) {
    if (!std::isfinite(value)) refuse_value(argument, std::to_string(value) + " is no finite number");
}
void positive(const char* argument, double value) {
    finite(argument, value);
    if (value <= 0.0) refuse_value(argument, std::to_string(value) + "; expected more than 0");
}
void not_negative(const char* argument, double value) {
    finite(argument, value);
    if (value < 0.0) refuse_value(argument, std::to_string(value) + "; expected 0 or more");
}
void finite(const char* argument, std::span<const double> values) {
    all_finite(argument, values);
}
void finite(const char* argument, std::span<const float> values) {
    all_finite(argument, values);
}

void positive_size(int width, int height) {
    if (width < 1 || height < 1)
        refuse_value("size", std::to_string(width) + "x" + std::to_string(height) + "; expected at least 1x1 pixels");
}

int choice(const char* argument, int value, int count, const char* what) {
    if (value >= 0 && value < count) return value;
    refuse_value(argument,
                 std::to_string(value) + " is not one of 0 to " + std::to_string(count - 1) + " (" + what + ")");
}

void at_most(const char* argument, std::size_t count, std::size_t most) {
    if (count > most) refuse_value(argument, std::to_string(count) + " is above " + std::to_string(most));
}

std::size_t index_below(std::size_t index, std::size_t count, const char* what) {
    if (index < count) return index;
    refuse_value("index", std::to_string(index) + " is not below " + std::to_string(count) + ", the number of " + what);
}

}  // namespace lapfx::c

const char* lapfx_version(void) {
    return LAPFX_VERSION;
}

const char* lapfx_last_message(void) {
    return lapfx::c::last_message;
}

void lapfx_set_log(lapfx_log log, void* user) {
    lapfx::c::Log& kept = lapfx::c::the_log();
    const std::lock_guard lock(kept.mutex);
    kept.log = log;
    kept.user = user;
}
