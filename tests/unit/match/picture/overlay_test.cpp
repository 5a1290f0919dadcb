#include "match/picture/overlay.h"

#include <gtest/gtest.h>

#include "match/frame/estimator.h"
#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

/// A text and a logo, as a recorder burns them in.
void burn_in(cv::Mat& code) {
    cv::putText(code, "OR 4  23.11.2026", {20, 30}, cv::FONT_HERSHEY_SIMPLEX, 0.5, {40, 230, 240}, 2);
    cv::circle(code, {280, 220}, 16, cv::Scalar(220, 120, 60), cv::FILLED);
}

/// The tissue moves by some pixels from one frame to the next; `moves` false: it stands still.
Image frame(int number, bool moves, bool burnt) {
    const cv::Mat whole = test::tissue();
    cv::Mat shifted;
    const int shift = moves ? 7 * number : 0;
    cv::copyMakeBorder(whole, shifted, shift, 0, 2 * shift, 0, cv::BORDER_REFLECT);
    cv::Mat code = test::code_picture(shifted(test::box()).clone());
    if (burnt) burn_in(code);
    cv::Mat rgba;
    cv::cvtColor(code, rgba, cv::COLOR_BGR2RGBA);
    return {.width = rgba.cols, .height = rgba.rows, .pixels = {rgba.datastart, rgba.dataend}, .name = ""};
}

cv::Mat found_in(bool moves, bool burnt, int frames = 6) {
    OverlaySurvey survey;
    for (int i = 0; i < frames; ++i) survey.add(frame(i, moves, burnt));
    return survey.found({test::width, test::height});
}

cv::Mat burnt_pixels() {
    cv::Mat clean = cv::Mat::zeros(test::height, test::width, CV_8UC3), grey;
    burn_in(clean);
    cv::cvtColor(clean, grey, cv::COLOR_BGR2GRAY);
    return grey > 0;
}

TEST(Overlay, IsTextAndLogoThatStayWhileTheTissueMoves) {
    const cv::Mat found = found_in(true, true), truth = burnt_pixels();
    EXPECT_GT(cv::countNonZero(found & truth), 0.9 * cv::countNonZero(truth));
    cv::Mat near;
    cv::dilate(truth, near, cv::getStructuringElement(cv::MORPH_RECT, {13, 13}));
    EXPECT_LT(cv::countNonZero(found & ~near), 0.005 * static_cast<double>(found.total()));
}

TEST(Overlay, IsNothingWithoutTextOrMotionOrFrames) {
    EXPECT_LT(cv::countNonZero(found_in(true, false)), 0.005 * test::width * test::height);
    EXPECT_EQ(cv::countNonZero(found_in(false, true)), 0);
    EXPECT_EQ(cv::countNonZero(found_in(true, true, 3)), 0);
}

/// There a letter is no more than a fold of the tissue.
TEST(Overlay, IsNotLookedForInSmallPictures) {
    const auto found_at = [](int across) {
        OverlaySurvey survey;
        for (int i = 0; i < 6; ++i) {
            Image picture = frame(i, true, true);
            const cv::Mat whole(picture.height, picture.width, CV_8UC4, picture.pixels.data());
            cv::Mat smaller;
            cv::resize(whole, smaller, {across, across / 2}, 0, 0, cv::INTER_AREA);
            survey.add({.width = smaller.cols,
                        .height = smaller.rows,
                        .pixels = {smaller.datastart, smaller.dataend},
                        .name = ""});
        }
        return cv::countNonZero(survey.found({across, across / 2}));
    };
    EXPECT_EQ(found_at(128), 0);
    EXPECT_GT(found_at(240), 100);
}

/// A recorder may leave a line at the edge of the picture, which stays as well.
TEST(Overlay, IsNoLineAtTheEdgeOfThePicture) {
    const auto with_line = [](int from_edge) {
        OverlaySurvey survey;
        for (int i = 0; i < 6; ++i) {
            Image picture = frame(i, true, false);
            const cv::Mat whole(picture.height, picture.width, CV_8UC4, picture.pixels.data());
            whole(cv::Rect(60, picture.height - from_edge - 3, 120, 3)) = cv::Scalar(230, 240, 230, 255);
            survey.add(picture);
        }
        return cv::countNonZero(survey.found({test::width, test::height}));
    };
    EXPECT_EQ(with_line(0), 0);
    EXPECT_GT(with_line(12), 250);
}

/// Pictures of a folder may be cut a pixel narrower.
TEST(Overlay, IsFoundInPicturesThatDifferByAPixel) {
    OverlaySurvey survey;
    for (int i = 0; i < 6; ++i) {
        Image picture = frame(i, true, true);
        if (i == 3) {
            const cv::Mat whole(picture.height, picture.width, CV_8UC4, picture.pixels.data());
            const cv::Mat cut = whole.rowRange(0, whole.rows - 1).clone();
            picture = {.width = cut.cols, .height = cut.rows, .pixels = {cut.datastart, cut.dataend}, .name = ""};
        }
        survey.add(picture);
    }
    const cv::Mat found = survey.found({test::width, test::height}), truth = burnt_pixels();
    EXPECT_GT(cv::countNonZero(found & truth), 0.5 * cv::countNonZero(truth));
}

/// Pale tissue keeps its value under smoke that is as bright; an instrument that lies above it, then below it, darkens
/// what is around it.
TEST(Overlay, IsNoTissueBetweenTwoPlacesOfAnInstrument) {
    const HazeLight light{.color = {0.5, 0.48, 0.5}, .fall_off = 0};
    cv::Mat pale;
    cv::add(0.1 * test::tissue(), cv::Scalar(0.45, 0.45, 0.47), pale);
    OverlaySurvey survey;
    for (int i = 0; i < 6; ++i) {
        cv::Mat picture = test::veiled(pale, cv::Mat(pale.size(), CV_32F, cv::Scalar(0.05 * i)), test::light_of(light));
        const cv::Rect shafts[] = {{100, 90, 120, 14}, {100, 118, 120, 14}, {84, 90, 20, 42}, {216, 90, 20, 42}};
        cv::rectangle(picture, shafts[i % 4], cv::Scalar(0.01, 0.01, 0.01), cv::FILLED);
        survey.add(test::image_of(picture));
    }
    EXPECT_EQ(cv::countNonZero(survey.found({test::width, test::height})), 0);
}

TEST(Overlay, IsNoPartOfTheValidView) {
    Estimator estimator(frame(0, true, true), {});
    for (int i = 0; i < 6; ++i) estimator.survey(frame(i, true, true));
    estimator.measure(frame(0, true, true), 0);
    const cv::Mat truth = burnt_pixels();
    cv::Mat in_working_size;
    cv::resize(truth, in_working_size, estimator.working_size(), 0, 0, cv::INTER_NEAREST);
    EXPECT_LT(cv::countNonZero(estimator.valid() & in_working_size), 0.1 * cv::countNonZero(in_working_size));
    EXPECT_GT(cv::countNonZero(estimator.valid()), 0.85 * static_cast<double>(estimator.valid().total()));
    EXPECT_GT(cv::countNonZero(estimator.surveyed()->overlay & in_working_size),
              0.9 * cv::countNonZero(in_working_size));
}

}  // namespace
}  // namespace lapfx::match
