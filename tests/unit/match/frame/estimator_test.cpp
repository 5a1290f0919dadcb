#include "match/frame/estimator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "match/frame/smoke_tint.h"
#include "unit/match/clips.h"
#include "unit/preset/support.h"

namespace lapfx::match {
namespace {

// Of the mean veil: painted tissue is none of the renders that its model was learned from, of which it is off by 0.05.
constexpr double off_by_model = 0.06;

/// Tells the mean of the map.
std::shared_ptr<const VeilModel> map_alone() {
    nlohmann::json model = nlohmann::json::parse(VeilModel::shipped().json());
    for (auto& weight : model["with_map"]["weights"]) weight = 0.0;     // nothing is added to the map
    for (auto& weight : model["without_map"]["weights"]) weight = 1e6;  // nor is there a most
    return std::make_shared<const VeilModel>(VeilModel::read(model.dump(), "map alone"));
}

cv::Mat even(double veil) {
    return {test::height, test::width, CV_32F, cv::Scalar(veil)};
}

TEST(Estimator, MeasuresBloodAndSmokeTogether) {
    const cv::Mat clear = test::tissue();
    cv::Mat bloody = clear.clone();
    constexpr int radius = 40;
    test::bleed(bloody, {150, 130}, radius);
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>(), .veil_model = map_alone()}),
        shipped(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
    for (const double veil : {0.0, 0.2, 0.5}) {
        const Image picture = test::image_of(test::veiled(bloody, even(veil), test::light_of({})));
        const FrameAmounts a = estimator.measure(picture, 0);
        EXPECT_NEAR(a.veil.value, veil, 0.03) << veil;
        EXPECT_NEAR(shipped.measure(picture, 0).veil.value, veil, off_by_model) << veil;
        EXPECT_NEAR(a.blood.value, 3.14159 * radius * radius / (test::width * test::height), 0.015) << veil;
        EXPECT_TRUE(a.measurable());
        EXPECT_EQ(a.blood_measurable(), veil < dense_veil) << veil;
        EXPECT_LE(a.veil.low, a.veil.value);
        EXPECT_GE(a.veil.high, a.veil.value);
    }
}

TEST(Estimator, TissueOfAStillViewThatIsLittleAlikeIsCovered) {
    const cv::Mat clear = test::tissue();
    cv::Mat bloody = clear.clone();
    const cv::Rect pool(0, test::height / 4, test::width, test::height - test::height / 4);
    bloody(pool) = cv::Scalar(0.015, 0.012, 0.16);  // level: nothing of the tissue shows
    const Image picture = test::image_of(test::veiled(bloody, even(0.2), test::light_of({})));
    const auto told = [&](bool still) {
        return Estimator(test::image_of(clear), {.still = still, .survey = std::make_shared<const Survey>()})
            .measure(picture, 0)
            .blood.value;
    };
    EXPECT_NEAR(told(true), 0.75, 0.1);
    EXPECT_LT(told(false), 0.1) << "tissue that may have moved is sure of nothing here";
}

TEST(Estimator, LearnsTheLightOfTheSmoke) {
    const HazeLight truth{.color = {0.40, 0.37, 0.42}, .fall_off = 0.25};
    const cv::Mat clear = test::tissue();
    Estimator estimator(test::image_of(clear), {.veil_model = map_alone()});
    const Image smoky = test::image_of(test::veiled(clear, test::ramp(0.1, 0.7), test::light_of(truth)));
    estimator.survey(smoky);
    EXPECT_NEAR(estimator.surveyed()->light.color.r, truth.color.r, 0.15 * truth.color.r);
    EXPECT_NEAR(estimator.measure(smoky, 0).veil.value, 0.4, 0.04);
}

TEST(Estimator, OfTheSameFramesGivesTheSameAmounts) {
    const cv::Mat clear = test::tissue();
    const Image smoky = test::image_of(test::veiled(clear, test::ramp(0, 0.6), test::light_of({})));
    std::vector<FrameAmounts> found;
    for (int i = 0; i < 2; ++i) {
        Estimator estimator(test::image_of(clear), {});
        estimator.survey(smoky);
        found.push_back(estimator.measure(smoky, 1));
    }
    EXPECT_EQ(found[0].veil.value, found[1].veil.value);
    EXPECT_EQ(found[0].blood.value, found[1].blood.value);
    EXPECT_EQ(found[0].likeness, found[1].likeness);
}

TEST(Estimator, LeavesOutRegionMasksAndInstruments) {
    const cv::Mat clear = test::tissue();
    cv::Mat bloody = clear.clone();
    test::bleed(bloody, {60, 60}, 30);
    const MaskPolygon corner{{0, 0}, {0.4, 0}, {0.4, 0.5}, {0, 0.5}};
    Estimator masked(test::image_of(clear), {.masks = {corner}});
    EXPECT_LT(masked.measure(test::image_of(bloody), 0).blood.value, 0.002);
    Estimator regional(test::image_of(clear), {.region = {0.5, 0, 0.5, 1}});
    const FrameAmounts a = regional.measure(test::image_of(bloody), 0);
    EXPECT_EQ(a.blood.value, 0);
    EXPECT_NEAR(a.valid, 0.5, 0.03);
}

cv::Mat evenly(const cv::Vec3f& color) {
    return {test::height, test::width, CV_32FC3, cv::Scalar(color)};
}

/// In a round view with a black surround.
cv::Mat round(const cv::Mat& picture) {
    cv::Mat made = evenly({0, 0, 0}), disc = cv::Mat::zeros(picture.size(), CV_8U);
    cv::circle(disc, {test::width / 2, test::height / 2}, 105, 255, cv::FILLED);
    picture.copyTo(made, disc);
    return made;
}

TEST(Estimator, TakesDenseSmokeForNoInstrument) {
    const cv::Mat clear = 0.5 * test::tissue();
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
    const double all = estimator.measure(test::image_of(clear), 0).valid;
    const HazeLight another{.color = {0.31, 0.40, 0.42}};  // brighter than it is taken for, and of another tint
    const FrameAmounts a =
        estimator.measure(test::image_of(test::veiled(clear, even(0.7), test::light_of(another))), 1);
    EXPECT_GT(a.valid, 0.95 * all);
    cv::Mat held = clear.clone();
    constexpr int width_of_shaft = 40;
    held(cv::Rect(0, 100, test::width, width_of_shaft)) = cv::Scalar(0.16, 0.16, 0.16);
    EXPECT_LT(estimator.measure(test::image_of(held), 2).valid, all - 0.9 * width_of_shaft / test::height);
}

/// White letters over all of a dark picture.
cv::Mat title_card() {
    cv::Mat card = evenly({0.02F, 0.02F, 0.02F});
    for (int y = 24; y < test::height; y += 24)
        cv::putText(card, "Case 4: gastric banding", {2, y}, cv::FONT_HERSHEY_SIMPLEX, 0.8, {0.8, 0.8, 0.8}, 2);
    return card;
}

TEST(Estimator, TellsWhatCannotBeMeasured) {
    const cv::Mat clear = test::tissue();
    Estimator estimator(test::image_of(clear), {.veil_model = map_alone()});
    EXPECT_TRUE(estimator.measure(test::image_of(evenly({0, 0, 0})), 0).flags & told::dark);
    estimator.measure(test::image_of(clear), 1);
    const FrameAmounts a = estimator.measure(test::image_of(test::bag()), 2);
    EXPECT_EQ(a.flags, told::cut | told::bag);
    EXPECT_FALSE(a.measurable());
    Estimator shipped(test::image_of(clear), {});
    shipped.measure(test::image_of(clear), 1);
    const FrameAmounts same = shipped.measure(test::image_of(test::bag()), 2);
    EXPECT_EQ(same.flags, a.flags);
    EXPECT_LT(same.veil.value, a.veil.value) << "the statistics limit what a map without the tissue tells";
    EXPECT_GT(a.veil.value, dense_veil);
    EXPECT_FALSE(a.flags & told::dense) << "nobody knows what is before the tissue";
}

TEST(Estimator, TellsACutWhereTheViewIsAnother) {
    Estimator estimator(test::image_of(test::tissue()), {});
    const auto cut = [&](const cv::Mat& frame) {
        return (estimator.measure(test::image_of(frame), 0).flags & told::cut) != 0;
    };
    EXPECT_FALSE(cut(test::tissue())) << "the first frame follows none";
    EXPECT_TRUE(cut(test::bag()));
    EXPECT_FALSE(cut(test::bag()));
    EXPECT_TRUE(cut(test::tissue(2)));
    EXPECT_TRUE(cut(test::tissue()));
    EXPECT_FALSE(cut(test::tissue()));
}

TEST(Estimator, TellsNoCutAroundPlainFrames) {
    Estimator estimator(test::image_of(test::tissue()), {});
    const cv::Mat dense(test::height, test::width, CV_32F, cv::Scalar(0.97));
    for (const cv::Mat& plain :
         {evenly({0, 0, 0}), evenly({0.95F, 0.95F, 0.95F}), test::veiled(test::tissue(), dense, test::light_of({}))}) {
        EXPECT_FALSE(estimator.measure(test::image_of(test::tissue()), 0).flags & told::cut);
        EXPECT_FALSE(estimator.measure(test::image_of(plain), 1).flags & told::cut);
        EXPECT_FALSE(estimator.measure(test::image_of(test::tissue()), 2).flags & told::cut);
    }
}

TEST(Estimator, TellsNoCutWhereTheCameraPans) {
    cv::Mat wide;
    const std::vector<cv::Mat> beside = {test::tissue(), test::tissue(5)};
    cv::hconcat(beside, wide);
    Estimator estimator(test::image_of(test::tissue()), {});
    for (int x = 0; x <= test::width; x += 20)  // the last one has nothing of the baseline
        EXPECT_FALSE(estimator.measure(test::image_of(wide(cv::Rect(x, 0, test::width, test::height))), x).flags &
                     told::cut)
            << x;
}

TEST(Estimator, SurveysNoForeignFrame) {
    const HazeLight truth{.color = {0.40, 0.37, 0.42}, .fall_off = 0.25};
    const cv::Mat clear = round(test::tissue());
    const Image smoky =
        test::image_of(round(test::veiled(test::tissue(), test::ramp(0.1, 0.7), test::light_of(truth))));
    Estimator alone(test::image_of(clear), {}), mixed(test::image_of(clear), {});
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(alone.survey(smoky));
        EXPECT_TRUE(mixed.survey(smoky));
        EXPECT_FALSE(mixed.survey(test::image_of(i % 2 == 0 ? evenly({0.95F, 0.95F, 0.95F}) : title_card())));
        EXPECT_FALSE(mixed.survey(test::image_of(test::bag())));
        EXPECT_FALSE(mixed.survey(test::image_of(evenly({0, 0, 0}))));
    }
    const auto a = alone.surveyed(), b = mixed.surveyed();
    EXPECT_EQ(a->light.color, b->light.color);
    EXPECT_EQ(cv::norm(a->brightest, b->brightest), 0);
    EXPECT_EQ(cv::norm(a->overlay, b->overlay), 0);
    EXPECT_EQ(alone.measure(smoky, 0).valid, mixed.measure(smoky, 0).valid);
}

TEST(Estimator, SurveysDenseSmoke) {
    const HazeLight truth{.color = {0.40, 0.37, 0.42}, .fall_off = 0.25};
    Estimator estimator(test::image_of(test::tissue()), {});
    EXPECT_TRUE(
        estimator.survey(test::image_of(test::veiled(test::tissue(), test::ramp(0.6, 0.95), test::light_of(truth)))));
    EXPECT_NEAR(estimator.surveyed()->light.color.r, truth.color.r, 0.2 * truth.color.r);
}

TEST(Estimator, ItsViewGrowsIntoHollowsAndNotIntoTheSurround) {
    const cv::Mat clear = test::tissue();
    cv::Mat hollow = round(clear), lit = clear.clone();
    cv::circle(hollow, {240, 128}, 40, cv::Scalar(0, 0, 0), cv::FILLED);  // dark, at the rim
    Estimator estimator(test::image_of(hollow), {});
    const double before = estimator.measure(test::image_of(hollow), 0).valid;
    const cv::Mat veil(test::height, test::width, CV_32F, cv::Scalar(0.4));
    const auto valid_after = [&](const cv::Mat& frame) {
        estimator.survey(test::image_of(frame));
        return estimator.measure(test::image_of(frame), 1).valid;
    };
    const double disc = 3.14159 * 105 * 105 / (test::width * test::height);
    EXPECT_LT(before, 0.97 * disc);
    // The whole picture is lit, as on a title card through which the video is faded in.
    const double after = valid_after(test::veiled(lit, veil, test::light_of({})));
    EXPECT_GT(after, before);
    EXPECT_LT(after, 1.1 * disc);
}

/// A column of smoke at the tip, four times as bright as haze is: it hides two fifths.
TEST(Estimator, ABrightPlumeIsSmokeAndStandsOut) {
    const cv::Mat clear = test::tissue();
    cv::Mat frame = clear.clone();
    const cv::Rect column(140, 20, 48, 120);
    for (int y = column.y; y < column.br().y; ++y)
        for (int x = column.x; x < column.br().x; ++x) {
            const double side = (x - column.x - 23.5) / 24.0;
            const auto veil = static_cast<float>(0.4 * std::sqrt(1.0 - side * side));
            frame.at<cv::Vec3f>(y, x) = (1.0F - veil) * clear.at<cv::Vec3f>(y, x) + 0.7F * veil * usual_smoke_tint;
        }
    const double area = static_cast<double>(column.area()) / (test::width * test::height), middle = 0.785 * 0.4;
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
    const FrameAmounts plain = estimator.measure(test::image_of(clear), 0.0),
                       a = estimator.measure(test::image_of(frame), 0.1);
    EXPECT_GT(a.valid, 0.98 * plain.valid) << "nothing of it is an instrument";
    ASSERT_TRUE(plain.plume && a.plume);
    EXPECT_LT(plain.plume->value, 0.004);
    EXPECT_NEAR(a.plume->value, middle * area, 0.3 * middle * area);
    EXPECT_LT(a.plume->low, middle * area);
    EXPECT_GT(a.plume->high, middle * area);
}

TEST(Estimator, HasNoPlumeOfAnotherView) {
    Estimator estimator(test::image_of(test::tissue(1)), {});
    EXPECT_FALSE(estimator.measure(test::image_of(test::tissue(2)), 0.0).plume);
}

TEST(Estimator, TellsAnotherWhiteBalance) {
    const cv::Mat clear = test::tissue();
    cv::Mat bluer;
    cv::multiply(clear, cv::Scalar(1.4, 1.0, 0.95), bluer);
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
    EXPECT_FALSE(estimator.measure(test::image_of(clear), 0).flags & told::tinted);
    EXPECT_TRUE(estimator.measure(test::image_of(bluer), 0).flags & told::tinted);
}

TEST(Estimator, TakesThinSmokeForNoOtherWhiteBalance) {
    Estimator estimator(test::image_of(test::tissue()), {.survey = std::make_shared<const Survey>()});
    for (const double veil : {0.02, 0.05, 0.07, 0.1})
        EXPECT_FALSE(
            estimator.measure(test::image_of(test::veiled(test::tissue(), even(veil), test::light_of({}))), 0).flags &
            told::tinted)
            << veil;
}

cv::Mat gained(const cv::Mat& picture, const cv::Scalar& by) {
    cv::Mat made;
    cv::multiply(picture, by, made);
    return made;
}

/// A plume of this veil over the left quarter.
cv::Mat plume(double veil) {
    cv::Mat map = even(0.0);
    map(cv::Rect(0, 0, test::width / 4, test::height)) = veil;
    return map;
}

/// Tissue that moved by itself: the flow finds it again, where no motion of the camera lays it over the frame.
cv::Mat moved_by_itself(const cv::Mat& tissue) {
    cv::Mat from(tissue.size(), CV_32FC2), moved;
    for (int y = 0; y < test::height; ++y)
        for (int x = 0; x < test::width; ++x)
            from.at<cv::Vec2f>(y, x) = {static_cast<float>(x + 8.0 * std::sin(y / 25.0)),
                                        static_cast<float>(y + 8.0 * std::sin(x / 30.0))};
    cv::remap(tissue, moved, from, {}, cv::INTER_LINEAR, cv::BORDER_REFLECT);
    return moved;
}

/// What a map of pixels tells there is the tissue's, and most of it is not told.
TEST(Estimator, TakesTissueThatMovesByItselfForNoSmoke) {
    const cv::Mat clear = test::tissue();
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
    const FrameAmounts a = estimator.measure(test::image_of(moved_by_itself(clear)), 0);
    EXPECT_GT(a.likeness, 0.6);
    EXPECT_LT(estimator.veil_figures().likeness, 0.5);
    EXPECT_LT(a.veil.value, 0.01) << estimator.veil_figures().map;
}

/// Its colours may as well be those of other tissue. They make the amounts no surer.
TEST(Estimator, TellsNoWhiteBalanceOfTissueThatMovesByItself) {
    const cv::Mat clear = test::tissue();
    cv::Mat bluer;
    cv::multiply(moved_by_itself(clear), cv::Scalar(1.4, 1.0, 0.95), bluer);
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
    const FrameAmounts as_it_was = estimator.measure(test::image_of(moved_by_itself(clear)), 0),
                       other = estimator.measure(test::image_of(bluer), 0);
    cv::multiply(clear, cv::Scalar(1.4, 1.0, 0.95), bluer);
    EXPECT_TRUE(estimator.measure(test::image_of(bluer), 0).flags & told::tinted);
    EXPECT_TRUE(other.measurable());
    EXPECT_FALSE(other.flags & told::tinted);
    EXPECT_GT(other.veil.high - other.veil.value, as_it_was.veil.high - as_it_was.veil.value);
}

TEST(Estimator, TakesACameraThatChangesForNoSmoke) {
    const cv::Mat clear = test::tissue();
    cv::Mat bloody = clear.clone();
    constexpr int radius = 30;
    test::bleed(bloody, {150, 130}, radius);
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
    for (const double by : {0.7, 0.8, 1.1, 1.3}) {
        const FrameAmounts a = estimator.measure(test::image_of(gained(bloody, {by, by, by})), 0);
        EXPECT_LT(a.veil.value, 0.01) << by;
        EXPECT_NEAR(a.blood.value, 3.14159 * radius * radius / (test::width * test::height), 0.01) << by;
        EXPECT_EQ(a.flags, 0U) << by;
    }
}

TEST(Estimator, TakesADarkerPictureForNoBlood) {
    for (const int seed : {1, 3}) {
        const cv::Mat clear = test::tissue(seed);
        Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
        for (const double by : {0.2, 0.3, 0.4, 0.5, 0.55, 0.6, 0.65}) {
            const FrameAmounts a = estimator.measure(test::image_of(gained(clear, {by, by, by})), 0);
            EXPECT_TRUE(!a.blood_measurable() || a.blood.value < 0.01) << seed << " " << by << " " << a.blood.value;
        }
    }
}

TEST(Estimator, FindsSmokeThoughTheCameraChanged) {
    const cv::Mat clear = test::tissue(), brighter = gained(clear, {1.2, 1.2, 1.2});
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>(), .veil_model = map_alone()});
    for (const cv::Mat& veil : {plume(0.2), plume(0.5)}) {
        const Image picture = test::image_of(test::veiled(brighter, veil, test::light_of({})));
        EXPECT_NEAR(estimator.measure(picture, 0).veil.value, cv::mean(veil)[0], 0.02) << cv::mean(veil)[0];
    }
}

/// A puff near the lens: brightest and densest in its middle, at the lower left.
struct Puff {
    double veil, light;  ///< in its middle: 1 - transmission, and luminance before the gain
    cv::Mat over(const cv::Mat& tissue, double gain) const {
        cv::Mat made = tissue.clone();
        for (int y = 0; y < test::height; ++y)
            for (int x = 0; x < test::width; ++x) {
                const auto here = static_cast<float>(shape(x, y));
                cv::Vec3f& p = made.at<cv::Vec3f>(y, x);
                p = (p * (1.0F - static_cast<float>(veil) * here) + tint() * (static_cast<float>(light) * here)) *
                    static_cast<float>(gain);
            }
        return made;
    }
    static double shape(int x, int y) { return std::max(1.0 - std::pow(std::hypot(x - 80, y - 200) / 100.0, 2), 0.0); }
    static double mean_shape() {
        double sum = 0.0;
        for (int y = 0; y < test::height; ++y)
            for (int x = 0; x < test::width; ++x) sum += shape(x, y);
        return sum / (test::height * test::width);
    }
    /// Of luminance 1, blue, green and red; no tint that is assumed.
    static cv::Vec3f tint() {
        return cv::Vec3f(1.0F, 0.82F, 0.9F) / (0.0722F * 1.0F + 0.7152F * 0.82F + 0.2126F * 0.9F);
    }
};

bool holds(const Amount& amount, double truth) {
    return amount.low <= truth && truth <= amount.high;
}

TEST(Estimator, TellsTheGainOfTheCameraFromTheLightOfAPuff) {
    for (const int seed : {1, 3}) {
        const cv::Mat clear = test::tissue(seed);
        Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
        for (const Puff puff : {Puff{0.0, 0.0}, Puff{0.1, 0.15}, Puff{0.25, 0.45}})
            for (const double gain : {0.6, 0.8, 1.0, 1.25}) {
                const FrameAmounts a = estimator.measure(test::image_of(puff.over(clear, gain)), 0);
                const double light = puff.light * Puff::mean_shape();
                EXPECT_NEAR(a.gain.value, gain, 0.05) << seed << " " << puff.light;
                EXPECT_NEAR(a.light.value, light, 0.02) << seed << " " << gain;
                EXPECT_TRUE(holds(a.gain, gain)) << a.gain.low << " " << gain << " " << a.gain.high;
                EXPECT_TRUE(holds(a.light, light)) << a.light.low << " " << light << " " << a.light.high;
            }
    }
}

TEST(Estimator, TellsOfAStillFrameNeitherGainNorLight) {
    const Image clear = test::image_of(test::tissue());
    Estimator estimator(clear, {});
    const FrameAmounts a = estimator.measure(clear, 0);
    EXPECT_NEAR(a.gain.value, 1.0, 1e-3);
    EXPECT_NEAR(a.light.value, 0.0, 1e-3);
    EXPECT_LT(a.light.high, 0.02);
    EXPECT_GT(a.gain.low, 0.95);
    EXPECT_LT(a.gain.high, 1.05);
}

/// Only bright smoke says that a darker picture is the camera's doing.
TEST(Estimator, DoesNotTellAGainFromAVeilWithoutLight) {
    const cv::Mat clear = test::tissue();
    Estimator estimator(test::image_of(clear), {.survey = std::make_shared<const Survey>()});
    const FrameAmounts dark = estimator.measure(test::image_of(gained(clear, {0.6, 0.6, 0.6})), 0);
    EXPECT_TRUE(holds(dark.gain, 0.6) && holds(dark.gain, 1.0)) << dark.gain.low << " " << dark.gain.high;
    const FrameAmounts lit = estimator.measure(test::image_of(Puff{0.25, 0.8}.over(clear, 0.6)), 1);
    EXPECT_TRUE(holds(lit.gain, 0.6)) << lit.gain.low << " " << lit.gain.high;
    EXPECT_LT(lit.gain.high, 0.9);
}

TEST(Estimator, TellsNoGainWhereNothingIsMeasurable) {
    Estimator estimator(test::image_of(test::tissue()), {});
    const FrameAmounts a = estimator.measure(test::image_of(evenly({0, 0, 0})), 0);
    EXPECT_EQ(a.gain.value, 1.0);
    EXPECT_EQ(a.gain.low, least_gain);
    EXPECT_EQ(a.gain.high, most_gain);
    EXPECT_EQ(a.light.high, 1.0);
}

TEST(Estimator, RefusesABaselineThatShowsNothing) {
    const Image black = test::image_of(cv::Mat(test::height, test::width, CV_32FC3, cv::Scalar::all(0)));
    EXPECT_EQ(lapfx::test::faults_of([&] { Estimator(black, {}); }),
              std::vector<std::string>{"baseline: has no view to measure: it is black"});
    EXPECT_EQ(lapfx::test::faults_of([&] {
                  Estimator(test::image_of(test::tissue()), {.region = {0.5, 0.5, 0, 0}});
              }).size(),
              1U);
}

TEST(Estimator, MeasuresPicturesOfAnySizeAlike) {
    const cv::Mat clear = test::tissue(), smoky = test::veiled(clear, even(0.4), test::light_of({}));
    cv::Mat large_clear, large_smoky;
    cv::resize(clear, large_clear, {}, 3, 3, cv::INTER_CUBIC);
    cv::resize(smoky, large_smoky, {}, 3, 3, cv::INTER_CUBIC);
    Estimator estimator(test::image_of(cv::max(large_clear, 0.0)),
                        {.survey = std::make_shared<const Survey>(), .veil_model = map_alone()});
    EXPECT_NEAR(estimator.measure(test::image_of(cv::max(large_smoky, 0.0)), 0).veil.value, 0.4, 0.02);
    EXPECT_EQ(estimator.working_size(), cv::Size(256, 205));
}

}  // namespace
}  // namespace lapfx::match
