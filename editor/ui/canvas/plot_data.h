// The samples of a plot, with minima, maxima and areas of blocks of them, which are computed once. So a million samples
// cost no more than the pixels of the plot.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lapfx::ui {

/// float or double, not owned.
class Numbers {
  public:
    Numbers() = default;
    Numbers(std::span<const float> v) : floats_(v.data()), size_(v.size()) {}       // NOLINT
    Numbers(std::span<const double> v) : doubles_(v.data()), size_(v.size()) {}     // NOLINT
    Numbers(const std::vector<float>& v) : Numbers(std::span<const float>(v)) {}    // NOLINT
    Numbers(const std::vector<double>& v) : Numbers(std::span<const double>(v)) {}  // NOLINT
    std::size_t size() const { return size_; }
    double operator[](std::size_t i) const {
        return floats_ != nullptr ? static_cast<double>(floats_[i]) : doubles_[i];
    }

  private:
    const float* floats_ = nullptr;
    const double* doubles_ = nullptr;
    std::size_t size_ = 0;
};

struct Extremes {
    double low = 0, high = 0;
    bool any = false;  ///< false: no finite sample

    void add(double v) { low = any ? std::min(low, v) : v, high = any ? std::max(high, v) : v, any = true; }
    void add(const Extremes& o) {
        if (o.any) add(o.low), add(o.high);
    }
};

/// Statistics of the line through the samples, between two places.
struct RangeStatistics {
    double mean = 0;    ///< area over the width that is covered
    double area = 0;    ///< below the line, gaps left out
    double width = 0;   ///< of x, gaps left out
    Extremes extremes;  ///< of the samples and of where the line meets the ends
};

class PlotData {
  public:
    /// Samples at start, start + step, ...; step > 0 (assert). What is not finite is a gap. `y` must stay as it is
    /// until the next set().
    void set(Numbers y, double start = 0, double step = 1);
    /// Samples at places of their own: as many, finite, none before the one in front of it (assert).
    void set(Numbers y, Numbers x);

    std::size_t size() const { return y_.size(); }
    double y(std::size_t i) const { return y_[i]; }
    double x(std::size_t i) const { return x_.size() != 0 ? x_[i] : start_ + step_ * static_cast<double>(i); }
    /// Index of the first sample at `x` or after it; size(): none.
    std::size_t index_from(double x) const;
    std::size_t nearest(double x) const;  ///< size() must not be 0 (assert)
    /// On the line through the samples; NaN outside of them and in gaps.
    double value_at(double x) const;
    /// The extremes of the samples from `first` up to, but without, `last`, in logarithmic time.
    Extremes extremes(std::size_t first, std::size_t last) const;
    Extremes extremes() const { return extremes(0, size()); }
    /// The statistics from `low` to `high`, in either order, also in logarithmic time.
    RangeStatistics statistics(double low, double high) const;

  private:
    static constexpr std::size_t block = 16;  ///< samples of a node of the lowest level, and nodes of one above
    void build();
    double area_between(std::size_t first, std::size_t last, double& width) const;

    Numbers y_, x_;
    double start_ = 0, step_ = 1;
    std::vector<std::vector<Extremes>> levels_;
    std::vector<double> areas_, widths_;  ///< of all line pieces before each block
};

struct PlotSeries;
/// One line of names, then one for each place that a series has a sample at within low..high, empty where it has none
/// (or a gap). Names with commas, quotes or line breaks are quoted.
std::string plot_csv(std::span<const PlotSeries> series, std::string_view x_name, double low, double high);

}  // namespace lapfx::ui
