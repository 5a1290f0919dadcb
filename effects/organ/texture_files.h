// The files that an OBJ, its material libraries and a PLY name.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "organ/raw.h"

namespace lapfx::organ {

/// Where the file of that name is for a mesh in `folder`. Backslashes separate folders. A path that leads elsewhere or
/// to no file, which was right on the machine that wrote it, is tried again without its first folders, down to the name
/// alone. Throws Error for a name that may not be followed.
std::filesystem::path file_beside(const std::filesystem::path& folder, std::string name);

/// Reads textures into an organ.
class TextureFiles {
  public:
    TextureFiles(std::filesystem::path folder, RawOrgan& organ) : folder_(std::move(folder)), organ_(organ) {}

    /// The index in RawOrgan::images; -1: there is none. Each file is read once, whatever its names, and gives one
    /// warning. One that is wanted with both is there for each `wrap`.
    int read(const std::string& name, Wrap wrap = Wrap::repeat);

  private:
    /// Empty, or why it is not a texture.
    std::string decode(const std::filesystem::path& path, Image& image, Encoded& encoded);

    int read_new(const std::filesystem::path& path, const std::string& name);

    std::filesystem::path folder_;
    RawOrgan& organ_;
    std::map<std::pair<std::string, Wrap>, int> by_name_;
    std::map<std::filesystem::path, std::map<Wrap, int>> by_path_;
};

}  // namespace lapfx::organ
