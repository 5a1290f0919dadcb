// Shared by verbs that show a scene: its preset, and the folders of shipped files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lapfx {
struct Preset;
struct Scene;
}  // namespace lapfx

namespace lapfx::commands {

/// The folder of the shipped files: clips, presets, samples, shaders. It is named by LAPFX_DATA in the environment, or
/// lies beside the program: ../share/lapfx where it is installed, share/lapfx in a build folder. Throws Error
/// (bad_input) where there is none.
std::filesystem::path data_folder();

/// The folders where bare clip names of presets are looked up: the shipped clips.
std::vector<std::filesystem::path> clip_folders();

/// The preset that the scene names, or `preset` when that is not empty; then each `KEY=VALUE` of `settings`.
/// Throws Error (bad_input).
Preset preset_for(const Scene& scene, const std::string& preset, const std::vector<std::string>& settings);

}  // namespace lapfx::commands
