#include "document/folders.h"

#include <cstdlib>

namespace lapfx::document {

namespace fs = std::filesystem;

namespace {

/// A relative one is to be ignored, says the specification.
fs::path folder_in(const char* variable, const char* below_home) {
    if (const char* value = std::getenv(variable); value != nullptr && fs::path(value).is_absolute())
        return fs::path(value) / "lapfx";
    if (const char* home = std::getenv("HOME"); home != nullptr && fs::path(home).is_absolute())
        return fs::path(home) / below_home / "lapfx";
    return {};
}

}  // namespace

Folders Folders::of_user() {
    return {.config = folder_in("XDG_CONFIG_HOME", ".config"),
            .state = folder_in("XDG_STATE_HOME", ".local/state"),
            .cache = folder_in("XDG_CACHE_HOME", ".cache")};
}

}  // namespace lapfx::document
