// A preset on its way to others: alone, or as a folder with all that it needs. Never half of one: what is written has
// been loaded back before it gets its name. No OpenGL; any thread.
//
//     output::export_preset(preset, "/mnt/share/ooze.json", clip_folders);
//
//     output::write_bundle({.preset = preset, .scene = scene, .folder = "/mnt/share/ooze", .clip_folders =
//     clip_folders,
//                           .thumbnail = image});
//     // ooze/ooze.json  ooze/thumbnail.png  ooze/clips/plume.mp4
//     // ooze/ooze.scene.json  ooze/organ/liver.glb  ooze/tool/hook.glb
//
// All names in a bundle are made here: none comes from a file, and nothing is written outside of the bundle. Only what
// was read as the clip, mesh or picture that it is said to be comes along.
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

/// Where a preset's clip lies: one file, or the images of a numbered sequence; none when it cannot be found, or is out
/// of reach.
struct ClipFiles {
    std::vector<std::filesystem::path> files;
    std::string name;      ///< of the file, or the pattern of the sequence
    std::string fault;     ///< why there are none
    bool shipped = false;  ///< found on the search path, by its bare name
    bool sequence = false;
};
ClipFiles clip_files(const std::string& clip, const std::filesystem::path& preset_folder,
                     const std::vector<std::filesystem::path>& clip_folders);

/// The preset as a file in `folder` has to name its clips. A clip that is missing, or lies outside of the folder, is a
/// fault whose place is its "/smoke/clips/N/file".
Preset preset_in(const std::filesystem::path& folder, const Preset& preset,
                 const std::vector<std::filesystem::path>& clip_folders, std::vector<Fault>& faults);

/// Writes the preset alone, loads it back and compares. Throws Error.
void export_preset(const Preset& preset, const std::filesystem::path& file,
                   const std::vector<std::filesystem::path>& clip_folders);

struct Bundle {
    Preset preset;
    std::optional<Scene> scene{};  ///< with its organ and tool; the reference video stays where it is
    std::filesystem::path folder;  ///< its name is that of the files in it
    std::vector<std::filesystem::path> clip_folders;
    Image thumbnail;
};

/// Why a bundle cannot be made in the folder `named` so; empty: it can. A folder that is there is replaced only if it
/// is empty or a bundle.
std::string check_bundle_folder(const std::filesystem::path& named);

/// What a bundle holds.
struct BundleContent {
    std::size_t files = 0, bytes = 0, clips = 0;
};

/// `goes_on`, with a share 0..1, now and then: false stops it, nothing is left, and Error (runtime) is thrown, as for
/// all that goes wrong.
BundleContent write_bundle(const Bundle& bundle, const std::function<bool(double)>& goes_on = {});

}  // namespace lapfx::output
