// Density of the environmental smoke over time, in closed form, so that any time can be asked for in any order. Any
// thread, one at a time for set().
//
//   dE/dt = accumulation * factor(t) * emission(t) - (ventilation + suction while any runs) * E,
//   E = 0 before the first emission
//
// The factor is the scene's (lapfx/curves.h), linear between two of its points. Between two moments at which something
// starts or ends, or at which the factor has a point, the emission is linear and the loss constant, and the solution is
// an exponential and a line; set() computes the value at each of these moments, and density() continues from the last
// one.
#pragma once

#include <span>
#include <vector>

#include "lapfx/smoke_parameters.h"
#include "preset/factor_curve.h"

namespace lapfx::smoke {

/// Smoke of `power` (0 and more) comes from `start` to `end`, s. Emissions at the same time add up.
struct Emission {
    double start;
    double end;
    double power;

    friend bool operator==(const Emission&, const Emission&) = default;
};

/// A suction tool runs from `start` to `end`, s. Several at the same time count once.
struct Suction {
    double start;
    double end;

    friend bool operator==(const Suction&, const Suction&) = default;
};

class HazeCurve {
  public:
    /// After a change (redo::haze), and of the scene's factor, which is 1 at first. They count with the next set().
    void set_parameters(const HazeParameters& haze);
    void set_factor(const FactorCurve& factor);
    /// Both lists may be in any order. Spans that end before they start, or are not finite, are ignored. It computes
    /// only what follows the first change since the last call: the given numbers of first elements of both lists have
    /// not changed and cost nothing.
    void set(std::span<const Emission> emissions, std::span<const Suction> suctions, std::size_t same_emissions = 0,
             std::size_t same_suctions = 0);

    /// E(t), optical thickness at the focus distance. O(log contacts).
    double density(double time) const noexcept;
    /// factor(t) * emission(t): the emission at this moment.
    double emission(double time) const noexcept;

  private:
    /// A moment at which something starts or ends.
    struct Event {
        double time;
        double power;             ///< added to that of emissions; 0 for suction
        int emissions, suctions;  ///< added to how many there are: -1, 0 or 1

        friend auto operator<=>(const Event&, const Event&) = default;
    };
    /// From `start` to the start of the next piece.
    struct Piece {
        double start;
        double density;  ///< at `start`
        double factor;   ///< at `start`
        double slope;    ///< slope of the factor, 1/s
        double power;    ///< all emissions together have this power
        int emissions, suctions;
    };
    double at(const Piece& piece, double time) const noexcept;
    const Piece* piece_at(double time) const noexcept;

    template <class Span>
    struct List {
        std::vector<Span> spans;
        std::vector<double> latest;  // when each and all before it have ended, s

        double replace(std::span<const Span> wanted, std::size_t same);
        std::span<const Span> after(double time) const;
    };
    List<Emission> emissions_;
    List<Suction> suctions_;
    FactorCurve factor_;
    double accumulation_ = 0.0, ventilation_ = 0.0, suction_ = 0.0;
    bool anew_ = false;  // the next set() computes everything
    std::vector<Piece> pieces_;
    std::vector<Event> events_;  // kept for its memory
};

}  // namespace lapfx::smoke
