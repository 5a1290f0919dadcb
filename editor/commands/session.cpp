#include "commands/session.h"

#include <cstdlib>

#include "lapfx/authoring/file.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

fs::path program_folder() {
    std::error_code code;
    return fs::read_symlink("/proc/self/exe", code).parent_path();
}

/// Empty if there is none. Throws Error (bad_input) if LAPFX_DATA names what is not a folder.
fs::path find_data_folder() {
    std::error_code code;
    if (const char* told = std::getenv("LAPFX_DATA"); told != nullptr && *told != '\0') {
        fs::path folder = fs::canonical(told, code);
        if (code || !fs::is_directory(folder, code))
            throw Error(Failure::bad_input, Fault{.file = told, .place = "LAPFX_DATA", .reason = "is not a folder"});
        return folder;
    }
    for (const char* beside : {"../share/lapfx", "share/lapfx"})
        if (fs::path folder = fs::canonical(program_folder() / beside, code); !code && fs::is_directory(folder, code))
            return folder;
    return {};
}

const fs::path& found_data_folder() {
    static const fs::path folder = find_data_folder();
    return folder;
}

}  // namespace

fs::path data_folder() {
    if (found_data_folder().empty())
        throw Error(Failure::bad_input,
                    Fault{.file = "share/lapfx",
                          .place = "",
                          .reason = "there is no such folder beside the program, so the presets and samples that come "
                                    "with it are not found; set LAPFX_DATA to their folder"});
    return found_data_folder();
}

std::vector<fs::path> clip_folders() {
    // Where there are none, a clip that is missing is told with the place where it would have been found.
    const fs::path& found = found_data_folder();
    return {(found.empty() ? program_folder() / "share/lapfx" : found) / "samples" / "clips"};
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
