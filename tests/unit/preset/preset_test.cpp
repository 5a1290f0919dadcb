// The shipped presets, and loading and saving.
#include "lapfx/preset.h"
#include "lapfx/authoring/documents.h"

#include <gmock/gmock.h>

#include <limits>

#include "support/folders.h"
#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

using testing::ElementsAre;
namespace fs = std::filesystem;

class ShippedPreset : public testing::TestWithParam<const char*> {};

TEST_P(ShippedPreset, LoadsAndIsWrittenAsItIs) {
    const fs::path path = test::source_folder() / "presets" / GetParam();
    const Preset preset = load_preset(path);
    EXPECT_FALSE(preset.name.empty());
    EXPECT_FALSE(preset.description.empty());
    EXPECT_FALSE(preset.smoke.clips.empty());
    EXPECT_EQ(preset.folder, path.parent_path());
    EXPECT_EQ(write_preset(preset), test::read_text(path));
    for (const SmokeClip& clip : preset.smoke.clips)
        EXPECT_EQ(clip.file.find('/'), std::string::npos) << "shipped clips are bare names";
}

INSTANTIATE_TEST_SUITE_P(All, ShippedPreset,
                         testing::Values("gastric_banding.json", "slow_ooze.json", "brisk_bleed.json",
                                         "hook_cautery_plume.json", "heavy_haze.json", "fast_haze.json",
                                         "cleared_haze.json", "sudden_burst.json"),
                         [](const auto& test) {
                             const std::string name = test.param;
                             return name.substr(0, name.find('.'));
                         });

TEST(ShippedPresets, AreAllTested) {
    int presets = 0;
    for (const auto& entry : fs::directory_iterator(test::source_folder() / "presets"))
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema") ++presets;
    EXPECT_EQ(presets, 8);
}

TEST(SavePreset, LoadsAgainFromItsFolder) {
    const test::Folder folder;
    const Preset preset = test::full_preset();
    save_preset(preset, folder / "p.json");
    const Preset read = load_preset(folder / "p.json");
    EXPECT_EQ(write_preset(read), write_preset(preset));
    EXPECT_EQ(read.folder, folder.path());
}

TEST(SavePreset, RefusesWhatCouldNotBeLoadedAndKeepsTheOldFile) {
    const test::Folder folder;
    const fs::path path = folder.write("p.json", "old");
    Preset preset = test::full_preset();
    preset.bleeding.speed = std::numeric_limits<double>::quiet_NaN();
    preset.smoke.clips[0].file = "../x.mp4";
    preset.smoke.keying.luma_low = 201.0;
    const auto faults = test::faults_of([&] { save_preset(preset, path); });
    EXPECT_THAT(faults, ElementsAre(testing::HasSubstr("p.json: /bleeding/speed: nan is not a finite number"),
                                    testing::HasSubstr("/smoke/clips/0/file: \"../x.mp4\" is outside the folder"),
                                    testing::HasSubstr("/smoke/keying/luma_low: 201 is not below luma_high")));
    EXPECT_EQ(test::read_text(path), "old");
}

TEST(LoadPreset, FaultsNameTheFileAsGiven) {
    const test::Folder folder;
    const fs::path path = folder.write("p.json", test::preset_text(R"(, "bleeding": {"speed": -3})"));
    EXPECT_THAT(
        test::faults_of([&] { load_preset(path); }),
        ElementsAre(path.string() + ": /bleeding/speed: -3 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)"));
}

}  // namespace

}  // namespace lapfx
