// Reading files that may be anything: missing, a folder, a pipe, empty, huge.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lapfx::organ {

using Bytes = std::vector<std::uint8_t>;

/// The whole of a plain local file. Throws Error (bad_input): missing, not a plain file, empty, unreadable, larger than
/// maximum_file_size. Faults use `name` for the file and `place` for where it is named.
Bytes read_file(const std::filesystem::path& path, const std::string& name, const std::string& place = {});

/// The text of a file as UTF-8, without the byte order mark that some programs write first; a file whose mark says
/// UTF-16 is converted into `storage`. A file without a mark is its own text.
std::string_view text_of(const Bytes& bytes, std::string& storage);

/// "%20" and the like of a URI.
std::string percent_decoded(std::string_view uri);

/// Base64, also with the letters for URLs (RFC 4648, sections 4 and 5); false when the text is not Base64. At most 2
/// GiB of text.
bool decode_base64(std::string_view text, Bytes& out);

}  // namespace lapfx::organ
