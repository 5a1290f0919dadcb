// How a document names the files that it uses.
//
//     scene.organ.file = app::path_for("/data/case/liver.glb", "/data/case");  // "liver.glb"
#pragma once

#include <filesystem>
#include <string>

namespace lapfx::app {

/// `file` as a document in `folder` names it: relative when it lies inside, else absolute.
std::string path_for(const std::filesystem::path& file, const std::filesystem::path& folder);

/// The path of a file that a scene in `folder` names; empty: it names no file, or a URL.
std::filesystem::path path_from(const std::filesystem::path& folder, const std::string& file);

}  // namespace lapfx::app
