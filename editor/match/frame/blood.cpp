#include "match/frame/blood.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr int least_area = 6;  // px of surely blood, for a patch to count
constexpr int moves_by = 2;    // px by which tissue moves where the baseline lies well
// Where it does not, tissue may lie as far from its place as this, by the likeness, with lines between; red tissue that
// came nearer is no blood. Chosen by known blood over real clips in which tissue moves, and by real blood that a person
// labelled.
struct Moves {
    double likeness, px;  // of 256
};
constexpr Moves tissue_moves[] = {{0.3, 20.0}, {0.5, 8.0}, {0.7, 3.0}};
constexpr double maybe_nearer = 0.5;  // of these px, for what may be blood
// There the map of the veil is known badly, too. But smoke adds no more blue and green, which blood leaves dark, than
// the darkest place within so many px of 256 has, and no more of it is removed than is beyond that error. Both were
// chosen by known blood over tissue that moves (video01_010 to 298 without those that the bench holds out, and
// DeSmoke-LAP).
constexpr double smoke_within = 24.0;
constexpr float unsure_veil = 0.03F;
constexpr float most_smoke = 0.7F;  // of the light: what remains is noise
constexpr float least_light = 1e-3F;
constexpr int every = 2, halvings = 6;                // px; of the search for how much of it
constexpr std::size_t palest = 4;                     // a quarter of the tissue is paler
constexpr double least_red = 0.72;                    // share of the qualifier's redness
constexpr double sure_more = 0.75, maybe_more = 0.3;  // shares of the qualifier's rise over 1
constexpr float least_code = 50.0F;                   // of red: what lies darker in a shadow seems redder
constexpr double sure_share = 0.25;                   // of a patch
// Cameras show less light than there is by a black level, so that the same tissue is redder in the shade: a liver of
// code values 173, 93, 93 has a rim of 65, 18, 21. With this much added back (linear), shade changes no redness; of
// tissue so compared, blood is redder by these factors. They were chosen by clips without blood (video01_200, 202, 288,
// video02_130) and by known blood over tissue that moves (video01_010, 024, 064, 192, 194, 198, 200, 202, 203).
constexpr float black_level = 0.006F;
constexpr float sure_unshaded = 1.3F, maybe_unshaded = 1.1F;
constexpr float redder_than_shade = 8.0F;  // livers of these clips reach 7.8 at the rim of the light
// What is dark and hardly red in the baseline is a black shaft: what it covers has never been seen. Chosen by
// video02_130 and by that known blood.
constexpr float covered_redness = 1.65F;
constexpr double least_covered = 2.0, beside_covered = 2.0;  // px: half of its width; around it
// Thickness of a film (its edge has .06, as it is drawn) and how sure it is, of what may be blood, of what surely is,
// and of what is left out when the veil is looked for. They were tuned on known blood over real and rendered tissue.
constexpr float maybe_film = 0.05F, maybe_certain = 1.5F, sure_film = 0.1F, sure_certain = 3.5F;
constexpr float redder_film = 0.035F, redder_certain = 1.0F;
constexpr float thin_redness = 0.7F, thin_rise = 0.15F, surely_red = 1.1F;
constexpr double sure_share_of_film = 0.25;
constexpr float film_lit = 1.1F;        // most light of a film over the tissue's: noise
constexpr float code_power = 2.2F;      // of light, by its code value
constexpr int fill_reach = 10;          // px from which hidden places are filled
constexpr float redder_redness = 0.8F;  // of what is left out when the veil is looked for

/// Red over the mean of green and blue, in light as it is before the camera takes its black level away.
float unshaded_redness(const cv::Vec3f& linear) {
    return (linear[2] + black_level) / (0.5F * (linear[0] + linear[1]) + black_level);
}

cv::Vec3f without_smoke(const cv::Vec3f& seen, const cv::Vec3f& light, float smoke) {
    cv::Vec3f clear = (seen - smoke * light) * (1.0F / (1.0F - smoke));
    for (int k = 0; k < 3; ++k) clear[k] = std::max(clear[k], 0.0F);
    return clear;
}

void unshaded_redness_of(const cv::Mat& linear, cv::Mat& into) {
    into.create(linear.size(), CV_32F);
    for (int y = 0; y < linear.rows; ++y)
        for (int x = 0; x < linear.cols; ++x) into.at<float>(y, x) = unshaded_redness(linear.at<cv::Vec3f>(y, x));
}

/// The reddest that tissue of the baseline is `around` each place. `tissue`: CV_8U, where the baseline shows it.
void reddest_within(const cv::Mat& around, const cv::Mat& baseline_redness, const cv::Mat& tissue, cv::Mat& into) {
    into.create(tissue.size(), CV_32F);
    into.setTo(0.0F);
    baseline_redness.copyTo(into, tissue);
    cv::dilate(into, into, around);
}

cv::Mat square(double px) {  // a wide disc takes far longer
    const int side = 2 * static_cast<int>(std::lround(px)) + 1;
    return cv::getStructuringElement(cv::MORPH_RECT, {side, side});
}

/// px of 256 by which tissue may lie beside its place.
double moves_of(double likeness) {
    for (std::size_t i = 1; i < std::size(tissue_moves); ++i) {
        const Moves &from = tissue_moves[i - 1], &to = tissue_moves[i];
        if (likeness < to.likeness)
            return std::lerp(from.px, to.px, std::max((likeness - from.likeness) / (to.likeness - from.likeness), 0.0));
    }
    return std::rbegin(tissue_moves)->px;
}

}  // namespace

void BloodFinder::find(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& frame,
                       const cv::Mat& veil, const cv::Mat& light, const cv::Mat& valid, const BloodQualifier& qualifier,
                       const Laid& laid) {
    see_covered(baseline, baseline_redness, laid.tissue.empty() ? valid : laid.tissue);
    if (laid.well)
        find_film(baseline, baseline_redness, frame, veil, light, valid, qualifier);
    else
        find_redder(baseline, baseline_redness, frame, veil, light, valid, qualifier, laid);
    grow(valid, laid.well ? sure_share_of_film : sure_share);
    fill_hidden(valid);
}

/// Tissue that a black shaft uncovers is redder than the shaft was, and no blood for that. The black surround, which is
/// no part of `tissue`, covers nothing.
void BloodFinder::see_covered(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& tissue) {
    const float darkest = linear_of(least_code);
    covered_.create(baseline.size(), CV_8U);
    for (int y = 0; y < baseline.rows; ++y)
        for (int x = 0; x < baseline.cols; ++x) {
            const bool dark = baseline.at<cv::Vec3f>(y, x)[2] < darkest;
            covered_.at<std::uint8_t>(y, x) = dark && baseline_redness.at<float>(y, x) < covered_redness ? 255 : 0;
        }
    covered_ &= tissue;
    cv::morphologyEx(covered_, covered_, cv::MORPH_OPEN, square(least_covered));
    cv::dilate(covered_, covered_, square(beside_covered));
}

void BloodFinder::clear_smoke(const cv::Mat& frame, const cv::Mat& veil, const cv::Mat& light) {
    clear_.create(frame.size(), CV_32FC3);
    for (int y = 0; y < frame.rows; ++y)
        for (int x = 0; x < frame.cols; ++x) {
            const float smoke = std::min(veil.at<float>(y, x), 1.0F - 0.5F * least_through);
            cv::Vec3f clear = without_smoke(frame.at<cv::Vec3f>(y, x), light.at<cv::Vec3f>(y, x), smoke);
            for (int k = 0; k < 3; ++k) clear[k] = std::min(clear[k], 1.0F);
            clear_.at<cv::Vec3f>(y, x) = clear;
        }
    cv::GaussianBlur(clear_, clear_, {3, 3}, 0);
    redness_of(clear_, redness_);
}

/// Of the smoke that the map tells, how much may be removed until the palest of the tissue is as red as the baseline's
/// was: what a map that is too dense would make redder stays as it is. Blood is not among the palest, unless it covers
/// nearly all.
float BloodFinder::share_of_smoke(const cv::Mat& light, const cv::Mat& valid, const cv::Mat& tissue) {
    const auto pale = [this] {
        if (reds_.empty()) return 0.0F;
        const auto at = reds_.begin() + static_cast<std::ptrdiff_t>(reds_.size() / palest);
        std::nth_element(reds_.begin(), at, reds_.end());
        return *at;
    };
    const auto each = [&](const cv::Mat& part, const auto& red_at) {
        reds_.clear();
        for (int y = 0; y < part.rows; y += every)
            for (int x = 0; x < part.cols; x += every)
                if (part.at<std::uint8_t>(y, x) != 0) reds_.push_back(red_at(y, x));
    };
    each(tissue, [this](int y, int x) { return unshaded_.at<float>(y, x); });
    const float was = pale();
    float low = 0.0F, high = 1.0F;
    for (int i = 0; i < halvings; ++i) {
        const float share = 0.5F * (low + high);
        each(valid, [&](int y, int x) {
            return unshaded_redness(
                without_smoke(seen_.at<cv::Vec3f>(y, x), light.at<cv::Vec3f>(y, x), share * smoke_.at<float>(y, x)));
        });
        (pale() <= was ? low : high) = share;
    }
    return low;
}

/// The frame without the smoke that is surely before it: no more than the darkest place near by leaves, and than makes
/// the palest tissue as red as it was. `unshaded_` is that of the baseline.
void BloodFinder::clear_sure_smoke(const cv::Mat& frame, const cv::Mat& veil, const cv::Mat& light,
                                   const cv::Mat& valid, const cv::Mat& tissue, double within) {
    cv::GaussianBlur(frame, seen_, {3, 3}, 0);
    smoke_.create(frame.size(), CV_32F);
    for (int y = 0; y < frame.rows; ++y)
        for (int x = 0; x < frame.cols; ++x) {
            const cv::Vec3f &f = seen_.at<cv::Vec3f>(y, x), &l = light.at<cv::Vec3f>(y, x);
            const bool known = valid.at<std::uint8_t>(y, x) != 0;
            const float most = std::min(f[0] / std::max(l[0], least_light), f[1] / std::max(l[1], least_light));
            smoke_.at<float>(y, x) = known ? std::min(most, most_smoke) : most_smoke;
        }
    cv::erode(smoke_, smoke_, square(within));
    for (int y = 0; y < frame.rows; ++y)
        for (int x = 0; x < frame.cols; ++x) {
            const float sure = std::max(veil.at<float>(y, x) - unsure_veil, 0.0F);
            smoke_.at<float>(y, x) = std::min(smoke_.at<float>(y, x), sure);
        }
    const float share = share_of_smoke(light, valid, tissue);
    for (int y = 0; y < frame.rows; ++y)
        for (int x = 0; x < frame.cols; ++x) {
            cv::Vec3f& here = seen_.at<cv::Vec3f>(y, x);
            here = without_smoke(here, light.at<cv::Vec3f>(y, x), share * smoke_.at<float>(y, x));
        }
    redness_of(seen_, seen_redness_);
}

/// What is redder than all tissue near by was, with no more smoke removed than is surely there. Blood behind a veil is
/// missed rather than invented, and so is blood in the shade that only the shade may make redder.
void BloodFinder::find_redder(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& frame,
                              const cv::Mat& veil, const cv::Mat& light, const cv::Mat& valid,
                              const BloodQualifier& qualifier, const Laid& laid) {
    for (cv::Mat* m : {&sure_, &maybe_, &hidden_, &redder_}) m->create(frame.size(), CV_8U);
    clear_smoke(frame, veil, light);
    const double px = std::max(frame.cols, frame.rows) / 256.0;
    const cv::Mat& tissue = laid.tissue.empty() ? valid : laid.tissue;
    unshaded_redness_of(baseline, unshaded_);
    clear_sure_smoke(frame, veil, light, valid, tissue, smoke_within * px);
    const double moves = moves_of(laid.likeness) * px;
    reddest_within(square(moves), baseline_redness, tissue, near_);
    reddest_within(square(maybe_nearer * moves), baseline_redness, tissue, nearer_);
    reddest_within(square(moves), unshaded_, tissue, unshaded_near_);
    reddest_within(square(maybe_nearer * moves), unshaded_, tissue, unshaded_nearer_);
    unshaded_redness_of(seen_, unshaded_);
    const float brightest = linear_of(static_cast<float>(255.0 * qualifier.brightness)),
                darkest = linear_of(least_code);
    const auto least = static_cast<float>(least_red * qualifier.redness);
    const auto more = [&qualifier](double share) { return static_cast<float>(1.0 + share * (qualifier.rise - 1.0)); };
    const float sure_rise = more(sure_more), maybe_rise = more(maybe_more);
    for (int y = 0; y < frame.rows; ++y)
        for (int x = 0; x < frame.cols; ++x) {
            const float red = seen_redness_.at<float>(y, x), unshaded = unshaded_.at<float>(y, x),
                        light_of = seen_.at<cv::Vec3f>(y, x)[2];
            const bool inside = valid.at<std::uint8_t>(y, x) != 0;
            const bool hidden = 1.0F - veil.at<float>(y, x) < least_through || light_of < darkest_red;
            const bool lit = inside && !hidden && light_of >= darkest,
                       can = lit && light_of <= brightest && red >= least && covered_.at<std::uint8_t>(y, x) == 0;
            const auto redder_than = [&](float factor, const cv::Mat& tissue_near) {
                return unshaded >= std::min(factor * tissue_near.at<float>(y, x), redder_than_shade);
            };
            const auto mark = [&](cv::Mat& into, bool so) { into.at<std::uint8_t>(y, x) = so ? 255 : 0; };
            mark(hidden_, inside && hidden);
            mark(sure_, can && red >= sure_rise * near_.at<float>(y, x) && redder_than(sure_unshaded, unshaded_near_));
            mark(maybe_,
                 can && red >= maybe_rise * nearer_.at<float>(y, x) && redder_than(maybe_unshaded, unshaded_nearer_));
            mark(redder_, lit && red >= redder_redness * least && red >= nearer_.at<float>(y, x));
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
    static const cv::Mat around = cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * moves_by + 1, 2 * moves_by + 1});
    reddest_within(around, baseline_redness, valid, near_);
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
                             covered_.at<std::uint8_t>(y, x) == 0 && clear_.at<cv::Vec3f>(y, x)[2] <= most;
            const auto mark = [&](cv::Mat& into, bool so) { into.at<std::uint8_t>(y, x) = can && so ? 255 : 0; };
            mark(redder_, film >= redder_film && certain >= redder_certain && red >= redder_redness * redness);
            mark(maybe_, film >= maybe_film && certain >= maybe_certain && red >= redness && red >= rise * was);
            mark(sure_, film >= sure_film && certain >= sure_certain && red >= surely_red * redness &&
                            red >= (2.0F * rise - 1.0F) * drift * near_.at<float>(y, x));
        }
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
