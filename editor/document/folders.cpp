#include "document/folders.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace lapfx::document {

namespace fs = std::filesystem;

namespace {

/// The specification says that a relative path is to be ignored.
fs::path folder_in(const char* variable, const char* below_home) {
    if (const char* value = std::getenv(variable); value != nullptr && fs::path(value).is_absolute())
        return fs::path(value) / "lapfx";
    if (const char* home = std::getenv("HOME"); home != nullptr && fs::path(home).is_absolute())
        return fs::path(home) / below_home / "lapfx";
    return {};
}

/// The documents folder in the file of xdg-user-dirs: XDG_DOCUMENTS_DIR="$HOME/Documents", or an absolute path. Empty
/// if the file does not name one.
fs::path documents_in(const fs::path& user_dirs, const fs::path& home) {
    constexpr std::string_view key = "XDG_DOCUMENTS_DIR=\"", in_home = "$HOME/";
    std::ifstream file(user_dirs);
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(key)) continue;
        const std::string value = line.substr(key.size(), line.find('"', key.size()) - key.size());
        return value.starts_with(in_home) ? home / value.substr(in_home.size()) : fs::path(value);
    }
    return {};
}

fs::path documents_of_user(const fs::path& config) {
    const char* home = std::getenv("HOME");
    if (home == nullptr || !fs::path(home).is_absolute()) return {};
    std::error_code error;
    for (const fs::path& folder :
         {documents_in(config.parent_path() / "user-dirs.dirs", home), home / fs::path("Documents")})
        if (folder.is_absolute() && fs::is_directory(folder, error)) return folder;
    return fs::is_directory(home, error) ? home : "";
}

}  // namespace

Folders Folders::of_user() {
    const fs::path config = folder_in("XDG_CONFIG_HOME", ".config");
    return {.config = config,
            .state = folder_in("XDG_STATE_HOME", ".local/state"),
            .cache = folder_in("XDG_CACHE_HOME", ".cache"),
            .documents = documents_of_user(config)};
}

bool is_writable_folder(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder, error) && ::access(folder.c_str(), W_OK | X_OK) == 0;
}

}  // namespace lapfx::document
