#include "lapfx/authoring/preview.h"

#include <numbers>

#include "parity/render/scene_fixture.h"

namespace lapfx {
namespace {

class PreviewTest : public test::SceneTest {};

TEST_F(PreviewTest, TheSameFrameTwiceIsTheSameBytes) {
    Preview p = preview();
    const Image first = p.image(2.5, size), second = p.image(2.5, size);
    EXPECT_EQ(first.width, size.x);
    EXPECT_EQ(first.height, size.y);
    EXPECT_TRUE(first.pixels == second.pixels);
    EXPECT_TRUE(preview().image(2.5, size).pixels == first.pixels) << "from another preview, too";
}

TEST_F(PreviewTest, AFrameIsTheSameWhateverWasShownBefore) {
    Preview p = preview();
    std::vector<Image> direct;
    const std::vector<double> times{0.0, 0.7, 2.5, 3.6, 9.0};
    for (const double time : times) direct.push_back(preview().image(time, size));
    EXPECT_GT(test::differing(direct[0], direct[2]), 100) << "the scene does change";
    for (const std::size_t i : {4u, 0u, 3u, 1u, 2u, 4u, 2u})
        EXPECT_TRUE(p.image(times[i], size).pixels == direct[i].pixels) << times[i] << " s";
}

TEST_F(PreviewTest, BloodCoversTheAreaItShould) {
    preset.smoke.clips.clear();
    preset.bleeding.noise_strength = 0.0;
    preset.bleeding.threshold = 3.0;
    scene.light.focus_distance =
        60.0;  // dim enough that the reflection of the lamp is not white with and without blood
    scene.events.resize(1);
    scene.events[0].position = scene.events[0].to = {0.0, 0.0, 0.0};
    Preview p = preview();
    constexpr glm::ivec2 large(320, 320);
    const Image bleeding = p.image(3.0, large);  // 12 mm, of which 9 above the threshold
    const double area = p.amounts().blood_area;
    EXPECT_NEAR(area, std::numbers::pi * 81.0, 0.02 * area);
    p.set_contacts({});
    const Image dry = p.image(3.0, large);
    const double mm_per_pixel = 2.0 * 60.0 * std::tan(glm::radians(scene.camera.field_of_view) / 2.0) / large.y;
    EXPECT_NEAR(test::differing(bleeding, dry) * mm_per_pixel * mm_per_pixel, area, 0.04 * area);
    EXPECT_EQ(p.amounts().blood_area, 0.0);
}

TEST_F(PreviewTest, BloodRunsDownhillOnThePicture) {
    preset.smoke.clips.clear();
    preset.bleeding.noise_strength = 0.0;
    preset.bleeding.gravity_bias = 0.5;
    scene.events.resize(1);
    scene.events[0].position = scene.events[0].to = {0.0, 0.0, 0.0};
    scene.gravity = {0.0, 0.0, 1.0};  // towards the lower edge of the picture
    Preview p = preview();
    const Image bleeding = p.image(2.0, size);
    p.set_contacts({});
    const Image dry = p.image(2.0, size);
    int above = 0, below = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const std::size_t i = 4 * static_cast<std::size_t>(y * size.x + x);
            if (std::abs(bleeding.pixels[i + 1] - dry.pixels[i + 1]) > 2) ++(y < size.y / 2 ? above : below);
        }
    EXPECT_GT(above, 20);
    EXPECT_GT(below, 2 * above);
}

TEST_F(PreviewTest, TheOrganHasTheScenesColour) {
    preset.smoke.clips.clear();
    scene.light.color = glm::dvec3(1.0);
    scene.light.intensity = 0.4;  // dim, so that the display curve does not compress channels
    const auto middle = [&](const Image& image) {
        const std::size_t i = 4 * static_cast<std::size_t>(size.y / 4 * size.x + size.x / 4);
        return glm::ivec3(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
    };
    Preview p = preview();
    const Image white = p.image(2.5, size);
    scene.organ.color = {0.8, 0.25, 0.2};
    p.set_scene(scene);
    const Image red = p.image(2.5, size);
    EXPECT_NEAR(middle(white).r, middle(white).g, 15) << "a mesh without colours";
    EXPECT_GT(middle(red).r, 2 * middle(red).g);
    EXPECT_LT(middle(red).g, middle(white).g - 40);
    EXPECT_TRUE(preview().image(2.5, size).pixels == red.pixels) << "as if it had been so from the start";
    const Amounts amounts = p.amounts();
    scene.organ.color = glm::dvec3(1.0);
    p.set_scene(scene);
    EXPECT_TRUE(p.image(2.5, size).pixels == white.pixels) << "white leaves it as it is";
    EXPECT_EQ(p.amounts().blood_area, amounts.blood_area) << "where it bleeds stays the same";
}

TEST_F(PreviewTest, SmokeAndCharAreSeen) {
    Preview p = preview();
    const Image during = p.image(3.0, size);
    EXPECT_GT(p.amounts().haze, 0.0);
    EXPECT_EQ(p.amounts().bleeding_wounds, 2);
    Preset clear = preset;
    clear.smoke.clips.clear();
    p.set_preset(clear);
    const Image without_smoke = p.image(3.0, size);
    EXPECT_GT(test::differing(during, without_smoke), 200);
    p.set_contacts(std::span(scene.events).first(1));
    EXPECT_GT(test::differing(without_smoke, p.image(3.0, size)), 20) << "the char of the burn";
}

struct Change {
    const char* key;
    const char* value;
};

class LiveParameter : public PreviewTest, public testing::WithParamInterface<Change> {};

TEST_P(LiveParameter, ShowsInTheNextFrameAndGoesAgain) {
    Preview p = preview();
    const Image before = p.image(2.8, size);
    Preset changed = preset;
    set_parameter(preset_table(), &changed, GetParam().key, GetParam().value);
    p.set_preset(changed);
    const Image after = p.image(2.8, size);
    EXPECT_GT(test::differing(before, after), 15);
    p.set_preset(preset);
    EXPECT_TRUE(p.image(2.8, size).pixels == before.pixels) << "back to what it was";
    preset = changed;
    EXPECT_TRUE(preview().image(2.8, size).pixels == after.pixels) << "as if it had been so from the start";
}

INSTANTIATE_TEST_SUITE_P(Preset, LiveParameter,
                         testing::Values(Change{"bleeding.speed", "2"}, Change{"bleeding.max_extent", "5"},
                                         Change{"bleeding.threshold", "4"}, Change{"bleeding.noise_scale", "2"},
                                         Change{"bleeding.noise_strength", "0"}, Change{"bleeding.noise_octaves", "1"},
                                         Change{"bleeding.opacity", "0.2"}, Change{"bleeding.color_deep", "#602080"},
                                         Change{"cautery.cut_temperature", "399"},
                                         Change{"cautery.char_temperature", "390"},
                                         Change{"smoke.keying.luma_low", "60"}, Change{"smoke.keying.luma_high", "100"},
                                         Change{"smoke.keying.noise_strength", "1"}, Change{"smoke.plume.size", "90"},
                                         Change{"smoke.plume.density", "0.2"}, Change{"smoke.haze.accumulation", "1"},
                                         Change{"smoke.clips.0.weight", "0"}, Change{"smoke.clips.0.polarity", "dark"}),
                         [](const auto& tested) {
                             std::string name = tested.param.key;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST_F(PreviewTest, AClipThatCannotBeUsedLeavesThePresetAsItWas) {
    Preview p = preview();
    const Image before = p.image(2.5, size);
    Preset broken = preset;
    broken.bleeding.speed = 20.0;
    broken.smoke.clips.push_back({.file = "missing.avi"});
    EXPECT_EQ(test::faults_of([&] { p.set_preset(broken); }),
              std::vector{"missing.avi: no such clip; looked in " + folder.path().string()});
    EXPECT_TRUE(p.image(2.5, size).pixels == before.pixels);
}

TEST_F(PreviewTest, SizesThatCannotBeMadeAreRefused) {
    Preview p = preview();
    for (const glm::ivec2 wrong : {glm::ivec2(0, 10), glm::ivec2(10, -1), glm::ivec2(1'000'000, 10)})
        EXPECT_EQ(test::faults_of([&] { p.image(0.0, wrong); }).size(), 1u) << wrong.x;
    EXPECT_EQ(p.image(0.0, {1, 1}).pixels.size(), 4u);
}

}  // namespace
}  // namespace lapfx
