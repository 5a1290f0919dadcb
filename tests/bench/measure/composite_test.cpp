#include "bench/measure/composite.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "bench/measure/camera.h"
#include "bench/measure/over.h"
#include "lapfx/effects.h"
#include "match/frame/film.h"
#include "match/picture/colors.h"

namespace lapfx::bench {
namespace {

using composite::least_thickness;

const cv::Size size(64, 48);

cv::Mat everywhere(cv::Size of = size) {
    return {of, CV_8U, cv::Scalar(255)};
}

TEST(Composite, AVeilMixesInLinearLight) {
    cv::Mat picture(1, 3, CV_32FC3, cv::Scalar(0.1, 0.2, 0.4));
    const cv::Mat light(1, 3, CV_32FC3, cv::Scalar(0.5, 0.6, 0.8)), veil = (cv::Mat_<float>(1, 3) << 0.0F, 0.25F, 1.0F);
    composite::lay_veil(picture, veil, light);
    EXPECT_EQ(picture.at<cv::Vec3f>(0, 0), cv::Vec3f(0.1F, 0.2F, 0.4F));
    EXPECT_EQ(picture.at<cv::Vec3f>(0, 2), cv::Vec3f(0.5F, 0.6F, 0.8F));
    EXPECT_LT(cv::norm(picture.at<cv::Vec3f>(0, 1), cv::Vec3f(0.2F, 0.3F, 0.5F)), 1e-6);
}

TEST(Composite, AFilmPassesByItsThickness) {
    cv::Mat picture(1, 3, CV_32FC3, cv::Scalar(0.2, 0.3, 0.8));
    const cv::Mat thickness = (cv::Mat_<float>(1, 3) << 0.0F, 0.01F, 0.5F);
    const cv::Mat blood = composite::lay_blood(picture, thickness);
    EXPECT_EQ(picture.at<cv::Vec3f>(0, 0), cv::Vec3f(0.2F, 0.3F, 0.8F));
    const cv::Vec3f passed(0.2F * std::exp2(-3.75F), 0.3F * std::exp2(-4.0F), 0.8F * std::exp2(-1.3F));
    EXPECT_LT(cv::norm(picture.at<cv::Vec3f>(0, 2), passed), 1e-6);
    EXPECT_EQ(blood.at<std::uint8_t>(0, 0), 0);
    EXPECT_EQ(blood.at<std::uint8_t>(0, 1), 0) << "a change of less than a tenth is none";
    EXPECT_EQ(blood.at<std::uint8_t>(0, 2), 255);
}

TEST(Composite, AbsorptionIsThatOfTheShader) {
    EXPECT_EQ(match::blood_absorption, cv::Vec3f(7.5F, 8.0F, 2.6F));  // blue, green, red
    EXPECT_NE(bleeding_shader().find("lapfx_blood_absorption = vec3(2.6, 8.0, 7.5)"), std::string::npos);
    EXPECT_NE(bleeding_shader().find("(share * (1.0 + b.clot) + 0.06)"), std::string::npos);
    EXPECT_EQ(least_thickness, 0.06F);
}

TEST(Composite, AVeilHasTheMeanThatWasAsked) {
    Random random(3, 0, 0);
    cv::Mat view = cv::Mat::zeros(size, CV_8U);
    cv::circle(view, {30, 24}, 20, 255, cv::FILLED);
    const cv::Mat plume(20, 20, CV_32F, cv::Scalar(0.7));
    for (int i = 0; i < 20; ++i) {
        const cv::Mat shape = composite::veil_shape(random, size, plume);
        for (const double mean : {0.0, 0.03, 0.4, 0.8}) {
            const cv::Mat veil = composite::veil_of(shape, view, mean);
            EXPECT_NEAR(cv::mean(veil, view)[0], mean, 1e-5);
            double low = 0.0, high = 0.0;
            cv::minMaxLoc(veil, &low, &high);
            EXPECT_GE(low, 0.0);
            EXPECT_LE(high, 1.0);
        }
    }
}

TEST(Composite, BloodHasTheAreaThatWasAskedAndTheCoreWouldSeeAllOfIt) {
    Random random(4, 0, 0);
    for (const double area : {0.0, 0.01, 0.3}) {
        const cv::Mat film = composite::thickness_of(composite::blood_shape(random, size), everywhere(), area, 0.4);
        cv::Mat tissue(size, CV_32FC3, cv::Scalar(0.1, 0.1, 0.5));
        const cv::Mat blood = composite::lay_blood(tissue, film);
        EXPECT_NEAR(cv::countNonZero(blood) / static_cast<double>(size.area()), area, 1.0 / size.area());
        double high = 0.0;
        cv::minMaxLoc(film, nullptr, &high);
        EXPECT_NEAR(high, area > 0.0 ? 0.4 : 0.0, 1e-6);
    }
}

TEST(Composite, LightIsAsBrightAsRealSmokeAndDimAtTheRim) {
    for (std::uint32_t i = 0; i < 20; ++i) {
        Random random(5, 0, i);
        const cv::Mat light = composite::draw_light(random, {65, 65});
        const cv::Vec3f middle = light.at<cv::Vec3f>(32, 32), rim = light.at<cv::Vec3f>(32, 0);
        const float brightness = match::code_of(middle[0]) / 255.0F;
        EXPECT_GT(brightness, 0.54F);
        EXPECT_LT(brightness, 0.96F);
        EXPECT_LE(middle[2], middle[0]);
        EXPECT_NEAR(match::code_of(rim[0]) / match::code_of(middle[0]), 0.7F, 0.02F);
    }
}

TEST(Moves, ActOnThePictureAndWhatIsKnownOfItAlike) {
    Shown shown{.code = cv::Mat::zeros(size, CV_8UC3),
                .view = everywhere(),
                .blood = cv::Mat::zeros(size, CV_8U),
                .veil = cv::Mat::zeros(size, CV_32F)};
    const cv::Rect spot(20, 16, 8, 8);
    shown.code(spot) = cv::Scalar(0, 0, 200);
    shown.blood(spot) = 255;
    shown.veil(spot) = 0.5;
    const Shown to = moved(shown, {.right = 8.0 / size.width, .down = -4.0 / size.width}, size);
    const cv::Rect there(28, 12, 8, 8);
    EXPECT_EQ(cv::countNonZero(to.blood(there)), 64);
    EXPECT_EQ(cv::countNonZero(to.blood), 64);
    EXPECT_NEAR(cv::mean(to.code(there))[2], 200.0, 1e-9);
    EXPECT_NEAR(cv::mean(to.veil)[0], cv::mean(shown.veil)[0], 1e-9);
    EXPECT_NEAR(known(to).blood, 64.0 / size.area(), 1e-12);
}

TEST(Moves, NoneLeavesTheMiddle) {
    cv::Mat code(size, CV_8UC3);
    cv::RNG random(1);
    random.fill(code, cv::RNG::UNIFORM, 0, 255);
    const Shown part = moved({.code = code, .view = {}, .blood = {}, .veil = {}}, {}, {32, 32});
    EXPECT_EQ(cv::norm(part.code, code({16, 8, 32, 32}), cv::NORM_INF), 0.0);
    EXPECT_TRUE(part.view.empty());
}

TEST(Moves, AreDrawnOfTheSizeThatIsSaid) {
    Random random(6, 0, 0);
    int moves = 0;
    for (int i = 0; i < 1000; ++i) {
        const Move move = draw_move(random, 0.6);
        if (!move.any()) continue;
        ++moves;
        const double length = 256.0 * std::hypot(move.right, move.down);
        EXPECT_GE(length, 5.0 - 1e-9);
        EXPECT_LE(length, 20.0 + 1e-9);
        EXPECT_LE(std::abs(move.degrees), 2.0);
        EXPECT_LE(std::abs(move.scale - 1.0), 0.03 + 1e-12);
    }
    EXPECT_NEAR(moves, 600, 60);
}

TEST(Operation, IsTheFolderAndTheNameUpToTheLastUnderscore) {
    EXPECT_EQ(operation_of("/data/high/video01_010.mp4"), "high/video01");
    EXPECT_EQ(operation_of("/data/img_dir/t80_VID03_000030.png"), "img_dir/t80_VID03");
    EXPECT_EQ(operation_of("/data/clear/whole.avi"), "clear/whole");
}

}  // namespace
}  // namespace lapfx::bench
