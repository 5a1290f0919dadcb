// Lists where the files of a bundle come from, so that a person sees it before they are copied: a scene's organ and
// tool may be anywhere on the disk.
//
//     for (const output::SourceFile& s : output::outside_files(preset, &scene, scene.folder, clip_folders))
//         show(s.what, s.file);
//
// No OpenGL; any thread.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lapfx/scene.h"

namespace lapfx {
struct Preset;
}

namespace lapfx::output {

/// A file that a bundle copies.
struct SourceFile {
    std::string what;            ///< "Organ", "Tool" or "Clip"
    std::filesystem::path file;  ///< absolute, symbolic links resolved; for numbered images their pattern
    friend bool operator==(const SourceFile&, const SourceFile&) = default;
};

/// The files outside of `folder` that a bundle of `preset`, and of `scene` if it is not null, would copy. Each file is
/// listed once. If `folder` is empty, all files count as outside. `organ_files` and `tool_files` are all files of these
/// meshes if they have been read; if they are empty, only the mesh's own file is listed. Files that cannot be found are
/// left out: write_bundle() reports them.
std::vector<SourceFile> outside_files(const Preset& preset, const Scene* scene, const std::filesystem::path& folder,
                                      const std::vector<std::filesystem::path>& clip_folders,
                                      std::span<const std::filesystem::path> organ_files = {},
                                      std::span<const std::filesystem::path> tool_files = {});

}  // namespace lapfx::output
