// Files: reads whole plain files, never leaves half a file behind, and is the only way from a name in a file to a path.
//
//     const fs::path skin = lapfx::named_path(folder_of_the_organ, "maps/skin.png", "liver.obj");  // none above
//     lapfx::write_file("tuned.json", text);
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lapfx {

/// Throws Error (bad_input) for what is missing, unreadable, not a plain file, empty, or larger than
/// `longest` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t longest);

/// Writes a new file next to `path`, flushes it to the disk and renames it. Throws Error (runtime); the old
/// file is then unchanged. Refuses to replace what is not a plain file (a symbolic link, a folder, a pipe)
/// or is write-protected.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Where a name in a file may lead.
enum class Reach {
    inside,    ///< the folder of that file, or below it, once symbolic links are resolved: organs, presets
    anywhere,  ///< any place on this machine: a scene's organ, tool, preset and reference, which a person has chosen by
               ///< hand
};

/// The path of a file that a file in `folder` names; one that is not there is looked for as systems spell it that
/// compose letters and marks differently (NFC, NFD). Whether it exists, and is what it should be, is found out by
/// whoever reads it. Throws Error (bad_input) at `file` and `place` for a name that is empty, a URL or out of reach.
std::filesystem::path named_path(const std::filesystem::path& folder, std::string_view name,
                                 Reach reach = Reach::inside, const std::string& file = {},
                                 const std::string& place = {});

/// Whether a path leads into the folder, or below it, once symbolic links are resolved; it need not exist.
bool lies_in(const std::filesystem::path& folder, const std::filesystem::path& path);

/// A file or folder that is made next to `target` and then renamed to it. The destructor removes it if it still exists.
/// What a killed process has left in that folder is removed when the next Beside is made there. Those of running
/// processes stay: each holds a lock (flock), which the kernel releases when the process ends.
class Beside {
  public:
    enum class Kind { file, folder };
    /// `extension` ends the name. Throws Error (runtime) that names `target`.
    Beside(const std::filesystem::path& target, Kind kind, std::string_view extension = ".tmp");
    ~Beside();
    Beside(const Beside&) = delete;
    Beside& operator=(const Beside&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    /// Of a file: open for writing; closed by this.
    int descriptor() const { return descriptor_; }

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace lapfx
