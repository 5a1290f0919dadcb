// Where the editor keeps things of its own (XDG Base Directory Specification).
#pragma once

#include <filesystem>

namespace lapfx::document {

/// All absolute; made when they are first written to. Empty: nothing is kept there.
struct Folders {
    std::filesystem::path config;  ///< settings: theme, keys, layouts
    std::filesystem::path state;   ///< autosave, recent files
    std::filesystem::path cache;   ///< thumbnails

    /// Of the user's own work, where saving begins; exists when of_user() gives it. Not made, and nothing is kept there
    /// unasked.
    std::filesystem::path documents{};

    /// "lapfx" in XDG_CONFIG_HOME, XDG_STATE_HOME and XDG_CACHE_HOME, or where these are by default below HOME;
    /// documents are where user-dirs.dirs says, in "Documents", or in HOME itself. Without any, all are empty.
    static Folders of_user();
};

/// A folder that is there, and this user may make files in it.
bool is_writable_folder(const std::filesystem::path& folder);

}  // namespace lapfx::document
