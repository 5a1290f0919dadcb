// lapfx edit: opens a window on a scene; presets, meshes and videos are shown in one.
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

bool is_mesh_name(const fs::path& path) {
    static const std::set<std::string> extensions{".glb", ".gltf", ".obj", ".ply", ".stl", ".off"};
    return extensions.contains(path.extension().string());
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
    opened.scene.camera = window::frame(report(load_organ(file)));
    opened.scene.camera.vignette = 0.0;
    opened.scene.light.focus_distance = glm::distance(opened.scene.camera.eye, opened.scene.camera.target);
}

/// A smoke video becomes the plume.
void open_clip(Opened& opened, const fs::path& file) {
    opened.preset.folder = fs::absolute(file).parent_path();
    opened.preset.smoke.clips = {{.file = file.filename().string()}};
}

Opened open_files(const std::vector<std::string>& files) {
    Opened opened;
    opened.scene = load_scene(data_folder() / "samples" / "lagb.scene.json");
    opened.preset = preset_for(opened.scene, "", {});
    for (const std::string& file : files) {
        if (is_mesh_name(file)) {
            open_mesh(opened, file);
        } else if (fs::path(file).extension() != ".json") {
            open_clip(opened, file);
        } else if (check_document(file).kind == "scene") {
            opened.scene = load_scene(file);
            opened.preset = preset_for(opened.scene, "", {});
        } else {
            opened.preset = load_preset(file);
        }
    }
    return opened;
}

void run(const std::vector<std::string>& files) {
    const Opened opened = open_files(files);
    std::cerr
        << "lapfx: left button cauterises the organ; right button or empty space orbits, middle pans, wheel zooms;"
           " space plays and pauses, arrows step, R restarts, Home resets the view\n";
    window::view(opened.scene, opened.preset, clip_folders());
}

}  // namespace

void add_edit(CLI::App& app) {
    auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* verb = app.add_subcommand("edit", "Open a window on a scene; the sample scene if no file is given");
    verb->add_option("FILE", *files,
                     "A scene or preset (.json), an organ (.glb, .gltf, .obj, .ply, .stl, .off), a smoke video");
    verb->callback([files] { run(*files); });
    // `lapfx` alone opens the sample scene.
    app.callback([&app] {
        if (app.get_subcommands().empty()) run({});
    });
}

}  // namespace lapfx::commands
