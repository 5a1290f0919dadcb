// Which picture may be the texture that an organ names and that is not there: files are renamed, converted and put into
// a folder beside.
//
//     if (const auto found = app::likely_texture(missing, "liver.obj")) offer(*found);
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx::app {

/// The pictures of `files` that cannot be read: textures that an organ names.
std::vector<std::filesystem::path> missing_textures(const std::vector<std::filesystem::path>& unread);

/// Looks in the folder of `missing` and in folders in it: the same name with another ending, else what shares most of
/// its beginning with the name of the missing file or of the mesh, else the only picture. Nothing where several are as
/// likely. Normal maps and the like are left out.
std::optional<std::filesystem::path> likely_texture(const std::filesystem::path& missing,
                                                    const std::filesystem::path& mesh);

/// A texture that an organ names and that cannot be read, and the picture that may be meant.
struct MissingTexture {
    std::filesystem::path missing;
    std::optional<std::filesystem::path> likely;
    bool there = false;  ///< a file of this name is, but it cannot be read as a picture
};

/// "Its texture skin.png is missing", or "cannot be read" where there is such a file; without a full stop.
std::string words_of(const MissingTexture& texture);
/// "Use skin.jpg"; with its folder where both have the same name: "Use textures/skin.png". `likely` must be there.
std::string offer_of(const MissingTexture& texture);

/// Of the first texture of an organ without any for which a picture is found, else of the first that is missing.
/// Nothing where the organ has a picture: one that is given in the scene is that of every part.
std::optional<MissingTexture> missing_texture(const Organ& organ, const std::filesystem::path& mesh);

}  // namespace lapfx::app
