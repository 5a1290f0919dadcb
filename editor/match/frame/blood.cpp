#include "match/frame/blood.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr double surer = 1.15;  // factor on redness and rise for what is surely blood
// Blood takes light from the tissue that it covers, so it is not far brighter: what was dark and is not has smoke
// before it.
constexpr float most_lit = 3.0F, least_lit = 0.01F;  // linear red
constexpr int least_area = 6;                        // px of surely blood, for a patch to count
// Tissue moves by itself, and red tissue beside pale is no blood when it comes a little nearer; what it leaves shaded
// is maybe blood with a rim that looks sure. Found on clear real clips in which it moves; it costs the renders 0.001.
constexpr int moves_by = 2;         // px
constexpr double sure_share = 0.3;  // of a patch
// Thickness of a film (its edge has .06, as it is drawn) and how sure it is, of what may be blood, of what surely is,
// and of what is left out when the veil is looked for. They were tuned on known blood over real and rendered tissue.
constexpr float maybe_film = 0.05F, maybe_certain = 1.5F, sure_film = 0.1F, sure_certain = 3.5F;
constexpr float redder_film = 0.035F, redder_certain = 1.0F;
constexpr float thin_redness = 0.7F, thin_rise = 0.15F, surely_red = 1.1F;
constexpr double sure_share_of_film = 0.25;
constexpr float film_lit = 1.1F;                            // most light of a film over the tissue's: noise
constexpr float code_power = 2.2F;                          // of light, by its code value
constexpr int fill_reach = 10;                              // px from which hidden places are filled
constexpr float redder_rise = 1.1F, redder_redness = 0.8F;  // of what is left out when the veil is looked for
constexpr double drift_share = 0.35;                        // of the tissue: blood may cover the rest
constexpr double drift_of_veil = 0.6;                       // most drift, per veil
constexpr float least_drop = 3.0F;  // code values that blood takes from green and blue, or it cannot be read
constexpr float sure_drop = 25.0F;  // the same of what is surely blood, where no smoke is before it

}  // namespace

void BloodFinder::find(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& frame,
                       const cv::Mat& veil, const cv::Mat& light, const cv::Mat& valid, const BloodQualifier& qualifier,
                       bool well_placed) {
    if (well_placed)
        find_film(baseline, baseline_redness, frame, veil, light, valid, qualifier);
    else
        find_redder(baseline, baseline_redness, frame, veil, light, valid, qualifier);
    grow(valid, well_placed ? sure_share_of_film : sure_share);
    fill_hidden(valid);
}

/// What is redder than all tissue near by was: tissue that is not in its place is not.
void BloodFinder::find_redder(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& frame,
                              const cv::Mat& veil, const cv::Mat& light, const cv::Mat& valid,
                              const BloodQualifier& qualifier) {
    const QuickCode quick_code;
    clear_.create(frame.size(), CV_32FC3);
    drop_.create(frame.size(), CV_32F);
    for (cv::Mat* m : {&sure_, &maybe_, &hidden_, &redder_}) m->create(frame.size(), CV_8U);
    for (int y = 0; y < frame.rows; ++y)
        for (int x = 0; x < frame.cols; ++x) {
            const float through = std::max(1.0F - veil.at<float>(y, x), 0.5F * least_through);
            cv::Vec3f clear =
                (frame.at<cv::Vec3f>(y, x) - light.at<cv::Vec3f>(y, x) * (1.0F - through)) * (1.0F / through);
            for (int k = 0; k < 3; ++k) clear[k] = std::clamp(clear[k], 0.0F, 1.0F);
            clear_.at<cv::Vec3f>(y, x) = clear;
            // How much darker green and blue are than tissue behind that veil would be.
            const cv::Vec3f &f = frame.at<cv::Vec3f>(y, x), &h = light.at<cv::Vec3f>(y, x);
            const cv::Vec3f tissue =
                baseline.at<cv::Vec3f>(y, x) * (1.0F - veil.at<float>(y, x)) + h * veil.at<float>(y, x);
            drop_.at<float>(y, x) =
                0.5F * (quick_code(tissue[0]) + quick_code(tissue[1]) - quick_code(f[0]) - quick_code(f[1]));
        }
    cv::blur(drop_, drop_, {3, 3});
    reddest_near(baseline_redness, valid);
    cv::GaussianBlur(clear_, clear_, {3, 3}, 0);
    redness_of(clear_, redness_);
    const float brightest = linear_of(static_cast<float>(255.0 * qualifier.brightness));
    const auto redness = static_cast<float>(qualifier.redness);
    // A veil that was taken for too dense makes all tissue redder, and blood redder still.
    const float drift = drift_of(baseline_redness, veil, valid), rise = static_cast<float>(qualifier.rise) * drift;
    for (int y = 0; y < frame.rows; ++y)
        for (int x = 0; x < frame.cols; ++x) {
            const cv::Vec3f &clear = clear_.at<cv::Vec3f>(y, x), &before = baseline.at<cv::Vec3f>(y, x);
            const float red = redness_.at<float>(y, x), was = near_.at<float>(y, x);
            const bool inside = valid.at<std::uint8_t>(y, x) != 0;
            const bool hidden =
                1.0F - veil.at<float>(y, x) < least_through || std::max(clear[2], before[2]) < darkest_red;
            const bool can = inside && !hidden && clear[2] <= brightest &&
                             clear[2] <= most_lit * before[2] + least_lit && drop_.at<float>(y, x) >= least_drop;
            hidden_.at<std::uint8_t>(y, x) = inside && hidden ? 255 : 0;
            maybe_.at<std::uint8_t>(y, x) = can && red >= redness && red >= rise * was ? 255 : 0;
            const float open = 1.0F - veil.at<float>(y, x);
            const bool strong = drop_.at<float>(y, x) >= sure_drop * open * open;
            sure_.at<std::uint8_t>(y, x) =
                can && strong && red >= surer * redness && red >= surer * rise * was ? 255 : 0;
            redder_.at<std::uint8_t>(y, x) =
                can && red >= redder_rise * drift * was && red >= redder_redness * redness ? 255 : 0;
        }
}

/// Where a film of blood explains the change, and what is left is red. The qualifier says how red thick blood is, and
/// how much redder than tissue that is not pale: a thin film is less, by thin_redness and thin_rise.
void BloodFinder::find_film(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& frame,
                            const cv::Mat& veil, const cv::Mat& light, const cv::Mat& valid,
                            const BloodQualifier& qualifier) {
    film_.solve(baseline, frame, veil, light, valid);
    film_.hidden().copyTo(hidden_);
    cv::GaussianBlur(film_.clear(), clear_, {3, 3}, 0);
    redness_of(clear_, redness_);
    reddest_near(baseline_redness, valid);
    for (cv::Mat* m : {&sure_, &maybe_, &redder_}) m->create(valid.size(), CV_8U);
    const float brightest = linear_of(static_cast<float>(255.0 * qualifier.brightness));
    const float redness = thin_redness * static_cast<float>(qualifier.redness),
                rise = 1.0F + thin_rise * static_cast<float>(qualifier.rise - 1.0);
    // The white balance changes redness as well.
    const cv::Vec3f& gains = film_.gains();
    const float drift = std::pow(gains[2] / std::sqrt(gains[0] * gains[1]), 1.0F / code_power);
    // A film on bright tissue is nearly as bright as that, and redder: a highlight is brighter than the tissue.
    const float bright = film_lit * gains[2] / linear_of(static_cast<float>(255.0 * BloodQualifier{}.brightness));
    for (int y = 0; y < valid.rows; ++y)
        for (int x = 0; x < valid.cols; ++x) {
            const float most = brightest * std::max(1.0F, bright * baseline.at<cv::Vec3f>(y, x)[2]);
            const float film = film_.thickness().at<float>(y, x), certain = film_.sureness().at<float>(y, x);
            const float red = redness_.at<float>(y, x), was = drift * baseline_redness.at<float>(y, x);
            const bool can = valid.at<std::uint8_t>(y, x) != 0 && hidden_.at<std::uint8_t>(y, x) == 0 &&
                             clear_.at<cv::Vec3f>(y, x)[2] <= most;
            const auto mark = [&](cv::Mat& into, bool so) { into.at<std::uint8_t>(y, x) = can && so ? 255 : 0; };
            mark(redder_, film >= redder_film && certain >= redder_certain && red >= redder_redness * redness);
            mark(maybe_, film >= maybe_film && certain >= maybe_certain && red >= redness && red >= rise * was);
            mark(sure_, film >= sure_film && certain >= sure_certain && red >= surely_red * redness &&
                            red >= (2.0F * rise - 1.0F) * drift * near_.at<float>(y, x));
        }
}

/// The factor of redness over the baseline that most of the tissue has, within what a veil's error can do.
float BloodFinder::drift_of(const cv::Mat& baseline_redness, const cv::Mat& veil, const cv::Mat& valid) {
    ratios_.clear();
    double veils = 0.0;
    for (int y = 0; y < valid.rows; y += 2)
        for (int x = 0; x < valid.cols; x += 2) {
            if (valid.at<std::uint8_t>(y, x) == 0 || 1.0F - veil.at<float>(y, x) < least_through) continue;
            ratios_.push_back(redness_.at<float>(y, x) / baseline_redness.at<float>(y, x));
            veils += static_cast<double>(veil.at<float>(y, x));
        }
    if (ratios_.empty()) return 1.0F;
    const auto count = static_cast<double>(ratios_.size());
    const auto place = ratios_.begin() + static_cast<std::ptrdiff_t>(drift_share * count);
    std::nth_element(ratios_.begin(), place, ratios_.end());
    return std::clamp(*place, 1.0F, 1.0F + static_cast<float>(drift_of_veil * veils / count));
}

/// The reddest that tissue of the baseline is within its own motion.
void BloodFinder::reddest_near(const cv::Mat& baseline_redness, const cv::Mat& valid) {
    near_.create(valid.size(), CV_32F);
    near_.setTo(0.0F);
    baseline_redness.copyTo(near_, valid);
    static const cv::Mat around = cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * moves_by + 1, 2 * moves_by + 1});
    cv::dilate(near_, near_, around);
}

void BloodFinder::grow(const cv::Mat& valid, double of_patch) {
    blood_.create(valid.size(), CV_8U);
    blood_.setTo(0);
    const int count = cv::connectedComponents(maybe_, labels_, 8, CV_32S);
    std::vector<int> seeds(static_cast<std::size_t>(count), 0), areas = seeds;
    for (int y = 0; y < valid.rows; ++y)
        for (int x = 0; x < valid.cols; ++x) {
            const auto label = static_cast<std::size_t>(labels_.at<int>(y, x));
            ++areas[label];
            if (sure_.at<std::uint8_t>(y, x) != 0) ++seeds[label];
        }
    const auto blood = [&](std::size_t label) {
        return label > 0 && seeds[label] >= std::max(static_cast<double>(least_area), of_patch * areas[label]);
    };
    for (int y = 0; y < valid.rows; ++y)
        for (int x = 0; x < valid.cols; ++x) {
            if (blood(static_cast<std::size_t>(labels_.at<int>(y, x)))) blood_.at<std::uint8_t>(y, x) = 255;
        }
}

void BloodFinder::fill_hidden(const cv::Mat& valid) {
    if (cv::countNonZero(hidden_) == 0) return;
    const cv::Size window(2 * fill_reach + 1, 2 * fill_reach + 1);
    cv::subtract(valid, hidden_, decided_);
    decided_.convertTo(weight_, CV_32F, 1.0 / 255.0);
    blood_.convertTo(share_, CV_32F, 1.0 / 255.0);
    cv::blur(weight_, weight_, window, {-1, -1}, cv::BORDER_CONSTANT);
    cv::blur(share_, share_, window, {-1, -1}, cv::BORDER_CONSTANT);
    for (int y = 0; y < valid.rows; ++y)
        for (int x = 0; x < valid.cols; ++x)
            if (hidden_.at<std::uint8_t>(y, x) != 0 && share_.at<float>(y, x) > 0.5F * weight_.at<float>(y, x))
                blood_.at<std::uint8_t>(y, x) = 255;
}

}  // namespace lapfx::match
