// Finds the file of a smoke clip, and refuses what is not a clip: a clip is one plain local file, or a sequence of
// numbered images.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lapfx/authoring/clip.h"
#include "lapfx/error.h"

namespace lapfx::media {

/// The clip `file` of a preset: inside the preset's folder, or a bare name on the search path. The name of an image
/// sequence ("plume_%04d.png") is found where its first image is. Throws Error (bad_input) that names `file`: where it
/// was looked for, or that its name in the preset's folder is a directory or not a plain file.
std::filesystem::path find_clip(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> search_path);

/// The same as an absolute path without "..".
std::filesystem::path clip_path(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> search_path);

/// Images that are numbered without a gap, all in one folder.
struct ImageSequence {
    std::filesystem::path folder;
    std::string before, after;  ///< the number, in a name
    int digits = 0;             ///< least number of digits
    int first = 0, count = 0;

    std::filesystem::path file(int index) const;
};

/// The files that a name with one "%d" or "%04d" means: from the lowest number in 0..999 on, at most `maximum`. None
/// when a file has exactly that name, when it is not such a pattern, or when there is no image.
std::optional<ImageSequence> find_sequence(const std::filesystem::path& pattern, int maximum);

/// The images of such a name, in their order; empty when it is not a pattern.
std::vector<std::filesystem::path> sequence_images(const std::filesystem::path& pattern);

constexpr const char* not_decodable = "is not a video that can be decoded";

Error bad_clip(const std::filesystem::path& path, const std::string& reason);

/// Throws Error (bad_input): no file, not a plain one, empty, a playlist or another text.
void require_clip_file(const std::filesystem::path& path);

}  // namespace lapfx::media
