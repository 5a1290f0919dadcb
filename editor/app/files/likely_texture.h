// Which picture may be the texture that an organ names and that is not there: files are renamed, converted and put into
// a folder beside.
//
//     if (const auto found = app::likely_texture(missing, "liver.obj")) offer(*found);
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lapfx::app {

/// The pictures of `files` that cannot be read: textures that an organ names.
std::vector<std::filesystem::path> missing_textures(const std::vector<std::filesystem::path>& unread);

/// Looks in the folder of `missing` and in folders in it: the same name with another ending, else what shares most of
/// its beginning with the name of the missing file or of the mesh, else the only picture. Nothing where several are as
/// likely. Normal maps and the like are left out.
std::optional<std::filesystem::path> likely_texture(const std::filesystem::path& missing,
                                                    const std::filesystem::path& mesh);

}  // namespace lapfx::app
