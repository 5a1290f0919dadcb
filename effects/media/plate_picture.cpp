#include "media/plate_picture.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "lapfx/error.h"
#include "media/camera_motion.h"
#include "media/opencv.h"

namespace lapfx::media {

namespace {

constexpr int looked_at = 48;        // frames
constexpr int study_width = 160;     // px at which frames are judged: noise and compression do not count
constexpr int dark_patch = 7;        // px of that
constexpr double least_light = 0.6;  // frames with less than this part of the median are dark
constexpr double still = 0.2;  // px: a camera that moves the corners by less has not moved, and nothing is resampled

std::string seconds(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g s", value);
    return text;
}

/// The mean of `values` where the mask is set; 0 where it is empty.
double mean_of(const cv::Mat& values, const cv::Mat1b& mask) {
    return cv::mean(values, mask)[0];
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// 255 where a pixel of the picture is valid as a whole.
cv::Mat1b mask_of(const ValidView& view, cv::Size size) {
    cv::Mat1b mask(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) mask(y, x) = view.share({x, y}) >= 1.0 ? 255 : 0;
    return mask;
}

int chosen_frame(const VideoReader& video, double time) {
    const double duration = video.info().duration;
    if (time < 0.0 || time > duration)
        throw Error(Failure::bad_input,
                    Fault{.file = "",
                          .place = "/plate/time",
                          .reason = seconds(time) + " is outside the reference, which ends at " + seconds(duration)});
    return video.frame_at(time + 5e-4);  // a time as it is written may fall just short of the frame's own
}

/// Frames evenly from the span around `frame`, ascending, and itself first.
std::vector<int> frames_around(const VideoReader& video, int frame, int count, double span) {
    std::set<int> all{frame};
    const double time = video.time_of(frame), from = std::max(0.0, time - span / 2),
                 to = std::min(video.info().duration, time + span / 2);
    for (int i = 0; i < count; ++i)
        if (all.size() < static_cast<std::size_t>(count))
            all.insert(video.frame_at(count == 1 ? time : from + (to - from) * i / (count - 1)));
    std::vector<int> frames{frame};
    for (const int one : all)
        if (one != frame) frames.push_back(one);
    return frames;
}

bool read(VideoReader& video, int frame, Image& picture, const std::atomic<bool>* stop) {
    const bool good = video.read(frame, picture, stop);
    if (stop != nullptr && *stop) throw work::Stopped{};
    return good;
}

/// Lays `picture` over the one that the motion comes from. Alpha is 0 where it shows nothing of it.
Image laid_over(const Image& picture, const glm::dmat3& motion, const ValidView& view) {
    const cv::Size size(picture.width, picture.height);
    cv::Matx33d matrix;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) matrix(r, c) = motion[c][r];
    Image laid{.width = size.width, .height = size.height, .pixels = picture.pixels, .name = ""};
    cv::Mat4b pixels = pixels_of(laid);
    const cv::Mat1b mask = mask_of(view, size);
    cv::Mat4b source = pixels_of(picture).clone();
    cv::insertChannel(mask, source, 3);
    cv::warpPerspective(source, pixels, matrix, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT,
                        cv::Scalar::all(0));
    return laid;
}

bool moves_nothing(const glm::dmat3& motion, glm::dvec2 size) {
    for (const glm::dvec2 corner : {glm::dvec2(0), {size.x, 0}, {0, size.y}, size})
        if (glm::distance(moved(motion, corner), corner) > still) return false;
    return true;
}

std::uint8_t median_of(std::span<std::uint8_t> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    if (values.size() % 2 == 1) return values[half];
    return static_cast<std::uint8_t>((values[half - 1] + values[half] + 1) / 2);
}

}  // namespace

Clearness clearness_of(const Image& picture, const ValidView& view) {
    const double scale = std::min(1.0, static_cast<double>(study_width) / picture.width);
    cv::Mat4b small;
    cv::resize(pixels_of(picture), small, {}, scale, scale, cv::INTER_AREA);
    cv::Mat1b mask;
    cv::resize(mask_of(view, pixels_of(picture).size()), mask, small.size(), 0, 0, cv::INTER_NEAREST);
    cv::erode(mask, mask, cv::Mat::ones(dark_patch, dark_patch, CV_8U), {-1, -1}, 1, cv::BORDER_CONSTANT,
              cv::Scalar(0));
    std::vector<cv::Mat1b> channels;
    cv::split(small, channels);
    const cv::Mat1b most(cv::max(cv::max(channels[0], channels[1]), channels[2]));
    const cv::Mat1b least(cv::min(cv::min(channels[0], channels[1]), channels[2]));
    cv::Mat1b dark;
    cv::erode(least, dark, cv::Mat::ones(dark_patch, dark_patch, CV_8U));
    cv::Mat1f saturation, x, y, steepness;
    cv::divide(most - least, cv::max(most, 1), saturation, 1.0, CV_32F);
    cv::Mat1b grey;
    cv::cvtColor(small, grey, cv::COLOR_RGBA2GRAY);
    cv::Sobel(grey, x, CV_32F, 1, 0);
    cv::Sobel(grey, y, CV_32F, 0, 1);
    cv::magnitude(x, y, steepness);
    return {.contrast = mean_of(steepness, mask) / 255.0,
            .saturation = mean_of(saturation, mask),
            .veil = mean_of(dark, mask) / 255.0,
            .light = mean_of(grey, mask) / 255.0};
}

int clearest_frame(VideoReader& video, const work::Stages& stages, const std::atomic<bool>* stop) {
    const int frames = video.info().frames, count = std::min(frames, looked_at);
    std::vector<int> which;
    std::vector<Clearness> found;
    std::vector<double> light;
    Image picture;
    for (int i = 0; i < count; ++i) {
        stages.reach(static_cast<double>(i) / count);
        const int frame = static_cast<int>((static_cast<std::int64_t>(i) * 2 + 1) * frames / (2 * count));
        if (!read(video, frame, picture, stop)) continue;
        which.push_back(frame);
        found.push_back(clearness_of(picture, valid_view(picture)));
        light.push_back(found.back().light);
    }
    if (which.empty()) return 0;
    const double usual = median_of(light);
    std::size_t best = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < which.size(); ++i)
        if (found[i].light >= least_light * usual && found[i].value() > most) most = found[i].value(), best = i;
    return which[best];
}

Image blended(const std::vector<Image>& pictures, const ValidView& view, int& left_out, const work::Stages& stages) {
    const Image& first = pictures.front();
    std::vector<Image> laid;
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        stages.reach(static_cast<double>(i) / static_cast<double>(pictures.size()));
        const std::optional<glm::dmat3> motion = camera_motion(first, pictures[i], view);
        if (!motion)
            ++left_out;
        else if (moves_nothing(*motion, glm::dvec2(first.width, first.height)))
            laid.push_back(pictures[i]);
        else
            laid.push_back(laid_over(pictures[i], *motion, view));
    }
    Image made = first;
    std::vector<std::uint8_t> values;
    for (std::size_t i = 0; i + 3 < made.pixels.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c) {
            values.assign(1, first.pixels[i + c]);
            for (const Image& image : laid)
                if (image.pixels[i + 3] == 255) values.push_back(image.pixels[i + c]);
            made.pixels[i + c] = median_of(values);
        }
    return made;
}

PlatePicture plate_picture(VideoReader& video, const ScenePlate& wanted, const work::Stages& stages,
                           const std::atomic<bool>* stop) {
    const bool suggested = wanted.frame == PlateFrame::clearest;
    const double searched = suggested ? 0.6 : 0.0;
    const int frame =
        suggested ? clearest_frame(video, stages.part(0.0, searched), stop) : chosen_frame(video, wanted.time);
    PlatePicture made;
    made.time = video.time_of(frame);
    const std::vector<int> frames = frames_around(video, frame, wanted.frames, wanted.span);
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        stages.reach(searched + 0.2 * static_cast<double>(i) / static_cast<double>(frames.size()));
        Image picture;
        // One that cannot be decoded shows the one before it, or black.
        const bool good = read(video, frames[i], picture, stop);
        if (good || i == 0) pictures.push_back(std::move(picture));
    }
    if (pictures.front().pixels.empty())
        throw Error(Failure::runtime,
                    Fault{.file = "", .place = "/plate", .reason = "no memory for a frame of the reference"});
    made.view = valid_view(pictures.front());
    made.image = blended(pictures, made.view, made.left_out, stages.part(searched + 0.2, 1.0));
    made.blended = static_cast<int>(pictures.size()) - made.left_out;
    for (int y = 0; y < made.image.height; ++y)
        for (int x = 0; x < made.image.width; ++x)
            made.image.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(made.image.width) +
                                   static_cast<std::size_t>(x)) +
                              3] = static_cast<std::uint8_t>(std::lround(255.0 * made.view.share({x, y})));
    stages.reach(1.0);
    return made;
}

}  // namespace lapfx::media
