// Finding a smoke clip's file, and telling what is none: a clip is one plain local file, or a sequence of numbered
// images.
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
/// sequence
/// ("plume_%04d.png") is found where its first image is.
/// Throws Error (bad_input) that names `file`: where it was looked for, or that a directory or no plain file has its
/// name in the preset's folder.
std::filesystem::path find_clip(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> search_path);

/// The same as the one name that the file is known by: absolute, without "..".
std::filesystem::path clip_path(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> search_path);

/// Images that are numbered without a gap, all in one folder.
struct ImageSequence {
    std::filesystem::path folder;
    std::string before, after;  ///< the number, in a name
    int digits = 0;             ///< that a number has at least
    int first = 0, count = 0;

    std::filesystem::path file(int index) const;
};

/// What a name with one "%d" or "%04d" stands for: the files from the lowest number in 0..999 on, at most `maximum`.
/// None when there is a file of just that name, when it is no such pattern, or when no image is there.
std::optional<ImageSequence> find_sequence(const std::filesystem::path& pattern, int maximum);

/// The images of such a name, in their order; none when it is none.
std::vector<std::filesystem::path> sequence_images(const std::filesystem::path& pattern);

constexpr const char* not_decodable = "is not a video that can be decoded";

Error bad_clip(const std::filesystem::path& path, const std::string& reason);

/// Throws Error (bad_input): no file, not a plain one, empty, a playlist or another text.
void require_clip_file(const std::filesystem::path& path);

}  // namespace lapfx::media
