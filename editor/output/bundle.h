// Writes a preset to pass it on: alone, or as a folder with all files that it needs. An export is never incomplete: it
// gets its name only after it has been loaded back. No OpenGL; any thread.
//
//     output::export_preset(preset, "/mnt/share/ooze.json", clip_folders);
//
//     output::write_bundle({.preset = preset, .scene = scene, .folder = "/mnt/share/ooze",
//         .clip_folders = clip_folders,
//                           .thumbnail = image});
//     // ooze/ooze.json  ooze/thumbnail.png  ooze/clips/plume.mp4
//     // ooze/ooze.scene.json  ooze/organ/liver.glb  ooze/tool/hook.glb
//
// All names in a bundle are made here. None is taken from a file, so nothing can be written outside of the bundle. A
// file is copied only if it could be read as the clip, mesh or picture that it is named as.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lapfx/organ.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::output {

/// The files of a preset's clip: one file, or the images of a numbered sequence. There are none when the clip cannot be
/// found or its name leads out of the folders that are allowed.
struct ClipFiles {
    std::vector<std::filesystem::path> files;
    std::string name;      ///< the name of the file, or the pattern of the sequence
    std::string fault;     ///< why there are no files
    bool shipped = false;  ///< it was found on the search path, by its name without a folder
    bool sequence = false;
};
ClipFiles clip_files(const std::string& clip, const std::filesystem::path& preset_folder,
                     const std::vector<std::filesystem::path>& clip_folders);

/// The preset with its clips named as a file in `folder` has to name them. A clip that is missing or is outside of the
/// folder is a fault whose place is its "/smoke/clips/N/file".
Preset preset_in(const std::filesystem::path& folder, const Preset& preset,
                 const std::vector<std::filesystem::path>& clip_folders, std::vector<Fault>& faults);

/// Writes the preset alone, loads it back and compares. Throws Error.
void export_preset(const Preset& preset, const std::filesystem::path& file,
                   const std::vector<std::filesystem::path>& clip_folders);

struct Bundle {
    Preset preset;
    std::optional<Scene> scene{};  ///< with its organ and tool; the reference video stays where it is
    std::filesystem::path folder;  ///< the preset and the scene in it get its name
    std::vector<std::filesystem::path> clip_folders;
    Image thumbnail;
};

/// The reason why a bundle cannot be made under this name; empty: it can. An existing folder is replaced only if it is
/// empty or a bundle.
std::string check_bundle_folder(const std::filesystem::path& named);

/// How much a bundle contains.
struct BundleContent {
    std::size_t files = 0, bytes = 0, clips = 0;
};

/// Calls `goes_on` from time to time with the share that is done, 0..1. If that returns false, the export is cancelled.
/// Throws Error (runtime) then, and for all other failures, and leaves nothing behind.
BundleContent write_bundle(const Bundle& bundle, const std::function<bool(double)>& goes_on = {});

}  // namespace lapfx::output
