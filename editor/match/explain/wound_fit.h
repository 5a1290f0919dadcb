// Wounds whose area is known from tables (wound_site.h), fitted to a curve: least squares over start, speed and largest
// extent. It takes a few milliseconds, so that it can be done again from many beginnings.
// Pure; any thread.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "match/explain/wound_site.h"
#include "match/explain/wounds.h"

namespace lapfx::match {

/// The measured curve in at most so many blocks of time; a block weighs as its points do together.
struct BloodCurve {
    static constexpr std::size_t most_blocks = 72;
    struct Block {
        double time = 0.0, blood = 0.0, weight = 0.0;  // weight: 1 / variance
    };
    std::vector<BloodPoint> points;  // those that count
    std::vector<Block> blocks;
    // How many blocks would say as much if their errors had nothing to do with one another.
    double independent = 0.0;

    BloodCurve(std::span<const BloodPoint> measured, double error_lasts);
    double begin() const { return blocks.front().time; }
    double end() const { return blocks.back().time; }
    double most() const;
    /// Times from which the curve rises most, as many, apart from one another and ascending.
    std::vector<double> steepest(std::size_t count) const;
    /// Times at which the curve leaves the first, second, ... of equal shares of its most.
    std::vector<double> shares(std::size_t count) const;
    /// Weighted sum of squares of what `blood` (of each block) leaves.
    double misfit(std::span<const double> blood) const;

  private:
    std::vector<double> smooth() const;
};

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

struct FittedWound {
    double start = 0.0;  // s
    double pace = 0.0;   // mm/s: speed times the event's strength
};
inline bool earlier(const FittedWound& a, const FittedWound& b) {
    return a.start < b.start;
}
struct WoundFit {
    std::vector<FittedWound> wounds = {};
    double max_extent = unbounded;  // mm
    double misfit = 0.0;            // BloodCurve::misfit()
    bool even = false;              // paces are as the sites' strengths say
    std::size_t unknowns() const {
        return (even && !wounds.empty() ? wounds.size() + 1 : 2 * wounds.size()) + (max_extent < unbounded ? 1 : 0);
    }
};

class WoundTables {
  public:
    /// Keeps references. `usual_speed`: mm/s, what is taken as far as the curve says nothing.
    WoundTables(const BloodCurve& curve, const WoundSearch& search, double usual_speed);

    /// Wound i opens at sites[i].
    void set_sites(std::vector<const WoundSite*> sites) { sites_ = std::move(sites); }
    /// What the tables are multiplied with at each block; empty: 1.
    void set_correction(std::vector<double> correction) { correction_ = std::move(correction); }

    /// Share of the view at each block, without the correction.
    std::vector<double> raw(const WoundFit& fit) const;
    /// The best fit near `from`, with or without a largest extent, with paces that are free or as the strengths say.
    WoundFit fitted(const WoundFit& from) const;
    /// `before` with one wound more, at the last place in time or between: from many beginnings. The sites are those of
    /// all the wounds. Not corrected.
    WoundFit with_one_more(const WoundFit& before) const;
    /// mm that blood of wound i has travelled at the end of the curve.
    double travelled(const WoundFit& fit, std::size_t i) const;

    /// Standard errors of starts, s, then paces, as shares of them (one, where they are even).
    std::vector<double> errors(const WoundFit& fit) const;

  private:
    double flowing(double from, double to) const;
    double full_extent() const;
    void residuals_of(const WoundFit& fit, std::span<double> residuals) const;
    double cost(const WoundFit& fit) const;
    double misfit_of(const WoundFit& fit) const;
    WoundFit beginning(const WoundFit& before, double start, double speed, bool alike, double extent) const;
    std::vector<WoundFit> beginnings(const WoundFit& before, bool alike) const;
    WoundFit beginning_at(std::span<const double> starts) const;
    double tried_speed(int k) const;
    std::vector<double> unknowns_of(const WoundFit& fit) const;
    WoundFit fit_of(std::span<const double> unknowns, const WoundFit& like) const;

    const BloodCurve& curve_;
    const WoundSearch& search_;
    double usual_speed_;
    std::vector<const WoundSite*> sites_;
    std::vector<double> correction_;
};

}  // namespace lapfx::match
