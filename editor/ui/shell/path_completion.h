// What a name or path may become while it is typed: the entries of its folder that begin so, in a list at its field.
//
// Tab takes the longest part that all of them begin with. Arrows mark one, Enter or a click takes it, Esc closes the
// list. The keyboard stays in the field. A path may begin with "~", "/" or "..".
#pragma once

#include "ui/shell/folder_reader.h"
#include "ui/widgets/rows.h"

namespace lapfx::ui {

/// The longest text that all of `names` begin with, in their spelling. All of them begin with `typed`, apart from the
/// case of letters; where they differ in case, the letters stay as typed.
std::string longest_common(std::span<const std::string_view> names, std::string_view typed);

class PathCompletion {
  public:
    static constexpr std::size_t most_found = 500;  ///< names after these, in order, are left out
    static constexpr std::size_t rows = 8;          ///< seen at once

    /// The folder that is shown, and which of any folder's entries are looked for (`hidden`: also those that begin with
    /// a dot).
    struct FolderListing {
        const std::string& folder;
        const std::vector<FileEntry>& entries;
        const FunctionRef<bool(const FileEntry&, bool hidden)>& wanted;
    };

    PathCompletion(FileSystem& files, RunBeside beside) : files_(files), reader_(files, std::move(beside)) {}

    /// Call it after `typed` was edited by hand.
    void search(Ui& ui, std::string_view typed, const FolderListing& shown);
    void close();
    /// What folders hold may have changed.
    void forget() { reader_.forget(); }
    bool open() const { return open_; }
    /// Whether Tab is for it: there is more to take, or a folder is still being read.
    bool completes() const { return waits_ || extends_; }
    /// A key of the field, which leaves Enter, Esc and arrows to this. Returns whether it was taken; `typed` may have
    /// changed.
    bool take_key(Ui& ui, Key key, std::string& typed, const FolderListing& shown);
    /// Once a frame after the field. Returns whether `typed` has changed.
    bool build(Ui& ui, Id field, std::string& typed, const FolderListing& shown);

  private:
    struct CompletedName {
        std::string name;
        bool folder = false;
    };
    void collect(const std::vector<FileEntry>& entries, std::string_view stem, const FolderListing& shown);
    void take(Ui& ui, std::size_t index, std::string& typed, const FolderListing& shown);
    void take_common(Ui& ui, std::string& typed, const FolderListing& shown);
    std::size_t put_rows(Ui& ui);
    void move(int step);

    FileSystem& files_;
    FolderReader reader_;
    std::string head_, common_;         ///< typed up to the last '/', and what Tab makes of the rest
    std::vector<CompletedName> found_;  ///< in order
    std::size_t marked_ = no_row, first_ = 0;
    bool open_ = false, waits_ = false, extends_ = false;
    bool tab_waits_ = false;  ///< Tab was pressed while the folder was being read
};

}  // namespace lapfx::ui
