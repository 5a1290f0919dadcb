#include "match/frame/logistic.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lapfx::match {

namespace {

constexpr double least_deviation = 1e-9;  // a figure that is always the same says nothing
constexpr int most_steps = 100, most_halvings = 40;
constexpr double least_step = 1e-9;

/// log(1 + exp(-margin)) without overflow.
double log_loss(double margin) {
    return std::max(-margin, 0.0) + std::log1p(std::exp(-std::abs(margin)));
}

/// The rows, each figure with a mean of 0 and a deviation of 1, and a last column of 1 for the bias.
struct Scaled {
    cv::Mat rows;
    std::vector<double> mean, deviation;

    explicit Scaled(const cv::Mat& of)
        : rows(of.rows, of.cols + 1, CV_64F, cv::Scalar(1.0)),
          mean(static_cast<std::size_t>(of.cols), 0.0),
          deviation(mean) {
        for (int k = 0; k < of.cols; ++k) {
            const auto at = static_cast<std::size_t>(k);
            for (int i = 0; i < of.rows; ++i) mean[at] += of.at<double>(i, k) / of.rows;
            for (int i = 0; i < of.rows; ++i) deviation[at] += std::pow(of.at<double>(i, k) - mean[at], 2) / of.rows;
            deviation[at] = std::max(std::sqrt(deviation[at]), least_deviation);
            for (int i = 0; i < of.rows; ++i) rows.at<double>(i, k) = (of.at<double>(i, k) - mean[at]) / deviation[at];
        }
    }
};

/// What is made as small as can be, over the weights and, as the last, the bias.
class Problem {
  public:
    Problem(const cv::Mat& rows, std::span<const std::uint8_t> kinds, double c) : rows_(rows), kinds_(kinds) {
        const auto ones = static_cast<double>(std::count(kinds.begin(), kinds.end(), 1));
        const auto all = static_cast<double>(kinds.size());
        of_kind_[1] = c * all / (2.0 * ones);
        of_kind_[0] = c * all / (2.0 * (all - ones));
    }

    double value(const cv::Mat& weights) const {
        double sum = 0.0;
        for (int k = 0; k + 1 < weights.rows; ++k) sum += 0.5 * std::pow(weights.at<double>(k), 2);
        const cv::Mat sums = rows_ * weights;
        for (int i = 0; i < rows_.rows; ++i)
            sum += share_of(i) * log_loss(kind_of(i) == 1 ? sums.at<double>(i) : -sums.at<double>(i));
        return sum;
    }

    /// The step to where the parabola at `weights` is least.
    cv::Mat step_at(const cv::Mat& weights) const {
        const int count = weights.rows;
        cv::Mat slope = weights.clone(), curve = cv::Mat::eye(count, count, CV_64F), step;
        slope.at<double>(count - 1) = curve.at<double>(count - 1, count - 1) = 0.0;
        const cv::Mat sums = rows_ * weights;
        for (int i = 0; i < rows_.rows; ++i) {
            const double chance = Logistic::chance(sums.at<double>(i)), share = share_of(i);
            const double off = share * (chance - kind_of(i)), bend = share * chance * (1.0 - chance);
            const double* const row = rows_.ptr<double>(i);
            for (int k = 0; k < count; ++k) {
                slope.at<double>(k) += off * row[k];
                for (int j = 0; j <= k; ++j) curve.at<double>(k, j) += bend * row[k] * row[j];
            }
        }
        cv::completeSymm(curve, true);
        if (!cv::solve(curve, -slope, step, cv::DECOMP_CHOLESKY)) cv::solve(curve, -slope, step, cv::DECOMP_SVD);
        return step;
    }

  private:
    int kind_of(int row) const { return kinds_[static_cast<std::size_t>(row)]; }
    double share_of(int row) const { return of_kind_[kind_of(row)]; }

    const cv::Mat& rows_;
    std::span<const std::uint8_t> kinds_;
    double of_kind_[2];
};

}  // namespace

double Logistic::chance(double sum) {
    return 1.0 / (1.0 + std::exp(-sum));
}

Logistic Logistic::fit(const cv::Mat& rows, std::span<const std::uint8_t> kinds, double c) {
    assert(rows.type() == CV_64F && static_cast<std::size_t>(rows.rows) == kinds.size());
    assert(std::ranges::count(kinds, 1) > 0 && std::ranges::count(kinds, 0) > 0);
    const Scaled scaled(rows);
    const Problem problem(scaled.rows, kinds, c);
    cv::Mat weights = cv::Mat::zeros(rows.cols + 1, 1, CV_64F);
    double value = problem.value(weights);
    for (int i = 0; i < most_steps; ++i) {
        cv::Mat step = problem.step_at(weights);
        double next = problem.value(weights + step);
        // Far from the least, Newton's step may be too long.
        for (int halved = 0; !(next <= value) && halved < most_halvings; ++halved) {
            step *= 0.5;
            next = problem.value(weights + step);
        }
        if (!(next <= value)) break;
        weights += step;
        value = next;
        if (cv::norm(step, cv::NORM_INF) < least_step) break;
    }
    Logistic made{.weights = {}, .bias = weights.at<double>(rows.cols)};
    for (int k = 0; k < rows.cols; ++k) {
        const auto at = static_cast<std::size_t>(k);
        made.weights.push_back(weights.at<double>(k) / scaled.deviation[at]);
        made.bias -= made.weights.back() * scaled.mean[at];
    }
    return made;
}

}  // namespace lapfx::match
