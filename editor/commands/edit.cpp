// lapfx edit: opens a window on a scene; presets, meshes and videos are shown in one.
#include <algorithm>
#include <cctype>
#include <iostream>
#include <set>

#include "commands/command.h"
#include "commands/output.h"
#include "commands/session.h"
#include "window/orbit.h"
#include "window/viewer.h"

namespace lapfx::commands {

namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool is_mesh_name(const fs::path& path) {
    static const std::set<std::string> extensions{".glb", ".gltf", ".obj", ".ply", ".stl", ".off"};
    return extensions.contains(lower_extension(path));
}

/// What the window opens with.
struct Opened {
    Scene scene;
    Preset preset;
};

void open_mesh(Opened& opened, const fs::path& file) {
    opened.scene.organ = {.file = fs::absolute(file).string()};
    opened.scene.tool = {};
    opened.scene.events.clear();
    const OrganReport organ = report(load_organ(file));
    for (const std::string& warning : organ.warnings)
        std::cerr << "lapfx: warning: " << file.string() << ": " << warning << '\n';
    const double exposure = opened.scene.camera.exposure;
    opened.scene.camera = window::frame(organ);
    opened.scene.camera.exposure = exposure;
    opened.scene.camera.vignette = 0.0;
    opened.scene.light.focus_distance = glm::distance(opened.scene.camera.eye, opened.scene.camera.target);
}

/// A smoke video becomes the plume; the haze stays.
void open_clip(Opened& opened, const fs::path& file) {
    const bool numbered = file.filename().string().find('%') != std::string::npos;  // the window tells if none is there
    if (!numbered && !fs::exists(file))
        throw Error(Failure::bad_input, Fault{.file = file.string(), .place = "", .reason = "no such file"});
    opened.preset.folder = fs::absolute(file).parent_path();
    auto& clips = opened.preset.smoke.clips;
    std::erase_if(clips, [](const SmokeClip& clip) { return clip.role == ClipRole::plume; });
    clips.insert(clips.begin(), {.file = file.filename().string()});
}

Opened open_files(const std::vector<std::string>& files) {
    Opened opened;
    opened.scene = load_scene(data_folder() / "samples" / "lagb.scene.json");
    opened.preset = preset_for(opened.scene, "", {});
    std::vector<std::string> presets, meshes, clips;
    for (const std::string& file : files) {
        if (is_mesh_name(file)) {
            meshes.push_back(file);
        } else if (lower_extension(file) != ".json") {
            clips.push_back(file);
        } else if (check_document(file).kind == "preset") {
            presets.push_back(file);
        } else {
            opened.scene = load_scene(file);
            opened.preset = preset_for(opened.scene, "", {});
        }
    }
    // In whatever order they are named: a preset goes into the scene, a mesh and a clip into both.
    for (const std::string& file : presets) opened.preset = load_preset(file);
    for (const std::string& file : meshes) open_mesh(opened, file);
    for (const std::string& file : clips) open_clip(opened, file);
    return opened;
}

void run(const std::vector<std::string>& files) {
    const Opened opened = open_files(files);
    std::cerr
        << "lapfx: left button works on the organ (1 cauterise, 2 cut, 3 coagulate, 4 tear, 5 suction, 6 irrigation);"
           " right button or empty space orbits, middle pans, wheel zooms;"
           " space plays and pauses, arrows step, R restarts, Home resets the view\n";
    window::view(opened.scene, opened.preset, clip_folders());
}

}  // namespace

void add_edit(CLI::App& app) {
    auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* verb = app.add_subcommand("edit", "Open a window on a scene; the sample scene if no file is given");
    verb->add_option("FILE", *files,
                     "A scene or preset (.json), an organ (.glb, .gltf, .obj, .ply, .stl, .off), a smoke video or "
                     "image, numbered images (smoke_%04d.png)");
    verb->callback([files] { run(*files); });
    // `lapfx` alone opens the sample scene.
    app.callback([&app] {
        if (app.get_subcommands().empty()) run({});
    });
}

}  // namespace lapfx::commands
