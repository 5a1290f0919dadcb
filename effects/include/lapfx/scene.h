// A scene: what a preset is previewed on. Organ, camera, light, tool events, the reference video. It is JSON like a
// preset. The editor, `lapfx render` and the sample host read it; a simulator never needs it.
//
//     lapfx::Scene scene = lapfx::load_scene("samples/lagb.scene.json");
//
// Lengths mm, angles degrees, times s from the start of the scene, y up unless the organ is rotated. Paths
// are relative to the scene's folder (Scene::folder). Each value: lapfx-scene(5). Plain data.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "lapfx/api.h"
#include "lapfx/camera.h"
#include "lapfx/curves.h"
#include "lapfx/parameter.h"
#include "lapfx/tool.h"

namespace lapfx {

struct SceneOrgan {
    std::string file;
    double scale = 0.0;        ///< mm per unit of the file; 0 = by format: 1000 for glTF (metres), 1 for others
    glm::dvec3 rotation{0.0};  ///< degrees about x, then y, then z
    std::string texture = {};  ///< a picture in place of the organ's own base colour textures; empty: its own
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
    // How light becomes the picture: CameraResponse.
    double exposure = 1.0;
    double vignette = 1.0;
    glm::dvec3 white_balance{1.0};
    double sharpening = 0.0;
    double saturation = 1.0;
    double lens_falloff = 0.45;
    ResponseCurve curve = ResponseCurve::shoulder;
    double toe = 0.2;
    double knee = 0.6;
    double white = 3.0;

    CameraResponse response() const {
        return {.exposure = exposure,
                .vignette = vignette,
                .white_balance = white_balance,
                .sharpening = sharpening,
                .saturation = saturation,
                .lens_falloff = lens_falloff,
                .curve = curve,
                .toe = toe,
                .knee = knee,
                .white = white};
    }
    void set_response(const CameraResponse& r) {
        exposure = r.exposure, vignette = r.vignette, white_balance = r.white_balance, sharpening = r.sharpening;
        saturation = r.saturation, lens_falloff = r.lens_falloff, curve = r.curve;
        toe = r.toe, knee = r.knee, white = r.white;
    }
};

/// The endoscope's lamp, at the camera.
struct SceneLight {
    double intensity = 1.0;  ///< at 1, white at the focus distance has the value 1
    double focus_distance = 100.0;
    double beam_angle = 75.0;
    glm::dvec3 color{1.0, 0.97, 0.92};
};

/// Which pixels of the reference count as blood, its smoke removed, or, where its tissue has moved, as they are seen.
/// Redness is (red + 8) / (mean of green and blue + 8) in 8-bit sRGB code values: about 2 for liver, 3 to 15 for blood.
struct BloodQualifier {
    double redness = 2.2;     ///< least redness of blood
    double rise = 1.3;        ///< least factor of redness over the baseline's at that place, or near by
    double brightness = 0.8;  ///< largest red of blood, 0..1: what is brighter is a highlight or tissue
};

/// When something happens in the reference, s of its own time; -1 = not marked.
struct ReferenceMarks {
    double smoke_starts = -1.0;
    double smoke_peaks = -1.0;
    double smoke_clears = -1.0;
    double blood_starts = -1.0;
};

/// The part that is looked at again and again, s of the reference's time; none where both are the same.
struct ReferenceLoop {
    double from = 0.0;
    double to = 0.0;
    bool set() const { return to > from; }
};

/// Where the reference lies under the preview when both are compared: moved, then scaled and turned about its middle. A
/// plate (ScenePlate) lies there, too.
struct ReferencePlacement {
    double right = 0.0, up = 0.0;  ///< heights of the picture
    double scale = 1.0;
    double rotation = 0.0;  ///< degrees, counter-clockwise
    bool moved() const { return right != 0 || up != 0 || scale != 1 || rotation != 0; }
};

/// A place in the reference's picture: fractions of it from its upper left corner.
struct PicturePlace {
    double x = 0.0, y = 0.0;
    friend bool operator==(const PicturePlace&, const PicturePlace&) = default;
};
/// A polygon of the reference's picture that is not measured; with fewer than three corners it is nothing.
struct LeftOutPart {
    std::vector<PicturePlace> corners = {};
};
/// The rectangle of the reference's picture that is measured, fractions of it; what lies beyond the picture is nothing.
struct MeasuredRegion {
    double x = 0.0, y = 0.0, width = 1.0, height = 1.0;
};
inline constexpr std::size_t most_left_out_parts = 12, most_part_corners = 32;

/// What a person says of the pixels below a stroke; `other`: tissue, an instrument, anything that is no blood.
enum class StrokeMark { blood, other };
/// A stroke of a brush over a frame of the reference, by which this video's blood is learned. Without points it is
/// nothing.
struct BloodStroke {
    double time = 0.0;  ///< s of the reference: of the frame that is painted over
    StrokeMark marks = StrokeMark::blood;
    double radius = 0.01;  ///< of the brush, share of the picture's width
    std::vector<PicturePlace> points = {};
};
inline constexpr std::size_t most_blood_strokes = 500, most_stroke_points = 2000;
inline constexpr double most_stroke_radius = 0.25;  // of the width

/// How the reference's blood and smoke are measured. Times in s of the reference.
struct ReferenceMeasure {
    double baseline = 0.0;        ///< of a frame without smoke and blood; 0: a clear one is looked for
    double from = 0.0, to = 0.0;  ///< what is measured; to 0: up to the end
    BloodQualifier blood = {};
    MeasuredRegion region = {};
    std::vector<LeftOutPart> parts = {};
    double without_blood = -1.0;            ///< of a frame that has no blood, as a person says; -1: none is named
    std::vector<BloodStroke> strokes = {};  ///< a later one is painted over those before
};

/// A rectangle that is compared in the pictures of the reference and the preview, fractions of them; what lies beyond
/// is nothing.
struct ComparedRegion {
    double x = 0.4, y = 0.4, width = 0.2, height = 0.2;
};
inline constexpr std::size_t most_compared_regions = 8;

struct SceneReference {
    std::string file;
    double offset = 0.0;  ///< s; reference time = scene time + offset
    double aspect = 0.0;  ///< width over height when shown; 0 = as stored
    ReferenceMarks marks{};
    ReferenceLoop loop{};
    ReferencePlacement placement{};
    ReferenceMeasure measure = {};
    std::vector<ComparedRegion> regions = {};
};

/// Which frame of the reference becomes the plate.
enum class PlateFrame { clearest, chosen };
/// How far away the tissue of the plate is taken to be.
enum class PlateDepth { bowl, flat };

/// A clear frame of the reference in place of the organ, made for the scene's camera; the programs of lapfx draw it.
struct ScenePlate {
    bool use = false;
    PlateFrame frame = PlateFrame::clearest;
    double time = 0.0;  ///< s in the reference; for PlateFrame::chosen
    int frames = 1;     ///< as many are blended
    double span = 2.0;  ///< s around the frame from which they are taken
    PlateDepth depth = PlateDepth::bowl;
    double distance = 0.0;  ///< mm from the camera to its middle; 0 = to the camera's target
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
    ScenePlate plate;

    std::filesystem::path folder;  ///< where it was loaded from; not written
};

/// These work like those of presets (preset.h).
LAPFX_API const Table& scene_table();
LAPFX_API Scene parse_scene(std::string_view json, const std::string& name, const std::filesystem::path& folder = {});
LAPFX_API Scene load_scene(const std::filesystem::path& path);
LAPFX_API std::string write_scene(const Scene& scene);

}  // namespace lapfx
