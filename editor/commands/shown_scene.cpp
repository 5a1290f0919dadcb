#include "commands/shown_scene.h"

#include <algorithm>

#include "commands/session.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/formats.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

void require_exists(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error))
        throw Error(Failure::bad_input, Fault{.file = "", .place = "", .reason = "no such file"});
}

/// Calls `work` and keeps the faults of the input that it throws, each once: a wrong setting is wrong for every preset.
template <typename Work>
void gather(std::vector<Fault>& faults, const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        if (error.failure() != Failure::bad_input) throw;
        for (const Fault& fault : error.faults())
            if (std::none_of(faults.begin(), faults.end(), [&](const Fault& f) { return f.text() == fault.text(); }))
                faults.push_back(fault);
    }
}

}  // namespace

fs::path SceneFiles::path_of(const std::string& file) const {
    return named_path(scene_.folder, file, Reach::anywhere);
}

void SceneFiles::add(const std::string& place, const std::string& file, const Error& error) {
    for (const Fault& fault : error.faults()) {
        const std::string inner = fault.place.empty() ? "" : fault.place + ": ";
        faults_.push_back({.file = name_, .place = place, .reason = '"' + file + "\": " + inner + fault.reason});
    }
}

ShownScene open_shown(const std::string& scene, const std::vector<std::string>& presets,
                      const std::vector<std::string>& settings) {
    if (is_named_as(Content::video, scene))
        throw Error(
            Failure::bad_input,
            Fault{.file = scene, .place = "", .reason = "is named as a video; a scene (.scene.json) is needed here"});
    ShownScene shown{.scene = load_scene(scene), .presets = {}, .clips = std::make_shared<ClipCache>()};
    SceneFiles files(shown.scene, scene);
    files.open("/organ/file", shown.scene.organ.file, require_exists);
    files.open("/organ/texture", shown.scene.organ.texture, require_exists);
    files.open("/tool/file", shown.scene.tool.file, require_exists);
    std::vector<Fault> faults;
    const auto take = [&](const std::string& given, const std::string& name) {
        gather(faults, [&] {
            const Preset& preset = shown.presets.emplace_back(preset_for(shown.scene, given, settings));
            check_clips(preset, name, clip_folders(), shown.clips.get());
        });
    };
    bool there = true;
    if (presets.empty())
        files.open("/preset", shown.scene.preset, [&](const fs::path& file) {
            there = false;
            require_exists(file);
            there = true;
        });
    faults = files.take();
    if (presets.empty() && there)
        take("", shown.scene.preset.empty() ? scene : (shown.scene.folder / shown.scene.preset).string());
    for (const std::string& preset : presets) take(preset, preset);
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    return shown;
}

}  // namespace lapfx::commands
