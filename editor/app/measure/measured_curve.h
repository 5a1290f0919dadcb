// Measured amounts, made ready to be plotted: value and interval, with gaps where they are not measurable.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "match/frame/estimator.h"
#include "match/video/episode.h"
#include "ui/canvas/plot.h"

namespace lapfx::app {

class MeasuredCurve {
  public:
    static constexpr ui::Span all{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

    /// In %, at the times of the frames and `shift`, s; only those that lie `within`, then.
    void set(std::span<const match::FrameAmounts> frames, match::Curve curve, double shift = 0, ui::Span within = all);
    /// Holds until the next set().
    ui::PlotSeries series(std::string_view name, int color, bool quiet = false) const;
    const ui::PlotData& values() const { return data_[0]; }

  private:
    std::vector<double> times_;
    std::array<std::vector<double>, 3> numbers_;  ///< value, low, high
    std::array<ui::PlotData, 3> data_;
};

}  // namespace lapfx::app
