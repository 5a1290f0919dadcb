#include "commands/session.h"

#include "lapfx/authoring/file.h"

namespace lapfx::commands {

std::filesystem::path data_folder() {
    return LAPFX_DATA_DIR;
}

std::vector<std::filesystem::path> clip_folders() {
    return {data_folder() / "samples" / "clips"};
}

Preset preset_for(const Scene& scene, const std::string& preset, const std::vector<std::string>& settings) {
    Preset result;
    if (!preset.empty())
        result = load_preset(preset);
    else if (!scene.preset.empty())
        result = load_preset(named_path(scene.folder, scene.preset, Reach::anywhere, "", "/preset"));
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos)
            throw Error(Failure::bad_input,
                        Fault{.file = "", .place = "--set", .reason = "\"" + setting + "\" is not KEY=VALUE"});
        set_parameter(preset_table(), &result, setting.substr(0, equals), setting.substr(equals + 1));
    }
    // Rules between values are checked for all settings together, not after each one.
    if (std::vector<Fault> faults = check(preset_table(), &result); !faults.empty())
        throw Error(Failure::bad_input, std::move(faults));
    return result;
}

}  // namespace lapfx::commands
