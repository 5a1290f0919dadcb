// Small videos whose frames show their number.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
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

}  // namespace lapfx::test
