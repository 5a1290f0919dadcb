// Where the editor keeps things of its own (XDG Base Directory Specification).
#pragma once

#include <filesystem>

namespace lapfx::document {

/// All absolute; made when they are first written to. Empty: nothing is kept there.
struct Folders {
    std::filesystem::path config;  ///< settings: theme, keys, layouts
    std::filesystem::path state;   ///< autosave, recent files
    std::filesystem::path cache;   ///< thumbnails

    /// Of the user's own work, where saving begins: there is one. Not made, and nothing is kept there unasked.
    std::filesystem::path documents{};

    /// "lapfx" in XDG_CONFIG_HOME, XDG_STATE_HOME and XDG_CACHE_HOME, or where these are by default below HOME; documents are where
    /// user-dirs.dirs says, in "Documents", or in HOME itself. Without any, all are empty.
    static Folders of_user();
};

}  // namespace lapfx::document
