#include "ui/shell/folder_reader.h"

#include <algorithm>
#include <exception>
#include <mutex>

namespace lapfx::ui {

/// Shared with the thread that reads.
struct FolderReader::Reading {
    std::string folder;
    std::vector<FileEntry> entries;  ///< only the thread uses them until `done`
    std::mutex mutex;
    bool done = false;
    Ui* ui = nullptr;  ///< woken at the end; null: nobody waits any more

    void read(FileSystem& files) {
        std::vector<FileEntry> found;
        try {
            if (!files.list(folder, found).empty()) found.clear();
        } catch (const std::exception&) {  // out of memory
            found.clear();
        }
        const std::lock_guard lock(mutex);
        entries = std::move(found);
        done = true;
        if (ui != nullptr) ui->wake("a folder");
    }
};

const std::vector<FileEntry>* FolderReader::read(Ui& ui, const std::string& folder) {
    if (now_ == nullptr || now_->folder != folder) {
        forget();
        std::erase_if(left_, [](const auto& each) { return each.expired(); });
        if (left_.size() >= most_left) return nullptr;
        now_ = std::make_shared<Reading>();
        now_->folder = folder;
        now_->ui = &ui;
        if (beside_) {
            try {
                beside_([reading = now_, &files = files_] { reading->read(files); });
            } catch (const std::exception&) {  // no thread can be made
                now_->done = true;
            }
        } else {
            now_->read(files_);
        }
    }
    const std::lock_guard lock(now_->mutex);
    return now_->done ? &now_->entries : nullptr;
}

void FolderReader::forget() {
    if (now_ == nullptr) return;
    {
        const std::lock_guard lock(now_->mutex);
        now_->ui = nullptr;
        if (!now_->done) left_.emplace_back(now_);
    }
    now_.reset();
}

}  // namespace lapfx::ui
