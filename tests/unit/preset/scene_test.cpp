#include "lapfx/scene.h"
#include "lapfx/authoring/documents.h"

#include <gmock/gmock.h>

#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

using test::scene_faults;
using test::scene_text;
using testing::ElementsAre;

const std::string organ = R"(, "organ": {"file": "o.ply"})";

TEST(Scene, OrganAloneIsEnough) {
    const Scene scene = parse_scene(scene_text(), "s.json", "here");
    EXPECT_EQ(scene.organ.file, "o.ply");
    EXPECT_EQ(scene.duration, 12.0);
    EXPECT_EQ(scene.camera.field_of_view, 60.0);
    EXPECT_EQ(scene.folder, "here");
    EXPECT_TRUE(scene.events.empty());
}

TEST(Scene, OrganFileIsRequired) {
    const std::string fault = "s.json: /organ/file: missing; expected the name of a local file";
    EXPECT_THAT(scene_faults(scene_text("")), ElementsAre(fault));
    EXPECT_THAT(scene_faults(scene_text(R"(, "organ": {})")), ElementsAre(fault));
    EXPECT_THAT(scene_faults(scene_text(R"(, "organ": {"file": ""})")),
                ElementsAre("s.json: /organ/file: empty; expected the name of a local file"));
}

TEST(Scene, EventStaysAtItsPositionUnlessToIsGiven) {
    const Scene scene = parse_scene(scene_text(organ + R"(, "events": [
        {"position": [1, 2, 3]},
        {"position": [1, 2, 3], "to": [4, 5, 6], "action": "tear", "time": 9},
        {"position": [7, 8, 9], "time": 2}])"),
                                    "s.json");
    ASSERT_EQ(scene.events.size(), 3u);
    EXPECT_EQ(scene.events[0].to, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.events[1].to, glm::dvec3(4, 5, 6));
    EXPECT_EQ(scene.events[1].action, ToolAction::tear);
    EXPECT_EQ(scene.events[2].time, 2.0) << "the order of the file is kept";
}

TEST(Scene, EventPositionIsRequired) {
    EXPECT_THAT(scene_faults(scene_text(organ + R"(, "events": [{"time": 1}])")),
                ElementsAre("s.json: /events/0/position: missing; expected [x, y, z], each -10000 to 10000 mm"));
}

TEST(Scene, TheReferenceIsMeasuredAsItSays) {
    const Scene plain = parse_scene(scene_text(), "s.json");
    EXPECT_EQ(plain.reference.measure.baseline, 0.0) << "looked for";
    const Scene scene = parse_scene(scene_text(organ + R"(, "reference": {"file": "v.mp4", "measure": {
        "baseline": 2.5, "from": 1, "to": 9, "blood": {"redness": 3}, "region": {"x": 0.5, "width": 0.25},
        "parts": [{"corners": [{"x": 0, "y": 0}, {"x": 0.5, "y": 0}, {"x": 0, "y": 1}]}],
        "without_blood": 0.5, "strokes": [{"time": 2, "marks": "other", "points": [{"x": 0.25, "y": 1}]}, {}]}})"),
                                    "s.json");
    const ReferenceMeasure& measure = scene.reference.measure;
    EXPECT_EQ(measure.baseline, 2.5);
    EXPECT_EQ(measure.to, 9.0);
    EXPECT_EQ(measure.blood.redness, 3.0);
    EXPECT_EQ(measure.blood.rise, BloodQualifier{}.rise);
    EXPECT_EQ(measure.region.width, 0.25);
    EXPECT_EQ(measure.region.height, 1.0);
    ASSERT_EQ(measure.parts.size(), 1U);
    ASSERT_EQ(measure.parts[0].corners.size(), 3U);
    EXPECT_EQ(measure.parts[0].corners[1].x, 0.5);
    EXPECT_EQ(measure.without_blood, 0.5);
    ASSERT_EQ(measure.strokes.size(), 2U);
    EXPECT_EQ(measure.strokes[0].time, 2.0);
    EXPECT_EQ(measure.strokes[0].marks, StrokeMark::other);
    EXPECT_EQ(measure.strokes[0].points, (std::vector<PicturePlace>{{0.25, 1.0}}));
    EXPECT_EQ(measure.strokes[1].marks, StrokeMark::blood);
    EXPECT_EQ(write_scene(parse_scene(write_scene(scene), "s.json")), write_scene(scene));
}

TEST(Scene, NamesFaults) {
    struct Bad {
        const char* members;
        const char* fault;
    };
    const Bad cases[] = {
        {R"(, "camera": {"eye": [0, 0, 0]})", "/camera/target: the same as eye: the camera looks nowhere"},
        {R"(, "camera": {"up": [0, 0, -2]})", "/camera/up: zero or along the view"},
        {R"(, "camera": {"up": [0, 0, 0]})", "/camera/up: zero or along the view"},
        {R"(, "camera": {"eye": [0, 99999, 0]})",
         "/camera/eye: y = 99999 is above the maximum 10000 mm (allowed: -10000 to 10000 mm)"},
        {R"(, "reference": {"aspect": 0.05})", "/reference/aspect: 0.05 is neither 0 nor from 0.1 to 10"},
        {R"(, "reference": {"aspect": 11})", "/reference/aspect: 11 is above the maximum 10 (allowed: 0 to 10)"},
        {R"(, "plate": {"distance": 3})", "/plate/distance: 3 mm is neither 0 nor from 10 to 1000 mm"},
        {R"(, "plate": {"frames": 0})", "/plate/frames: 0 is below the minimum 1 (allowed: 1 to 25)"},
        {R"(, "plate": {"time": -1})", "/plate/time: -1 is below the minimum 0 s (allowed: 0 to 86400 s)"},
        {R"(, "plate": {"frame": "best"})",
         "/plate/frame: \"best\" is not one of \"clearest\", \"chosen\"; nearest is \"clearest\""},
        {R"(, "reference": {"marks": {"smoke_peaks": -0.5}})",
         "/reference/marks/smoke_peaks: -0.5 s is neither -1 nor from 0 on"},
        {R"(, "reference": {"marks": {"smoke": 2}})",
         "/reference/marks/smoke: unknown key; nearest is \"smoke_peaks\""},
        {R"(, "reference": {"loop": {"from": 3, "to": 2}})", "/reference/loop/to: 2 s is before 3 s, where it begins"},
        {R"(, "reference": {"placement": {"right": 2.5}})",
         "/reference/placement/right: 2.5 is above the maximum 2 of the height (allowed: -2 to 2 of the height)"},
        {R"(, "reference": {"placement": {"up": -3}})",
         "/reference/placement/up: -3 is below the minimum -2 of the height (allowed: -2 to 2 of the height)"},
        {R"(, "reference": {"placement": {"scale": 0}})",
         "/reference/placement/scale: 0 is below the minimum 0.1 (allowed: 0.1 to 10)"},
        {R"(, "reference": {"placement": {"rotation": "left"}})",
         "/reference/placement/rotation: \"left\" is not a number from -180 to 180 deg"},
        {R"(, "reference": {"placement": [0, 0]})", "/reference/placement: an array of 2 is not an object"},
        {R"(, "reference": {"placement": {"rotate": 2}})",
         "/reference/placement/rotate: unknown key; nearest is \"rotation\""},
        {R"(, "reference": {"measure": {"from": 4, "to": 3}})",
         "/reference/measure/to: 3 s is neither 0 nor after from, 4 s"},
        {R"(, "reference": {"measure": {"blood": {"redness": 0}}})",
         "/reference/measure/blood/redness: 0 is below the minimum 1 (allowed: 1 to 20)"},
        {R"(, "reference": {"measure": {"without_blood": -0.5}})",
         "/reference/measure/without_blood: -0.5 s is neither -1 nor from 0 on"},
        {R"(, "reference": {"measure": {"strokes": [{"marks": "bleeding"}]}})",
         "/reference/measure/strokes/0/marks: \"bleeding\" is not one of \"blood\", \"other\"; nearest is \"blood\""},
        {R"(, "reference": {"measure": {"strokes": [{"radius": 0.5}]}})",
         "/reference/measure/strokes/0/radius: 0.5 is above the maximum 0.25 of the width (allowed: 0 to 0.25 of the "
         "width)"},
        {R"(, "reference": {"measure": {"parts": [{"corners": [{"x": 0, "y": 2}]}]}})",
         "/reference/measure/parts/0/corners/0/y: 2 is above the maximum 1 of the picture (allowed: 0 to 1 of the "
         "picture)"},
        {R"(, "reference": {"regions": [{"x": 0.2}, {"width": 0}]})",
         "/reference/regions/1/width: 0 is below the minimum 0.01 of the picture (allowed: 0.01 to 1 of the picture)"},
        {R"(, "gravity": [0, 0, 0])", "/gravity: zero: it has no direction"},
        {R"(, "seed": -1)", "/seed: -1 is below the minimum 0 (allowed: 0 to 2147483647)"},
        {R"(, "seed": 2147483648)", "/seed: 2147483648 is not a whole number from 0 to 2147483647"},
        {R"(, "duration": 0)", "/duration: 0 is below the minimum 0.1 s (allowed: 0.1 to 3600 s)"},
        {R"(, "preset": "http://x/p.json")",
         "/preset: \"http://x/p.json\" is a URL or a protocol; expected the name of a local file"},
        {R"(, "events": [{"position": [0, 0, 0], "action": "cuts"}])",
         "/events/0/action: \"cuts\" is not one of \"cauterise\", \"cut\", \"coagulate\", \"tear\", \"suction\", "
         "\"irrigation\", \"clip\"; nearest is \"cut\""},
        {R"(, "bleeding": {})", "/bleeding: unknown key; nearest is \"seed\""},
    };
    for (const Bad& bad : cases)
        EXPECT_THAT(scene_faults(scene_text(organ + bad.members)), ElementsAre("s.json: " + std::string(bad.fault)));
}

TEST(Scene, KeepsThePlacementOfTheReference) {
    const Scene scene = parse_scene(
        scene_text(organ + R"(, "reference": {"placement": {"right": 0.25, "scale": 1.5, "rotation": -30}})"),
        "s.json");
    const ReferencePlacement& placement = scene.reference.placement;
    EXPECT_EQ(placement.right, 0.25);
    EXPECT_EQ(placement.up, 0.0) << "what the file leaves out";
    EXPECT_EQ(placement.scale, 1.5);
    EXPECT_EQ(placement.rotation, -30.0);
    EXPECT_TRUE(placement.moved());
    const Scene again = parse_scene(write_scene(scene), "s.json");
    EXPECT_EQ(again.reference.placement.rotation, -30.0);
    EXPECT_EQ(again.reference.placement.scale, 1.5);
    EXPECT_EQ(write_scene(again), write_scene(scene));
    EXPECT_FALSE(ReferencePlacement{}.moved());
}

TEST(Scene, PathsMayLeaveTheFolder) {
    const Scene scene =
        parse_scene(scene_text(
                        R"(, "organ": {"file": "../organs/o.glb"}, "preset": "../presets/p.json", "tool": {"file": ""},
                      "reference": {"file": "/data/%04d.png"})"),
                    "s.json");
    EXPECT_EQ(scene.preset, "../presets/p.json");
    EXPECT_EQ(scene.reference.file, "/data/%04d.png");
}

TEST(Scene, EventsHaveALimit) {
    std::string events;
    for (int i = 0; i < 4097; ++i) events += (i ? "," : "") + std::string(R"({"position":[0,0,0]})");
    EXPECT_THAT(scene_faults(scene_text(organ + R"(, "events": [)" + events + "]")),
                ElementsAre("s.json: /events: 4097 elements; at most 4096 are allowed"));
}

TEST(Scene, SavesAndLoads) {
    const test::Folder folder;
    const Scene scene = test::full_scene();
    save_scene(scene, folder / "s.json");
    EXPECT_EQ(write_scene(load_scene(folder / "s.json")), write_scene(scene));
    EXPECT_THAT(test::faults_of([&] { save_scene(Scene{}, folder / "x.json"); }),
                ElementsAre((folder / "x.json").string() + ": /organ/file: empty; expected the name of a local file"));
    EXPECT_FALSE(std::filesystem::exists(folder / "x.json"));
}

TEST(CheckDocument, TellsPresetsFromScenes) {
    const test::Folder folder;
    const CheckedDocument preset = check_document(folder.write("p", test::preset_text(R"(, "name": "N")")));
    EXPECT_EQ(preset.kind, "preset");
    EXPECT_EQ(preset.name, "N");
    EXPECT_EQ(check_document(folder.write("s", scene_text())).kind, "scene");
    const auto faults = [&](const std::string& text) {
        return test::faults_of([&] { check_document(folder.write("x", text)); });
    };
    const std::string file = (folder / "x").string();
    EXPECT_THAT(faults("{}"), ElementsAre(file + ": /format: missing; expected \"lapfx.preset\" or \"lapfx.scene\""));
    EXPECT_THAT(faults(R"({"format": "gltf"})"),
                ElementsAre(file + ": /format: \"gltf\" is not known; expected \"lapfx.preset\" or \"lapfx.scene\""));
    EXPECT_THAT(faults("[]"), ElementsAre(file + ": an array of 0 in place of an object; expected \"lapfx.preset\" or "
                                                 "\"lapfx.scene\""));
    EXPECT_THAT(faults(scene_text("")),
                ElementsAre(file + ": /organ/file: missing; expected the name of a local file"));
}

TEST(Scene, HasCurvesOverTime) {
    const Scene scene = parse_scene(scene_text(organ + R"(, "curves": {
        "bleeding_strength": [{"time": 0, "value": 0}, {"time": 2.5, "value": 4}], "emission": [{"time": 3}]})"),
                                    "s.json");
    EXPECT_TRUE(scene.curves.cautery_power.empty());
    EXPECT_EQ(scene.curves.bleeding_strength, (std::vector<CurvePoint>{{0.0, 0.0}, {2.5, 4.0}}));
    EXPECT_EQ(scene.curves.emission, (std::vector<CurvePoint>{{3.0, 1.0}}));
    const std::string written = write_scene(scene);
    EXPECT_EQ(parse_scene(written, "again").curves, scene.curves);
    EXPECT_EQ(write_scene(parse_scene(written, "again")), written);
}

TEST(Scene, FaultsOfCurvesNameTheirPlace) {
    EXPECT_THAT(
        scene_faults(scene_text(organ + R"(, "curves": {
        "cautery_power": [{"time": 1, "value": 1.5}, {"value": 1}],
        "bleeding_strength": [{"time": 1}, {"time": 2}, {"time": 2}, {"time": 1.5}],
        "emission": [{"time": -1, "value": -1}], "speed": []})")),
        ElementsAre("s.json: /curves/speed: unknown key; nearest is \"emission\"",
                    "s.json: /curves/cautery_power/0/value: 1.5 is above the maximum 1 (allowed: 0 to 1)",
                    "s.json: /curves/cautery_power/1/time: missing; expected a number from 0 to 3600 s",
                    "s.json: /curves/bleeding_strength/2/time: 2 s is not after 2 s, the time of the point before",
                    "s.json: /curves/bleeding_strength/3/time: 1.5 s is not after 2 s, the time of the point before",
                    "s.json: /curves/emission/0/time: -1 is below the minimum 0 s (allowed: 0 to 3600 s)",
                    "s.json: /curves/emission/0/value: -1 is below the minimum 0 (allowed: 0 to 4)"));
    Scene scene;
    scene.organ.file = "o.ply";
    scene.curves.emission = {{2.0, 1.0}, {1.0, 1.0}};
    const std::vector<Fault> faults = check(scene_table(), &scene);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].place, "/curves/emission/1/time");
}

}  // namespace

}  // namespace lapfx
