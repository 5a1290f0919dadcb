#include "media/plate_picture.h"

#include <gmock/gmock.h>

#include "media/camera_motion.h"
#include "media/opencv.h"
#include "support/endoscope.h"
#include "unit/preset/support.h"

namespace lapfx::media {
namespace {

constexpr glm::ivec2 size(320, 240);

/// As a camera sees it that has moved by `motion`: what was at a place is where that leads.
Image seen_after(const Image& image, const glm::dmat3& motion) {
    cv::Matx33d matrix;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) matrix(r, c) = motion[c][r];
    Image seen = image;
    cv::Mat4b into = pixels_of(seen);
    cv::warpPerspective(pixels_of(image).clone(), into, matrix, into.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
    return seen;
}

ValidView whole() {
    return {.from = {0, 0}, .to = size, .disc = std::nullopt};
}

glm::dmat3 shift(double x, double y) {
    return {1, 0, 0, 0, 1, 0, x, y, 1};
}

double farthest_corner(const glm::dmat3& a, const glm::dmat3& b) {
    double most = 0.0;
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {320, 0}, {0, 240}, {320, 240}})
        most = std::max(most, glm::distance(moved(a, corner), moved(b, corner)));
    return most;
}

/// Mean difference per channel, code values, within the rectangle.
double apart(const Image& a, const Image& b, cv::Rect within = {40, 40, 240, 160}) {
    cv::Mat difference;
    cv::absdiff(pixels_of(a)(within), pixels_of(b)(within), difference);
    const cv::Scalar mean = cv::mean(difference);
    return (mean[0] + mean[1] + mean[2]) / 3.0;
}

Image with_square(Image image, glm::ivec2 at) {
    cv::Mat4b pixels = pixels_of(image);
    cv::rectangle(pixels, cv::Rect(at.x, at.y, 40, 40), cv::Scalar(220, 220, 230, 255), cv::FILLED);
    return image;
}

TEST(ValidView, FindsTheRoundViewOfAnEndoscope) {
    const glm::dvec2 center(163.5, 118.0);
    for (const double radius : {90.0, 130.0, 160.0}) {  // whole; cut off above and below; only the corners are black
        const ValidView view = valid_view(test::behind_round_view(test::tissue_picture(size), center, radius));
        ASSERT_TRUE(view.disc) << radius;
        EXPECT_LT(glm::distance(view.disc->center, center), 1.5) << radius;
        EXPECT_LT(glm::distance(view.disc->radius, glm::dvec2(radius)), 2.0);
        EXPECT_EQ(view.share({163, 118}), 1.0);
        EXPECT_EQ(view.share({0, 0}), 0.0);
        EXPECT_GT(view.share({163 + static_cast<int>(radius) - 5, 118}), 0.9);
    }
}

TEST(ValidView, AnInstrumentAndTextAtTheRimDoNotBendTheDisc) {
    Image image = test::behind_round_view(test::tissue_picture(size), {160.0, 120.0}, 110.0);
    cv::Mat4b pixels = pixels_of(image);
    cv::rectangle(pixels, cv::Rect(200, 100, 90, 30), cv::Scalar(8, 8, 10, 255), cv::FILLED);
    cv::putText(pixels, "12:45", {4, 20}, cv::FONT_HERSHEY_SIMPLEX, 0.5, cv::Scalar(240, 240, 240, 255));
    const ValidView view = valid_view(image);
    ASSERT_TRUE(view.disc);
    EXPECT_LT(glm::distance(view.disc->center, glm::dvec2(160.0, 120.0)), 2.0);
    EXPECT_LT(glm::distance(view.disc->radius, glm::dvec2(110.0)), 3.0);
}

TEST(ValidView, ARoundViewThatIsStoredSqueezedIsAnEllipse) {
    Image wide = test::behind_round_view(test::tissue_picture({480, 240}), {236.0, 118.0}, 150.0), squeezed = wide;
    squeezed.width = 240;
    squeezed.pixels.resize(240U * 240 * 4);
    cv::Mat4b into = pixels_of(squeezed);
    cv::resize(pixels_of(wide), into, into.size(), 0, 0, cv::INTER_AREA);
    const ValidView view = valid_view(squeezed);
    ASSERT_TRUE(view.disc);
    EXPECT_LT(glm::distance(view.disc->center, glm::dvec2(118.0, 118.0)), 3.0);
    EXPECT_LT(glm::distance(view.disc->radius, glm::dvec2(75.0, 150.0)), 5.0);
}

TEST(ValidView, ADarkCornerIsNoSurround) {
    Image image = test::tissue_picture(size);
    cv::Mat4b pixels = pixels_of(image);
    cv::circle(pixels, {320, 0}, 100, cv::Scalar(10, 8, 9, 255), cv::FILLED);
    cv::circle(pixels, {310, 20}, 60, cv::Scalar(180, 90, 80, 255), cv::FILLED);
    EXPECT_FALSE(valid_view(image).disc);
}

TEST(ValidView, WithoutARoundViewItIsTheRectangleThatIsNotBlack) {
    Image image = test::tissue_picture(size);
    EXPECT_FALSE(valid_view(image).disc);
    EXPECT_EQ(valid_view(image).to, size);
    cv::Mat4b pixels = pixels_of(image);
    pixels.rowRange(0, 30) = cv::Scalar(0, 0, 0, 255);
    pixels.rowRange(210, 240) = cv::Scalar(3, 3, 3, 255);
    const ValidView bars = valid_view(image);
    EXPECT_FALSE(bars.disc);
    EXPECT_NEAR(bars.from.y, 30, 2);
    EXPECT_NEAR(bars.to.y, 210, 2);
    EXPECT_EQ(bars.share({100, 5}), 0.0);
    pixels = cv::Scalar(2, 2, 2, 255);
    EXPECT_EQ(valid_view(image).to, size) << "black all over: the lens is covered, which says nothing";
}

TEST(CameraMotion, RecoversAKnownShift) {
    const Image image = test::tissue_picture(size);
    for (const glm::dmat3& known : {shift(0, 0), shift(3, -2), shift(-21, 14), shift(35, 8)}) {
        const auto found = camera_motion(image, seen_after(image, known), whole());
        ASSERT_TRUE(found) << known[2][0];
        EXPECT_LT(farthest_corner(*found, known), 0.5) << known[2][0];
    }
}

TEST(CameraMotion, RecoversTurnZoomAndPerspective) {
    const Image image = test::tissue_picture(size);
    const double c = std::cos(0.07), s = std::sin(0.07);
    const glm::dmat3 turn = shift(160, 120) * glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * shift(-160, -120);
    const glm::dmat3 zoom = shift(160, 120) * glm::dmat3(1.06, 0, 0, 0, 1.06, 0, 0, 0, 1) * shift(-160, -120);
    const glm::dmat3 tilt(1.02, 0.01, 8e-5, -0.015, 0.99, 1.5e-4, 4, -3, 1);
    for (const glm::dmat3& known : {turn, zoom, tilt, turn * zoom}) {
        const auto found = camera_motion(image, seen_after(image, known), whole());
        ASSERT_TRUE(found);
        EXPECT_LT(farthest_corner(*found, known), 1.0);
    }
}

TEST(CameraMotion, SaysNothingWhereThereIsNone) {
    const Image image = test::tissue_picture(size);
    EXPECT_FALSE(camera_motion(image, test::tissue_picture(size, 9), whole())) << "another place: a cut";
    Image flat = image;
    std::fill(flat.pixels.begin(), flat.pixels.end(), std::uint8_t{128});
    EXPECT_FALSE(camera_motion(flat, flat, whole())) << "nothing to be found again";
    EXPECT_FALSE(camera_motion(image, seen_after(image, shift(160, 0)), whole())) << "farther than a camera moves";
}

TEST(Blended, APassingThingVanishesAndTheTissueStays) {
    const Image image = test::tissue_picture(size);
    std::vector<Image> frames{with_square(image, {60, 60})};
    for (const int x : {100, 140, 180, 220}) frames.push_back(with_square(image, {x, 100}));
    int left_out = 0;
    const Image made = blended(frames, whole(), left_out);
    EXPECT_EQ(left_out, 0);
    EXPECT_EQ(made.pixels, image.pixels) << "nothing was resampled: the camera stood still";
}

TEST(Blended, TheCamerasMotionIsTakenOut) {
    const Image image = test::tissue_picture(size);
    std::vector<Image> frames{with_square(image, {140, 100})};
    for (const glm::dmat3& motion : {shift(6, 3), shift(-9, 5), shift(4, -11), shift(-5, -4)})
        frames.push_back(seen_after(image, motion));
    int left_out = 0;
    const Image made = blended(frames, whole(), left_out);
    EXPECT_EQ(left_out, 0);
    EXPECT_GT(apart(frames[0], image), 3.0);
    EXPECT_LT(apart(made, image), 2.0);
}

TEST(Blended, FramesOfAnotherShotAreLeftOut) {
    const Image image = test::tissue_picture(size), other = test::tissue_picture(size, 5);
    int left_out = 0;
    const Image made = blended({image, other, other, other}, whole(), left_out);
    EXPECT_EQ(left_out, 3);
    EXPECT_EQ(made.pixels, image.pixels);
}

TEST(Blended, WhatMovesInFromTheSurroundIsNotTissue) {
    const glm::dvec2 center(160, 120);
    const Image tissue = test::tissue_picture(size), image = test::behind_round_view(tissue, center, 100.0);
    std::vector<Image> frames{image};
    for (int i = 0; i < 4; ++i)
        frames.push_back(test::behind_round_view(seen_after(tissue, shift(20, 0)), center, 100));
    int left_out = 0;
    const ValidView view = valid_view(image);
    const Image made = blended(frames, view, left_out);
    EXPECT_EQ(left_out, 0);
    // Left of what the others show, the first one alone has it.
    EXPECT_EQ(test::pixel(made, {68, 120}), test::pixel(image, {68, 120}));
    EXPECT_EQ(test::pixel(made, {30, 120}), glm::ivec3(0)) << "the surround stays black";
}

TEST(ClearestFrame, HasTheLeastSmoke) {
    const test::Folder folder;
    const Image image = test::tissue_picture(size);
    std::vector<Image> frames;
    for (const double transmission : {0.9, 0.5, 0.3, 0.6, 0.8, 1.0, 0.7, 0.4})
        frames.push_back(test::veiled(image, transmission));
    VideoReader video(test::write_video(folder.path(), frames));
    EXPECT_EQ(clearest_frame(video), 5);
}

TEST(ClearestFrame, IsNoneOfTheDarkOrBlurredOnes) {
    const test::Folder folder;
    const Image image = test::tissue_picture(size);
    Image dark = image, blurred = image;
    for (std::size_t i = 0; i < dark.pixels.size(); ++i)
        if (i % 4 != 3) dark.pixels[i] /= 6;
    cv::Mat4b pixels = pixels_of(blurred);
    cv::GaussianBlur(pixels.clone(), pixels, {0, 0}, 5.0);
    VideoReader video(test::write_video(folder.path(), {dark, blurred, test::veiled(image, 0.9), blurred, dark}));
    EXPECT_EQ(clearest_frame(video), 2);
}

TEST(PlatePicture, OneChosenFrameIsThatOfTheVideo) {
    const test::Folder folder;
    std::vector<Image> frames;
    for (unsigned i = 0; i < 4; ++i) frames.push_back(test::tissue_picture(size, i));
    VideoReader video(test::write_video(folder.path(), frames));
    const PlatePicture made = plate_picture(video, {.use = true, .frame = PlateFrame::chosen, .time = 0.08});
    EXPECT_EQ(made.image.pixels, frames[2].pixels);
    EXPECT_NEAR(made.time, 0.08, 1e-9);
    EXPECT_EQ(made.blended, 1);
}

TEST(PlatePicture, BlendsFramesAroundTheChosenOne) {
    const test::Folder folder;
    const Image image = test::tissue_picture(size);
    std::vector<Image> frames;
    for (int i = 0; i < 12; ++i) frames.push_back(with_square(image, {20 * i, 100}));
    VideoReader video(test::write_video(folder.path(), frames));
    const ScenePlate wanted{.use = true, .frame = PlateFrame::chosen, .time = 0.24, .frames = 7, .span = 0.4};
    const PlatePicture made = plate_picture(video, wanted);
    EXPECT_EQ(made.blended, 7);
    EXPECT_EQ(made.left_out, 0);
    EXPECT_EQ(made.image.pixels, image.pixels);
}

TEST(PlatePicture, ItsOpacityIsTheValidView) {
    const test::Folder folder;
    const Image image = test::behind_round_view(test::tissue_picture(size), {160, 120}, 100);
    VideoReader video(test::write_video(folder.path(), {image}));
    const PlatePicture made = plate_picture(video, {.use = true});
    EXPECT_EQ(made.image.pixels[4 * (120 * 320 + 160) + 3], 255);
    EXPECT_EQ(made.image.pixels[4 * (120 * 320 + 20) + 3], 0);
}

TEST(PlatePicture, ATimeOutsideTheVideoIsRefused) {
    const test::Folder folder;
    VideoReader video(test::write_video(folder.path(), {test::tissue_picture(size), test::tissue_picture(size, 2)}));
    EXPECT_EQ(test::faults_of([&] { plate_picture(video, {.use = true, .frame = PlateFrame::chosen, .time = 99.0}); }),
              std::vector<std::string>{"/plate/time: 99 s is outside the reference, which ends at 0.08 s"});
    EXPECT_NO_THROW(plate_picture(video, {.use = true, .frame = PlateFrame::clearest, .time = 99.0}))
        << "the time is that of a chosen frame";
}

TEST(PlatePicture, AnotherThreadStopsItWhereItReads) {
    const test::Folder folder;
    VideoReader video(test::write_video(folder.path(), {test::tissue_picture(size)}));
    const std::atomic<bool> stop = true;
    for (const PlateFrame frame : {PlateFrame::clearest, PlateFrame::chosen})
        EXPECT_THROW(plate_picture(video, {.use = true, .frame = frame}, {}, &stop), work::Stopped);
}

TEST(PlatePicture, CanBeStoppedWhereverItAsks) {
    const test::Folder folder;
    const Image image = test::tissue_picture(size);
    VideoReader video(test::write_video(folder.path(), {image, image, image}));
    int asked = 0;
    const Progress count = [&](double) { return ++asked > 0; };
    plate_picture(video, {.use = true, .frames = 3, .span = 1.0}, work::Stages(count));
    ASSERT_GT(asked, 6);
    for (int stop = 1; stop <= asked; ++stop) {
        int now = 0;
        const Progress until = [&](double) { return ++now < stop; };
        EXPECT_THROW(plate_picture(video, {.use = true, .frames = 3, .span = 1.0}, work::Stages(until)), work::Stopped);
    }
}

}  // namespace
}  // namespace lapfx::media
