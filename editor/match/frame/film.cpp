#include "match/frame/film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr float dark_offset = 0.003F;  // linear: the noise of black

// Standard deviations. They were tuned on known blood over real and rendered tissue (`lapfx bench measure`), seed 1.
constexpr float code_noise = 2.5F;      // code values: camera and encoder
constexpr float least_noise = 0.03F;    // of a change
constexpr float texture_noise = 0.35F;  // share of the deviation of the baseline within texture_reach
constexpr int texture_reach = 2;        // px
constexpr float shade_deviation = 0.1F;
constexpr float least_veil_left = 0.012F, veil_left_of_veil = 0.03F;
constexpr int near = 3;              // px across that are solved together
constexpr float independent = 3.0F;  // of the near * near pixels count: noise of an encoder is common to neighbours
constexpr float most_gain = 0.35F, gain_deviation = 0.2F;  // logarithms

// Of what became less red within so many px.
constexpr int around = 61;
constexpr double least_less_red = 0.3;  // of the valid view: where all is blood nothing can become less red
constexpr float highlight = 0.4F;       // change of green: what shines says nothing
constexpr float usual_excess = 3.0F;    // variances: less is the noise that is known
constexpr float most_excess = 0.25F;    // squared thickness
constexpr float prior_doubt = 0.1F;     // weight of the whole view

/// ln(light + dark_offset) from a table, as QuickCode.
class QuickLog {
  public:
    QuickLog() {
        static const std::vector<float> table = [] {
            std::vector<float> all(steps + 1);
            for (std::size_t i = 0; i < all.size(); ++i) {
                const float root = static_cast<float>(i) / steps;
                all[i] = std::log(root * root + dark_offset);
            }
            return all;
        }();
        table_ = table.data();
    }
    float operator()(float linear) const {
        return table_[static_cast<int>(std::sqrt(std::clamp(linear, 0.0F, 1.0F)) * steps)];
    }

  private:
    static constexpr int steps = 4096;
    const float* table_;
};

float through_of(float veil) {
    return std::max(1.0F - veil, 0.5F * least_through);
}

/// Standard deviation of linear light by that of its code value.
float light_noise(float light, float code) {
    constexpr float slope = 2.2F, least_light = 0.0005F, least_code = 4.0F;  // of the sRGB curve
    return slope * std::max(light, least_light) / std::max(code, least_code) * code_noise;
}

/// Of one place: sums over the channels of weight times these products of absorption a, smoke q and change d.
enum Sum { w, wa, waa, wq, wqq, waq, wd, wad, wqd, sum_count };
using Sums = cv::Vec<float, sum_count>;

struct Film {
    float thickness, information;  ///< information: 1 / variance
};

/// Shade and the rest of the veil are small, which their priors say; the thickness has none.
Film film_of(const Sums& n, float veil) {
    const float left = least_veil_left + veil_left_of_veil * veil;
    const float ss = n[w] + 1.0F / (shade_deviation * shade_deviation), qq = n[wqq] + 1.0F / (left * left), sq = n[wq];
    const float det = ss * qq - sq * sq;
    const float of_s = (sq * n[waq] - qq * n[wa]) / det, of_q = (sq * n[wa] - ss * n[waq]) / det;
    const float information = std::max(n[waa] + n[wa] * of_s + n[waq] * of_q, 1e-6F);
    return {.thickness = (-n[wad] - n[wd] * of_s - n[wqd] * of_q) / information, .information = information};
}

}  // namespace

void FilmSolver::see_changes(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& veil, const cv::Mat& light,
                             const cv::Mat& valid) {
    const QuickCode quick_code;
    const QuickLog quick_log;
    for (cv::Mat* m : {&clear_, &change_, &variance_, &log_}) m->create(frame.size(), CV_32FC3);
    hidden_.create(frame.size(), CV_8U);
    for (int y = 0; y < frame.rows; ++y) {
        const auto* b = baseline.ptr<cv::Vec3f>(y);
        auto* log = log_.ptr<cv::Vec3f>(y);
        for (int x = 0; x < frame.cols; ++x)
            for (int k = 0; k < 3; ++k) log[x][k] = quick_log(b[x][k]);
    }
    const cv::Size window(2 * texture_reach + 1, 2 * texture_reach + 1);
    cv::blur(log_, mean_, window);
    cv::multiply(log_, log_, square_);
    cv::blur(square_, square_, window);
    for (int y = 0; y < frame.rows; ++y) {
        const auto *b = baseline.ptr<cv::Vec3f>(y), *f = frame.ptr<cv::Vec3f>(y), *h = light.ptr<cv::Vec3f>(y),
                   *log = log_.ptr<cv::Vec3f>(y), *mean = mean_.ptr<cv::Vec3f>(y), *square = square_.ptr<cv::Vec3f>(y);
        auto *clear = clear_.ptr<cv::Vec3f>(y), *change = change_.ptr<cv::Vec3f>(y),
             *variance = variance_.ptr<cv::Vec3f>(y);
        for (int x = 0; x < frame.cols; ++x) {
            const float density = veil.at<float>(y, x), through = through_of(density);
            for (int k = 0; k < 3; ++k) {
                const float tissue = std::clamp((f[x][k] - h[x][k] * (1.0F - through)) / through, 0.0F, 1.0F);
                clear[x][k] = tissue;
                change[x][k] = quick_log(tissue) - log[x][k];
                const float noise =
                    light_noise(f[x][k], quick_code(f[x][k])) / (through * (0.5F * (tissue + b[x][k]) + dark_offset));
                const float texture = std::max(square[x][k] - mean[x][k] * mean[x][k], 0.0F);
                variance[x][k] = noise * noise + texture_noise * texture_noise * texture + least_noise * least_noise;
            }
            const bool hidden = 1.0F - density < least_through || std::max(clear[x][2], b[x][2]) < darkest_red;
            hidden_.at<std::uint8_t>(y, x) = valid.at<std::uint8_t>(y, x) != 0 && hidden ? 255 : 0;
        }
    }
}

/// The change that most of the tissue has, per channel: blood covers less of it.
cv::Vec3f FilmSolver::common_change(const cv::Mat& valid) const {
    constexpr int bins = 80, reach = 8;
    constexpr float width = 0.02F, spread = 4.0F;  // of a bin; in bins
    constexpr float even = 0.0025F;                // added to each variance: very sure pixels do not decide alone
    std::array<std::array<float, bins>, 3> counts{};
    for (int y = 0; y < valid.rows; ++y)
        for (int x = 0; x < valid.cols; x += 2) {
            if (valid.at<std::uint8_t>(y, x) == 0 || hidden_.at<std::uint8_t>(y, x) != 0) continue;
            const cv::Vec3f &change = change_.at<cv::Vec3f>(y, x), &variance = variance_.at<cv::Vec3f>(y, x);
            for (int k = 0; k < 3; ++k) {
                const int bin = static_cast<int>(std::floor(change[k] / width)) + bins / 2;
                if (bin >= 0 && bin < bins)
                    counts[static_cast<std::size_t>(k)][static_cast<std::size_t>(bin)] += 1.0F / (variance[k] + even);
            }
        }
    cv::Vec3f common(0.0F, 0.0F, 0.0F);
    for (int k = 0; k < 3; ++k) {
        float most = 0.0F;
        for (int i = 0; i < bins; ++i) {
            float all = 0.0F, mean = 0.0F;
            for (int j = std::max(i - reach, 0); j <= std::min(i + reach, bins - 1); ++j) {
                const float beside = static_cast<float>(j - i) / spread;
                const float weight = std::exp(-0.5F * beside * beside) *
                                     counts[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)];
                all += weight;
                mean += weight * static_cast<float>(j);
            }
            const float there = (mean / all - bins / 2 + 0.5F) * width / gain_deviation;
            const float likely = all * std::exp(-0.5F * there * there);
            if (!(likely > most)) continue;
            most = likely;
            common[k] = (mean / all - bins / 2 + 0.5F) * width;
        }
        common[k] = std::clamp(common[k], -most_gain, most_gain);
    }
    return common;
}

void FilmSolver::sum(const cv::Mat& baseline, const cv::Mat& veil, const cv::Mat& light, const cv::Vec3f& gain) {
    const cv::Vec3f absorption = blood_absorption * std::numbers::ln2_v<float>;
    sums_.create(baseline.size(), CV_MAKETYPE(CV_32F, sum_count));
    for (int y = 0; y < baseline.rows; ++y) {
        const auto *b = baseline.ptr<cv::Vec3f>(y), *h = light.ptr<cv::Vec3f>(y), *clear = clear_.ptr<cv::Vec3f>(y),
                   *change = change_.ptr<cv::Vec3f>(y), *variance = variance_.ptr<cv::Vec3f>(y);
        auto* sums = sums_.ptr<Sums>(y);
        for (int x = 0; x < baseline.cols; ++x) {
            const float through = through_of(veil.at<float>(y, x));
            Sums& n = sums[x];
            n = Sums::all(0.0F);
            for (int k = 0; k < 3; ++k) {
                const float weight = independent / variance[x][k], a = absorption[k], d = change[x][k] - gain[k],
                            q = h[x][k] / (through * (0.5F * (clear[x][k] + b[x][k]) + dark_offset));
                n[w] += weight;
                n[wa] += weight * a;
                n[waa] += weight * a * a;
                n[wq] += weight * q;
                n[wqq] += weight * q * q;
                n[waq] += weight * a * q;
                n[wd] += weight * d;
                n[wad] += weight * a * d;
                n[wqd] += weight * q * d;
            }
        }
    }
    cv::blur(sums_, sums_, {near, near});
}

void FilmSolver::solve_places(const cv::Mat& veil, const cv::Mat& valid) {
    thickness_.create(veil.size(), CV_32F);
    sureness_.create(veil.size(), CV_32F);
    uncertain_.create(veil.size(), CV_32F);
    less_red_.create(veil.size(), CV_32FC2);
    for (int y = 0; y < veil.rows; ++y)
        for (int x = 0; x < veil.cols; ++x) {
            const Film film = film_of(sums_.at<Sums>(y, x), veil.at<float>(y, x));
            thickness_.at<float>(y, x) = film.thickness;
            uncertain_.at<float>(y, x) = 1.0F / film.information;
            const bool less_red = valid.at<std::uint8_t>(y, x) != 0 && hidden_.at<std::uint8_t>(y, x) == 0 &&
                                  film.thickness < 0.0F && change_.at<cv::Vec3f>(y, x)[1] < highlight;
            const float excess = film.thickness * film.thickness - usual_excess / film.information;
            less_red_.at<cv::Vec2f>(y, x) =
                less_red ? cv::Vec2f(std::clamp(excess, 0.0F, most_excess), 1.0F) : cv::Vec2f(0.0F, 0.0F);
        }
}

/// Blood makes no tissue less red, but tissue that is not in its place does, as often as it seems redder.
void FilmSolver::see_doubt(const cv::Mat& valid) {
    const cv::Scalar all = cv::sum(less_red_);
    const auto usual = static_cast<float>(all[0] / std::max({all[1], least_less_red * cv::countNonZero(valid), 1.0}));
    cv::blur(less_red_, less_red_, {around, around});
    for (int y = 0; y < less_red_.rows; ++y)
        for (int x = 0; x < less_red_.cols; ++x) {
            const cv::Vec2f& less_red = less_red_.at<cv::Vec2f>(y, x);
            const float there = (less_red[0] + prior_doubt * usual) / (less_red[1] + prior_doubt);
            sureness_.at<float>(y, x) = thickness_.at<float>(y, x) / std::sqrt(uncertain_.at<float>(y, x) + there);
        }
}

void FilmSolver::solve(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& veil, const cv::Mat& light,
                       const cv::Mat& valid) {
    see_changes(baseline, frame, veil, light, valid);
    const cv::Vec3f common = common_change(valid);
    for (int k = 0; k < 3; ++k) gains_[k] = std::exp(common[k]);
    sum(baseline, veil, light, common);
    solve_places(veil, valid);
    see_doubt(valid);
}

}  // namespace lapfx::match
