// Folders and files as the file dialog needs them; tests make their own up.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lapfx::ui {

struct FileEntry {
    std::string name;  ///< any bytes but '/' and 0
    bool folder = false;
    std::uint64_t size = 0;    ///< bytes
    std::int64_t changed = 0;  ///< s since 1970, UTC
};

struct FilePlace {
    std::string name, path;
};

/// Paths are absolute, with '/' between names and none at the end (but "/" itself).
class FileSystem {
  public:
    virtual ~FileSystem() = default;
    /// What is in a folder, in any order, without "." and "..". Returns why it cannot be read; empty: all is well.
    virtual std::string list(const std::string& folder, std::vector<FileEntry>& entries) = 0;
    enum class Kind : std::uint8_t { nothing, file, folder };
    virtual Kind kind(const std::string& path) = 0;
    /// The folder in which a dialog starts when it has no other.
    virtual std::string home() = 0;
    virtual std::vector<FilePlace> places() = 0;
    /// Makes a folder inside an existing one. Returns the reason why it cannot be made; empty: it has been made.
    virtual std::string make_folder(const std::string& path) = 0;
};

/// Runs what it is given, at once or on another thread, and does not wait for that. Throws when there is no thread for
/// it.
using RunBeside = std::function<void(std::function<void()>)>;

/// This computer's, for any thread. What a link leads to counts, not the link.
FileSystem& system_files();

/// `path` as seen from `folder`, with ".", ".." and doubled '/' worked out.
std::string resolve_path(std::string_view folder, std::string_view path);
/// "~" and "~/a" are `home` and what is in it; all else is as it was.
std::string expand_home(std::string_view path, std::string_view home);
std::string_view parent_of(std::string_view path);  ///< "/" is its own parent
std::string_view name_of_path(std::string_view path);
/// "823 B", "1.2 MB"; thousands, as disks are sold.
std::string size_text(std::uint64_t bytes);
/// "2026-11-21 15:04", local time, in place of what is in `text`.
void date_text(std::int64_t seconds, std::string& text);
/// Whether a comes before b as people count: "shot 9" before "shot 10", upper and lower case alike.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace lapfx::ui
