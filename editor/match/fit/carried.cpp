#include "match/fit/carried.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lapfx::match {

namespace {

constexpr double most_veil = 0.98;    // denser veils say nothing about their depth
constexpr double least_depth = 0.02;  // of haze or plume in the drawn curve: below, it tells no factor
constexpr double least_area = 5.0;    // mm2, likewise
constexpr double least_factor = 0.2, most_factor = 5.0;  // of haze: the mean way of the light, in focus distances

double depth_of(double veil) {
    return -std::log1p(-std::clamp(veil, 0.0, most_veil));
}

/// Values that are NaN become those between their neighbours.
void fill(std::vector<double>& values) {
    std::size_t before = values.size();
    for (std::size_t i = 0; i <= values.size(); ++i) {
        if (i < values.size() && std::isnan(values[i])) continue;
        for (std::size_t k = before == values.size() ? 0 : before + 1; k < i; ++k) {
            if (before == values.size())
                values[k] = i == values.size() ? 0.0 : values[i];
            else if (i == values.size())
                values[k] = values[before];
            else
                values[k] = std::lerp(values[before], values[i],
                                      static_cast<double>(k - before) / static_cast<double>(i - before));
        }
        before = i;
    }
}

/// y is about a * x + b * z, neither factor below 0.
void least_squares(std::span<const double> y, std::span<const double> x, std::span<const double> z, double& a,
                   double& b) {
    const auto dot = [](std::span<const double> p, std::span<const double> q) {
        return std::inner_product(p.begin(), p.end(), q.begin(), 0.0);
    };
    const double xx = dot(x, x), zz = dot(z, z), xz = dot(x, z), xy = dot(x, y), zy = dot(z, y);
    const double determinant = xx * zz - xz * xz;
    if (determinant > 1e-6 * xx * zz) {
        a = (xy * zz - zy * xz) / determinant, b = (zy * xx - xy * xz) / determinant;
        if (a >= 0.0 && b >= 0.0) return;
    }
    const double without_b = xx > 0.0 ? std::max(xy / xx, 0.0) : 0.0;
    const double without_a = zz > 0.0 ? std::max(zy / zz, 0.0) : 0.0;
    if (without_b * xy >= without_a * zy)
        a = without_b, b = 0.0;
    else
        a = 0.0, b = without_a;
}

}  // namespace

ShownCurves curves_of(std::span<const FrameAmounts> frames) {
    ShownCurves curves;
    for (const FrameAmounts& frame : frames) {
        curves.blood.push_back(measurable(frame, Curve::blood) ? frame.blood.value : std::nan(""));
        curves.veil.push_back(measurable(frame, Curve::veil) ? frame.veil.value : std::nan(""));
        curves.plume.push_back(frame.plume ? frame.plume->value : std::nan(""));
    }
    fill(curves.blood), fill(curves.veil), fill(curves.plume);
    return curves;
}

Carried::Carried(std::size_t parameters, double share_per_mm2) : parameters_(parameters), area_factor_(share_per_mm2) {}

/// Each from the first curve that shows its amount: what is learnt afterwards is beside it.
void Carried::find_factors(std::span<const Amounts> core, const ShownCurves& curves) {
    std::vector<double> depth, haze, emission;
    double area2 = 0.0, blood = 0.0, most_area = 0.0;
    for (std::size_t i = 0; i < core.size(); ++i) {
        depth.push_back(depth_of(curves.veil[i]));
        haze.push_back(core[i].haze), emission.push_back(core[i].emission);
        const double area = core[i].blood_area;
        area2 += area * area, blood += area * curves.blood[i];
        most_area = std::max(most_area, area);
    }
    const bool bleeds = most_area > least_area && blood > 0.0,
               smokes = *std::max_element(haze.begin(), haze.end()) >= least_depth,
               has_plume = *std::max_element(emission.begin(), emission.end()) >= least_depth;
    if (bleeds && !std::exchange(area_known_, true)) area_factor_ = blood / area2;
    if (has_plume && !std::exchange(plume_known_, true))
        least_squares(curves.plume, haze, emission, haze_stands_out_, plume_stands_out_);
    if (!smokes || std::exchange(haze_known_, true)) return;
    least_squares(depth, haze, emission, haze_factor_, plume_factor_);
    haze_factor_ = std::clamp(haze_factor_, least_factor, most_factor);
}

void Carried::drawn(std::span<const double> coordinates, std::span<const Amounts> core, const ShownCurves& curves) {
    const std::size_t times = core.size();
    const bool first = core_.empty();
    find_factors(core, curves);
    ShownCurves told;
    std::vector<double> step(parameters_);
    double length2 = 0.0;
    if (first) {
        blood_slopes_.assign(times * parameters_, 0.0), depth_slopes_ = plume_slopes_ = blood_slopes_;
    } else {
        told = at(coordinates, core);
        for (std::size_t k = 0; k < parameters_; ++k) {
            step[k] = coordinates[k] - coordinates_[k];
            length2 += step[k] * step[k];
        }
    }
    // Broyden, "A class of methods for solving nonlinear simultaneous equations", 1965.
    if (length2 > 0.0)
        for (std::size_t i = 0; i < times; ++i)
            for (std::size_t k = 0; k < parameters_; ++k) {
                const double part = step[k] / length2;
                blood_slopes_[i * parameters_ + k] += part * (curves.blood[i] - told.blood[i]);
                depth_slopes_[i * parameters_ + k] += part * (depth_of(curves.veil[i]) - depth_of(told.veil[i]));
                plume_slopes_[i * parameters_ + k] += part * (curves.plume[i] - told.plume[i]);
            }
    stand_at(coordinates, core, curves);
}

void Carried::stand_at(std::span<const double> coordinates, std::span<const Amounts> core, const ShownCurves& curves) {
    coordinates_.assign(coordinates.begin(), coordinates.end());
    core_.assign(core.begin(), core.end());
    curves_ = curves;
}

void Carried::learn(std::size_t parameter, double step, const ShownCurves& curves) {
    for (std::size_t i = 0; i < core_.size(); ++i) {
        blood_slopes_[i * parameters_ + parameter] = (curves.blood[i] - curves_.blood[i]) / step;
        depth_slopes_[i * parameters_ + parameter] = (depth_of(curves.veil[i]) - depth_of(curves_.veil[i])) / step;
        plume_slopes_[i * parameters_ + parameter] = (curves.plume[i] - curves_.plume[i]) / step;
    }
}

ShownCurves Carried::at(std::span<const double> coordinates, std::span<const Amounts> core) const {
    ShownCurves shown;
    for (std::size_t i = 0; i < core.size(); ++i) {
        double blood = curves_.blood[i] + area_factor_ * (core[i].blood_area - core_[i].blood_area);
        double depth = depth_of(curves_.veil[i]) + haze_factor_ * (core[i].haze - core_[i].haze) +
                       plume_factor_ * (core[i].emission - core_[i].emission);
        double plume = curves_.plume[i] + haze_stands_out_ * (core[i].haze - core_[i].haze) +
                       plume_stands_out_ * (core[i].emission - core_[i].emission);
        for (std::size_t k = 0; k < parameters_; ++k) {
            const double step = coordinates[k] - coordinates_[k];
            blood += blood_slopes_[i * parameters_ + k] * step;
            depth += depth_slopes_[i * parameters_ + k] * step;
            plume += plume_slopes_[i * parameters_ + k] * step;
        }
        shown.blood.push_back(std::clamp(blood, 0.0, 1.0));
        shown.veil.push_back(-std::expm1(-std::max(depth, 0.0)));
        shown.plume.push_back(std::clamp(plume, 0.0, 1.0));
    }
    return shown;
}

}  // namespace lapfx::match
