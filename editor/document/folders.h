// Where the editor keeps things of its own (XDG Base Directory Specification).
#pragma once

#include <filesystem>

namespace lapfx::document {

/// All paths are absolute. A folder is made when something is first written to it. An empty path: nothing is kept.
struct Folders {
    std::filesystem::path config;  ///< settings: theme, keys, layouts
    std::filesystem::path state;   ///< autosave, recent files
    std::filesystem::path cache;   ///< thumbnails

    /// The folder for the user's own work, in which saving starts. of_user() gives only one that exists. The
    /// editor does not make it, and writes nothing there unless the user asks for it.
    std::filesystem::path documents{};

    /// "lapfx" in XDG_CONFIG_HOME, XDG_STATE_HOME and XDG_CACHE_HOME, or where these are by default below HOME;
    /// documents are where user-dirs.dirs says, in "Documents", or in HOME itself. A folder for which none of these is
    /// set is empty.
    static Folders of_user();
};

/// Whether this is an existing folder in which this user may make files.
bool is_writable_folder(const std::filesystem::path& folder);

}  // namespace lapfx::document
