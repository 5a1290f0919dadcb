// Document files: whole plain files in, never half a file out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lapfx {

/// Throws Error (bad_input) for what is missing, unreadable, not a plain file, empty, or larger than
/// `longest` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t longest);

/// Writes a new file beside `path`, flushes it to the disk and renames it. Throws Error (runtime); the old
/// file is then as it was. Refuses to replace what is not a plain file (a symbolic link, a folder, a pipe)
/// or is write-protected.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace lapfx
