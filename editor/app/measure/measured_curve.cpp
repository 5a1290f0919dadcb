#include "app/measure/measured_curve.h"

namespace lapfx::app {

namespace {

constexpr double percent = 100;
constexpr double slack = 1e-6;  // s
constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void MeasuredCurve::set(std::span<const match::FrameAmounts> frames, const FrameCurve& curve, double shift,
                        ui::Span within) {
    times_.clear();
    for (auto& numbers : numbers_) numbers.clear();
    for (const match::FrameAmounts& frame : frames) {
        const double time = frame.time + shift;
        if (time < within.low - slack || time > within.high + slack) continue;
        const match::Amount& amount = frame.*curve.amount;
        const double unit = (frame.*curve.known)() ? percent : none;
        times_.push_back(time);
        numbers_[0].push_back(unit * amount.value);
        numbers_[1].push_back(unit * amount.low);
        numbers_[2].push_back(unit * amount.high);
    }
    for (std::size_t i = 0; i < data_.size(); ++i) data_[i].set(numbers_[i], times_);
}

ui::PlotSeries MeasuredCurve::series(std::string_view name, int color, bool quiet) const {
    return {.name = name, .data = &data_[0], .color = color, .reference = quiet, .low = &data_[1], .high = &data_[2]};
}

}  // namespace lapfx::app
