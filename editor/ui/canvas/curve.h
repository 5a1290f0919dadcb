// A function of one input: points with straight lines between them. No UI; the editor is curve_editor.h.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace lapfx::ui {

struct CurvePoint {
    double x = 0, y = 0;
    friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// One value for each input: points have different x, in ascending order.
class Curve {
  public:
    /// A straight line from (0, 0) to (1, 1).
    Curve();
    /// The points must be valid() (assert).
    explicit Curve(std::vector<CurvePoint> points);
    /// Whether there are one or more points, all finite, each x above the one before.
    static bool valid(std::span<const CurvePoint> points);

    /// Before the first and after the last point: their values. NaN gives the first value.
    double evaluate(double x) const;
    std::span<const CurvePoint> points() const { return points_; }
    const CurvePoint& point(std::size_t i) const { return points_[i]; }
    std::size_t size() const { return points_.size(); }

    /// Returns its index; nothing when there is a point at this x already, or a number is not finite.
    std::optional<std::size_t> insert(double x, double y);
    /// The last one stays.
    void erase(std::size_t i);
    /// Replaces all of them; valid() (assert).
    void set_points(std::span<const CurvePoint> points);
    friend bool operator==(const Curve&, const Curve&) = default;

  private:
    std::vector<CurvePoint> points_;
};

}  // namespace lapfx::ui
