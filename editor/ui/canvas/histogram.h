// How often each value occurs, and the thresholds that are set by looking at it.
#pragma once

#include <optional>

#include "ui/core/ui.h"

namespace lapfx::ui {

/// `bins` share minimum..maximum evenly; the axis of the parameters beside it.
struct HistogramData {
    std::span<const std::uint32_t> bins;
    double minimum = 0, maximum = 255;
};

/// Below `low` nothing, above `high` everything.
struct Levels {
    double low = 0, high = 255;
    friend bool operator==(const Levels&, const Levels&) = default;
};

struct HistogramOptions {
    Levels reset = {};  ///< the saved values: a double click on a handle, or Backspace, goes back to them
    std::optional<Levels> initial = {};  ///< the defaults, to which Shift+Backspace goes; none: `reset`
    double step = 1;                     ///< of low and high: of the arrow keys and the least distance between them
    bool* log_counts = nullptr;          ///< null: counts are shown as they are, without a switch
    double clip_share = 0.01;            ///< more than this share in an end's bin is marked as clipped
    std::string_view unit = {};
    std::string_view tip = {};
    Size width = grow();
    float height = 9;  ///< em, at least
};

struct HistogramResult {
    Edit low, high;
    Edit log;  ///< of the switch
    Edit any() const {
        Edit all = low;
        return all |= high;
    }
};

/// Handles "Low" and "High": drag (Shift fine, Ctrl whole steps), arrows (Shift a tenth), page keys ten steps,
/// Home and End. low stays `step` below high. Under the pointer it reads out a bin. `levels` null: no handles.
HistogramResult histogram(Ui& ui, std::string_view label, const HistogramData& data, Levels* levels,
                          const HistogramOptions& options = {});

/// 0..1: the height of a bar. `most` is the count that is full height; more is cut.
float bar_height(std::uint32_t count, std::uint32_t most, bool logarithmic);
/// The count that is shown at full height: the largest, without the two ends, which are huge in a clipped picture.
std::uint32_t full_count(std::span<const std::uint32_t> bins);

}  // namespace lapfx::ui
