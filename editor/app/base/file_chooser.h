// Asks a person for files and folders, by the one file dialog, and knows which folders are the person's own.
//
//     chooser.ask({.title = "Add clips"}, [&](const std::vector<std::string>& files) { shelf.add(files); });
//
// UI thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/base/editor_options.h"
#include "ui/shell/file_dialog.h"

namespace lapfx::app {

class Screen;
class Settings;

class FileChooser {
  public:
    using Then = std::function<void(const std::vector<std::string>&)>;

    /// All must outlive it.
    FileChooser(const EditorOptions& options, Settings& settings, Screen& screen);

    /// Opens the dialog; `then` gets the paths that were chosen, of save one that may exist (the person was asked).
    /// Opens the dialog. If `request` has no folder, it starts where files of this title were chosen last. Call it
    /// after the first frame.
    void ask(ui::FileRequest request, Then then);
    /// Once a frame, while the UI is built.
    void build(ui::Ui& ui);

    /// The folder to write to unless the person chooses another one: the last one (for this `title` of the dialog),
    /// `beside`, or the user's documents; never a folder of files that came with the program.
    std::filesystem::path own_folder(const std::string& title, const std::filesystem::path& beside = {}) const;
    /// What came with the program: Save does not write over it, nor is anything proposed there.
    bool shipped(const std::filesystem::path& file) const;
    /// A folder that files of the user may be put into: writable, and not among those that came with the program.
    bool takes_files(const std::filesystem::path& folder) const;

    ui::FileDialog& dialog() { return dialog_; }

  private:
    const EditorOptions& options_;
    Settings& settings_;
    Screen& screen_;
    ui::FileDialog dialog_;
    Then asked_;
};

}  // namespace lapfx::app
