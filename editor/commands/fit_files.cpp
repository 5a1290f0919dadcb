#include "commands/fit_files.h"

#include <filesystem>

#include "commands/file_kind.h"
#include "commands/options.h"
#include "commands/session.h"
#include "document/document.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/file.h"
#include "output/files.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

struct Written {
    const char* option;
    const std::string& file;
    std::string_view ending;
};

std::vector<Written> written(const FitFiles& files) {
    return {{"--output", files.output, ".json"},
            {"--fitted-scene", files.fitted_scene, ".scene.json"},
            {"--csv", files.csv, ".csv"},
            {"--report", files.report, ".html"}};
}

void check_clips(const FitFiles& files, const Preset& preset) {
    const fs::path folder = document::folder_of(files.output);
    for (const SmokeClip& clip : preset.smoke.clips) {
        try {
            (void)find_clip(clip.file, folder, clip_folders());
        } catch (const Error&) {
            throw wrong_option("--output", "\"" + files.output + "\" would not find the preset's clip \"" + clip.file +
                                               "\", which lies in " + preset.folder.string() +
                                               ": write it there, or copy the clip beside it");
        }
    }
}

}  // namespace

std::vector<fs::path> read_files(const FitFiles& files, const Scene& scene) {
    std::vector<fs::path> all = {files.scene, files.reference, files.preset};
    for (const std::string& file : {scene.organ.file, scene.organ.texture, scene.tool.file, scene.preset})
        if (!file.empty()) all.push_back(named_path(scene.folder, file, Reach::anywhere));
    std::erase_if(all, [](const fs::path& file) { return file.empty(); });
    return all;
}

void check_names(const FitFiles& files) {
    for (const auto& [option, file, ending] : written(files)) {
        if (file.empty()) continue;
        if (!file.ends_with(ending))
            throw wrong_option(option, "\"" + file + "\" does not end in " + std::string(ending));
        check_output(option, file);
    }
}

void check_files(const FitFiles& files, const ShownScene& shown) {
    check_clips(files, shown.presets.front());
}

Scene fitted_scene(const FitFiles& files, const SceneReference& reference, Scene scene) {
    const fs::path folder = document::folder_of(files.fitted_scene);
    document::move_scene(scene, folder);
    scene.preset = document::moved_path(fs::absolute(files.output).string(), {}, folder);
    scene.reference = reference;
    scene.reference.file = document::moved_path(fs::absolute(files.reference).string(), {}, folder);
    return scene;
}

}  // namespace lapfx::commands
