// Which frame is the clear one. Of up to 48 frames over the video, those that show what most others show also; of these
// the one with the least haze (dark channel: He, Sun and Tang 2009), the least blood and instruments, the most detail.
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "lapfx/error.h"
#include "match/colors.h"
#include "match/measure.h"
#include "match/view.h"

namespace lapfx::match {

namespace {

constexpr int most_candidates = 48;
constexpr int side = 160;             // px of the longer side
constexpr int dark_window = 7;        // px
constexpr double alike = 0.3;         // correlation of textures
constexpr double well_seen = 0.6;     // of the most frequent view's frames
constexpr double least_light = 10.0;  // code value: darker pictures are no candidates
constexpr float blood_redness = 3.0F;

struct Candidate {
    double time = 0.0, clear = 0.0, dark_channel = 0.0;
    cv::Mat texture, view;
    int like = 0;
};

/// Mean over the view of the darkest value around each pixel, 0..1: 0.04 to 0.08 in clear frames.
double dark_channel(const cv::Mat& code, const cv::Mat& view) {
    cv::Mat channels[3], darkest;
    cv::split(code, channels);
    cv::min(channels[0], channels[1], darkest);
    cv::min(darkest, channels[2], darkest);
    cv::erode(darkest, darkest, cv::getStructuringElement(cv::MORPH_RECT, {dark_window, dark_window}));
    return cv::mean(darkest, view)[0] / 255.0;
}

double share(const cv::Mat& part, const cv::Mat& whole) {
    return static_cast<double>(cv::countNonZero(part & whole)) / std::max(cv::countNonZero(whole), 1);
}

/// Nothing for a black picture.
std::optional<Candidate> candidate_of(const Image& image, double time) {
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(image.width, image.height));
    cv::Mat code, luma, dx, dy, linear, redness;
    shrink(image,
           {std::max(8, static_cast<int>(image.width * scale)), std::max(8, static_cast<int>(image.height * scale))},
           code);
    Candidate found;
    found.time = time;
    found.view = view_of(code);
    if (cv::countNonZero(found.view) == 0 || cv::mean(code, found.view)[2] < least_light) return {};
    cv::cvtColor(code, luma, cv::COLOR_BGR2GRAY);
    cv::Sobel(luma, dx, CV_32F, 1, 0);
    cv::Sobel(luma, dy, CV_32F, 0, 1);
    cv::magnitude(dx, dy, dx);
    to_linear(code, linear);
    redness_of(linear, redness);
    texture_of(code, found.texture);
    found.dark_channel = dark_channel(code, found.view);
    const double detail = std::log(std::max(cv::mean(dx, found.view)[0], 1.0));
    const double blood = share(redness > blood_redness, found.view);
    const double instruments = share(instruments_of(code, found.view), found.view);
    found.clear = 0.3 * detail - 4.0 * found.dark_channel - blood - instruments;
    return found;
}

double likeness(const Candidate& a, const Candidate& b) {
    double ab = 0.0, aa = 1.0, bb = 1.0;
    for (int y = 0; y < a.texture.rows; ++y)
        for (int x = 0; x < a.texture.cols; ++x) {
            if (a.view.at<std::uint8_t>(y, x) == 0) continue;
            const double p = a.texture.at<std::uint8_t>(y, x) - 128.0, q = b.texture.at<std::uint8_t>(y, x) - 128.0;
            ab += p * q;
            aa += p * p;
            bb += q * q;
        }
    return ab / std::sqrt(aa * bb);
}

}  // namespace

double hazeness_of(const Image& image) {
    const std::optional<Candidate> found = candidate_of(image, 0.0);
    return found ? found->dark_channel : 0.0;
}

double suggest_baseline(VideoReader& video, double from, double to, const Progress& progress) {
    const int first = video.frame_at(from), last = video.frame_at(to), count = last - first + 1;
    const int steps = std::min(count, most_candidates);
    std::vector<Candidate> candidates;
    Image image;
    for (int i = 0; i < steps; ++i) {
        if (progress && !progress(static_cast<double>(i) / steps))
            throw Error(Failure::runtime, Fault{.file = "", .place = "", .reason = "measuring was stopped"});
        const int frame = first + static_cast<int>(static_cast<long long>(i) * count / steps);
        if (!video.read(frame, image)) continue;
        if (auto found = candidate_of(image, video.time_of(frame))) candidates.push_back(std::move(*found));
    }
    if (candidates.empty())
        throw Error(
            Failure::bad_input,
            Fault{.file = "", .place = "", .reason = "has no frame that shows anything: all are black or missing"});
    int most = 0;
    for (Candidate& a : candidates) {
        for (const Candidate& b : candidates) a.like += likeness(a, b) > alike ? 1 : 0;
        most = std::max(most, a.like);
    }
    const Candidate* best = nullptr;
    for (const Candidate& c : candidates)
        if (c.like >= well_seen * most && (best == nullptr || c.clear > best->clear)) best = &c;
    return best->time;
}

}  // namespace lapfx::match
