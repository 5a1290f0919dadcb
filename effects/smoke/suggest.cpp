// Suggesting for a file: what decoding has to do with it.
#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "smoke/clip_file.h"
#include "smoke/suggest_cpu.h"

namespace lapfx {

namespace {

constexpr int looked_at = 24;  // pictures: a loop's smoke has gone through its whole path

}  // namespace

KeyingSuggestion suggest_keying(const std::filesystem::path& clip) {
    const int count = smoke::read_clip_info(clip).frame_count;
    cv::VideoCapture capture = smoke::open_clip(clip);
    smoke::KeyingSurvey survey;
    cv::Mat bgr, rgb;
    const int wanted = std::min(count, looked_at);
    for (int i = 0, at = 0; i < wanted; ++i, ++at) {
        const int index = static_cast<int>((2L * i + 1) * count / (2L * wanted));
        for (; at < index; ++at)
            if (!capture.grab()) return survey.suggest();
        if (!capture.read(bgr) || bgr.empty()) break;
        cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
        survey.add({rgb.cols, rgb.rows}, {rgb.data, rgb.total() * 3});
    }
    return survey.suggest();
}

}  // namespace lapfx
