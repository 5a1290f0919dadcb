// What was opened here is not replaced by what is exported.
#pragma once

#include <filesystem>

#include "lapfx/authoring/file_guard.h"
#include "lapfx/error.h"

namespace lapfx::app {

/// Throws Error (bad_input) for a file that was opened here.
inline void require_not_opened(const std::filesystem::path& path) {
    if (is_read(path))
        throw Error(Failure::bad_input,
                    Fault{.file = path.string(), .place = "", .reason = "was opened here; choose another name"});
}

}  // namespace lapfx::app
