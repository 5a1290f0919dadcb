#include "match/fit/certainty.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <random>

namespace lapfx::match {

namespace {

constexpr int drawn_references = 400;
constexpr double low_share = 0.05, high_share = 0.95;
constexpr double deviates = 1.645;                        // half a 90 % interval, in standard errors
constexpr double determined_below = 0.4;                  // coordinates: a standard error of 40 %
constexpr double least_factor = 0.35, most_factor = 2.0;  // of the stated errors
constexpr double alike_above = 0.95;                      // correlation

/// Rows [first, last) of the blocks' times, for each amount alike.
struct Block {
    std::size_t first, last;
};

std::vector<Block> blocks_of(std::span<const TargetPoint> target) {
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < target.size(); ++i) {
        if (blocks.empty() || target[i].time - target[blocks.back().first].time >= Objective::block - 1e-9)
            blocks.push_back({i, i});
        blocks.back().last = i + 1;
    }
    if (blocks.size() > 1 && target.back().time - target[blocks.back().first].time < Objective::block - 1e-9) {
        blocks[blocks.size() - 2].last = blocks.back().last;  // a short rest is no block of its own
        blocks.pop_back();
    }
    return blocks;
}

/// Of some rows: J^T J and J^T r.
struct Normal {
    cv::Mat matrix, side;
    explicit Normal(std::size_t columns)
        : matrix(cv::Mat::zeros(static_cast<int>(columns), static_cast<int>(columns), CV_64F)),
          side(cv::Mat::zeros(static_cast<int>(columns), 1, CV_64F)) {}
    void add_row(const Linearised& at, std::size_t row) {
        for (std::size_t a = 0; a < at.columns; ++a) {
            const double slope = at.slopes[row * at.columns + a];
            side.at<double>(static_cast<int>(a)) += slope * at.residuals[row];
            for (std::size_t b = 0; b < at.columns; ++b)
                matrix.at<double>(static_cast<int>(a), static_cast<int>(b)) += slope * at.slopes[row * at.columns + b];
        }
    }
};

/// With the rows of the amounts, the first, multiplied.
Linearised weighted(Linearised at, std::span<const double> weights) {
    for (std::size_t row = 0; row < weights.size(); ++row) {
        at.residuals[row] *= weights[row];
        for (std::size_t a = 0; a < at.columns; ++a) at.slopes[row * at.columns + a] *= weights[row];
    }
    return at;
}

/// The steps that correct the fit for each drawn reference: steps[parameter][reference].
std::vector<std::vector<double>> corrections(const Objective& objective, const Linearised& at, std::uint32_t seed) {
    const std::vector<Block> blocks = blocks_of(objective.target());
    std::vector<Normal> parts;
    for (const Block& block : blocks) {
        Normal& part = parts.emplace_back(at.columns);
        for (std::size_t i = block.first; i < block.last; ++i)
            for (std::size_t c = 0; c < Objective::curves; ++c) part.add_row(at, c * objective.times() + i);
    }
    Normal known(at.columns);  // of the priors
    for (std::size_t row = objective.amounts(); row < objective.size(); ++row) known.add_row(at, row);
    std::mt19937 random(seed);
    std::vector<std::vector<double>> steps(at.columns - 1);
    for (int n = 0; n < drawn_references; ++n) {
        cv::Mat matrix = known.matrix.clone(), side = known.side.clone(), step;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Normal& part = parts[random() % parts.size()];
            matrix += part.matrix, side += part.side;
        }
        cv::solve(matrix, side, step, cv::DECOMP_SVD);
        for (std::size_t k = 0; k < steps.size(); ++k) steps[k].push_back(-step.at<double>(static_cast<int>(k) + 1));
    }
    return steps;
}

double quantile(std::vector<double>& values, double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

cv::Mat covariance_of(const Objective& objective, const Linearised& at) {
    Normal all(at.columns);
    for (std::size_t row = 0; row < objective.size(); ++row) all.add_row(at, row);
    cv::Mat covariance;
    cv::invert(all.matrix, covariance, cv::DECOMP_SVD);
    return covariance;
}

/// How large the errors of this video are beside the stated ones, as what the fit leaves tells it (reduced
/// chi-squared).
double error_factor(const Objective& objective, const Linearised& at) {
    double sum = 0.0;
    for (std::size_t row = 0; row < objective.amounts(); ++row) sum += at.residuals[row] * at.residuals[row];
    const double freedom = objective.blocks() - static_cast<double>(at.fitted);
    return std::clamp(std::sqrt(sum / std::max(freedom, 1.0)), least_factor, most_factor);
}

/// What each row of the amounts is multiplied by, so that it is in standard errors of this video. What is known
/// beforehand has its own errors, whatever those of a video.
std::vector<double> row_weights(const Objective& objective, const Linearised& at, Errors errors) {
    std::vector<double> weights(objective.amounts(), 1.0);
    if (errors == Errors::with_hidden) weights = objective.parts_of_error();
    const double factor = error_factor(objective, at);
    for (double& weight : weights) weight /= factor;
    return weights;
}

/// Standard errors of the parameters that come from those of the scales, which the curves do not show.
std::vector<double> scale_errors(const Objective& objective, const Linearised& at, std::span<const double> weights,
                                 const cv::Mat& covariance) {
    std::vector<double> errors(at.columns - 1, 0.0);
    for (const std::vector<double>& changes : objective.scaled()) {
        cv::Mat side = cv::Mat::zeros(static_cast<int>(at.columns), 1, CV_64F);
        for (std::size_t row = 0; row < weights.size(); ++row)
            for (std::size_t a = 0; a < at.columns; ++a)
                side.at<double>(static_cast<int>(a)) += weights[row] * at.slopes[row * at.columns + a] * changes[row];
        const cv::Mat step = covariance * side;
        for (std::size_t k = 0; k < errors.size(); ++k)
            errors[k] = std::hypot(errors[k], step.at<double>(static_cast<int>(k) + 1));
    }
    return errors;
}

}  // namespace

std::vector<Certainty> certainty_of(const Objective& objective, const Linearised& linear,
                                    std::span<const double> coordinates, Errors errors, std::uint32_t seed) {
    const std::vector<double> weights = row_weights(objective, linear, errors);
    const Linearised at = weighted(linear, weights);
    const cv::Mat covariance = covariance_of(objective, at);
    std::vector<std::vector<double>> steps = corrections(objective, at, seed);
    const std::vector<double> of_scales = scale_errors(objective, at, weights, covariance);
    std::vector<Certainty> all(coordinates.size());
    const auto error = [&](std::size_t k) {
        const int i = static_cast<int>(k) + 1;  // after the offset
        return std::sqrt(std::max(covariance.at<double>(i, i), 0.0));
    };
    for (std::size_t k = 0; k < all.size(); ++k) {
        Certainty& c = all[k];
        c.error = error(k);
        const double below = std::max(-quantile(steps[k], low_share), deviates * c.error),
                     above = std::max(quantile(steps[k], high_share), deviates * c.error);
        c.low = coordinates[k] - std::hypot(below, deviates * of_scales[k]);
        c.high = coordinates[k] + std::hypot(above, deviates * of_scales[k]);
        if (errors != Errors::of_course) c.error = std::hypot(c.error, of_scales[k]);
        c.determined = c.error < determined_below;
        for (std::size_t other = 0; other < all.size(); ++other) {
            if (other == k) continue;
            const double both = covariance.at<double>(static_cast<int>(k) + 1, static_cast<int>(other) + 1);
            if (std::abs(both) > alike_above * error(k) * error(other)) c.alike = static_cast<int>(other);
        }
    }
    return all;
}

}  // namespace lapfx::match
