// Suggested keying for smoke of known opacity, and for clips that keying is not made for.
#include "lapfx/authoring/suggest.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <opencv2/imgcodecs.hpp>

#include "lapfx/preset.h"
#include "smoke/keying_pixel.h"
#include "smoke/keying_survey.h"
#include "support/clips.h"
#include "support/folders.h"
#include "support/known_smoke.h"
#include "unit/organ/fixtures.h"
#include "unit/preset/support.h"

namespace lapfx::smoke {
namespace {

using testing::HasSubstr;

constexpr glm::vec3 black(0.0f), green(0.0f, 177.0f, 64.0f), blue(20.0f, 60.0f, 200.0f), grey(96.0f);

std::vector<cv::Mat> keyed(const std::vector<cv::Mat>& frames, const KeyingSuggestion& s) {
    const Keying key = keying_of(s.keying, s.polarity);
    std::vector<cv::Mat> alphas;
    for (const cv::Mat& frame : frames) {
        cv::Mat& alpha = alphas.emplace_back(frame.size(), CV_32F);
        frame.forEach<cv::Vec3b>([&](const cv::Vec3b& c, const int* at) {
            alpha.at<float>(at[0], at[1]) = key_alpha({c[0], c[1], c[2]}, key);
        });
    }
    return alphas;
}

using Smoke = std::vector<clips::Picture>;

/// Solved once for all tests of a run: it takes seconds. The later pictures only, which have the more smoke.
const Smoke& shaded_plume() {
    static const Smoke smoke = [] {
        Smoke solved = test::solve_smoke({.cells = 32});
        solved.erase(solved.begin(), solved.begin() + 5);
        return solved;
    }();
    return smoke;
}
Smoke plume() {
    return test::evenly_lit(shaded_plume(), 1.0f);
}
Smoke thick_plume() {
    return test::evenly_lit(shaded_plume(), 0.7f, 6.0f);
}
/// Nobody can know how bright it would be if it were thick.
Smoke dim_plume() {
    return test::evenly_lit(shaded_plume(), 0.7f);
}
Smoke wisps() {
    return test::evenly_lit(shaded_plume(), 0.9f, 0.2f);
}

class SuggestFromFile : public testing::Test {
  protected:
    test::Folder folder;

    struct Result {
        KeyingSuggestion found;
        test::AlphaError error;
    };
    Result suggest(const std::vector<clips::Picture>& smoke, const test::Recording& how) {
        test::record_smoke(folder / "clip.mp4", smoke, how);
        const auto frames = test::read_frames(folder / "clip.mp4");
        EXPECT_EQ(frames.size(), smoke.size());
        Result result{suggest_keying(folder / "clip.mp4"), {}};
        result.error = test::alpha_error(keyed(frames, result.found), smoke);
        std::printf("    error %.4f over the frame, %.4f where there is smoke; %s\n", result.error.frame,
                    result.error.smoke, result.found.reason.c_str());
        return result;
    }
};

TEST_F(SuggestFromFile, EvenlyLitSmokeOnBlackIsKeyedTo3Percent) {
    // Dim smoke could also be thin: full smoke of brightness 0.7 and white smoke of opacity 0.7 are the same picture,
    // so nothing in it distinguishes them. 0.85 is used, 0.15 from either; a tighter bound for one is a looser bound
    // for the other.
    const Smoke dim = dim_plume(), thick = thick_plume();
    for (const Smoke& smoke : {plume(), thick, wisps(), dim})
        for (const float noise : {0.0f, 3.0f}) {
            const Result r = suggest(smoke, {.background = black, .sensor_noise = noise});
            EXPECT_LE(r.error.frame, 0.03);
            EXPECT_LE(r.error.smoke, smoke[0].value == dim[0].value || smoke[0].value == thick[0].value ? 0.12 : 0.04);
            EXPECT_EQ(r.found.polarity, ClipPolarity::light);
            EXPECT_EQ(r.found.keying.chroma_high, 0.0) << "black has no chroma to key by";
            EXPECT_GT(r.found.confidence, 0.5);
        }
}

TEST_F(SuggestFromFile, EvenlyLitSmokeOnGreenIsKeyedTo3Percent) {
    for (const Smoke& smoke : {plume(), thick_plume(), wisps(), dim_plume()})
        for (const float noise : {0.0f, 5.0f}) {
            const Result r = suggest(smoke, {.background = green, .sensor_noise = noise});
            EXPECT_LE(r.error.frame, 0.03);
            EXPECT_LE(r.error.smoke, 0.06);
            EXPECT_EQ(r.found.keying.spill, 1.0);
            EXPECT_LT(glm::distance(r.found.keying.key_color * 255.0, glm::dvec3(green)), 6.0);
            EXPECT_GT(r.found.confidence, 0.5);
        }
}

TEST_F(SuggestFromFile, ColouredAndGreyBackgroundsKeyLikeBlackAndGreen) {
    const Result on_blue = suggest(plume(), {.background = blue, .sensor_noise = 2.0f});
    EXPECT_LE(on_blue.error.smoke, 0.06);
    EXPECT_GT(on_blue.found.keying.chroma_high, 60.0);
    const Result on_grey = suggest(thick_plume(), {.background = grey, .sensor_noise = 2.0f});
    // White smoke of opacity 0.52 before this grey is the same picture as this smoke: 0.76 is used, 0.24 from either.
    EXPECT_LE(on_grey.error.smoke, 0.18);
    EXPECT_EQ(on_grey.found.polarity, ClipPolarity::light);
    EXPECT_GT(on_grey.found.keying.luma_low, luma(grey));
    // The same smoke is darker than white.
    const Result on_white = suggest(thick_plume(), {.background = glm::vec3(255.0f), .sensor_noise = 2.0f});
    EXPECT_LE(on_white.error.smoke, 0.04);
    EXPECT_EQ(on_white.found.polarity, ClipPolarity::dark);
}

TEST_F(SuggestFromFile, ShadedSmokeOnGreenIsKeyedAsWellAsLitSmoke) {
    const Result r = suggest(shaded_plume(), {.background = green, .sensor_noise = 3.0f});
    EXPECT_LE(r.error.smoke, 0.06) << "chroma does not mind shadows";
    // On black a shadow looks like thin smoke, whatever the thresholds: measured, not bounded.
    suggest(shaded_plume(), {.background = black, .sensor_noise = 3.0f});
}

TEST_F(SuggestFromFile, WhatIsNoClipIsAFault) {
    EXPECT_THAT(test::faults_of([&] { suggest_keying(folder / "none.mp4"); }),
                testing::ElementsAre((folder / "none.mp4").string() + ": no such file"));
    EXPECT_THAT(test::faults_of([&] { suggest_keying(folder.write("text.mp4", "words, and no video at all")); }),
                testing::SizeIs(1));
}

/// Pictures made in memory: colour of a pixel from its place and the picture's number.
KeyingSuggestion suggest_for(const std::function<glm::vec3(glm::ivec2, int)>& colour, int pictures = 8,
                             glm::ivec2 size = {96, 64}) {
    KeyingSurvey survey;
    for (int n = 0; n < pictures; ++n) {
        std::vector<std::uint8_t> rgb;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int c = 0; c < 3; ++c) rgb.push_back(static_cast<std::uint8_t>(std::lround(colour({x, y}, n)[c])));
        survey.add(size, rgb);
    }
    return survey.suggest();
}

/// Opacity of a soft ball that moves; with a `peak` over 1 its middle is opaque.
float ball(glm::ivec2 at, int picture, float peak) {
    const glm::vec2 middle(32.0f + 4.0f * static_cast<float>(picture), 32.0f);
    const float r = glm::distance(glm::vec2(at), middle) / 24.0f;
    return std::min(peak * std::max(1.0f - r * r, 0.0f), 1.0f);
}

/// Luma is opacity times brightness: smoke of one luma everywhere is dim and opaque, or bright and thin. The assumption
/// is between both, equally far from either.
TEST(SuggestKeying, SmokeOfOneLumaIsTakenForTheMiddleOfWhatItCanBe) {
    const auto smoke = [](float level, float base) {
        return suggest_for([=](glm::ivec2 at, int n) { return glm::vec3(base + (level - base) * ball(at, n, 3.0f)); });
    };
    for (const float base : {0.0f, 60.0f, 96.0f})
        for (const float level : {150.0f, 170.0f, 216.0f}) {
            const KeyingSuggestion s = smoke(level, base);
            const double least = static_cast<double>((level - base) / (255.0f - base));  // as bright as white
            EXPECT_TRUE(s.whole_smoke_seen);
            EXPECT_NEAR(s.least_opacity, least, 0.03) << base << ' ' << level;
            const float found = key_alpha(glm::vec3(level), keying_of(s.keying, s.polarity));
            EXPECT_NEAR(found, 0.5 * (1.0 + least), 0.03) << base << ' ' << level;
            EXPECT_THAT(s.reason, HasSubstr("dim or thin"));
        }
    // An opacity of .85 of the whitest smoke, which counted as 1.
    EXPECT_LT(key_alpha(glm::vec3(0.85f * 255.0f), keying_of(smoke(0.85f * 255.0f, 0.0f).keying, ClipPolarity::light)),
              0.94f);
}

TEST(SuggestKeying, ThinSmokeGivesTheAssumedLuma) {
    const KeyingSuggestion thin =
        suggest_for([](glm::ivec2 at, int n) { return glm::vec3(170.0f * ball(at, n, 0.6f)); });
    EXPECT_FALSE(thin.whole_smoke_seen);
    EXPECT_NEAR(thin.keying.luma_high, assumed_white, 4.0);
    EXPECT_THAT(thin.reason, HasSubstr("assumed"));
}

/// Smoke with clear strips at the left and the right: `share` of the picture.
KeyingSuggestion nearly_full(glm::vec3 background, float share) {
    const glm::ivec2 size(192, 128);
    return suggest_for(
        [=](glm::ivec2 at, int n) {
            const float margin = 0.5f * share * static_cast<float>(size.x);
            const float x = static_cast<float>(at.x), near = std::min(x, static_cast<float>(size.x) - x) - margin;
            const float wave = 0.5f + 0.5f * std::sin(0.11f * x + 0.7f * static_cast<float>(n)) *
                                          std::cos(0.09f * static_cast<float>(at.y) - 0.5f * static_cast<float>(n));
            return glm::mix(background, glm::vec3(225.0f),
                            glm::clamp(0.2f * near, 0.0f, 1.0f) * (0.35f + 0.65f * wave));
        },
        8, size);
}

TEST(SuggestKeying, ABackgroundThatHardlyShowsIsFound) {
    for (const glm::vec3 background : {black, green, blue, grey}) {
        const KeyingSuggestion s = nearly_full(background, 0.1f);
        EXPECT_LT(s.background_share, 0.1);
        EXPECT_LT(glm::distance(s.keying.key_color * 255.0, glm::dvec3(background)), 6.0) << background.x << s.reason;
        const Keying key = keying_of(s.keying, s.polarity);
        EXPECT_LT(key_alpha(background, key), 0.03f);
        EXPECT_NEAR(key_alpha(glm::mix(background, glm::vec3(225.0f), 0.5f), key), 0.5f, 0.12f);
    }
}

/// A ball before `background` that drifts through bars at the top and the bottom.
KeyingSuggestion barred(glm::vec3 background, int bar) {
    const glm::ivec2 size(160, 128);
    return suggest_for(
        [=](glm::ivec2 at, int n) {
            if (at.y < bar || at.y >= size.y - bar) return black;
            const glm::vec2 middle(40.0f + 10.0f * static_cast<float>(n), 20.0f + 11.0f * static_cast<float>(n));
            const float r = glm::distance(glm::vec2(at), middle) / 45.0f;
            return glm::mix(background, glm::vec3(220.0f), 0.8f * std::max(1.0f - r * r, 0.0f));
        },
        8, size);
}

TEST(SuggestKeying, BarsAreCroppedAndSmokeAtEdgesFades) {
    for (const glm::vec3 background : {black, green}) {
        const KeyingSuggestion s = barred(background, 12);
        EXPECT_NEAR(s.crop.top * 128.0, 13.5, 1.6) << s.reason;
        EXPECT_NEAR(s.crop.bottom * 128.0, 13.5, 1.6);
        EXPECT_EQ(s.crop.left, 0.0);
        EXPECT_EQ(s.crop.right, 0.0);
        EXPECT_GT(s.edge_fade, 0.0) << "smoke ends at the bars";
        EXPECT_THAT(s.reason, HasSubstr("bars at the picture's edges are cropped"));
        EXPECT_LT(glm::distance(s.keying.key_color * 255.0, glm::dvec3(background)), 6.0) << "bars are no background";
        const KeyingSuggestion without = barred(background, 0);
        EXPECT_EQ(without.crop, ClipCrop{}) << without.reason;
    }
    // A strip below the source of the smoke stays clean; it has the colour of the background, and smoke begins
    // suddenly.
    const KeyingSuggestion above_a_strip = suggest_for(
        [](glm::ivec2 at, int n) {
            const float across =
                std::abs(static_cast<float>(at.x - 80)) / (10.0f + 0.1f * static_cast<float>(118 - at.y));
            return at.y >= 118 || across > 1.0f ? black
                                                : glm::vec3(150.0f + 20.0f * static_cast<float>((at.y / 8 + n) % 3));
        },
        8, {160, 128});
    EXPECT_EQ(above_a_strip.crop, ClipCrop{}) << above_a_strip.reason;
    // Smoke that does not reach the edges.
    const KeyingSuggestion away =
        suggest_for([](glm::ivec2 at, int n) { return glm::vec3(200.0f * ball(at, n, 0.8f)); }, 8, {120, 110});
    EXPECT_EQ(away.crop, ClipCrop{}) << away.reason;
    EXPECT_EQ(away.edge_fade, 0.0);
}

TEST(SuggestKeying, TheLowerThresholdFollowsTheNoise) {
    const auto with_noise = [](int spread) {
        return suggest_for([=](glm::ivec2 at, int n) {
            const float noise = static_cast<float>((at.x * 7 + at.y * 13 + n * 5) % (2 * spread + 1) - spread);
            return glm::vec3(60.0f + noise + 150.0f * ball(at, n, 3.0f));
        });
    };
    for (const int spread : {2, 6, 12}) {
        const KeyingSuggestion s = with_noise(spread);
        EXPECT_NEAR(s.keying.luma_low, 60.0 + spread, 1.5) << spread;
        EXPECT_NEAR(s.background_noise, spread, 1.5) << spread;
    }
}

TEST(SuggestKeying, AKeyColourIsKeyedByChromaUpToGrey) {
    const KeyingSuggestion s =
        suggest_for([](glm::ivec2 at, int n) { return glm::mix(green, glm::vec3(150.0f), ball(at, n, 0.5f)); });
    EXPECT_NEAR(s.keying.chroma_high, glm::length(chroma(green)), 2.0) << "though no whole smoke is there to be seen";
    EXPECT_NEAR(key_alpha(glm::mix(green, glm::vec3(80.0f), 0.5f), keying_of(s.keying, s.polarity)), 0.5f, 0.02f);
    EXPECT_NEAR(key_alpha(glm::mix(green, glm::vec3(230.0f), 0.5f), keying_of(s.keying, s.polarity)), 0.5f, 0.02f);
}

TEST(SuggestKeying, AMarkThatNeverMovesIsToldAndDoesNotCount) {
    const auto marked = [](bool mark) {
        return suggest_for([=](glm::ivec2 at, int n) {
            const bool in_mark = at.x >= 80 && at.x < 88 && at.y >= 48 && at.y < 56;
            return glm::vec3(mark && in_mark ? 255.0f : 150.0f * ball(at, n, 3.0f));
        });
    };
    EXPECT_THAT(marked(true).reason, HasSubstr("a mark that never moves"));
    EXPECT_THAT(marked(false).reason, testing::Not(HasSubstr("mark")));
    EXPECT_EQ(marked(true).keying.luma_high, marked(false).keying.luma_high);
    ASSERT_EQ(marked(true).masks.size(), 1u);
    const ClipMask mask = marked(true).masks[0];
    EXPECT_LE(mask.x * 96.0, 80.0);
    EXPECT_GE((mask.x + mask.width) * 96.0, 88.0);
    EXPECT_LE(mask.y * 64.0, 48.0);
    EXPECT_GE((mask.y + mask.height) * 64.0, 56.0);
    EXPECT_LT(mask.width * mask.height, 0.1);
    EXPECT_TRUE(marked(false).masks.empty());
}

TEST(SuggestKeying, ASuggestionGoesIntoItsClipAlone) {
    SmokeClip clip;
    clip.keying.choke = 3.0;
    clip.masks = {{0.1, 0.2, 0.3, 0.4}};
    KeyingSuggestion found;
    found.keying.luma_high = 150.0;
    found.polarity = ClipPolarity::dark;
    found.crop.top = 0.1;
    found.masks = {{0.0, 0.0, 0.1, 0.1}};
    found.edge_fade = 0.06;
    found.apply(clip);
    EXPECT_TRUE(clip.own_keying);
    EXPECT_EQ(clip.keying.luma_high, 150.0);
    EXPECT_EQ(clip.keying.choke, 3.0) << "not suggested";
    EXPECT_EQ(clip.polarity, ClipPolarity::dark);
    EXPECT_EQ(clip.crop.top, 0.1);
    ASSERT_EQ(clip.masks.size(), 2u);
    EXPECT_EQ(clip.masks[0].x, 0.1) << "drawn by a person";
    EXPECT_EQ(clip.masks[1].x, 0.0);
    EXPECT_EQ(clip.edge_fade, 0.06);
    found.apply(clip);
    EXPECT_EQ(clip.masks.size(), 2u) << "the same once more";
    SmokeClip haze{.file = "h.mp4", .role = ClipRole::haze};
    found.apply(haze);
    EXPECT_EQ(haze.edge_fade, 0.0) << "the view has no edge within it";
}

TEST(SuggestKeying, WhatIsNotSmokeBeforeAPlainBackgroundGivesNoConfidence) {
    const auto gradient = [](glm::ivec2 at, int) {
        return glm::vec3(2.6f * static_cast<float>(at.x), 3.9f * static_cast<float>(at.y), 90.0f);
    };
    EXPECT_LT(suggest_for(gradient).confidence, 0.3);
    EXPECT_THAT(suggest_for(gradient).reason, HasSubstr("no plain background"));
    const auto red_balls = [](glm::ivec2 at, int n) { return glm::vec3(220, 30, 20) * ball(at, n, 3.0f); };
    EXPECT_THAT(suggest_for(red_balls).reason, HasSubstr("colours that smoke does not have"));
    EXPECT_LT(suggest_for(red_balls).confidence, 0.5);
    const auto checks = [](glm::ivec2 at, int n) {
        return glm::vec3((at.x + n) % 4 < 2 && at.y > 40 && at.x > 30 && at.x < 60 ? 220.0f : 0.0f);
    };
    EXPECT_THAT(suggest_for(checks).reason, HasSubstr("hard edges"));
    const auto both = [](glm::ivec2 at, int n) {
        return glm::vec3(120.0f + (at.x < 48 ? 80.0f : -80.0f) * ball(at, n, 1.0f));
    };
    EXPECT_THAT(suggest_for(both).reason, HasSubstr("both lighter and darker"));
    EXPECT_THAT(suggest_for([](glm::ivec2, int) { return green; }).reason, HasSubstr("hardly differs"));
}

TEST(SuggestKeying, HazeThatFillsTheViewIsTakenToBeBeforeBlack) {
    const KeyingSuggestion s = suggest_for([](glm::ivec2 at, int n) {
        return glm::vec3(80.0f + 20.0f * std::sin(0.1f * static_cast<float>(at.x + 3 * n)) +
                         20.0f * std::cos(0.08f * static_cast<float>(at.y)));
    });
    EXPECT_EQ(s.keying.luma_low, 0.0);
    EXPECT_EQ(s.keying.key_color, glm::dvec3(0.0));
    EXPECT_LT(s.confidence, 0.5);
    EXPECT_THAT(s.reason, HasSubstr("black is assumed"));
}

TEST(SuggestKeying, AnySizeAndNumberOfPicturesGivesKeyingInRange) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 9}, {9, 1}, {7, 7}, {17, 3}, {700, 8}})
        for (const int pictures : {0, 1, 2, 24}) {
            Preset preset;
            const KeyingSuggestion s =
                suggest_for([](glm::ivec2 at,
                               int n) { return glm::vec3(static_cast<float>((at.x * 37 + at.y * 91 + n * 11) % 256)); },
                            pictures, size);
            preset.smoke.keying = s.keying;
            EXPECT_TRUE(check(preset_table(), &preset).empty()) << size.x << "x" << size.y;
            EXPECT_GE(s.confidence, 0.0);
            EXPECT_FALSE(s.reason.empty());
        }
}

TEST(SuggestKeying, RealClipsAreToldFromWhatKeyingIsNotFor) {
    const std::filesystem::path data = test::data_folder() / "smoke";
    if (!std::filesystem::is_directory(data)) GTEST_SKIP() << "no folder of real clips";
    const KeyingSuggestion smoke_mov = suggest_keying(data / "Lordan_Film/smoke.mov");
    for (const auto& [clip, s] :
         {std::pair("three-parallax2", suggest_keying(data / "three-parallax2/public/assets/smoke.mp4")),
          std::pair("smoke-effect", suggest_keying(data / "smoke-effect/smoke.mp4")),
          std::pair("Lordan_Film", smoke_mov)}) {
        EXPECT_GT(s.confidence, 0.5) << clip << ": " << s.reason;
        EXPECT_LT(s.keying.luma_low, 6.0) << clip;
        EXPECT_GT(s.keying.luma_high, 200.0) << clip;
        EXPECT_GT(s.background_share, 0.8) << clip;
    }
    EXPECT_THAT(smoke_mov.reason, HasSubstr("a mark that never moves"));
    const KeyingSuggestion forest = suggest_keying(data / "forestfire-smoke/smoke.mp4");
    EXPECT_THAT(forest.reason, HasSubstr("no plain background"));
    EXPECT_LT(forest.confidence, 0.5);
    for (const char* clip : {"fire-smoke-video-augmentation/prep_real_fire_smoke_vid/smoke-2.webm",
                             "fire-smoke-video-augmentation/prep_fire_vid/fire-1.webm"})
        EXPECT_LT(suggest_keying(data / clip).confidence, 0.5) << clip;
}

class SuggestUse : public testing::Test {
  protected:
    test::Folder folder;
    UseSuggestion used(const std::filesystem::path& file) {
        const UseSuggestion found = suggest_use(file);
        EXPECT_FALSE(found.reason.empty());
        return found;
    }
};

TEST_F(SuggestUse, SmokeBeforeAPlainBackgroundIsAClip) {
    for (const cv::Vec3d& background : {cv::Vec3d(0, 0, 0), cv::Vec3d(40, 170, 30), cv::Vec3d(200, 60, 20)}) {
        const UseSuggestion found = used(test::write_smoke(folder / "smoke.avi", background));
        EXPECT_EQ(found.use, VideoUse::smoke) << background << found.reason;
        EXPECT_TRUE(found.sure) << background << found.reason;
    }
    const UseSuggestion white = used(test::write_seen(folder / "soot.avi", [](cv::Point2d at, int frame) {
        const double away = cv::norm(at - cv::Point2d(48, 60 - 3 * frame)) / 14;
        return cv::Vec3d::all(250 - 200 * std::exp(-away * away));
    }));
    EXPECT_EQ(white.use, VideoUse::smoke) << white.reason;
    EXPECT_TRUE(white.sure) << white.reason;
    for (const char* name : {"plume_thick.mp4", "wisps_thin.mp4", "plume_green.mp4"}) {
        const UseSuggestion found = used(test::source_folder() / "samples/clips" / name);
        EXPECT_EQ(found.use, VideoUse::smoke) << name << found.reason;
        EXPECT_TRUE(found.sure) << name << found.reason;
    }
}

TEST_F(SuggestUse, OpacityOfItsOwnIsAClipWhateverItShows) {
    cv::Mat image(64, 96, CV_8UC4, cv::Scalar(20, 30, 220, 255));
    image(cv::Rect(20, 20, 30, 30)) = cv::Scalar(200, 200, 200, 160);
    ASSERT_TRUE(cv::imwrite((folder / "own.png").string(), image));
    const UseSuggestion found = used(folder / "own.png");
    EXPECT_EQ(found.use, VideoUse::smoke);
    EXPECT_TRUE(found.sure);
    EXPECT_THAT(found.reason, HasSubstr("its own opacity"));
}

TEST_F(SuggestUse, TissueAllOverIsAReferenceAlsoInsideASurround) {
    const auto tissue = [](cv::Point2d at, int frame) {
        return cv::Vec3d(60, 70, 190) * (0.75 + 0.25 * std::sin(0.3 * at.x + 0.4 * frame) * std::cos(0.23 * at.y));
    };
    const auto hazy = [&](cv::Point2d at, int frame) {
        return tissue(at, frame) * 0.5 + cv::Vec3d(180, 180, 180) * 0.5;
    };
    const std::filesystem::path seen[] = {
        test::write_surgery(folder / "round.avi"), test::write_seen(folder / "whole.avi", tissue),
        test::write_seen(folder / "hazy.avi", hazy), test::source_folder() / "samples/reference/operation.mp4"};
    for (const std::filesystem::path& file : seen) {
        const UseSuggestion found = used(file);
        EXPECT_EQ(found.use, VideoUse::reference) << file << found.reason;
        EXPECT_TRUE(found.sure) << file << found.reason;
    }
}

TEST_F(SuggestUse, WhatIsNeitherIsNotSureAndTheLikelierIsSaid) {
    const UseSuggestion haze = used(test::source_folder() / "samples/clips/haze_rolling.mp4");
    EXPECT_EQ(haze.use, VideoUse::smoke);
    EXPECT_FALSE(haze.sure) << haze.reason;
    const UseSuggestion flat = used(test::write_clip(folder / "flat.avi", 10));
    EXPECT_FALSE(flat.sure) << flat.reason;
    // Of a room: neither tissue nor strong colours, and hard edges.
    const UseSuggestion room = used(test::write_seen(folder / "room.avi", [](cv::Point2d at, int frame) {
        const bool tile = (static_cast<int>(at.x) / 5 + static_cast<int>(at.y) / 5 + frame) % 2 == 0;
        return tile ? cv::Vec3d(150, 140, 120) : cv::Vec3d(60, 70, 80) + cv::Vec3d::all(at.x);
    }));
    EXPECT_EQ(room.use, VideoUse::reference) << room.reason;
    EXPECT_FALSE(room.sure) << room.reason;
    const UseSuggestion flame = used(test::write_seen(folder / "flame.avi", [](cv::Point2d at, int frame) {
        const double away = cv::norm(at - cv::Point2d(48, 50 - 2 * frame)) / 8;
        return cv::Vec3d(20, 120, 250) * std::exp(-away * away);
    }));
    EXPECT_EQ(flame.use, VideoUse::smoke) << flame.reason;
    EXPECT_FALSE(flame.sure) << flame.reason;
}

TEST_F(SuggestUse, AVideoWithoutAFrameThatCanBeReadIsAFault) {
    const std::filesystem::path file = folder / "blank.avi";
    {
        // More than are looked at, so that the first is not.
        cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20,
                               {96, 72});
        ASSERT_TRUE(writer.isOpened());
        for (int i = 0; i < 40; ++i) writer.write(cv::Mat(72, 96, CV_8UC3, cv::Scalar(60, 70, 150 + i)));
    }
    std::string bytes;
    {
        std::ifstream in(file, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    // Each frame is a chunk with its length; what is in it goes, but for that of the first, with which it opens.
    std::size_t frames = 0;
    for (std::size_t at = bytes.find("movi"); (at = bytes.find("00dc", at)) != std::string::npos; ++frames) {
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + at + 4, sizeof length);
        if (at + 8 + length > bytes.size()) break;
        if (frames > 0) std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at) + 8, length, '\0');
        at += 8 + length;
    }
    ASSERT_GT(frames, 3U);
    std::ofstream(file, std::ios::binary) << bytes;
    try {
        const UseSuggestion found = suggest_use(file);
        FAIL() << "it says " << (found.use == VideoUse::smoke ? "smoke: " : "reference: ") << found.reason;
    } catch (const Error& error) {
        ASSERT_EQ(error.faults().size(), 1U);
        EXPECT_EQ(error.faults()[0].text(), file.string() + ": not one of its pictures can be read");
    }
}

TEST_F(SuggestUse, WhatIsNoVideoIsAFault) {
    std::ofstream(folder / "words.mp4") << "words";
    EXPECT_THROW(suggest_use(folder / "words.mp4"), Error);
    const std::atomic<bool> stop = true;
    EXPECT_THROW(suggest_use(test::write_surgery(folder / "stopped.avi"), &stop), Error);
}

}  // namespace
}  // namespace lapfx::smoke
