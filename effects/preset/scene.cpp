// The rows of a scene. A scene is for previews only, so the ranges are wide: they catch slips, not taste.
#include "lapfx/scene.h"

#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/preset.h"
#include "preset/document.h"
#include "preset/tables.h"
#include "preset/text.h"

namespace lapfx {

namespace preset {

const Format scene_format{
    .format = "lapfx.scene",
    .version = 1,
    .title = "lapfx scene",
    .help =
        "What a preset is previewed on. Lengths in mm, angles in degrees, times in s from the start of the "
        "scene; files "
        "relative to the scene.",
    .table = scene_table,
};

namespace {

constexpr Range place{-10'000, 10'000, 1, "mm"};
constexpr Range direction{-1'000, 1'000, 0.1};
constexpr Range file_scale{0, 1e6, 0.1, "mm per unit of the file"};
constexpr Range event_time{0, 3600, 0.1, "s"};
constexpr std::string_view scale_help =
    "Size of one unit of the file. 0 follows the format: glTF is in metres, others in mm.";

constexpr Parameter organ_rows[] = {
    again(redo::organ | redo::amounts,
          required(path<&SceneOrgan::file>("file", "File",
                                           "The organ's surface: a mesh; `lapfx help files` lists the formats."))),
    again(redo::organ | redo::amounts, number<&SceneOrgan::scale>("scale", "Scale", file_scale, scale_help)),
    again(redo::organ | redo::amounts,
          vector<&SceneOrgan::rotation>("rotation", "Rotation", {-360, 360, 1, "degrees"},
                                        "Turns about the x, then the y, then the z axis.")),
    again(redo::organ | redo::amounts,
          path<&SceneOrgan::texture>("texture", "Texture",
                                     "A picture in place of the organ's own base colour textures, laid over it by its "
                                     "texture coordinates; empty: its own. Vessels and fat are looked for in it.")),
    color<&SceneOrgan::color>("color", "Colour",
                              "Multiplies the organ's own colours; white leaves them as they are. For an organ without "
                              "a texture it is the colour of the tissue. It does not change where the organ bleeds."),
};

constexpr Parameter tool_rows[] = {
    again(redo::organ,
          path<&SceneTool::file>("file", "File", "The instrument, its tip at the origin; empty draws none.")),
    again(redo::organ, number<&SceneTool::scale>("scale", "Scale", file_scale, scale_help)),
    vector<&SceneTool::port>("port", "Port", place, "Where the shaft enters the abdomen."),
};

using C = SceneCamera;
constexpr Parameter camera_rows[] = {
    vector<&C::eye>("eye", "Eye", place, "Where the endoscope's tip is."),
    vector<&C::target>("target", "Target", place, "What it looks at."),
    vector<&C::up>("up", "Up", direction, "The direction that is up in the picture; its length does not matter."),
    number<&C::field_of_view>("field_of_view", "Field of view", {5, 150, 1, "degrees"}, "Vertical angle of view."),
    number<&C::exposure>("exposure", "Exposure", {0.01, 100, 0.05, "", Scale::logarithmic},
                         "Brightness of the whole picture, as a factor on its light."),
    number<&C::vignette>("vignette", "Vignette", {0, 1, 0.01},
                         "0 shows the whole rectangle, 1 the round picture of an endoscope."),
    vector<&C::white_balance>("white_balance", "White balance", {0.2, 5, 0.01},
                              "Factors on red, green and blue light; 1.03, 0.96, 1.08 bring the sample to the tint of "
                              "clear frames of real operations."),
    number<&C::sharpening>(
        "sharpening", "Sharpening", {0, 2, 0.05},
        "Factor by which details of 1/340 of the height gain contrast, at edges only up to a bound. "
        "Endoscope processors do so: 0.9 brings a render to the gradients of real clips; 0 is none."),
    number<&C::saturation>("saturation", "Saturation", {0, 2, 0.01},
                           "0 is grey, 1 leaves colours as they are. A film curve saturates; 0.85 beside it is as real "
                           "clips are."),
    number<&C::lens_falloff>("lens_falloff", "Lens fall-off", {0, 1, 0.01},
                             "Share of the light that is missing at the rim of the round view. Real lenses: about "
                             "0.15."),
    choice<&C::curve>("curve", "Curve", response_curves,
                      "How light becomes the picture's. shoulder: as it is up to 0.7, then ever slower towards white; "
                      "film: as toe, knee and white say, as cameras do."),
    number<&C::toe>("toe", "Toe", {0, 1, 0.01}, "Of film: how far darks are darkened; 0 leaves them as they are."),
    number<&C::knee>("knee", "Knee", {0.1, 0.95, 0.01}, "Of film: from which light on lights are compressed."),
    number<&C::white>("white", "White", {1.05, 20, 0.1, "", Scale::logarithmic},
                      "Of film: the least light that is shown as white."),
};

std::string check_target(const void* owner) {
    const C& camera = *static_cast<const C*>(owner);
    return camera.eye == camera.target ? "the same as eye: the camera looks nowhere" : "";
}

std::string check_up(const void* owner) {
    const C& camera = *static_cast<const C*>(owner);
    const glm::dvec3 view = camera.target - camera.eye;
    if (view == glm::dvec3(0)) return {};  // the target is blamed for that
    // As a sine, so that neither length matters; a zero vector counts as parallel.
    const double sine_length = glm::length(glm::cross(view, camera.up));
    return sine_length <= 1e-6 * glm::length(view) * glm::length(camera.up) ? "zero or along the view" : "";
}

constexpr Rule camera_rules[] = {{"target", check_target}, {"up", check_up}};

constexpr Parameter light_rows[] = {
    number<&SceneLight::intensity>("intensity", "Intensity", {0, 100, 0.05},
                                   "Brightness of the lamp; 1 shows white at the focus distance as full white."),
    number<&SceneLight::focus_distance>("focus_distance", "Focus distance", {1, 2000, 1, "mm"},
                                        "Distance from the lamp at which the intensity is as set."),
    number<&SceneLight::beam_angle>("beam_angle", "Beam angle", {1, 180, 1, "degrees"}, "Full angle of the beam."),
    color<&SceneLight::color>("color", "Colour", "Colour of the lamp."),
};

using E = ToolContact;
constexpr Parameter event_rows[] = {
    choice<&E::action>("action", "Action", keys_of<tool_actions>,
                       text_of<[](const auto& put) { put_rows(put, tool_actions); }>),
    number<&E::time>("time", "Time", event_time, "When the tool touches the organ."),
    number<&E::duration>("duration", "Duration", event_time, "How long it touches the organ."),
    required(vector<&E::position>("position", "Position", place, "Where it touches.")),
    same_as("position", vector<&E::to>("to", "To", place, "Where it is at the end.")),
    number<&E::power>("power", "Power", {0, 1, 0.01}, "Cautery power."),
    number<&E::strength>("strength", "Strength", {0, 10, 0.05},
                         "Strength of the wound: a factor on the preset's speed."),
};

constexpr Parameter curve_time = required(number<&CurvePoint::time>(
    "time", "Time", event_time, "When the factor has this value; later than the point before."));
constexpr Parameter power_rows[] = {
    curve_time,
    number<&CurvePoint::value>("value", "Value", {0, 1, 0.01},
                               "Factor on the cautery power of events; 1 leaves it unchanged."),
};
constexpr Parameter strength_rows[] = {
    curve_time,
    number<&CurvePoint::value>("value", "Value", {0, 4, 0.01},
                               "Factor on the speed at which blood spreads; 0 stops it."),
};
constexpr Parameter emission_rows[] = {
    curve_time,
    number<&CurvePoint::value>("value", "Value", {0, 4, 0.01}, "Factor on the smoke that heat makes, plume and haze."),
};

constexpr OrderRule ascending{"time", [](const void* before, const void* point) -> std::string {
                                  const double first = static_cast<const CurvePoint*>(before)->time;
                                  const double then = static_cast<const CurvePoint*>(point)->time;
                                  if (then > first) return "";
                                  return number_text(then) + " s is not after " + number_text(first) +
                                         " s, the time of the point before";
                              }};

constexpr std::size_t most_curve_points = 256;

constexpr Table curve_tables[] = {
    ordered(ascending, list<&Curves::cautery_power, most_curve_points>(
                           "cautery_power", "Cautery power",
                           "Factor on the cautery power of events over time; heat and smoke follow it. Straight lines "
                           "between points; without points it is 1 all the time.",
                           {power_rows})),
    ordered(ascending, list<&Curves::bleeding_strength, most_curve_points>(
                           "bleeding_strength", "Bleeding strength",
                           "Factor on the speed at which the blood of open wounds spreads, over time. Straight lines "
                           "between points; without points it is 1 all the time.",
                           {strength_rows})),
    ordered(ascending,
            list<&Curves::emission, most_curve_points>("emission", "Emission",
                                                       "Factor on the smoke that heat makes, over time. Straight lines "
                                                       "between points; without points it is 1 all the time.",
                                                       {emission_rows})),
};

constexpr Parameter reference_rows[] = {
    path<&SceneReference::file>("file", "File", "The surgery video or numbered images to match; empty for none."),
    number<&SceneReference::offset>("offset", "Offset", {-86'400, 86'400, 0.05, "s"},
                                    "Time in the reference video when the scene starts."),
    number<&SceneReference::aspect>(
        "aspect", "Aspect", {0, 10, 0.01},
        "Width over height at which the reference is shown, for videos that are stored squeezed. 0: as stored."),
};

constexpr Range mark_time{-1, 86'400, 0.04, "s"};
using M = ReferenceMarks;
constexpr Parameter mark_rows[] = {
    number<&M::smoke_starts>("smoke_starts", "Smoke starts", mark_time,
                             "When smoke begins, in the reference's time. -1: not marked."),
    number<&M::smoke_peaks>("smoke_peaks", "Smoke peaks", mark_time,
                            "When smoke is densest, in the reference's time. -1: not marked."),
    number<&M::smoke_clears>("smoke_clears", "Smoke clears", mark_time,
                             "When no smoke is left, in the reference's time. -1: not marked."),
    number<&M::blood_starts>("blood_starts", "Blood starts", mark_time,
                             "When blood begins, in the reference's time. -1: not marked."),
};

template <class Owner, double Owner::*Member>
constexpr Rule set_or_not(std::string_view key) {
    return {key, [](const void* owner) -> std::string {
                const double time = static_cast<const Owner*>(owner)->*Member;
                return time == -1 || time >= 0 ? "" : number_text(time) + " s is neither -1 nor from 0 on";
            }};
}
constexpr Rule mark_rules[] = {
    set_or_not<M, &M::smoke_starts>("smoke_starts"), set_or_not<M, &M::smoke_peaks>("smoke_peaks"),
    set_or_not<M, &M::smoke_clears>("smoke_clears"), set_or_not<M, &M::blood_starts>("blood_starts")};

constexpr Range loop_time{-86'400, 86'400, 0.04, "s"};
constexpr Parameter loop_rows[] = {
    number<&ReferenceLoop::from>("from", "From", loop_time, "Where the part begins, in the reference's time."),
    number<&ReferenceLoop::to>("to", "To", loop_time,
                               "Where it ends, in the reference's time. The same as from: no part is chosen."),
};
constexpr Rule loop_rules[] = {{"to", [](const void* owner) -> std::string {
                                    const auto& loop = *static_cast<const ReferenceLoop*>(owner);
                                    return loop.to >= loop.from ? ""
                                                                : number_text(loop.to) + " s is before " +
                                                                      number_text(loop.from) + " s, where it begins";
                                }}};

using RP = ReferencePlacement;
constexpr Parameter placement_rows[] = {
    number<&RP::right>("right", "Right", {-2, 2, 0.005, "of the height"}, "How far it is moved to the right."),
    number<&RP::up>("up", "Up", {-2, 2, 0.005, "of the height"}, "How far it is moved up."),
    number<&RP::scale>("scale", "Scale", {0.1, 10, 0.01}, "How many times as large it is shown."),
    number<&RP::rotation>("rotation", "Rotation", {-180, 180, 0.5, "deg"},
                          "How far it is turned about its middle, counter-clockwise."),
};

constexpr double least_aspect = 0.1;
constexpr Rule reference_rules[] = {{"aspect", [](const void* owner) -> std::string {
                                         const double aspect = static_cast<const SceneReference*>(owner)->aspect;
                                         if (aspect == 0 || aspect >= least_aspect) return "";
                                         return number_text(aspect) + " is neither 0 nor from 0.1 to 10";
                                     }}};

constexpr std::string_view plate_frames[] = {"clearest", "chosen"};
constexpr std::string_view plate_depths[] = {"bowl", "flat"};
constexpr unsigned other_body = redo::organ | redo::amounts;

using P = ScenePlate;
constexpr Parameter plate_rows[] = {
    again(other_body, boolean<&P::use>("use", "Use",
                                       "A frame of the reference stands in for the organ: smoke and blood are drawn "
                                       "over the same tissue that the video shows.")),
    again(other_body,
          choice<&P::frame>("frame", "Frame", plate_frames,
                            "clearest: the frame with the least smoke that is found; chosen: the one at the time.")),
    again(other_body,
          number<&P::time>("time", "Time", {0, 86'400, 0.04, "s"}, "Time in the reference video of the chosen frame.")),
    again(other_body, integer<&P::frames>("frames", "Frames", {1, 25, 1},
                                          "So many frames are blended: the median of each pixel, after the camera's "
                                          "motion is taken out, so that instruments and wisps that pass vanish.")),
    again(other_body, number<&P::span>("span", "Span", {0.1, 60, 0.1, "s"},
                                       "Length of the video around the frame from which the blended ones are taken.")),
    again(other_body, choice<&P::depth>("depth", "Depth", plate_depths,
                                        "bowl: the tissue falls away towards the rim of the round view; flat: all of "
                                        "it is equally deep.")),
    again(other_body, number<&P::distance>("distance", "Distance", {0, 1'000, 1, "mm"},
                                           "Distance of its middle from the camera. 0: that of the camera's target.")),
};

constexpr double least_plate_distance = 10;
constexpr Rule plate_rules[] = {{"distance", [](const void* owner) -> std::string {
                                     const double distance = static_cast<const P*>(owner)->distance;
                                     if (distance == 0 || distance >= least_plate_distance) return "";
                                     return number_text(distance) + " mm is neither 0 nor from 10 to 1000 mm";
                                 }}};

constexpr double longest_video = 86'400;
using RM = ReferenceMeasure;
constexpr Parameter measure_rows[] = {
    number<&RM::baseline>("baseline", "Baseline", {0, longest_video, 0.05, "s"},
                          "Time of a frame of the reference without smoke and blood, which all others are compared "
                          "with. 0: the earliest frame that is nearly as clear as the clearest is looked for."),
    number<&RM::from>("from", "From", {0, longest_video, 0.05, "s"}, "Time in the reference where measuring starts."),
    number<&RM::to>("to", "To", {0, longest_video, 0.05, "s"},
                    "Time in the reference where measuring ends; 0 goes on to its end."),
    number<&RM::without_blood>("without_blood", "Without blood", {-1, longest_video, 0.05, "s"},
                               "Time of a frame of the reference that has no blood, for strokes to learn from; -1: "
                               "the baseline's frame, where the strokes agree with it."),
};
constexpr Rule measure_rules[] = {{"to",
                                   [](const void* owner) -> std::string {
                                       const RM& measure = *static_cast<const RM*>(owner);
                                       if (measure.to == 0 || measure.to > measure.from) return "";
                                       return number_text(measure.to) + " s is neither 0 nor after from, " +
                                              number_text(measure.from) + " s";
                                   }},
                                  set_or_not<RM, &RM::without_blood>("without_blood")};

using Q = BloodQualifier;
constexpr Parameter blood_rows[] = {
    number<&Q::redness>("redness", "Redness", {1, 20, 0.05, "", Scale::logarithmic},
                        "Least redness of blood: red over the mean of green and blue. About 2 is liver, 3 to 15 is "
                        "blood. Higher finds less blood. Thin blood counts too, from 0.7 of this."),
    number<&Q::rise>(
        "rise", "Rise", {1, 5, 0.02, "", Scale::logarithmic},
        "Least factor by which a place became redder than in the baseline. 1 also counts what was as red "
        "before; higher finds less blood. Of thin blood 0.15 of what is above 1 is asked. Where the tissue has "
        "moved, 0.75 of it is asked over the reddest tissue near by."),
    number<&Q::brightness>("brightness", "Brightness", {0.05, 1, 0.01},
                           "Largest red of blood: what is brighter is a highlight or tissue. Lower finds less blood. "
                           "Where the tissue of the baseline is in its place, and brighter than 0.8 itself, as many "
                           "times more."),
};

constexpr Range part_of_picture{0, 1, 0.005, "of the picture"};
constexpr Range stroke_radius{0, most_stroke_radius, 0.001, "of the width"};
using MR = MeasuredRegion;
constexpr Parameter region_rows[] = {
    number<&MR::x>("x", "X", {0, 0.95, 0.005, "of the picture"}, "The region's left edge."),
    number<&MR::y>("y", "Y", {0, 0.95, 0.005, "of the picture"}, "The region's upper edge."),
    number<&MR::width>("width", "Width", {0.05, 1, 0.005, "of the picture"}, "The region's width."),
    number<&MR::height>("height", "Height", {0.05, 1, 0.005, "of the picture"}, "The region's height."),
};

constexpr Parameter place_rows[] = {
    number<&PicturePlace::x>("x", "X", part_of_picture, "Where it is, from the left edge."),
    number<&PicturePlace::y>("y", "Y", part_of_picture, "Where it is, from the upper edge."),
};
constexpr Table part_tables[] = {
    list<&LeftOutPart::corners, most_part_corners>("corners", "Corners", "The polygon's corners, three or more.",
                                                   {place_rows}),
};

using BS = BloodStroke;
constexpr std::string_view stroke_marks[] = {"blood", "other"};
constexpr Parameter stroke_rows[] = {
    number<&BS::time>("time", "Time", {0, longest_video, 0.04, "s"},
                      "Time in the reference of the frame that is painted over."),
    choice<&BS::marks>("marks", "Marks", stroke_marks,
                       "blood: what is below the stroke is blood; other: it is tissue or anything else."),
    number<&BS::radius>("radius", "Radius", stroke_radius,
                        "Radius of the brush; the thinnest has the pixel below each point."),
};
constexpr Table stroke_tables[] = {
    list<&BS::points, most_stroke_points>("points", "Points", "Where the brush went: a line from point to point.",
                                          {place_rows}),
};

constexpr Table measure_tables[] = {
    table<&RM::blood>("blood", "Blood", "Which pixels of the reference count as blood, once smoke is taken away.",
                      {blood_rows}),
    table<&RM::region>("region", "Region", "The rectangle of the reference's picture that is measured.", {region_rows}),
    list<&RM::parts, most_left_out_parts>(
        "parts", "Parts", "Polygons of the reference's picture that are not measured, such as a logo or an instrument.",
        {{}, part_tables}),
    list<&RM::strokes, most_blood_strokes>(
        "strokes", "Strokes",
        "Strokes of a brush that say what is blood in the reference and what is not. With one of blood, all blood in "
        "view is measured, not only what is new since the baseline.",
        {stroke_rows, stroke_tables}),
};

using CR = ComparedRegion;
constexpr Parameter compared_rows[] = {
    number<&CR::x>("x", "X", {0, 0.99, 0.005, "of the picture"}, "The region's left edge."),
    number<&CR::y>("y", "Y", {0, 0.99, 0.005, "of the picture"}, "The region's upper edge."),
    number<&CR::width>("width", "Width", {0.01, 1, 0.005, "of the picture"}, "The region's width."),
    number<&CR::height>("height", "Height", {0.01, 1, 0.005, "of the picture"}, "The region's height."),
};

constexpr Table reference_tables[] = {
    table<&SceneReference::marks>("marks", "Marks", "What happens in the reference, and when.",
                                  {mark_rows, {}, mark_rules}),
    table<&SceneReference::loop>("loop", "Loop", "The part of the reference that is played again and again.",
                                 {loop_rows, {}, loop_rules}),
    table<&SceneReference::placement>(
        "placement", "Placement",
        "Where the reference lies under the preview when both are compared, and where a plate of it lies.",
        {placement_rows}),
    table<&SceneReference::measure>("measure", "Measure", "How the reference's blood and smoke are measured.",
                                    {measure_rows, measure_tables, measure_rules}),
    list<&SceneReference::regions, most_compared_regions>(
        "regions", "Regions", "Rectangles of the picture that are compared in the reference and the preview.",
        {compared_rows}),
};

constexpr Parameter scene_rows[] = {
    text<&Scene::name>("name", "Name", 100, "What the scene is called in lists."),
    path<&Scene::preset>("preset", "Preset", "The preset that the scene opens with; empty for the default values."),
    integer<&Scene::seed>("seed", "Seed", {0, 2'147'483'647, 1},
                          "Start of all random choices; the same seed gives the same picture."),
    again(redo::amounts,
          number<&Scene::duration>("duration", "Duration", {0.1, 3600, 0.5, "s"}, "Length of the scene.")),
    again(redo::amounts, vector<&Scene::gravity>("gravity", "Gravity", direction,
                                                 "The direction in which blood runs; its length does not matter.")),
};

constexpr Rule scene_rules[] = {{"gravity", [](const void* owner) -> std::string {
                                     const glm::dvec3& gravity = static_cast<const Scene*>(owner)->gravity;
                                     return glm::length(gravity) > 1e-6 ? "" : "zero: it has no direction";
                                 }}};

constexpr std::size_t most_events = 4096;

constexpr Table scene_tables[] = {
    table<&Scene::organ>("organ", "Organ", "The surface that bleeds.", {organ_rows}),
    table<&Scene::tool>("tool", "Tool", "The instrument that is drawn while an event runs.", {tool_rows}),
    table<&Scene::camera>("camera", "Camera", "The endoscope.", {camera_rows, {}, camera_rules}),
    table<&Scene::light>("light", "Light", "The endoscope's lamp, at the camera.", {light_rows}),
    again(redo::amounts,
          list<&Scene::events, most_events>(
              "events", "Events",
              "What the tool does, in any order. The heat of several tools at one place adds; nothing cold undoes a "
              "burn; a wound is there once.",
              {event_rows})),
    again(redo::amounts,
          table<&Scene::curves>("curves", "Curves", "Factors over the scene's time.", {{}, curve_tables})),
    table<&Scene::reference>("reference", "Reference", "The surgery video to match.",
                             {reference_rows, reference_tables, reference_rules}),
    table<&Scene::plate>("plate", "Plate", "A clear frame of the reference in place of the organ.",
                         {plate_rows, {}, plate_rules}),
};

}  // namespace

}  // namespace preset

const Table& scene_table() {
    static constexpr Table root{.key = "",
                                .name = "Scene",
                                .help = "What a preset is previewed on.",
                                .rows = preset::scene_rows,
                                .tables = preset::scene_tables,
                                .rules = preset::scene_rules};
    return root;
}

Scene parse_scene(std::string_view json, const std::string& name, const std::filesystem::path& folder) {
    Scene made;
    preset::read_document(preset::scene_format, preset::parse_json(json, name), name, &made);
    made.folder = folder;
    return made;
}

Scene load_scene(const std::filesystem::path& path) {
    note_read(path);
    Scene scene = parse_scene(read_file(path, preset::longest_document), path.string(), path.parent_path());
    // Not all of them are opened by whoever shows the scene, and yet they are what it needs.
    for (const std::string& file :
         {scene.organ.file, scene.organ.texture, scene.tool.file, scene.preset, scene.reference.file})
        if (!file.empty()) note_read(scene.folder / file);
    return scene;
}

std::string write_scene(const Scene& scene) {
    return preset::write_document(preset::scene_format, &scene);
}

void save_scene(const Scene& scene, const std::filesystem::path& path) {
    preset::save_document(preset::scene_format, &scene, path);
}

std::string scene_schema() {
    Scene defaults;
    return preset::write_schema(preset::scene_format, &defaults);
}

CheckedDocument check_document(const std::filesystem::path& path) {
    const std::string name = path.string();
    const preset::Json json = preset::parse_json(read_file(path, preset::longest_document), name);
    const preset::Json* format = json.find("format");
    if (format && format->text == preset::scene_format.format) {
        Scene scene;
        preset::read_document(preset::scene_format, json, name, &scene);
        return {"scene", scene.name};
    }
    if (format && format->text == preset::preset_format.format) {
        Preset made;
        preset::read_document(preset::preset_format, json, name, &made);
        return {"preset", made.name};
    }
    const std::string found = json.type != preset::Json::Type::object ? json.shown() + " in place of an object"
                              : format                                ? format->shown() + " is not known"
                                                                      : "missing";
    throw Error(Failure::bad_input, Fault{name, json.type == preset::Json::Type::object ? "/format" : "",
                                          found + "; expected \"lapfx.preset\" or \"lapfx.scene\""});
}

}  // namespace lapfx
