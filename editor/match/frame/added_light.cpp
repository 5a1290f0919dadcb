#include "match/frame/added_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/frame/frame_amounts.h"
#include "match/frame/smoke_tint.h"

namespace lapfx::match {

namespace {

const cv::Vec3f luminance_weights(0.0722F, 0.7152F, 0.2126F);
const cv::Vec3f& tint = usual_smoke_tint;
constexpr float tint_doubt = 0.15F;  // of the light: as much of it may have the tissue's colour, or lack it

constexpr float white = 0.90F;            // linear: highlights tell nothing
constexpr int window = 7;                 // of half pixels
constexpr float least_share = 0.3F;       // of a window that is looked at
constexpr float least_color = 0.02F;      // linear, across the tint: less tells no slope
constexpr float color_noise = 0.005F;     // linear, of a window's mean
constexpr double least_lit = 0.1;         // of the places: the gain is told there
constexpr float light_noise = 0.004F;     // linear: places with so much more light are as little lit
constexpr std::size_t least_places = 50;  // of half pixels
// Brightness of smoke for its veil over that of haze: near the lens, and the least.
constexpr float brightest = 3.4F, dimmest = 0.6F;
// What puffs hide is at most this; how far that is off, as a standard deviation.
constexpr float most_hidden = 0.25F, transmission_doubt = 0.25F;
constexpr float usual_brightness = 2.0F;

float luminance(const cv::Vec3f& color) {
    return color.dot(luminance_weights);
}

/// What is left of a colour without its part along the tint.
cv::Vec3f across_tint(const cv::Vec3f& color) {
    return color - tint * (color.dot(tint) / tint.dot(tint));
}

float quantile_of(std::vector<float>& values, double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

void AddedLightFinder::mean_colors(const cv::Mat& picture, cv::Mat& into) {
    picture.copyTo(half_);
    half_.setTo(cv::Scalar::all(0.0), counted_ == 0);
    cv::resize(half_, into, shares_.size(), 0, 0, cv::INTER_AREA);
    cv::blur(into, into, {window, window}, {-1, -1}, cv::BORDER_CONSTANT);
}

void AddedLightFinder::find_places(const cv::Mat& dense) {
    places_.clear();
    for (int y = 0; y < shares_.rows; ++y)
        for (int x = 0; x < shares_.cols; ++x) {
            const float share = shares_.at<float>(y, x);
            const cv::Point at(std::min(2 * x, counted_.cols - 1), std::min(2 * y, counted_.rows - 1));
            if (share < least_share || counted_.at<std::uint8_t>(at) == 0) continue;
            Place place{.baseline = means_of_baseline_.at<cv::Vec3f>(y, x) / share,
                        .frame = means_of_frame_.at<cv::Vec3f>(y, x) / share,
                        .dense = luminance(dense.at<cv::Vec3f>(at)),
                        .across = 0.0F,
                        .slope = 0.0F,
                        .light = 0.0F};
            const cv::Vec3f tissue = across_tint(place.baseline);
            place.across = std::max(tissue.dot(tissue), 1e-8F);
            place.slope = place.frame.dot(tissue) / place.across;
            place.light = (place.frame - place.baseline * place.slope).dot(tint) / tint.dot(tint);
            // No smoke takes light away: then the whole colour tells the slope.
            if (place.light < 0.0F) place.slope = place.frame.dot(place.baseline) / place.baseline.dot(place.baseline);
            places_.push_back(place);
        }
}

void AddedLightFinder::find_gain(AddedLight& found) {
    const auto tells = [](const Place& place) { return place.across > least_color * least_color; };
    sorted_.clear();
    for (const Place& place : places_)
        if (tells(place)) sorted_.push_back(place.light);
    if (sorted_.size() < least_places) return;
    const float most = std::max(quantile_of(sorted_, least_lit), 0.0F) + light_noise;
    const auto middle_of = [&](float brightness, double share) {
        sorted_.clear();
        for (const Place& place : places_)
            if (tells(place) && place.light <= most)
                sorted_.push_back(place.slope + std::max(place.light, 0.0F) / (brightness * place.dense));
        return std::clamp(static_cast<double>(quantile_of(sorted_, share)), least_gain, most_gain);
    };
    constexpr double median = 0.5, quartile = 0.25;
    found.gain = middle_of(1.0F, median);
    found.of_bright_smoke = middle_of(brightest, median);
    found.of_dim_smoke = middle_of(dimmest, median);
    found.spread = 0.5 * (middle_of(1.0F, 1.0 - quartile) - middle_of(1.0F, quartile));
    found.known = true;
}

/// The brighter the light the less its tint lets the tissue's colour tell; then what smoke hides as a rule counts more.
void AddedLightFinder::find_light(AddedLight& found) const {
    double light = 0.0, tissue = 0.0;
    const auto gain = static_cast<float>(found.gain);
    for (const Place& place : places_) {
        const float added = std::max(place.light, 0.0F) / gain, noise = color_noise + tint_doubt * added;
        const float usual = 1.0F - std::min(added / (usual_brightness * place.dense), most_hidden);
        const float seen = place.across / (noise * noise), held = 1.0F / (transmission_doubt * transmission_doubt);
        const float transmission = (seen * place.slope / gain + held * usual) / (seen + held);
        light += luminance(place.frame) / gain - transmission * luminance(place.baseline);
        tissue += luminance(place.baseline);
    }
    const auto count = static_cast<double>(places_.size());
    found.light = std::max(light / count, 0.0);
    found.tissue = tissue / count;
}

AddedLight AddedLightFinder::find(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& dense,
                                  const cv::Mat& part) {
    part.copyTo(counted_);
    for (int y = 0; y < counted_.rows; ++y)
        for (int x = 0; x < counted_.cols; ++x) {
            const auto& b = baseline.at<cv::Vec3f>(y, x);
            if (std::max({b[0], b[1], b[2]}) >= white) counted_.at<std::uint8_t>(y, x) = 0;
        }
    const cv::Size half((part.cols + 1) / 2, (part.rows + 1) / 2);
    counted_.convertTo(half_, CV_32F, 1.0 / 255.0);
    cv::resize(half_, shares_, half, 0, 0, cv::INTER_AREA);
    cv::blur(shares_, shares_, {window, window}, {-1, -1}, cv::BORDER_CONSTANT);
    mean_colors(baseline, means_of_baseline_);
    mean_colors(frame, means_of_frame_);
    find_places(dense);
    AddedLight found;
    find_gain(found);
    if (found.known) find_light(found);
    return found;
}

}  // namespace lapfx::match
