// Where the files of a bundle come from, for a person to see before they are copied: a scene's organ and tool may be
// anywhere.
//
//     for (const output::SourceFile& s : output::outside_files(preset, &scene, scene.folder, clip_folders))
//     show(s.what, s.file);
//
// No OpenGL; any thread.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::output {

/// A file that a bundle copies.
struct SourceFile {
    std::string what;            ///< "Organ", "Tool" or "Clip"
    std::filesystem::path file;  ///< absolute, symbolic links resolved; of numbered images their pattern
    friend bool operator==(const SourceFile&, const SourceFile&) = default;
};

/// What a bundle of `preset`, and of `scene` if there is one, copies that is not in `folder` or below, each file once.
/// An empty `folder` has nothing in it. `organ_files`, `tool_files`: all files of these meshes, when they have been
/// read; without them the mesh stands for all. Files that cannot be found are left out: write_bundle() says what is
/// wrong with them.
std::vector<SourceFile> outside_files(const Preset& preset, const Scene* scene, const std::filesystem::path& folder,
                                      const std::vector<std::filesystem::path>& clip_folders,
                                      std::span<const std::filesystem::path> organ_files = {},
                                      std::span<const std::filesystem::path> tool_files = {});

}  // namespace lapfx::output
