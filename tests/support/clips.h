// Small videos whose frames show their number, and those that look like smoke or like a surgery.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <opencv2/videoio.hpp>

namespace lapfx::test {

constexpr int level_step = 10;

/// The grey level of frame `index`: far enough apart to survive the encoder.
inline int level_of(int index) {
    return 5 + level_step * index;
}

/// The frame whose grey level this is.
inline int number_of_level(double level) {
    return cvRound((level - 5.0) / level_step);
}

/// Which frame of a clip made by write_clip() this is.
inline int frame_number(const cv::Mat& image) {
    return number_of_level(cv::mean(image)[1]);
}

/// A motion-JPEG AVI of flat grey frames: level_of(0), level_of(1), ...; at most 25.
inline std::filesystem::path write_clip(const std::filesystem::path& path, int frames, cv::Size size = {64, 48},
                                        double fps = 20.0) {
    cv::VideoWriter writer(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), fps, size);
    EXPECT_TRUE(writer.isOpened()) << path;
    for (int i = 0; i < frames; ++i) writer.write(cv::Mat(size, CV_8UC3, cv::Scalar::all(level_of(i))));
    return path;
}

/// A motion-JPEG AVI of 12 frames, 96 x 72, with the colour B, G, R of each pixel in each frame.
inline std::filesystem::path write_seen(const std::filesystem::path& path,
                                        const std::function<cv::Vec3d(cv::Point2d at, int frame)>& colour) {
    constexpr int frames = 12;
    const cv::Size size(96, 72);
    cv::VideoWriter writer(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20, size);
    EXPECT_TRUE(writer.isOpened()) << path;
    for (int i = 0; i < frames; ++i) {
        cv::Mat image(size, CV_8UC3);
        image.forEach<cv::Vec3b>([&](cv::Vec3b& pixel, const int* at) {
            const cv::Vec3d c = colour(cv::Point2d(at[1], at[0]), i);
            for (int k = 0; k < 3; ++k) pixel[k] = cv::saturate_cast<uchar>(c[k]);
        });
        writer.write(image);
    }
    return path;
}

/// A soft grey puff that rises before `background` (B, G, R).
inline std::filesystem::path write_smoke(const std::filesystem::path& path, const cv::Vec3d& background = {0, 0, 0}) {
    return write_seen(path, [&](cv::Point2d at, int frame) -> cv::Vec3d {
        const double away = cv::norm(at - cv::Point2d(48, 60 - 3 * frame)) / 14;
        const double opacity = 0.8 * std::exp(-away * away);
        return background * (1 - opacity) + cv::Vec3d(210, 210, 210) * opacity;
    });
}

/// Uneven red tissue that moves, inside the black surround of an endoscope.
inline std::filesystem::path write_surgery(const std::filesystem::path& path) {
    return write_seen(path, [](cv::Point2d at, int frame) -> cv::Vec3d {
        if (cv::norm(at - cv::Point2d(48, 36)) > 36) return {0, 0, 0};
        const double uneven = 0.75 + 0.25 * std::sin(0.3 * at.x + 0.4 * frame) * std::cos(0.23 * at.y);
        return cv::Vec3d(60, 70, 190) * uneven;
    });
}

}  // namespace lapfx::test
