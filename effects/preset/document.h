// Documents over a parameter table: JSON text to struct and back, and the schema. Presets and scenes are
// two of them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "lapfx/parameter.h"
#include "preset/json.h"

namespace lapfx::preset {

/// A format: {"format": "lapfx.preset", "version": 1, ...}.
struct Format {
    std::string_view format;
    int version;  ///< the newest that this program reads, and the one it writes
    std::string_view title;
    std::string_view help;
    const Table& (*table)();
};

constexpr std::size_t most_faults =
    200;  ///< most faults that are listed; a file with more is not a document of this kind

/// Fills `document`, a struct with its defaults. Throws Error (bad_input) with all faults; then the struct
/// is half filled.
void read_document(const Format& format, const Json& json, const std::string& name, void* document);

/// Every key in table order, two-space indent, vectors and colours on one line, final newline.
std::string write_document(const Format& format, const void* document);

/// Validates, then replaces the file at once. Throws Error.
void save_document(const Format& format, const void* document, const std::filesystem::path& path);

/// Draft-07 JSON Schema. `defaults` is a struct with its defaults; its lists are changed on the way.
std::string write_schema(const Format& format, void* defaults);

extern const Format preset_format;
extern const Format scene_format;

}  // namespace lapfx::preset
