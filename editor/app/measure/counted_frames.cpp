#include "app/measure/counted_frames.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "match/frame/counted.h"

namespace lapfx::app {

namespace {

constexpr double same_time = 1e-6;  // s
constexpr int veil_part = 2;        // its picture has so much less width and height: smoke is smooth

std::vector<std::uint8_t> packed(const cv::Mat& layer) {
    std::vector<std::uint8_t> bytes;
    if (!layer.empty()) cv::imencode(".png", layer, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1});
    return bytes;
}

cv::Mat unpacked(const std::vector<std::uint8_t>& bytes) {
    return bytes.empty() ? cv::Mat() : cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
}

}  // namespace

CountedFrames::Frame CountedFrames::pack(const match::Estimator* estimator, const match::FrameAmounts& amounts) {
    Frame frame{.time = amounts.time, .blood = {}, .veil = {}, .valid = {}};
    if (estimator == nullptr || (amounts.flags & match::told::missing) != 0) return frame;
    frame.valid = packed(estimator->valid());
    if (amounts.blood_measurable()) frame.blood = packed(estimator->blood());
    if (amounts.measurable()) {
        cv::Mat small;
        cv::resize(estimator->veil(), small, estimator->working_size() / veil_part, 0, 0, cv::INTER_AREA);
        small.convertTo(small, CV_8U, 255);
        frame.veil = packed(small);
    }
    return frame;
}

void CountedFrames::add(Frame frame) {
    memory_ += sizeof frame + frame.blood.capacity() + frame.veil.capacity() + frame.valid.capacity();
    frames_.push_back(std::move(frame));
}

const CountedFrames::Frame* CountedFrames::find(double time) const {
    const auto at = std::lower_bound(frames_.begin(), frames_.end(), time - same_time,
                                     [](const Frame& frame, double t) { return frame.time < t; });
    return at != frames_.end() && at->time <= time + same_time ? &*at : nullptr;
}

bool CountedFrames::draw(double time, Image& picture) const {
    const Frame* const frame = find(time);
    if (frame == nullptr) return false;
    match::MeasuredLayers layers{.blood = unpacked(frame->blood), .veil = {}, .valid = unpacked(frame->valid)};
    if (const cv::Mat veil = unpacked(frame->veil); !veil.empty()) veil.convertTo(layers.veil, CV_32F, 1.0 / 255);
    match::draw_layers(picture, layers);
    return true;
}

}  // namespace lapfx::app
