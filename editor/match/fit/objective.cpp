#include "match/fit/objective.h"

#include <algorithm>
#include <cmath>

namespace lapfx::match {

namespace {

constexpr double deviates = 1.645;  // half a 90 % interval, in standard errors
constexpr double least_blood_error = 0.003, least_veil_error = 0.01;

double error_of(const Amount& aim, double least) {
    return std::max((aim.high - aim.low) / (2.0 * deviates), least);
}

}  // namespace

Objective::Objective(std::vector<TargetPoint> target, const Weights& weights, std::vector<double> start)
    : target_(std::move(target)), start_(std::move(start)) {
    const double length = target_.empty() ? 0.0 : target_.back().time - target_.front().time;
    const double in_block =
        length > 0.0 ? std::max(block * static_cast<double>(target_.size() - 1) / length, 1.0) : 1.0;
    for (const TargetPoint& aim : target_) {
        const double blood = aim.blood ? weights.blood / error_of(*aim.blood, least_blood_error) : 0.0;
        const double veil = aim.veil ? weights.veil / error_of(*aim.veil, least_veil_error) : 0.0;
        blood_scale_.push_back(blood / std::sqrt(in_block));
        veil_scale_.push_back(veil / std::sqrt(in_block));
    }
}

void Objective::residuals(const ShownCurves& shown, double offset, std::span<const double> coordinates,
                          std::span<double> residuals) const {
    std::size_t next = 0;
    for (std::size_t i = 0; i < times(); ++i)
        residuals[next++] = target_[i].blood ? blood_scale_[i] * (shown.blood[i] - target_[i].blood->value) : 0.0;
    for (std::size_t i = 0; i < times(); ++i)
        residuals[next++] = target_[i].veil ? veil_scale_[i] * (shown.veil[i] + offset - target_[i].veil->value) : 0.0;
    for (std::size_t k = 0; k < start_.size(); ++k) residuals[next++] = (coordinates[k] - start_[k]) / prior;
    residuals[next] = offset / offset_error;
}

double Objective::best_offset(const ShownCurves& shown) const {
    double sum = 0.0, weight = 1.0 / (offset_error * offset_error);
    for (std::size_t i = 0; i < times(); ++i) {
        if (!target_[i].veil) continue;
        const double scale2 = veil_scale_[i] * veil_scale_[i];
        sum += scale2 * (target_[i].veil->value - shown.veil[i]), weight += scale2;
    }
    return sum / weight;
}

double Objective::cost(const ShownCurves& shown, std::span<const double> coordinates) const {
    std::vector<double> all(size());
    residuals(shown, best_offset(shown), coordinates, all);
    double sum = 0.0;
    for (const double residual : all) sum += residual * residual;
    return 0.5 * sum;
}

}  // namespace lapfx::match
