// Hidden colours, found again in what a made-up camera sees of them.
#include "match/fit/color_match.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/color_space.hpp>
#include <limits>

namespace lapfx::match {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

document::Content usual() {
    document::Content tuned;
    tuned.scene.camera.exposure = 1.9;
    tuned.preset.bleeding.color_thin = {0.45, 0.03, 0.035}, tuned.preset.bleeding.color_deep = {0.22, 0.016, 0.02};
    tuned.preset.smoke.haze.color = {0.46, 0.41, 0.46}, tuned.preset.smoke.plume.color = {0.62, 0.62, 0.68};
    return tuned;
}

document::Content hidden() {
    document::Content tuned = usual();
    tuned.scene.camera.exposure = 1.3, tuned.scene.organ.color = {1.0, 0.9, 0.8};
    tuned.preset.bleeding.color_thin = {0.7, 0.2, 0.12}, tuned.preset.bleeding.color_deep = {0.36, 0.1, 0.06};
    tuned.preset.smoke.haze.color = {0.4, 0.45, 0.6}, tuned.preset.smoke.plume.color = {0.54, 0.68, 0.88};
    return tuned;
}

glm::dvec3 mean_light(const glm::dvec3& a, const glm::dvec3& b) {
    return 0.5 * (glm::convertSRGBToLinear(a) + glm::convertSRGBToLinear(b));
}

/// As the shoulder of shaders/color.glsl.
glm::dvec3 shoulder(const glm::dvec3& light) {
    constexpr double knee = 0.7;
    const glm::dvec3 over = glm::max(light - knee, 0.0) / (1.0 - knee);
    return glm::min(light, knee) + (1.0 - knee) * over / (1.0 + over);
}

/// Tissue shines through its blood, and the lamp is mirrored in it.
struct Camera {
    glm::dvec3 tissue{0.12, 0.055, 0.03}, film{0.0};
    double blood = 0.08, veil = 0.3;  // amounts
    int drawn = 0;

    ColorsAtPeak see(const document::Content& tuned) {
        ++drawn;
        const Preset& p = tuned.preset;
        const double exposure = tuned.scene.camera.exposure;
        const glm::dvec3 body = tissue * glm::convertSRGBToLinear(tuned.scene.organ.color) + film;
        const glm::dvec3 of_blood = mean_light(p.bleeding.color_thin, p.bleeding.color_deep);
        const glm::dvec3 of_smoke = mean_light(p.smoke.haze.color, p.smoke.plume.color);
        return {.colors = {.blood = shoulder(exposure * (0.7 * of_blood + 0.1 * body + 0.002)),
                           .smoke = shoulder(exposure * 0.9 * of_smoke),
                           .tissue = shoulder(exposure * body),
                           .tinted = true},
                .blood = {blood, 0.5 * blood, 1.5 * blood},
                .veil = {veil, 0.8 * veil, 1.2 * veil}};
    }
    DrawColors draw() {
        return [this](const document::Content& tuned) { return std::optional(see(tuned)); };
    }
};

ColorsAtPeak video_of(const document::Content& tuned) {
    return Camera{}.see(tuned);
}

ColorMatch matched(const ColorsAtPeak& reference,
                   std::vector<std::string> keys = {color_keys().begin(), color_keys().end()}) {
    Camera camera;
    return match_colors({.start = usual(), .reference = reference, .keys = std::move(keys), .draw = camera.draw()});
}

TEST(ColorMatch, WhatDiffersIsTakenOver) {
    EXPECT_THAT(different_colors(usual(), usual()), testing::IsEmpty());
    document::Content other = usual();
    other.preset.bleeding.color_deep = {0.1, 0.2, 0.3};
    other.scene.camera.exposure = 2.5;
    other.scene.organ.color = {1.0, 0.5, 0.5};
    EXPECT_THAT(different_colors(usual(), other),
                testing::ElementsAre("camera.exposure", "organ.color", "bleeding.color_deep"));
    EXPECT_THAT(different_colors(usual(), hidden()), testing::ElementsAreArray(color_keys()));
    document::Content present = usual();
    take_colors(present, hidden(), std::vector<std::string>{"smoke.plume.color", "bleeding.color_thin", "no.color"});
    EXPECT_EQ(present.preset.smoke.plume.color, hidden().preset.smoke.plume.color);
    EXPECT_EQ(present.preset.bleeding.color_thin, hidden().preset.bleeding.color_thin);
    EXPECT_EQ(present.preset.smoke.haze.color, usual().preset.smoke.haze.color);
    EXPECT_EQ(present.scene.camera.exposure, usual().scene.camera.exposure);
    take_colors(present, hidden(), color_keys());
    EXPECT_THAT(different_colors(present, hidden()), testing::IsEmpty());
}

TEST(ColorMatch, FindsHiddenColoursAndExposure) {
    const ColorMatch found = matched(video_of(hidden()));
    EXPECT_GT(*found.before.blood, 5.0);
    EXPECT_GT(*found.before.smoke, 5.0);
    EXPECT_LT(*found.after.blood, 1.0);
    EXPECT_LT(*found.after.smoke, 1.0);
    EXPECT_NEAR(*found.light_after, 1.0, 0.03);
    EXPECT_NEAR(found.tuned.scene.camera.exposure, 1.3, 0.04);
    EXPECT_LT(*found.after.tissue, 1.0);
    EXPECT_NEAR(found.tuned.scene.organ.color.r, 1.0, 0.01);
    EXPECT_NEAR(found.tuned.scene.organ.color.g, 0.9, 0.01);
    EXPECT_NEAR(found.tuned.scene.organ.color.b, 0.8, 0.01);
    EXPECT_THAT(found.lines, Contains("organ.color: #ffffff -> #ffe6cc, the tint of the video's tissue"));
    const glm::dvec3 thin = found.tuned.preset.bleeding.color_thin;
    EXPECT_NEAR(thin.r, 0.7, 0.03);
    EXPECT_NEAR(thin.g, 0.2, 0.03);
    const glm::dvec3 haze = found.tuned.preset.smoke.haze.color;
    EXPECT_NEAR(haze.r, 0.4, 0.02);
    EXPECT_NEAR(haze.g, 0.45, 0.02);
    EXPECT_NEAR(haze.b, 0.6, 0.02);
    EXPECT_LE(found.drawn, 5);
    EXPECT_FALSE(found.ended_early);
    EXPECT_THAT(found.lines, Contains(HasSubstr("camera.exposure: 1.9 -> 1.3")));
    EXPECT_THAT(found.lines, Contains(HasSubstr("bleeding.color_thin: #730809 -> #")));
    EXPECT_THAT(likeness_lines(found), Contains(HasSubstr("blood: Delta E")));
}

/// A channel that is 0 tells no proportion.
TEST(ColorMatch, AnOrganWithoutAChannelIsFoundAllTheSame) {
    for (const glm::dvec3 none : {glm::dvec3(1.0, 0.0, 0.5), glm::dvec3(0.0, 0.5, 0.5), glm::dvec3(0.0)}) {
        document::Content start = usual();
        start.scene.organ.color = none;
        Camera camera;
        camera.film = glm::dvec3(0.004);
        const ColorMatch found = match_colors({.start = start,
                                               .reference = video_of(hidden()),
                                               .keys = {color_keys().begin(), color_keys().end()},
                                               .draw = camera.draw()});
        const glm::dvec3 color = found.tuned.scene.organ.color;
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(color[c] >= 0.0 && color[c] <= 1.0) << color[c];
        EXPECT_TRUE(std::isfinite(found.tuned.scene.camera.exposure));
        EXPECT_LT(*found.after.tissue, none == glm::dvec3(0.0) ? 30.0 : 4.0) << *found.before.tissue;
    }
}

TEST(ColorMatch, LeavesTheRestAsItIs) {
    document::Content found = matched(video_of(hidden())).tuned;
    const document::Content before = usual();
    EXPECT_EQ(found.scene.light.color, before.scene.light.color);
    EXPECT_EQ(found.scene.light.intensity, before.scene.light.intensity);
    found.preset.bleeding.color_thin = before.preset.bleeding.color_thin;
    found.preset.bleeding.color_deep = before.preset.bleeding.color_deep;
    found.preset.smoke.haze.color = before.preset.smoke.haze.color;
    found.preset.smoke.plume.color = before.preset.smoke.plume.color;
    EXPECT_EQ(write_preset(found.preset), write_preset(before.preset));
}

TEST(ColorMatch, WhatMatchesIsDrawnOnceAndStays) {
    const ColorMatch found = matched(video_of(usual()));
    EXPECT_EQ(found.drawn, 1);
    EXPECT_EQ(write_preset(found.tuned.preset), write_preset(usual().preset));
    EXPECT_EQ(found.tuned.scene.camera.exposure, 1.9);
    EXPECT_THAT(found.lines, Contains(HasSubstr("camera.exposure: stays, the tissue of the video is as bright")));
}

TEST(ColorMatch, WhatIsNotFreeStays) {
    const ColorMatch found = matched(video_of(hidden()), {"bleeding.color_thin", "smoke.haze.color"});
    EXPECT_EQ(found.tuned.scene.camera.exposure, 1.9);
    EXPECT_EQ(found.tuned.preset.bleeding.color_deep, usual().preset.bleeding.color_deep);
    EXPECT_EQ(found.tuned.preset.smoke.plume.color, usual().preset.smoke.plume.color);
    EXPECT_LT(*found.after.blood, 1.0) << "the other colour does it alone";
    EXPECT_THAT(found.lines,
                Contains(HasSubstr("camera.exposure: is not free; the tissue of the video is 0.59 times")));
    EXPECT_THAT(found.lines, Not(Contains(HasSubstr("color_deep"))));
    const ColorMatch nothing = matched(video_of(hidden()), {});
    EXPECT_EQ(nothing.drawn, 1);
    EXPECT_EQ(write_preset(nothing.tuned.preset), write_preset(usual().preset));
}

/// The lamp is white where it is mirrored, whatever the organ's colour is.
TEST(ColorMatch, TheTissueIsMirroringToo) {
    Camera camera{.film = glm::dvec3(0.02)};
    const ColorsAtPeak video = camera.see(hidden());
    const ColorMatch found = match_colors({.start = usual(), .reference = video, .draw = camera.draw()});
    EXPECT_LT(*found.after.tissue, 1.0);
    EXPECT_NEAR(found.tuned.scene.organ.color.b, 0.8, 0.03);
    EXPECT_LT(*found.after.blood, 1.0);
}

TEST(ColorMatch, TheTissueThatIsNotFreeIsAsBright) {
    std::vector<std::string> keys(color_keys().begin(), color_keys().end());
    std::erase(keys, "organ.color");
    const ColorMatch found = matched(video_of(hidden()), keys);
    EXPECT_EQ(found.tuned.scene.organ.color, usual().scene.organ.color);
    EXPECT_NEAR(*found.light_after, 1.0, 0.03);
    EXPECT_THAT(found.lines, Not(Contains(HasSubstr("organ.color"))));
}

TEST(ColorMatch, ADarkOrganKeepsHowLightItIs) {
    document::Content start = usual();
    start.scene.organ.color = {0.5, 0.5, 0.5};
    Camera camera;
    const ColorMatch found = match_colors({.start = start, .reference = video_of(hidden()), .draw = camera.draw()});
    const glm::dvec3 color = found.tuned.scene.organ.color;
    EXPECT_NEAR(std::max({color.r, color.g, color.b}), 0.5, 0.01);
    EXPECT_LT(*found.after.tissue, 1.0);
}

TEST(ColorMatch, BothBloodColoursKeepTheirRatio) {
    const Preset found = matched(video_of(hidden())).tuned.preset;
    const auto ratio = [](const Preset& preset) {
        return glm::convertSRGBToLinear(preset.bleeding.color_thin).r /
               glm::convertSRGBToLinear(preset.bleeding.color_deep).r;
    };
    EXPECT_NEAR(ratio(found), ratio(usual().preset), 0.1);
}

TEST(ColorMatch, LittleBloodOrSmokeOfTheVideoSaysNothing) {
    ColorsAtPeak video = video_of(hidden());
    video.blood = {0.02, 0.0, 0.04};  // may be none
    const ColorMatch bloodless = matched(video);
    EXPECT_EQ(bloodless.tuned.preset.bleeding.color_thin, usual().preset.bleeding.color_thin);
    EXPECT_EQ(bloodless.tuned.preset.bleeding.color_deep, usual().preset.bleeding.color_deep);
    EXPECT_LT(*bloodless.after.smoke, 1.0);
    EXPECT_THAT(bloodless.lines, Contains("bleeding.color_thin and bleeding.color_deep: stay, the video shows too "
                                          "little blood to tell its colour"));
    video = video_of(hidden()), video.colors.smoke.reset();
    const ColorMatch clear = matched(video);
    EXPECT_EQ(clear.tuned.preset.smoke.haze.color, usual().preset.smoke.haze.color);
    EXPECT_LT(*clear.after.blood, 1.0);
    EXPECT_FALSE(clear.after.smoke);
    EXPECT_THAT(clear.lines, Contains(HasSubstr("the video shows too little smoke to tell its colour")));
    EXPECT_THAT(likeness_lines(clear), Contains("smoke: colour not measurable in both"));
}

TEST(ColorMatch, SmokeWhoseTintIsNotToldKeepsItsOwn) {
    ColorsAtPeak video = video_of(hidden());
    video.colors.tinted = false;
    const ColorMatch found = matched(video);
    EXPECT_LT(*found.after.smoke, 1.0);
    EXPECT_LT(*found.after.smoke, *found.before.smoke);
    const auto tint = [](const glm::dvec3& color) {
        const glm::dvec3 light = glm::convertSRGBToLinear(color);
        return light / light.g;
    };
    const glm::dvec3 before = tint(usual().preset.smoke.haze.color), after = tint(found.tuned.preset.smoke.haze.color);
    EXPECT_NE(found.tuned.preset.smoke.haze.color, usual().preset.smoke.haze.color);
    EXPECT_NEAR(after.r, before.r, 0.03);
    EXPECT_NEAR(after.b, before.b, 0.03);
    EXPECT_THAT(found.lines, Contains(HasSubstr("smoke.haze.color and smoke.plume.color: keep their tint")));
}

TEST(ColorMatch, MuchBloodCountsBehindSmokeThatHidesWhetherItIsThere) {
    ColorsAtPeak video = video_of(hidden());
    video.blood = {0.1, 0.0, 0.2};
    EXPECT_LT(*matched(video).after.blood, 1.0);
}

TEST(ColorMatch, ASceneWithoutBloodIsNotCompared) {
    Camera camera{.blood = 0.001};
    const ColorMatch found = match_colors({.start = usual(), .reference = video_of(hidden()), .draw = camera.draw()});
    EXPECT_EQ(found.tuned.preset.bleeding.color_thin, usual().preset.bleeding.color_thin);
    EXPECT_THAT(found.lines, Contains(HasSubstr("the scene shows too little blood to compare its colour")));
}

TEST(ColorMatch, BlackAndWhiteVideosSayNothing) {
    for (const double level : {0.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
        const glm::dvec3 even(level);
        ColorsAtPeak video = video_of(hidden());
        video.colors = {.blood = even, .smoke = even, .tissue = even};
        const ColorMatch found = matched(video);
        EXPECT_EQ(found.tuned.scene.camera.exposure, 1.9) << level;
        for (const glm::dvec3& color : {found.tuned.preset.bleeding.color_thin, found.tuned.preset.smoke.haze.color})
            for (int c = 0; c < 3; ++c) EXPECT_TRUE(color[c] >= 0.0 && color[c] <= 1.0) << level;
        EXPECT_THAT(found.lines, Contains(HasSubstr("camera.exposure: stays, "))) << level;
    }
    const ColorMatch none = matched({});
    EXPECT_EQ(none.drawn, 1);
    EXPECT_EQ(write_preset(none.tuned.preset), write_preset(usual().preset));
}

TEST(ColorMatch, WhatCannotBeReachedIsNotOverdone) {
    ColorsAtPeak video = video_of(usual());
    video.colors.blood = glm::dvec3(0.05, 0.3, 0.3);
    const ColorMatch found = matched(video);
    EXPECT_LE(*found.after.blood, *found.before.blood);
    const glm::dvec3 thin = found.tuned.preset.bleeding.color_thin;
    EXPECT_LT(thin.g, 0.25) << "twenty times as much light as there was";
    EXPECT_GT(thin.r, 0.15);
    EXPECT_THAT(found.lines, Contains(HasSubstr("is left, which no colour mends")));
}

TEST(ColorMatch, ThePlateKeepsItsExposure) {
    document::Content start = usual();
    start.scene.plate.use = true;
    Camera camera;
    const ColorMatch found = match_colors({.start = start, .reference = video_of(hidden()), .draw = camera.draw()});
    EXPECT_EQ(found.tuned.scene.camera.exposure, 1.9);
    EXPECT_EQ(found.tuned.scene.organ.color, start.scene.organ.color);
    EXPECT_THAT(found.lines, Contains(HasSubstr("camera.exposure: stays, the tissue is the plate")));
}

TEST(ColorMatch, ExposureStaysWithinItsBounds) {
    ColorsAtPeak video = video_of(hidden());
    video.colors.tissue = glm::dvec3(0.005);
    Camera camera{.tissue = glm::dvec3(0.7)};
    document::Content start = usual();
    start.scene.camera.exposure = 0.015;
    const ColorMatch found = match_colors({.start = start, .reference = video, .draw = camera.draw()});
    EXPECT_GE(found.tuned.scene.camera.exposure, 0.01);
}

TEST(ColorMatch, ThatIsCancelledGivesTheBestSoFar) {
    for (const int most : {0, 1, 2}) {
        Camera camera;
        const ColorMatch found =
            match_colors({.start = usual(),
                          .reference = video_of(hidden()),
                          .draw = [&](const document::Content& tuned) -> std::optional<ColorsAtPeak> {
                              if (camera.drawn == most) return {};
                              return camera.see(tuned);
                          }});
        EXPECT_TRUE(found.ended_early);
        EXPECT_EQ(found.drawn, most);
        EXPECT_EQ(write_preset(found.tuned.preset) == write_preset(usual().preset), most < 2);
        if (most > 0) {
            EXPECT_EQ(*found.after.smoke < *found.before.smoke, most == 2);
        }
    }
}

TEST(ColorMatch, IsTheSameEachTime) {
    const ColorMatch once = matched(video_of(hidden())), again = matched(video_of(hidden()));
    EXPECT_EQ(write_preset(once.tuned.preset), write_preset(again.tuned.preset));
    EXPECT_EQ(once.lines, again.lines);
}

}  // namespace
}  // namespace lapfx::match
