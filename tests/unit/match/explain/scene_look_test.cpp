#include "match/explain/scene_look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "lapfx/preset.h"
#include "match/picture/colors.h"

namespace lapfx::match {
namespace {

using Vec = glm::dvec3;

constexpr int width = 320, height = 256;

Vec linear(const Vec& srgb) {
    Vec made;
    for (int c = 0; c < 3; ++c) made[c] = static_cast<double>(linear_of(static_cast<float>(255 * srgb[c])));
    return made;
}

/// Tissue with some texture under a lamp, drawn as the preview is: exposure, shoulder, the round view.
struct Tissue {
    double exposure = 1, vignette = 0;
    Vec light{1.0}, organ{1.0};
    bool highlights = true, blood = false;
    double veil = 0;
    Vec veil_light{0.3, 0.28, 0.3};

    Image image() const {
        Image made{.width = width, .height = height, .pixels = {}, .name = ""};
        std::mt19937 random(7);
        std::uniform_real_distribution<double> around(0.8, 1.2);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                Vec light_here = exposure * linear(light) * linear(organ) * Vec(0.30, 0.10, 0.08) * around(random);
                const bool spot = highlights && x % 40 < 4 && y % 40 < 4;
                if (spot) light_here = exposure * linear(light) * 0.5;
                if (blood && x > 120 && x < 200 && y > 90 && y < 160)
                    light_here = exposure * linear(light) * Vec(0.12, 0.004, 0.006);
                light_here = glm::mix(light_here, veil_light, veil);
                put(made, x, y, light_here);
            }
        return made;
    }

  private:
    void put(Image& made, int x, int y, Vec shown) const {
        const double radius = std::hypot(x + 0.5 - width / 2.0, y + 0.5 - height / 2.0) / (height / 2.0);
        const double t = std::clamp((radius - 0.35) / 0.8, 0.0, 1.0), lens = 1 - 0.45 * t * t * (3 - 2 * t);
        const double mask = radius < 1.12 ? 1 : 0;
        for (int c = 0; c < 3; ++c) {
            const double over = std::max(shown[c] - 0.7, 0.0) / 0.3;
            const double soft = std::min(shown[c], 0.7) + 0.3 * over / (1 + over);
            const double light_here = soft * glm::mix(1.0, lens * mask, vignette);
            made.pixels.push_back(static_cast<std::uint8_t>(
                std::lround(std::clamp(code_of(static_cast<float>(light_here)), 0.0F, 255.0F))));
        }
        made.pixels.push_back(255);
    }
};

SceneLook look_of(const Tissue& tissue) {
    return {.vignette = tissue.vignette,
            .exposure = tissue.exposure,
            .light = tissue.light,
            .organ = tissue.organ,
            .blood_thin = {0.45, 0.03, 0.035},
            .blood_deep = {0.22, 0.015, 0.02},
            .haze = {0.46, 0.41, 0.46}};
}

/// What reaches the camera from tissue: the parts cannot be told apart in a picture, their product can.
Vec product(const SceneLook& look) {
    return look.exposure * linear(look.light) * linear(look.organ);
}

void expect_near(const Vec& found, const Vec& truth, double share, const char* what) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / truth[c], 1.0, share) << what << ", channel " << c;
}

bool notes_contain(const LookProposal& found, const std::string& text) {
    for (const std::string& note : found.notes)
        if (note.find(text) != std::string::npos) return true;
    return false;
}

TEST(SceneLook, FindsExposureLampAndTissue) {
    const Tissue truth{.exposure = 1.6, .light = {1.0, 0.9, 0.75}, .organ = {1.0, 0.8, 0.9}};
    const LookProposal found = propose_look(truth.image(), Tissue{}.image(), look_of(Tissue{}));
    ASSERT_TRUE(found.possible);
    expect_near(product(found.look), product(look_of(truth)), 0.06, "product");
    expect_near(linear(found.look.light), linear(truth.light), 0.08, "lamp");
    expect_near(linear(found.look.organ), linear(truth.organ), 0.1, "tissue");
    EXPECT_NEAR(found.look.exposure, 1.6, 0.15);
    EXPECT_NEAR(std::max({found.look.organ.r, found.look.organ.g, found.look.organ.b}), 1.0, 1e-6);
    EXPECT_EQ(found.look.vignette, 0) << "the picture fills its frame";
    EXPECT_EQ(found.look.haze, look_of(Tissue{}).haze) << "no veil is seen";
    EXPECT_TRUE(notes_contain(found, "No veil"));
    EXPECT_TRUE(notes_contain(found, "No blood"));
}

TEST(SceneLook, WhatIsAlikeStaysAsItIs) {
    const Tissue tissue{.exposure = 1.2, .vignette = 1, .light = {1.0, 0.95, 0.9}, .organ = {0.9, 1.0, 0.95}};
    const LookProposal found = propose_look(tissue.image(), tissue.image(), look_of(tissue));
    ASSERT_TRUE(found.possible);
    EXPECT_EQ(found.look.vignette, 1);
    expect_near(product(found.look), product(look_of(tissue)), 0.16, "product");  // the video's own fall-off counts
}

TEST(SceneLook, WithoutHighlightsTheLampKeepsItsColour) {
    const Tissue truth{.organ = {1.0, 0.7, 0.7}, .highlights = false};
    const Tissue ours{.light = {1.0, 0.97, 0.92}, .highlights = false};
    const LookProposal found = propose_look(truth.image(), ours.image(), look_of(ours));
    ASSERT_TRUE(found.possible);
    expect_near(linear(found.look.light), linear(ours.light), 0.02, "lamp");
    expect_near(product(found.look), product(look_of(truth)), 0.06, "product");
    EXPECT_TRUE(notes_contain(found, "without clear highlights"));
}

TEST(SceneLook, TheRoundViewIsFoundAndBarsAreNone) {
    const Tissue round{.vignette = 1};
    EXPECT_EQ(propose_look(round.image(), Tissue{}.image(), look_of(Tissue{})).look.vignette, 1);
    Image bars = Tissue{}.image();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (y < 30 || y >= height - 30) std::fill_n(bars.pixels.begin() + 4 * (y * width + x), 3, std::uint8_t{0});
    const LookProposal found = propose_look(bars, Tissue{.vignette = 1}.image(), look_of(Tissue{.vignette = 1}));
    EXPECT_EQ(found.look.vignette, 0);
    EXPECT_TRUE(notes_contain(found, "No round view"));
}

TEST(SceneLook, BloodAndHazeTakeTheirHueWhereTheyAreSeen) {
    const Tissue bloody{.blood = true};
    const LookProposal blood = propose_look(bloody.image(), Tissue{}.image(), look_of(Tissue{}));
    ASSERT_TRUE(blood.possible);
    EXPECT_TRUE(notes_contain(blood, "Blood takes"));
    const Vec thin = linear(blood.look.blood_thin);
    EXPECT_NEAR(thin.g / thin.r, 0.004 / 0.12, 0.02);
    const auto bright = [](const Vec& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
    EXPECT_NEAR(bright(thin), bright(linear(look_of(Tissue{}).blood_thin)), 0.01) << "as bright as before";
    const Tissue hazy{.veil = 0.9, .veil_light = {0.25, 0.28, 0.33}};
    const LookProposal haze = propose_look(hazy.image(), Tissue{}.image(), look_of(Tissue{}));
    EXPECT_TRUE(notes_contain(haze, "Haze takes"));
    EXPECT_GT(haze.look.haze.b, haze.look.haze.r) << "bluish, as the veil is";
}

/// The right part of the picture shows no organ, but the dark cavity beside it.
Image beside_cavity(Image image, cv::Mat& organ) {
    organ = cv::Mat(height / 4, width / 4, CV_8U, cv::Scalar(255));
    organ.colRange(width / 8, width / 4).setTo(0);
    for (int y = 0; y < height; ++y)
        for (int x = width / 2; x < width; ++x) {
            std::uint8_t* const pixel = image.pixels.data() + 4 * (y * width + x);
            pixel[0] = 24, pixel[1] = 6, pixel[2] = 6;
        }
    return image;
}

TEST(SceneLook, TheCavityBesideTheOrganIsNoTissue) {
    const Tissue truth{.exposure = 1.6, .organ = {1.0, 0.8, 0.9}};
    cv::Mat organ;
    const Image ours = beside_cavity(Tissue{}.image(), organ);
    const LookProposal found = propose_look(truth.image(), ours, look_of(Tissue{}), organ);
    ASSERT_TRUE(found.possible);
    expect_near(product(found.look), product(look_of(truth)), 0.06, "product");
    const LookProposal taken_for_tissue = propose_look(truth.image(), ours, look_of(Tissue{}));
    EXPECT_GT(taken_for_tissue.look.exposure, 1.3 * found.look.exposure) << "what the mask is for";
    EXPECT_FALSE(propose_look(truth.image(), ours, look_of(Tissue{}), cv::Mat::zeros(64, 80, CV_8U)).possible);
}

TEST(SceneLook, NothingIsOverexposedThatIsNotInTheVideo) {
    // A dark organ with bright folds: as bright as the video on average, the folds would be white.
    const Tissue truth{.exposure = 2.2, .highlights = false};
    Image ours = Tissue{.exposure = 0.12, .highlights = false}.image();
    const Image bright = Tissue{.exposure = 1.0, .highlights = false}.image();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (x % 32 < 2)
                std::copy_n(bright.pixels.begin() + 4 * (y * width + x), 4, ours.pixels.begin() + 4 * (y * width + x));
    const SceneLook now = look_of(Tissue{.exposure = 0.12});
    const LookProposal found = propose_look(truth.image(), ours, now);
    ASSERT_TRUE(found.possible);
    EXPECT_TRUE(notes_contain(found, "bleach"));
    const double fold = 0.30 * 1.2 * found.look.exposure / 0.12;
    EXPECT_LT(fold, 1.05) << "in the light of its brightest channel";
    EXPECT_GT(fold, 0.5) << "and no darker than that";
}

TEST(SceneLook, BloodAndHazeAreNotBleachedByMoreExposure) {
    const Tissue dim{.exposure = 1.0}, truth{.exposure = 6.0, .highlights = false};
    const LookProposal found = propose_look(truth.image(), dim.image(), look_of(dim));
    ASSERT_TRUE(found.possible);
    EXPECT_GT(found.look.exposure, 1.5);
    const auto shown = [](const SceneLook& look, const Vec& color) {
        const Vec light = linear(color) * linear(look.light) * look.exposure;
        return std::max({light.r, light.g, light.b});
    };
    EXPECT_LE(shown(found.look, found.look.blood_thin), 0.46);
    EXPECT_LE(shown(found.look, found.look.haze), 0.71);
    EXPECT_TRUE(notes_contain(found, "overexposed"));
    SceneLook pale = look_of(dim);
    pale.haze = {0.9, 0.9, 0.9};
    const SceneLook as_pale = propose_look(dim.image(), dim.image(), pale).look;
    EXPECT_NEAR(shown(as_pale, as_pale.haze), shown(pale, pale.haze), 0.03) << "what was as bright before stays";
}

TEST(SceneLook, ABlackPictureProposesNothing) {
    Image black{.width = 64, .height = 48, .pixels = std::vector<std::uint8_t>(64 * 48 * 4, 0), .name = ""};
    const SceneLook now = look_of(Tissue{});
    LookProposal found = propose_look(black, Tissue{}.image(), now);
    EXPECT_FALSE(found.possible);
    EXPECT_EQ(found.look.exposure, now.exposure);
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_EQ(found.notes[0], "This frame of the reference is black.");
    found = propose_look(Tissue{}.image(), black, now);
    EXPECT_FALSE(found.possible);
    EXPECT_EQ(found.notes[0], "The preview is black: light the organ first.");
    EXPECT_FALSE(propose_look({}, Tissue{}.image(), now).possible);
}

TEST(SceneLook, IsPutIntoSceneAndPreset) {
    Scene scene;
    Preset preset;
    SceneLook look = match::look_of(scene, preset);
    EXPECT_EQ(look.exposure, scene.camera.exposure);
    look.vignette = 0, look.exposure = 1.23456789, look.light = {1, 0.5, 0.25}, look.haze = {0.2, 0.4, 0.6};
    put_look(look, scene, preset);
    EXPECT_EQ(scene.camera.vignette, 0);
    EXPECT_EQ(scene.camera.exposure, 1.2346);
    EXPECT_NEAR(scene.light.color.g, 0.5, 1.0 / 255);
    EXPECT_EQ(preset.smoke.haze.color.b, 0.6);
    EXPECT_EQ(preset.bleeding.color_thin, Preset{}.bleeding.color_thin) << "what did not change is not rounded away";
}

}  // namespace
}  // namespace lapfx::match
