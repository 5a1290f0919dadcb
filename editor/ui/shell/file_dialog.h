// The dialog that chooses files and folders. It is our own, so that it is the same on every desktop and can be tested.
//
//     ui::FileDialog files(ui::system_files());
//     if (ui::button(u, "Open")) files.open(u, {.task = ui::FileTask::open, .title = "Open a plate",
//                                               .filters = {{"Pictures", {".exr", ".png"}}}});
//     if (const auto chosen = files.build(u)) load(chosen->front());
//
// A folder is read when it is entered, and again by the button for that. Typed names and paths are completed
// (shell/path_completion.h); letters typed on the list go to the next name that begins so. Wherever the keyboard is:
// Ctrl+Shift+N makes a folder, Alt+Up goes to the one above, Ctrl+L to the name, Ctrl+H shows hidden files, F5 reads
// again. Down goes from the name to the list where there is nothing to suggest.
#pragma once

#include <optional>

#include "ui/shell/file_preview.h"
#include "ui/shell/file_system.h"
#include "ui/shell/path_completion.h"
#include "ui/widgets/table.h"

namespace lapfx::ui {

enum class FileTask : std::uint8_t { open, open_many, save, folder };

struct FileFilter {
    std::string name;                     ///< "Pictures"
    std::vector<std::string> extensions;  ///< ".exr"; upper and lower case are one; none: all files
};

struct FileRequest {
    FileTask task = FileTask::open;
    std::string title{};
    std::string folder{};  ///< to begin in; empty: where the last one ended
    std::string name{};    ///< save: proposed
    /// The first is chosen to begin with; "All files" comes last by itself. Save: a name without an extension gets the
    /// first one of the filter chosen.
    std::vector<FileFilter> filters{};
};

class FileDialog {
  public:
    /// `beside`: what reads folders for completion; empty: that is done at once.
    explicit FileDialog(FileSystem& files, RunBeside beside = {})
        : files_(files), completion_(files, std::move(beside)) {}
    /// The picture of the selected file is shown beside the list; null: there is none.
    void show_pictures(FilePictures* pictures) { pictures_ = pictures; }

    void open(Ui& ui, FileRequest request);
    /// Once a frame. The paths, when they are chosen; of save one that may exist (the person was asked).
    std::optional<std::vector<std::string>> build(Ui& ui);

    /// Folders that something was chosen in, the newest first; for the settings.
    const std::vector<std::string>& recent() const { return recent_; }
    void set_recent(std::vector<std::string> folders) { recent_ = std::move(folders); }
    const std::string& folder() const { return folder_; }
    bool shows_hidden() const { return hidden_; }

  private:
    void go(const std::string& folder);
    void arrange();
    bool passes(const FileEntry& entry, bool hidden) const;
    const FileEntry& entry(std::size_t row) const { return entries_[shown_[row]]; }
    std::uint64_t key_of(std::size_t row) const;
    void build_path_bar(Ui& ui);
    void build_places(Ui& ui);
    void build_table(Ui& ui);
    void build_name(Ui& ui);
    void build_new_folder(Ui& ui);
    void begin_folder();
    void end_folder();
    void make_folder();
    void take_chords(Ui& ui, Id dialog);
    void take_name_keys(Ui& ui, Id field, const PathCompletion::FolderListing& shown);
    void go_to_list(Ui& ui);
    void select_from_table();
    void look_at(const FileEntry* entry);
    bool previews(const Ui& ui) const;
    void accept(Ui& ui);
    void accept_typed(Ui& ui, std::string path);
    void accept_selected();
    void choose(std::vector<std::string> paths) { done_ = std::move(paths); }

    FileSystem& files_;
    FilePictures* pictures_ = nullptr;
    PathCompletion completion_;
    FileRequest request_;
    std::string folder_, fault_;
    std::vector<FileEntry> entries_;
    std::vector<std::uint32_t> shown_;  ///< into entries_, filtered and in order
    std::vector<FilePlace> places_;
    std::vector<std::string> recent_;
    TableState table_;
    int filter_ = 0;
    bool hidden_ = false;
    std::string name_;                   ///< typed, or of what is selected
    std::vector<std::string> selected_;  ///< names
    std::optional<LookedAt> looked_at_;
    std::string new_folder_;  ///< its name, while it is typed
    std::string replaces_;    ///< path that exists: waits for the answer
    std::string cell_;        ///< a cell's text is made here: the table copies it before it asks for the next
    std::string count_;       ///< "3 files", in the field while it is empty
    std::vector<std::string_view> filter_names_;
    bool fresh_ = false;  ///< the keyboard has not been given to the field yet
    bool accepts_ = false, leaves_ = false;
    bool takes_enter_ = false;  ///< Enter was for something in the dialog, not for its button
    bool makes_folder_ = false, folder_fresh_ = false;
    std::optional<std::vector<std::string>> done_;
};

}  // namespace lapfx::ui
