#include "app/base/file_chooser.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "app/base/screen.h"
#include "app/base/settings.h"
#include "document/document.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

/// On a thread that nobody waits for, since reading a folder may hang, even when the program ends. Throws
/// std::system_error when there are too many threads.
void run_beside(std::function<void()> work) {
    std::thread(std::move(work)).detach();
}

bool inside(const fs::path& file, const fs::path& folder) {
    if (folder.empty()) return false;
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(file, error), above = fs::weakly_canonical(folder, error);
    const auto [end, ignored] = std::mismatch(above.begin(), above.end(), whole.begin(), whole.end());
    return !error && end == above.end();
}

ui::FileSystem& files_of(const EditorOptions& options) {
    return options.files != nullptr ? *options.files : ui::system_files();
}

}  // namespace

FileChooser::FileChooser(const EditorOptions& options, Settings& settings, Screen& screen)
    : options_(options),
      settings_(settings),
      screen_(screen),
      dialog_(files_of(options), options.exact ? ui::RunBeside() : run_beside) {}

void FileChooser::ask(ui::FileRequest request, Then then) {
    // Each kind of file has its own place: organs lie elsewhere than presets.
    if (request.folder.empty())
        request.folder = request.task == ui::FileTask::save ? own_folder(request.title).string()
                                                            : settings_.last_folder(request.title);
    asked_ = [this, title = request.title, folder = request.task == ui::FileTask::folder,
              then = std::move(then)](const std::vector<std::string>& chosen) {
        if (!chosen.empty()) settings_.note_folder(title, folder ? chosen.front() : ui::parent_of(chosen.front()));
        then(chosen);
    };
    dialog_.open(*screen_.ui(), std::move(request));
}

void FileChooser::build(ui::Ui& ui) {
    const auto chosen = dialog_.build(ui);
    if (!chosen || !asked_) return;
    const Then then = std::exchange(asked_, nullptr);
    then(*chosen);
}

fs::path FileChooser::own_folder(const std::string& title, const fs::path& beside) const {
    for (const fs::path& folder : {fs::path(settings_.last_folder(title)), beside, options_.folders.documents})
        if (takes_files(folder)) return folder;
    return files_of(options_).home();
}

bool FileChooser::shipped(const fs::path& file) const {
    const fs::path& data = options_.data_folder;
    return !data.empty() && (inside(file, data / "presets") || inside(file, data / "samples"));
}

bool FileChooser::takes_files(const fs::path& folder) const {
    return document::is_writable_folder(folder) && !shipped(folder);
}

}  // namespace lapfx::app
