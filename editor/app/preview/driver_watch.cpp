#include "app/preview/driver_watch.h"

#include <glad/gl.h>

#include <string>

namespace lapfx::app {

namespace {

constexpr int most_errors = 16;

}  // namespace

std::optional<Fault> DriverWatch::check(double now) {
    if (lost_ || !unchecked_ || now - checked_ < 1.0) return std::nullopt;
    unchecked_ = false;
    checked_ = now;
    GLenum error = GL_NO_ERROR;
    for (int i = 0; i < most_errors; ++i)  // a lost context has no end of them
        if (const GLenum one = glGetError(); one != GL_NO_ERROR) error = one;
    lost_ = error == GL_CONTEXT_LOST || glGetGraphicsResetStatus() != GL_NO_ERROR;
    if (lost_)
        return Fault{.file = "",
                     .place = "",
                     .reason = "the graphics driver was reset and the picture is lost; start lapfx again to continue"};
    if (error == GL_NO_ERROR || error == told_error_) return std::nullopt;
    told_error_ = error;
    const std::string what = error == GL_OUT_OF_MEMORY ? "has run out of memory" : "reports " + std::to_string(error);
    return Fault{.file = "", .place = "", .reason = "OpenGL " + what + "; the picture may be wrong"};
}

}  // namespace lapfx::app
