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

/// What of a frame is plotted.
struct FrameCurve {
    match::Amount match::FrameAmounts::*amount;
    bool (match::FrameAmounts::*known)() const;  ///< the frame has it
};
inline constexpr FrameCurve blood_curve{&match::FrameAmounts::blood, &match::FrameAmounts::blood_measurable},
    veil_curve{&match::FrameAmounts::veil, &match::FrameAmounts::measurable},
    light_curve{&match::FrameAmounts::light, &match::FrameAmounts::measurable},
    gain_curve{&match::FrameAmounts::gain, &match::FrameAmounts::measurable};

class MeasuredCurve {
  public:
    static constexpr ui::Span all{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

    /// In %, at the times of the frames and `shift`, s; only those that lie `within`, then.
    void set(std::span<const match::FrameAmounts> frames, const FrameCurve& curve, double shift = 0,
             ui::Span within = all);
    /// Holds until the next set().
    ui::PlotSeries series(std::string_view name, int color, bool quiet = false) const;
    const ui::PlotData& values() const { return data_[0]; }

  private:
    std::vector<double> times_;
    std::array<std::vector<double>, 3> numbers_;  ///< value, low, high
    std::array<ui::PlotData, 3> data_;
};

}  // namespace lapfx::app
