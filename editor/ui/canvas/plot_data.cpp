#include "ui/canvas/plot_data.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "ui/canvas/plot.h"
#include "ui/value/csv.h"
#include "ui/value/number.h"

namespace lapfx::ui {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The area under the line from (x0, y0) to (x1, y1), if both ends are finite.
double area_of(double x0, double y0, double x1, double y1, double& width) {
    if (!std::isfinite(y0) || !std::isfinite(y1)) return 0;
    width += x1 - x0;
    return (x1 - x0) * (y0 / 2 + y1 / 2);
}

void append_number(std::string& csv, double value) {
    char buffer[32];
    if (std::isfinite(value)) csv += format_exact(buffer, value);
}

}  // namespace

void PlotData::set(Numbers y, double start, double step) {
    assert(step > 0);
    y_ = y, x_ = {}, start_ = start, step_ = step;
    build();
}

void PlotData::set(Numbers y, Numbers x) {
    assert(x.size() == y.size());
    y_ = y, x_ = x;
    for (std::size_t i = 1; i < x.size(); ++i) assert(x[i - 1] <= x[i]);
    build();
}

void PlotData::build() {
    const std::size_t count = (size() + block - 1) / block;
    std::size_t depth = 0;
    for (std::size_t nodes = count; nodes > 0; nodes = nodes > 1 ? (nodes + block - 1) / block : 0) ++depth;
    levels_.resize(depth);
    areas_.assign(count + 1, 0.0);
    widths_.assign(count + 1, 0.0);
    for (std::size_t level = 0; level < depth; ++level) {
        const std::size_t below = level == 0 ? size() : levels_[level - 1].size();
        levels_[level].assign((below + block - 1) / block, {});
        for (std::size_t i = 0; i < below; ++i) {
            Extremes& node = levels_[level][i / block];
            if (level > 0) {
                node.add(levels_[level - 1][i]);
            } else if (std::isfinite(y_[i])) {
                node.add(y_[i]);
            }
        }
    }
    for (std::size_t b = 0; b < count; ++b) {
        double width = 0;
        const std::size_t last = std::min((b + 1) * block, size() - 1);
        double area = 0;
        for (std::size_t i = b * block; i < last; ++i) area += area_of(x(i), y(i), x(i + 1), y(i + 1), width);
        areas_[b + 1] = areas_[b] + area;
        widths_[b + 1] = widths_[b] + width;
    }
}

std::size_t PlotData::index_from(double place) const {
    if (x_.size() == 0) {
        const double index = std::ceil((place - start_) / step_);
        return index <= 0 ? 0 : index >= static_cast<double>(size()) ? size() : static_cast<std::size_t>(index);
    }
    std::size_t first = 0, count = size();
    while (count > 0) {
        const std::size_t half = count / 2;
        if (x_[first + half] < place) {
            first += half + 1, count -= half + 1;
        } else {
            count = half;
        }
    }
    return first;
}

std::size_t PlotData::nearest(double place) const {
    assert(size() > 0);
    const std::size_t after = std::min(index_from(place), size() - 1);
    return after > 0 && place - x(after - 1) < x(after) - place ? after - 1 : after;
}

double PlotData::value_at(double place) const {
    const std::size_t after = index_from(place);
    if (after == size()) return nothing;
    if (x(after) == place) return std::isfinite(y(after)) ? y(after) : nothing;
    if (after == 0 || !std::isfinite(place)) return nothing;
    const double left = y(after - 1), right = y(after);
    if (!std::isfinite(left) || !std::isfinite(right)) return nothing;  // std::lerp would return an end
    return std::lerp(left, right, (place - x(after - 1)) / (x(after) - x(after - 1)));
}

Extremes PlotData::extremes(std::size_t first, std::size_t last) const {
    Extremes all;
    last = std::min(last, size());
    const auto take = [&](std::size_t level, std::size_t i) {
        if (level > 0) {
            all.add(levels_[level - 1][i]);
        } else if (const double v = y_[i]; std::isfinite(v)) {
            all.add(v);
        }
    };
    // Goes upwards: each level contributes what is outside of the whole blocks of the next one, on both sides.
    for (std::size_t level = 0; first < last; ++level) {
        while (first < last && first % block != 0) take(level, first++);
        while (first < last && last % block != 0) take(level, --last);
        if (level == levels_.size()) break;
        first /= block, last /= block;
    }
    return all;
}

/// The area under the pieces from sample `first` to sample `last`.
double PlotData::area_between(std::size_t first, std::size_t last, double& width) const {
    double area = 0;
    const auto piece = [&](std::size_t i) { area += area_of(x(i), y(i), x(i + 1), y(i + 1), width); };
    while (first < last && first % block != 0) piece(first++);
    while (first < last && last % block != 0) piece(--last);
    width += widths_[last / block] - widths_[first / block];
    return area + areas_[last / block] - areas_[first / block];
}

RangeStatistics PlotData::statistics(double low, double high) const {
    RangeStatistics result;
    if (low > high) std::swap(low, high);
    if (size() == 0 || !(low <= high)) return result;
    low = std::max(low, x(0)), high = std::min(high, x(size() - 1));
    if (low > high) return result;
    const std::size_t first = index_from(low);
    std::size_t last = index_from(high);  // the last sample within, or the one after `high`
    if (last > first && x(last) > high) --last;
    const double at_low = value_at(low), at_high = value_at(high);
    if (x(first) > high) {  // between two samples
        result.area = area_of(low, at_low, high, at_high, result.width);
    } else {
        result.extremes = extremes(first, last + 1);
        result.area = area_of(low, at_low, x(first), y(first), result.width);
        result.area += area_between(first, last, result.width);
        result.area += area_of(x(last), y(last), high, at_high, result.width);
    }
    for (const double v : {at_low, at_high}) {
        if (std::isfinite(v)) result.extremes.add(v);
    }
    result.mean = result.width > 0 ? result.area / result.width : result.extremes.low / 2 + result.extremes.high / 2;
    return result;
}

std::string plot_csv(std::span<const PlotSeries> series, std::string_view x_name, double low, double high) {
    std::string csv;
    append_csv(csv, x_name);
    std::vector<std::size_t> at;
    for (const PlotSeries& s : series) {
        csv += ',';
        append_csv(csv, s.name);
        at.push_back(s.data->index_from(low));
    }
    csv += '\n';
    while (true) {
        double next = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < series.size(); ++i) {
            if (at[i] < series[i].data->size()) next = std::min(next, series[i].data->x(at[i]));
        }
        if (!(next <= high) || std::isinf(next)) return csv;
        append_number(csv, next);
        for (std::size_t i = 0; i < series.size(); ++i) {
            const PlotData& data = *series[i].data;
            csv += ',';
            if (at[i] < data.size() && data.x(at[i]) == next) append_number(csv, data.y(at[i]++));
        }
        csv += '\n';
    }
}

}  // namespace lapfx::ui
