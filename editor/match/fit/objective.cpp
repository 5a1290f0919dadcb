#include "match/fit/objective.h"

#include <algorithm>
#include <cmath>

namespace lapfx::match {

namespace {

struct AimedAmount {
    std::optional<Amount> TargetPoint::*aim;
    std::vector<double> ShownCurves::*shown;
    CourseError error;
    double Weights::*weight;
};
/// In the order of the residuals; `curves` of them.
constexpr AimedAmount rows[] = {
    {&TargetPoint::blood, &ShownCurves::blood, blood_course, &Weights::blood},
    {&TargetPoint::veil, &ShownCurves::veil, veil_course, &Weights::veil},
    {&TargetPoint::plume, &ShownCurves::plume, plume_course, &Weights::veil},
};
static_assert(std::size(rows) == Objective::curves);
constexpr std::size_t veil_row = 1;

}  // namespace

Objective::Objective(std::vector<TargetPoint> target, const Weights& weights, std::vector<double> start)
    : target_(std::move(target)), start_(std::move(start)) {
    const double length = target_.empty() ? 0.0 : target_.back().time - target_.front().time;
    if (length > 0.0) in_block_ = std::max(block * static_cast<double>(target_.size() - 1) / length, 1.0);
    for (std::size_t c = 0; c < curves; ++c)
        for (TargetPoint& point : target_) {
            std::optional<Amount>& aim = point.*rows[c].aim;
            const double weight = weights.*rows[c].weight;
            if (weight == 0.0) aim.reset();
            scales_[c].push_back(aim ? weight / course_error(*aim, rows[c].error) / std::sqrt(in_block_) : 0.0);
        }
}

void Objective::residuals(const ShownCurves& shown, double offset, std::span<const double> coordinates,
                          std::span<double> residuals) const {
    std::size_t next = 0;
    for (std::size_t c = 0; c < curves; ++c)
        for (std::size_t i = 0; i < times(); ++i) {
            const std::optional<Amount>& aim = target_[i].*rows[c].aim;
            const double off = c == veil_row ? offset : 0.0;
            residuals[next++] = aim ? scales_[c][i] * ((shown.*rows[c].shown)[i] + off - aim->value) : 0.0;
        }
    for (std::size_t k = 0; k < start_.size(); ++k) residuals[next++] = (coordinates[k] - start_[k]) / prior;
    residuals[next] = offset / offset_error;
}

double Objective::best_offset(const ShownCurves& shown) const {
    double sum = 0.0, weight = 1.0 / (offset_error * offset_error);
    for (std::size_t i = 0; i < times(); ++i) {
        if (!target_[i].veil) continue;
        const double scale2 = scales_[veil_row][i] * scales_[veil_row][i];
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
    std::ptrdiff_t aims = 0;
    for (const std::vector<double>& scales : scales_)
        aims += std::count_if(scales.begin(), scales.end(), [](double scale) { return scale > 0.0; });
    return static_cast<double>(aims) / in_block_;
}

std::vector<double> Objective::parts_of_error() const {
    std::vector<double> parts(amounts(), 1.0);
    for (std::size_t i = 0; i < times(); ++i) {
        if (!target_[i].blood) continue;
        const double error = course_error(*target_[i].blood, blood_course);
        parts[i] = error / std::hypot(error, std::sqrt(hidden_blood_lasts / block) * target_[i].hidden_blood);
    }
    return parts;
}

std::array<std::vector<double>, Objective::curves> Objective::scaled() const {
    std::array<std::vector<double>, curves> all;
    for (std::size_t c = 0; c < curves; ++c) {
        all[c].assign(size(), 0.0);
        for (std::size_t i = 0; i < times(); ++i)
            if (const std::optional<Amount>& aim = target_[i].*rows[c].aim)
                all[c][c * times() + i] = -rows[c].error.scale_error * scales_[c][i] * aim->value;
    }
    return all;
}

}  // namespace lapfx::match
