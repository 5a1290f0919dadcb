// What an editor is started with.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "document/folders.h"

namespace lapfx::ui {
class FileSystem;
}

namespace lapfx::app {

class MeasuredVideos;

struct EditorOptions {
    std::filesystem::path data_folder;                ///< of the shipped presets, samples and shaders
    std::vector<std::filesystem::path> clip_folders;  ///< where bare clip names are looked up
    document::Folders folders;                        ///< of the user: settings, state, cache
    /// For pictures and tests: clips and references are decoded exactly, jobs waited for, nothing is autosaved.
    bool exact = false;
    double exact_scale = 1.0;      ///< with `exact`: factor on width and height of the scene's pictures
    bool measures_preview = true;  ///< the preview is measured while somebody looks at what that shows
    int measured_side = 256;  ///< px of the longer side of pictures that are drawn to be measured (match::preview_side)
    std::shared_ptr<MeasuredVideos> measured = nullptr;  ///< other editors may share it; null: the editor makes its own
    std::string renderer;                                ///< GL_RENDERER, for the status bar
    bool software = false;                               ///< no GPU
    std::function<double()> clock{};                     ///< s, for what pictures cost; empty: this computer's
    ui::FileSystem* files = nullptr;                     ///< of file dialogs; null: this computer's
};

}  // namespace lapfx::app
