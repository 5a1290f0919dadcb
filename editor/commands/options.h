// Shared by the command lines of verbs that draw pictures.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "lapfx/error.h"

namespace lapfx {
class Preview;
struct Preset;
struct Scene;
}  // namespace lapfx

namespace lapfx::commands {

/// Wrong use (bad_input) of an option, such as --size.
Error wrong_option(const std::string& option, const std::string& reason);

/// `text` as in 1280x1024. Throws Error (bad_input) for a size that a frame cannot have.
glm::ivec2 parse_size(const std::string& text);

/// Throws Error (bad_input) where a picture cannot have that name: it is a PNG.
void check_picture_name(const std::string& option, const std::string& file);

/// Checks a file that `option` has the command write, before the work; none if it is empty. Throws Error: runtime for a
/// folder that is not there or what may not be replaced, bad_input for a file that is read or is the output of another
/// option (file_guard.h).
void check_output(const std::string& option, const std::filesystem::path& output);

/// Prints on stderr what the user should know about the scene and would not see in the picture.
void print_warnings(const Preview& preview);
/// Prints which frame of the reference the plate is; nothing if there is none.
void print_plate_note(const Scene& scene, const Preview& preview);
/// Prints which smoke will not be visible; nothing if no tool burns.
void print_smoke_notes(const Scene& scene, const Preset& preset);
/// Prints which events touch nothing (touch_notes.h).
void print_touch_notes(const Scene& scene, const Preview& preview);
/// Prints warnings about its smoke clips. Call it when they have played, because frames that cannot be decoded are
/// known then.
void print_clip_warnings(const Preview& preview);
/// Warns about a time of `--at`, s, after the end of the scene.
void warn_after_end(const Scene& scene, double at);

}  // namespace lapfx::commands
