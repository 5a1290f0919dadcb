#include "commands/session.h"

#include <gmock/gmock.h>

#include "lapfx/preset.h"
#include "lapfx/scene.h"
#include "unit/preset/support.h"

namespace lapfx::commands {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

class PresetFor : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("scene.json", test::preset_text(R"(, "name": "of the scene", "bleeding": {"speed": 2})"));
        folder.write("other.json", test::preset_text(R"(, "name": "other", "bleeding": {"speed": 9})"));
        scene.folder = folder.path();
    }
    std::vector<std::string> faults(const std::vector<std::string>& settings) {
        return test::faults_of([&] { preset_for(scene, "", settings); });
    }
    test::Folder folder;
    Scene scene;
};

TEST_F(PresetFor, WithoutAnyItIsTheDefaults) {
    EXPECT_EQ(write_preset(preset_for(scene, "", {})), write_preset(Preset{}));
}

TEST_F(PresetFor, TheScenesOwnIsBesideTheScene) {
    scene.preset = "scene.json";
    const Preset preset = preset_for(scene, "", {});
    EXPECT_EQ(preset.name, "of the scene");
    EXPECT_EQ(preset.bleeding.speed, 2.0);
}

TEST_F(PresetFor, AnotherOneTakesItsPlace) {
    scene.preset = "missing.json";
    EXPECT_EQ(preset_for(scene, (folder / "other.json").string(), {}).name, "other");
}

TEST_F(PresetFor, SettingsComeLastInTheirOrder) {
    scene.preset = "scene.json";
    const Preset preset = preset_for(
        scene, "",
        {"bleeding.speed=5", "bleeding.color_thin=#800000", "bleeding.speed=7.5", "smoke.haze.unevenness=0"});
    EXPECT_EQ(preset.bleeding.speed, 7.5);
    EXPECT_NEAR(preset.bleeding.color_thin.r, 128.0 / 255.0, 1e-9);
    EXPECT_EQ(preset.smoke.haze.unevenness, 0.0);
    EXPECT_EQ(preset.name, "of the scene");
}

TEST_F(PresetFor, WrongSettingsAreNamed) {
    EXPECT_THAT(faults({"bleeding.speed"}), ElementsAre("--set: \"bleeding.speed\" is not KEY=VALUE"));
    EXPECT_THAT(faults({"bleeding.sped=3"}), ElementsAre(testing::HasSubstr("nearest is bleeding.speed")));
    EXPECT_THAT(faults({"bleeding.speed=-3"}), ElementsAre(testing::HasSubstr("-3 is below the minimum 0 mm/s")));
    EXPECT_THAT(faults({"bleeding.speed="}), SizeIs(1));
    EXPECT_THAT(faults({"=3"}), SizeIs(1));
}

TEST_F(PresetFor, AMissingPresetIsNamed) {
    scene.preset = "missing.json";
    const auto lines = test::faults_of([&] { preset_for(scene, "", {}); });
    ASSERT_THAT(lines, SizeIs(1));
    EXPECT_THAT(lines[0], testing::StartsWith((folder / "missing.json").string() + ": "));
}

}  // namespace
}  // namespace lapfx::commands
