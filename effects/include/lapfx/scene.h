// A scene: what a preset is previewed on. Organ, camera, light, tool events, the reference video. It is JSON like a
// preset. The editor, `lapfx render` and the sample host read it; a simulator never needs it.
//
//     lapfx::Scene scene = lapfx::load_scene("samples/lagb.scene.json");
//
// Lengths mm, angles degrees, times s from the start of the scene, y up unless the organ is rotated. Paths
// are relative to the scene's folder (Scene::folder). Rows: effects/preset/scene.cpp. Plain data.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "lapfx/curves.h"
#include "lapfx/parameter.h"
#include "lapfx/tool.h"

namespace lapfx {

struct SceneOrgan {
    std::string file;
    double scale = 0.0;        ///< mm per unit of the file; 0 = by format: 1000 for glTF (metres), 1 for others
    glm::dvec3 rotation{0.0};  ///< degrees about x, then y, then z
    glm::dvec3 color{1.0};     ///< sRGB; multiplies the organ's own colours in linear light
};

/// The instrument that is drawn at the tip while an event runs; no file = none is drawn.
struct SceneTool {
    std::string file;
    double scale = 0.0;
    glm::dvec3 port{0.0, 250.0, 150.0};  ///< where the shaft enters the abdomen, mm
};

struct SceneCamera {
    glm::dvec3 eye{0.0, 0.0, 120.0};
    glm::dvec3 target{0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    double field_of_view = 60.0;  ///< vertical, degrees
    double exposure = 1.0;
    double vignette = 1.0;  ///< 0 = whole rectangle, 1 = the round picture of an endoscope
};

/// The endoscope's lamp, at the camera.
struct SceneLight {
    double intensity = 1.0;  ///< at 1, white at the focus distance has the value 1
    double focus_distance = 100.0;
    double beam_angle = 75.0;
    glm::dvec3 color{1.0, 0.97, 0.92};
};

struct SceneReference {
    std::string file;
    double offset = 0.0;  ///< s; reference time = scene time + offset
    double aspect = 0.0;  ///< width over height when shown; 0 = as stored
};

struct Scene {
    std::string name;
    std::string preset;  ///< the preset that the scene opens with
    int seed = 1;
    double duration = 12.0;
    glm::dvec3 gravity{0.0, -1.0, 0.0};  ///< direction only
    SceneOrgan organ;
    SceneTool tool;
    SceneCamera camera;
    SceneLight light;
    std::vector<ToolContact> events;  ///< what the tool does, in any order
    Curves curves;                    ///< factors over the scene's time
    SceneReference reference;

    std::filesystem::path folder;  ///< where it was loaded from; not written
};

/// These work like those of presets (preset.h).
const Table& scene_table();
Scene parse_scene(std::string_view json, const std::string& name, const std::filesystem::path& folder = {});
Scene load_scene(const std::filesystem::path& path);
std::string write_scene(const Scene& scene);

}  // namespace lapfx
