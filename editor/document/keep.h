// Unsaved work that an editor keeps so that it survives a crash. Each editor writes files into a folder of its own and
// holds a lock in it, which the kernel releases when the process ends. A folder with files whose lock nobody holds was
// left behind by an editor that crashed.
//
//     KeepFolder keep(folders.state / "autosave");
//     keep.write(kept);                       // any thread, one at a time
//     keep.remove();                          // everything was saved
//     ...
//     for (LeftBehind& left : find_left_behind(folders.state / "autosave")) offer(left);
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "document/lock.h"

namespace lapfx::document {

struct KeptSnapshot {
    std::size_t slot = 0;
    std::int64_t time = 0;  ///< s since 1970, UTC
    Preset preset;
    std::filesystem::path file{};  ///< the file of the preset that was shown then; empty: it had none
};

struct Kept {
    std::int64_t time = 0;  ///< s since 1970, UTC
    Content content;
    std::filesystem::path scene_file, preset_file;
    OnDisk scene_disk, preset_disk;
    bool scene_unsaved = false, preset_unsaved = false;
    std::vector<KeptSnapshot> snapshots;
};

std::string write_kept(const Kept& kept);
/// Values that contradict each other are kept as they are: a document may break rules while it is edited. `told` gets a
/// line for each thing that could not be used. Throws Error (bad_input) when nothing can be used.
Kept read_kept(const std::filesystem::path& file, std::vector<std::string>& told);

class KeepFolder {
  public:
    static constexpr std::size_t most_files = 5;    ///< that one editor keeps
    static constexpr std::size_t most_in_all = 20;  ///< of all editors together; those of running editors stay

    /// `folder` is shared by all editors. Nothing is made before the first write().
    explicit KeepFolder(std::filesystem::path folder) : all_(std::move(folder)) {}

    /// Throws Error (runtime); what was kept before stays.
    void write(const Kept& kept);
    /// Removes what this editor has kept. The next write() starts a new folder.
    void remove();
    const std::filesystem::path& folder() const { return own_; }  ///< empty: nothing was written

  private:
    std::filesystem::path all_, own_;
    std::optional<Lock> lock_;
    unsigned count_ = 0;
};

/// The work that one editor kept before it ended. As long as this object exists, no other editor is offered that work.
struct LeftBehind {
    std::filesystem::path folder;
    Lock lock;
    std::vector<std::filesystem::path> files;  ///< the newest first
    std::int64_t time = 0;                     ///< the newest was written at this time, s since 1970, UTC
};

/// The newest first.
std::vector<LeftBehind> find_left_behind(const std::filesystem::path& folder);
/// Deletes its files. Throws Error (runtime).
void discard(LeftBehind left);

}  // namespace lapfx::document
