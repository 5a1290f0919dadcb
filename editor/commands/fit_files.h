// The files of lapfx fit: which may be written, and the scene that is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "commands/shown_scene.h"

namespace lapfx::commands {

/// The members are the names that were given; empty: none.
struct FitFiles {
    std::string scene, reference, preset;           ///< are read
    std::string output, fitted_scene, csv, report;  ///< are written
};

/// Before anything is read: endings and folders. Throws Error: bad_input, or runtime for a folder that is not there.
void check_names(const FitFiles& files);
/// Before the work: no file that is written is one that is read, or another one; and the preset finds its clips from
/// where it is written. Throws Error: bad_input, or runtime where a file may not be written.
void check_files(const FitFiles& files, const ShownScene& shown);

/// Those that were given, and those that the scene names; of a preset's clips none. Throws Error (bad_input) for a name
/// that is no path.
std::vector<std::filesystem::path> read_files(const FitFiles& files, const Scene& scene);

/// The scene as the document that is written, with the fitted preset and the reference.
Scene fitted_scene(const FitFiles& files, const SceneReference& reference, Scene scene);

}  // namespace lapfx::commands
