#include "match/picture/dense_flow.h"

#include <opencv2/imgproc.hpp>

#include "match/picture/colors.h"
#include "match/picture/placement.h"

namespace lapfx::match {

namespace {

constexpr double least_gain = 0.02;  // likeness: less is noise

}  // namespace

DenseFlow::DenseFlow() : search_(cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_FAST)) {
    search_->setFinestScale(1);  // half of the size: tissue moves smoothly
    search_->setUseSpatialPropagation(true);
    search_->setVariationalRefinementIterations(3);
}

bool DenseFlow::find(const cv::Mat& baseline, const cv::Mat& counts, const cv::Mat& frame, double likeness) {
    search_->calc(frame, baseline, flow_);
    map_.create(frame.size(), CV_32FC2);
    for (int y = 0; y < map_.rows; ++y) {
        const auto* from = flow_.ptr<cv::Vec2f>(y);
        auto* to = map_.ptr<cv::Vec2f>(y);
        for (int x = 0; x < map_.cols; ++x) to[x] = from[x] + cv::Vec2f(static_cast<float>(x), static_cast<float>(y));
    }
    cv::remap(baseline, moved_, map_, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT, plain_texture);
    likeness_ = likeness_of(moved_, frame, counts);
    if (likeness_ >= likeness + least_gain) return true;
    likeness_ = likeness;
    forget();
    return false;
}

}  // namespace lapfx::match
