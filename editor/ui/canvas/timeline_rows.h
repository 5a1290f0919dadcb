// Where items of a track overlap, each gets a row of the lane for itself, so that none hides another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ui/canvas/timeline.h"

namespace lapfx::ui {

class TimelineRows {
  public:
    static constexpr std::size_t most = 3;  ///< rows of a lane; where more overlap, some share one
    struct Row {
        std::uint8_t index = 0, count = 1;  ///< from above; of the rows there
    };

    /// Allocates only while the number of items grows. Marks have the whole lane.
    void place(std::span<const TimelineItem> items);
    Row of(std::size_t item) const { return rows_[item]; }

  private:
    void end_group(std::size_t begin, std::size_t end, std::size_t count);

    std::vector<Row> rows_;
    std::vector<std::uint32_t> order_;  ///< by start
};

}  // namespace lapfx::ui
