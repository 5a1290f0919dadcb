// What a file of the command line is, for verbs that take several kinds.
#pragma once

#include <cstdint>
#include <filesystem>

namespace lapfx::commands {

enum class FileKind : std::uint8_t {
    organ,
    image,     ///< a picture that the core decodes as a texture
    video,     ///< numbered images (smoke_%04d.png) or another picture are one, too
    document,  ///< a preset or a scene
};

/// By the name, else by the first bytes; whether it can be read is not looked at. Throws Error (bad_input): no such
/// file, no plain file, empty, or a text that is none of these.
FileKind kind_of_file(const std::filesystem::path& file);

/// Whether both are the same file, by whatever names. One that does not exist is none.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);
/// The same, also of files that do not exist yet and of the patterns of numbered images.
bool will_be_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace lapfx::commands
