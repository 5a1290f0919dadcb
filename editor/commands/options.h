// What the verbs that draw pictures have in common on their command lines.
#pragma once

#include <CLI/CLI.hpp>

#include "lapfx/authoring/preview.h"
#include "lapfx/error.h"

namespace lapfx::commands {

/// Wrong use (bad_input) of an option, such as --size.
Error wrong_option(const std::string& option, const std::string& reason);

/// `text` as in 1280x1024. Throws Error (bad_input) outside 1x1 to 16384x16384.
glm::ivec2 parse_size(const std::string& text);

/// Lets no "nan" and no "inf" through, which CLI::Range does.
CLI::Validator finite_number();

/// Throws Error (bad_input) where a picture cannot have that name: it is a PNG.
void check_picture_name(const std::string& option, const std::string& file);

/// Whether the file's folder is there, before the work and not after it. Throws Error (runtime).
void check_folder(const std::filesystem::path& output);

/// On stderr: what the user should know of the scene and would not see in the picture.
void print_warnings(const Preview& preview);
/// What of the smoke will not be seen: nothing where no tool burns.
void print_smoke_notes(const Scene& scene, const Preset& preset);
/// Likewise of its smoke clips, once they have played: what could not be decoded is known then.
void print_clip_warnings(const Preview& preview);
/// Likewise for a time, s, that `--at` named.
void warn_after_end(const Scene& scene, double at);

}  // namespace lapfx::commands
