// lapfx check: validates presets and scenes, with the files that they name, or prints their schema.
#include <algorithm>
#include <iostream>

#include "commands/command.h"
#include "commands/say.h"
#include "commands/session.h"
#include "commands/shown_scene.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/picture.h"
#include "lapfx/authoring/printable.h"
#include "lapfx/authoring/smoke_notes.h"
#include "lapfx/authoring/touch_notes.h"
#include "lapfx/organ.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace {

constexpr std::size_t longest_schema = std::size_t{16} << 20;  // bytes

struct Options {
    std::vector<std::string> files;
    std::string schema;
};

/// Gives what is no fault, and yet not what somebody may have meant.
std::vector<std::string> check_scene(const Scene& scene, const std::string& name) {
    SceneFiles files(scene, name);
    std::vector<std::string> notes;
    const bool smokes = std::ranges::any_of(scene.events, [](const ToolContact& c) { return c.hot(); });
    files.open("/organ/file", scene.organ.file, [&](const auto& file) {
        notes =
            touch_notes(load_organ(file, {.scale = scene.organ.scale, .rotation = scene.organ.rotation}), scene.events);
    });
    files.open("/organ/texture", scene.organ.texture, [&](const auto& file) { read_image(file); });
    files.open("/tool/file", scene.tool.file, [&](const auto& file) { load_organ(file, {.scale = scene.tool.scale}); });
    files.open("/preset", scene.preset, [&](const auto& file) {
        const Preset preset = load_preset(file);
        check_clips(preset, file.string(), clip_folders());
        if (!smokes) return;
        for (const std::string& note : smoke_notes(preset.smoke)) notes.push_back("/preset: " + note);
    });
    files.open("/reference/file", scene.reference.file, [&](const auto& file) { report_clip(file); });
    if (std::vector<Fault> faults = files.take(); !faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    return notes;
}

/// Whether a file is named as a schema, as the two beside the shipped presets are. Throws Error (bad_input) for one
/// that is not that of this version.
bool is_schema(const std::string& file) {
    if (!file.ends_with(".schema.json")) return false;
    const std::string text = read_file(file, longest_schema);
    if (text == preset_schema() || text == scene_schema()) return true;
    throw Error(
        Failure::bad_input,
        Fault{.file = file,
              .place = "",
              .reason = "is not the schema of this version; `lapfx check --schema preset` (or scene) prints it"});
}

/// Checks every file before it throws, so that one run shows every fault.
void check_files(const std::vector<std::string>& files) {
    std::vector<Fault> faults;
    for (const std::string& file : files) {
        try {
            if (is_schema(file)) {
                std::cout << printable(file) << ": schema, ok\n";
                continue;
            }
            const CheckedDocument found = check_document(file);
            std::vector<std::string> notes;
            if (found.kind == "preset") {
                const Preset preset = load_preset(file);
                check_clips(preset, file, clip_folders());
                notes = smoke_notes(preset.smoke);
            }
            if (found.kind == "scene") notes = check_scene(load_scene(file), file);
            std::cout << printable(file) << ": " << found.kind << " \"" << printable(found.name) << "\", ok\n";
            for (const std::string& text : notes) note(file + ": " + text);
        } catch (const Error& error) {
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
    }
    std::cout.flush();
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
}

void run(const Options& options) {
    if (options.schema.empty() && options.files.empty())
        throw Error(Failure::bad_input,
                    Fault{.file = "",
                          .place = "",
                          .reason = "check: a FILE, or --schema preset|scene, is required (see lapfx help)"});
    if (!options.schema.empty()) std::cout << (options.schema == "preset" ? preset_schema() : scene_schema());
    check_files(options.files);
}

}  // namespace

Verb check_verb() {
    auto options = std::make_shared<Options>();
    Verb verb{.name = "check",
              .help = "Validate presets and scenes and open the files that they name; every fault is printed",
              .footer =
                  "Examples:\n"
                  "  lapfx check presets/gastric_banding.json samples/lagb.scene.json\n"
                  "  lapfx check --schema preset",
              .run = [options] { run(*options); }};
    verb.argument("FILE.json", "Presets and scenes", &options->files);
    verb.option("--schema", "preset|scene", "Print the JSON Schema of presets or scenes instead", &options->schema,
                {.words = {"preset", "scene"}, .excludes = {"FILE.json"}});
    return verb;
}

}  // namespace lapfx::commands
