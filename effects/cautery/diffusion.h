// Heat that spreads over a surface: du/dt = diffusivity * Laplacian(u) - perfusion * u + source, on the points where
// something happens and nowhere else. Linear finite elements on the welded triangles (cotangent stiffness; mass three
// quarters lumped and one quarter consistent), TR-BDF2 in time (R. E. Bank et al., IEEE Trans CAD 4(4), 1985: second
// order and damped, stable for any step), conjugate gradients with a Jacobi preconditioner. The result depends only on
// the sequence of calls. One thread at a time. Eigen's solver is 1.4 times as fast, but consists of templates: in a
// plug-in these would clash with those of a host that also uses Eigen, built for another processor.
#pragma once

#include <cstdint>
#include <vector>

#include "organ/surface.h"
#include "organ/zeroed.h"

namespace lapfx::cautery {

class Diffusion {
  public:
    static constexpr double joins_at = 0.05;  ///< degrees at which the neighbours of a point join
    static constexpr double leaves_at =
        0.02;  ///< degrees below which a point leaves when its neighbours are also below

    /// Keeps a reference.
    explicit Diffusion(const Surface& surface) : surface_(surface), link_(surface.positions.size()) { clear(); }

    /// Points in play, in the order in which they joined; their rises now and before the last step.
    struct Field {
        std::vector<std::uint32_t> points;
        std::vector<double> now, before;
    };
    const Field& field() const { return field_; }
    void restore(const Field& field);
    void clear() { restore({}); }

    /// Heats a point during the next step, degrees per second.
    void heat(std::uint32_t point, double rate);
    void step(double dt, double diffusivity, double perfusion);
    /// Removes cool points; their rise is then 0.
    void drop_cool();

    /// The rise at a place, not below 0. It is smoother than the linear elements: quadratic in the logarithm.
    double rise_at(const SurfacePoint& place, const std::vector<double>& rises) const;

  private:
    static constexpr std::uint32_t none = 0xffffffff;
    struct Entry {
        std::uint32_t column;  // slot of the neighbour; none: it is not in play, so its rise is 0 and stays 0
        double mass, stiffness;
    };

    std::uint32_t slot_of(std::uint32_t point) const { return link_[point] - 1; }  // 0 - 1 is none
    double rise_of(std::uint32_t point, const std::vector<double>& rises) const {
        return slot_of(point) == none ? 0.0 : rises[slot_of(point)];
    }
    double level_of(std::uint32_t point, const std::vector<double>& rises) const;
    glm::dvec3 slope_at(std::uint32_t point, const std::vector<double>& rises) const;
    void join(std::uint32_t point);
    void assemble();
    void assemble_row(std::uint32_t point);
    /// out = (mass * a + stiffness * b) x
    void apply(double a, double b, const std::vector<double>& x, std::vector<double>& out) const;
    void solve(double a, double b, const std::vector<double>& right, std::vector<double>& x);

    const Surface& surface_;
    organ::Zeroed<std::uint32_t> link_;  // per point: 1 + its slot, 0 while it is not in play
    Field field_;
    std::vector<double> source_;  // per slot, for the next step
    bool stale_ = true;           // the rows belong to an earlier set of points
    std::vector<std::uint32_t> row_start_;
    std::vector<Entry> entries_;
    std::vector<double> mass_, stiffness_;  // diagonals
    std::vector<std::uint32_t> columns_;
    std::vector<double> matrix_, diagonal_;  // of the system that is being solved
    std::vector<double> right_, applied_, middle_, residual_, direction_, conditioned_;
};

}  // namespace lapfx::cautery
