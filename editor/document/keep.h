// What an editor keeps of unsaved work, so that it outlives a crash: files in a folder of its own, under a lock that
// the kernel releases when the process ends. A folder with files and without a holder is what a crashed editor left
// behind.
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
    std::filesystem::path file{};  ///< of the preset that it is a state of; empty: it had none
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
/// Values that contradict each other are kept as they are: a document may be out of order while it is edited. What
/// could not be used is told. Throws Error (bad_input) when nothing can.
Kept read_kept(const std::filesystem::path& file, std::vector<std::string>& told);

class KeepFolder {
  public:
    static constexpr std::size_t most_files = 5;    ///< of one editor
    static constexpr std::size_t most_in_all = 20;  ///< of all that are there; those of running editors stay

    /// `folder`: of all editors. Nothing is made before the first write().
    explicit KeepFolder(std::filesystem::path folder) : all_(std::move(folder)) {}

    /// Throws Error (runtime); what was kept before stays.
    void write(const Kept& kept);
    /// What this editor kept goes; the next write() begins anew.
    void remove();
    const std::filesystem::path& folder() const { return own_; }  ///< empty: nothing was written

  private:
    std::filesystem::path all_, own_;
    std::optional<Lock> lock_;
    unsigned count_ = 0;
};

/// What one ended editor kept. As long as this lives nobody else is offered it.
struct LeftBehind {
    std::filesystem::path folder;
    Lock lock;
    std::vector<std::filesystem::path> files;  ///< the newest first
    std::int64_t time = 0;                     ///< of the newest, s since 1970, UTC
};

/// The newest first.
std::vector<LeftBehind> find_left_behind(const std::filesystem::path& folder);
/// Its files, for good. Throws Error (runtime).
void discard(LeftBehind left);

}  // namespace lapfx::document
