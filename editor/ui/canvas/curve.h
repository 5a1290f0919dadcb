// A function of one input given by points: how strong over how old, how much over how long. Pure; the editor is
// curve_editor.h.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lapfx::ui {

/// How the curve goes through a point.
enum class CurveHandle : std::uint8_t {
    automatic,  ///< smooth: the slope between its neighbours
    free,       ///< slopes of its own
    linear,     ///< straight towards it, straight away from it
    step,       ///< keeps its value until the next point
};

struct CurvePoint {
    double x = 0, y = 0;
    CurveHandle handle = CurveHandle::automatic;
    double slope_in = 0, slope_out = 0;  ///< dy/dx, of `free` only
    friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

enum class CurvePreset : std::uint8_t { linear, ease, s, step, pulse };

/// Cubic between each two points (Hermite's form). One value for each input: points have different x, in ascending
/// order.
class Curve {
  public:
    /// From (0, 0) to (1, 1), straight.
    Curve();
    /// Of points that are valid(); others are a mistake of the program (assert).
    explicit Curve(std::vector<CurvePoint> points, bool monotone = false);
    /// Over 0..1 in both directions.
    static Curve preset(CurvePreset preset);
    /// One or more, all finite, each x above the one before.
    static bool valid(std::span<const CurvePoint> points);

    /// As far as the first and last point; beyond, their values. NaN gives the first value.
    double evaluate(double x) const;
    std::span<const CurvePoint> points() const { return points_; }
    const CurvePoint& point(std::size_t i) const { return points_[i]; }
    std::size_t size() const { return points_.size(); }
    /// Slopes as they are used, whatever the handle.
    double slope_in(std::size_t i) const { return slopes_in_[i]; }
    double slope_out(std::size_t i) const { return slopes_out_[i]; }

    /// Between two points the curve never leaves what lies between their values: F. N. Fritsch, R. E. Carlson, Monotone
    /// Piecewise Cubic Interpolation, SIAM J. Numer. Anal. 17 (1980).
    bool monotone() const { return monotone_; }
    void set_monotone(bool monotone);

    /// Gives its index; nothing when there is a point at this x already, or a number is not finite.
    std::optional<std::size_t> insert(double x, double y);
    /// The last one stays.
    void erase(std::size_t i);
    /// x must be between its neighbours (assert); all finite (assert).
    void set_point(std::size_t i, const CurvePoint& point);
    /// All of them anew; valid() (assert).
    void set_points(std::span<const CurvePoint> points);
    /// Free, with the slopes it has now.
    void make_free(std::size_t i);

    /// Five figures for each point: x, y, handle, slope_in, slope_out.
    std::vector<double> to_array() const;
    /// Nothing when it is no such array.
    static std::optional<Curve> from_array(std::span<const double> figures, bool monotone = false);
    friend bool operator==(const Curve& a, const Curve& b) {
        return a.points_ == b.points_ && a.monotone_ == b.monotone_;
    }

  private:
    void update();
    void keep_monotone();

    std::vector<CurvePoint> points_;
    std::vector<double> slopes_in_, slopes_out_;
    bool monotone_ = false;
};

}  // namespace lapfx::ui
