// Reads folders in the background, one at a time, because a folder may lie on a slow or broken network.
#pragma once

#include <memory>

#include "ui/core/ui.h"
#include "ui/shell/file_system.h"

namespace lapfx::ui {

class FolderReader {
  public:
    /// `beside`: empty: read at once. `files` must outlive all that was read, also after this has gone.
    FolderReader(FileSystem& files, RunBeside beside) : files_(files), beside_(std::move(beside)) {}
    ~FolderReader() { forget(); }
    FolderReader(const FolderReader&) = delete;
    FolderReader& operator=(const FolderReader&) = delete;

    /// The entries of `folder`; null: it is still being read, and the UI is woken when it has been. A folder that
    /// cannot be read has no entries. Only the last folder is kept: another one asked for earlier is read again.
    const std::vector<FileEntry>* read(Ui& ui, const std::string& folder);
    /// Drops what was read and what is being read. Call it before the Ui is destroyed.
    void forget();

  private:
    static constexpr std::size_t most_left =
        4;  ///< readings that were given up and still hang; with so many, no other is begun
    struct Reading;

    FileSystem& files_;
    RunBeside beside_;
    std::shared_ptr<Reading> now_;
    std::vector<std::weak_ptr<Reading>> left_;
};

}  // namespace lapfx::ui
