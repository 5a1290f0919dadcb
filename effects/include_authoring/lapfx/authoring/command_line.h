// The command line of the programs of lapfx: words and exit codes.
//
//     catch (const lapfx::Error& error) {
//         return lapfx::exit_code(error.failure());
//     }
#pragma once

#include <string>

#include "lapfx/context.h"
#include "lapfx/error.h"

namespace lapfx {

/// "egl", "osmesa" or "auto"; throws Error (bad_input) naming the allowed words.
Backend parse_backend(const std::string& word);

/// 1 failed while running, 2 wrong usage or input, 77 no usable OpenGL.
constexpr int exit_code(Failure failure) noexcept {
    switch (failure) {
        case Failure::bad_input:
            return 2;
        case Failure::no_gl:
            return 77;
        case Failure::runtime:
            break;
    }
    return 1;
}

}  // namespace lapfx
