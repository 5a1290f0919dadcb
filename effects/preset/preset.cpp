#include "lapfx/preset.h"

#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"
#include "preset/document.h"
#include "preset/tables.h"
#include "preset/text.h"

namespace lapfx {

namespace preset {

const Format preset_format{
    .format = "lapfx.preset",
    .version = 1,
    .title = "lapfx preset",
    .help = "Tuned parameters of bleeding and surgical smoke. Lengths in mm, times in s, colours sRGB.",
    .table = preset_table,
};

std::string below(double value, std::string_view bound_key, double bound) {
    if (value < bound) return {};
    return number_text(value) + " is not below " + std::string(bound_key) + " (" + number_text(bound) + ')';
}

std::string not_above(double value, std::string_view bound_key, double bound) {
    if (value <= bound) return {};
    return number_text(value) + " is above " + std::string(bound_key) + " (" + number_text(bound) + ')';
}

}  // namespace preset

const Table& preset_table() {
    static constexpr Parameter rows[] = {
        preset::text<&Preset::name>("name", "Name", 100, "What the preset is called in lists."),
        preset::text<&Preset::description>("description", "Description", 1000, "What the preset is for, in a line."),
        preset::text<&Preset::tags>("tags", "Tags", 200,
                                    "Words by which lists find the preset, separated by commas: slow, venous."),
    };
    static const Table groups[] = {preset::bleeding_table(), preset::vessels_table(), preset::cautery_table(),
                                   preset::smoke_table()};
    static const Table root{
        .key = "", .name = "Preset", .help = preset::preset_format.help, .rows = rows, .tables = groups, .rules = {}};
    return root;
}

Preset parse_preset(std::string_view json, const std::string& name, const std::filesystem::path& folder) {
    Preset made;
    preset::read_document(preset::preset_format, preset::parse_json(json, name), name, &made);
    made.folder = folder;
    return made;
}

Preset load_preset(const std::filesystem::path& path) {
    note_read(path);
    return parse_preset(read_file(path, preset::longest_document), path.string(), path.parent_path());
}

std::string write_preset(const Preset& preset) {
    return preset::write_document(preset::preset_format, &preset);
}

void save_preset(const Preset& preset, const std::filesystem::path& path) {
    preset::save_document(preset::preset_format, &preset, path);
}

std::string preset_schema() {
    Preset defaults;
    return preset::write_schema(preset::preset_format, &defaults);
}

}  // namespace lapfx
