#include "ui/canvas/timeline_rows.h"

#include <algorithm>

namespace lapfx::ui {

void TimelineRows::place(std::span<const TimelineItem> items) {
    rows_.assign(items.size(), {});
    order_.clear();
    for (std::size_t i = 0; i < items.size(); ++i)
        if (items[i].end > items[i].start) order_.push_back(static_cast<std::uint32_t>(i));
    const auto earlier = [&](std::uint32_t a, std::uint32_t b) {
        return items[a].start != items[b].start ? items[a].start < items[b].start : a < b;
    };
    if (!std::is_sorted(order_.begin(), order_.end(), earlier)) std::sort(order_.begin(), order_.end(), earlier);
    double ends[most] = {};  // of the newest item in each row
    std::size_t begin = 0, count = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const TimelineItem& item = items[order_[i]];
        if (std::all_of(ends, ends + count, [&](double end) { return end <= item.start; })) {
            end_group(begin, i, count);
            begin = i, count = 0;
        }
        std::size_t row = 0;
        while (row < count && ends[row] > item.start) ++row;
        if (row == most) row = static_cast<std::size_t>(std::min_element(ends, ends + most) - ends);
        ends[row] = row < count ? std::max(ends[row], item.end) : item.end;
        count = std::max(count, row + 1);
        rows_[order_[i]].index = static_cast<std::uint8_t>(row);
    }
    end_group(begin, order_.size(), count);
}

/// Items that overlap one another, directly or through others, divide the lane alike.
void TimelineRows::end_group(std::size_t begin, std::size_t end, std::size_t count) {
    for (std::size_t i = begin; i < end; ++i)
        rows_[order_[i]].count = static_cast<std::uint8_t>(std::max<std::size_t>(1, count));
}

}  // namespace lapfx::ui
