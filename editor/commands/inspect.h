// What `lapfx inspect` prints, one function for each kind of file. All write to stdout and throw lapfx::Error.
#pragma once

#include <filesystem>

namespace lapfx::commands {

void inspect_organ(const std::filesystem::path& file);
void inspect_image(const std::filesystem::path& file);
void inspect_video(const std::filesystem::path& file);
/// The result of suggest_keying(), also as the lines of a clip in a preset.
void inspect_keying(const std::filesystem::path& file);
void inspect_document(const std::filesystem::path& file);

}  // namespace lapfx::commands
