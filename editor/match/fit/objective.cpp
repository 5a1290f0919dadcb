#include "match/fit/objective.h"

#include <algorithm>
#include <cmath>

namespace lapfx::match {

Objective::Objective(std::vector<TargetPoint> target, const Weights& weights, std::vector<double> start)
    : target_(std::move(target)), start_(std::move(start)) {
    const double length = target_.empty() ? 0.0 : target_.back().time - target_.front().time;
    if (length > 0.0) in_block_ = std::max(block * static_cast<double>(target_.size() - 1) / length, 1.0);
    for (TargetPoint& aim : target_) {
        if (weights.blood == 0.0) aim.blood.reset();
        if (weights.veil == 0.0) aim.veil.reset();
        const double blood = aim.blood ? weights.blood / course_error(*aim.blood, blood_course) : 0.0;
        const double veil = aim.veil ? weights.veil / course_error(*aim.veil, veil_course) : 0.0;
        blood_scale_.push_back(blood / std::sqrt(in_block_));
        veil_scale_.push_back(veil / std::sqrt(in_block_));
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

double Objective::blocks() const {
    double aims = 0.0;
    for (std::size_t i = 0; i < times(); ++i)
        aims += (blood_scale_[i] > 0.0 ? 1.0 : 0.0) + (veil_scale_[i] > 0.0 ? 1.0 : 0.0);
    return aims / in_block_;
}

std::vector<double> Objective::parts_of_error() const {
    std::vector<double> parts(2 * times(), 1.0);
    for (std::size_t i = 0; i < times(); ++i) {
        if (!target_[i].blood) continue;
        const double error = course_error(*target_[i].blood, blood_course);
        parts[i] = error / std::hypot(error, std::sqrt(hidden_blood_lasts / block) * target_[i].hidden_blood);
    }
    return parts;
}

std::vector<double> Objective::blood_scaled() const {
    std::vector<double> changes(size(), 0.0);
    for (std::size_t i = 0; i < times(); ++i)
        if (target_[i].blood) changes[i] = -blood_course.scale_error * blood_scale_[i] * target_[i].blood->value;
    return changes;
}

std::vector<double> Objective::veil_scaled() const {
    std::vector<double> changes(size(), 0.0);
    for (std::size_t i = 0; i < times(); ++i)
        if (target_[i].veil) changes[times() + i] = -veil_course.scale_error * veil_scale_[i] * target_[i].veil->value;
    return changes;
}

}  // namespace lapfx::match
