#include "app/files/open.h"

#include <algorithm>

#include "app/files/organ_choice.h"
#include "app/preview/orbit.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/formats.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

fs::path preset_file_of(const Scene& scene) {
    return scene.preset.empty() ? fs::path() : named_path(scene.folder, scene.preset, Reach::anywhere, "", "/preset");
}

void open_scene(Opened& opened, const fs::path& file) {
    Scene& scene = opened.content.scene = load_scene(file);
    // The paths are the same as in the document, so that it asks for the files that were loaded early.
    scene.folder = document::folder_of(file);
    opened.content.preset = preset_of(scene);
    opened.scene_file = file;
    opened.preset_file = preset_file_of(scene);
    if (!scene.preset.empty()) opened.content.preset.folder = document::folder_of(opened.preset_file);
}

void open_preset(Opened& opened, const fs::path& file) {
    opened.content.preset = load_preset(file);
    opened.content.preset.folder = document::folder_of(file);
    opened.preset_file = file;
}

/// Seen from the front. What belonged to the former organ goes: events, and where the tool came from.
void open_organ(Opened& opened, const fs::path& file) {
    Scene& scene = opened.content.scene;
    scene.organ = {.file = fs::absolute(file).string()};
    scene.name = file.stem().string();
    scene.events.clear();
    const Organ loaded = load_organ(file);
    const OrganReport organ = report(loaded);
    for (const std::string& warning : organ.warnings) opened.warnings.push_back(file.string() + ": " + warning);
    see_whole(scene, organ);
    const glm::dvec3 size = (organ.maximum - organ.minimum) / loaded.scale;
    const double longest = std::max({size.x, size.y, size.z});
    if (const auto likely = likely_scale(longest, loaded.scale)) {
        OrganReport then = organ;
        then.minimum *= *likely / loaded.scale, then.maximum *= *likely / loaded.scale;
        opened.unit = {scene.organ.file, *likely, reason_for(longest, loaded.scale, *likely), then};
    }
    opened.scene_file.clear();
}

void check_exists(const fs::path& file) {
    const bool numbered = file.filename().string().find('%') != std::string::npos;  // told when none is found
    if (!numbered && !fs::exists(file))
        throw Error(Failure::bad_input, Fault{.file = file.string(), .place = "", .reason = "no such file"});
}

}  // namespace

bool is_document_name(const fs::path& file) {
    return is_named_as(Content::document, file);
}

bool is_organ_name(const fs::path& file) {
    return is_named_as(Content::mesh, file);
}

FileKind kind_of(const fs::path& file) {
    if (is_organ_name(file)) return FileKind::organ;
    if (!is_document_name(file)) {
        if (const std::string why = format_named(file) != nullptr ? "" : why_not_read(file); !why.empty())
            throw Error(Failure::bad_input, Fault{.file = file.string(), .place = "", .reason = why});
        if (is_text(file))
            throw Error(Failure::bad_input, Fault{.file = file.string(),
                                                  .place = "",
                                                  .reason = "is a text, but not a scene, a preset or an organ"});
        return FileKind::video;
    }
    return check_document(file).kind == "preset" ? FileKind::preset : FileKind::scene;
}

std::string why_not_replaced(FileKind kind, const fs::path& file) {
    const std::string what = kind == FileKind::scene ? "a scene" : "a preset";
    if (!is_document_name(file)) return what + " is a .json file";
    std::error_code error;
    if (!fs::exists(file, error) || fs::is_empty(file, error)) return {};
    try {
        if (kind_of(file) == kind) return {};
    } catch (const Error&) {  // a .json that is something else, or damaged
    }
    return "a file of this name is there and is not " + what + "; choose another name";
}

Preset preset_of(const Scene& scene) {
    return scene.preset.empty() ? Preset{} : load_preset(preset_file_of(scene));
}

Opened open_sample(const fs::path& data_folder) {
    Opened opened;
    open_scene(opened, data_folder / "samples" / "lagb.scene.json");
    return opened;
}

std::vector<std::string> open_files(Opened& opened, const std::vector<std::string>& files) {
    std::vector<std::string> presets, organs, videos;
    for (const std::string& file : files) {
        switch (kind_of(file)) {
            case FileKind::scene:
                open_scene(opened, file);
                break;
            case FileKind::preset:
                presets.push_back(file);
                break;
            case FileKind::organ:
                organs.push_back(file);
                break;
            default:
                check_exists(file);
                videos.push_back(file);
        }
    }
    for (const std::string& file : presets) open_preset(opened, file);
    for (const std::string& file : organs) open_organ(opened, file);
    return videos;
}

}  // namespace lapfx::app
