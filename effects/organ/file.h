// Reading files that may be anything: missing, a folder, a pipe, empty, huge.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lapfx::organ {

using Bytes = std::vector<std::uint8_t>;

/// The whole of a plain local file. Throws Error (bad_input): missing, not a plain file, empty, unreadable,
/// larger than maximum_file_size. `name` is what the faults call the file, `place` where it was asked for.
Bytes read_file(const std::filesystem::path& path, const std::string& name, const std::string& place = {});

/// Where a file named inside another file lies: beside it or below its folder. Throws Error (bad_input) for a
/// URL, an absolute path and a path that leads out of the folder. Does not look whether the file is there.
std::filesystem::path file_beside(const std::filesystem::path& folder, std::string_view reference,
                                  const std::string& file, const std::string& place);

/// "%20" and the like of a URI.
std::string percent_decoded(std::string_view uri);

/// "scheme:rest" as in URLs and data URIs; a single letter (a DOS drive) counts as well.
bool has_scheme(std::string_view reference);

/// Standard base64; false when the text is none.
bool decode_base64(std::string_view text, Bytes& out);

}  // namespace lapfx::organ
