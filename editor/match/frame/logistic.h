// Logistic regression: how likely a row of figures is one of two kinds, learned from rows whose kind is known.
//
//     const match::Logistic learned = match::Logistic::fit(rows, kinds, 0.1);
//     double share = match::Logistic::chance(learned.bias + dot(learned.weights, row));
//
// Pure and deterministic, any thread.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace lapfx::match {

struct Logistic {
    std::vector<double> weights;  ///< of each figure, in its own unit
    double bias = 0.0;

    /// Least sum of squared weights, of figures brought to a mean of 0 and a deviation of 1, plus 2 * `c` times the
    /// log loss, in which both kinds count alike, however many there are of each (Newton's method; the bias is not held
    /// small). `rows`: CV_64F, a row each; `kinds`: of each row 1 or 0, both must be there.
    static Logistic fit(const cv::Mat& rows, std::span<const std::uint8_t> kinds, double c);
    /// 0..1, of the weighted sum.
    static double chance(double sum);
};

}  // namespace lapfx::match
