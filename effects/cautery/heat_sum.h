// The heat of one place of the radial model: the sum of what all tools near it give, in closed form for any time.
// Formulas: effects/cautery/parameters.cpp. One thread at a time.
//
//   dU/dt = sum of the rates of the tools near - U / cooling_time
//   dH/dt = 1 while one of them heats, else -H / cooling_time
//
// A gentle tool (coagulation) gives nothing while U is above its top.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cautery/heat.h"

namespace lapfx::cautery {

class HeatSum {
  public:
    /// A tool near the place from `from` to `to`, s.
    struct Source {
        std::uint32_t contact = 0;
        double from = 0.0, to = 0.0;
        double rate = 0.0;  ///< degrees per second, greater than 0
        bool gentle = false;
    };
    struct Constants {
        double cooling_time = 1.0;  ///< s
        double gentle_top = 0.0;    ///< degrees
    };
    struct State {
        double rise = 0.0;    ///< U, degrees above the body
        double stayed = 0.0;  ///< H, s
    };
    /// A time in which U and H follow one formula. The last part does not end.
    struct HeatPiece {
        double from = 0.0, to = never;
        State start;
        double aim = 0.0;  ///< degrees that U tends to
        bool heated = false;
        bool sources_change = false;  ///< at its start
        State at(double time, const Constants& constants) const;
        /// The same formula within from..to, which it holds.
        HeatPiece between(double from, double to, const Constants& constants) const;
        /// The first time in it at which U is at least `wanted` or, with `falls`, at most; never: at none.
        double when(double wanted, bool falls, const Constants& constants) const;
    };

    /// Sources are added in the order of their contacts, whose times do not fall.
    void add(std::span<const Source> sources, const Constants& constants);
    /// Removes the sources of this contact and of those after it.
    void remove_from(std::uint32_t contact, const Constants& constants);

    const std::vector<Source>& sources() const { return sources_; }
    const std::vector<HeatPiece>& parts() const { return parts_; }
    /// Number of the part of a time; parts().size() before the first one.
    std::size_t part_at(double time) const;
    State at(double time, const Constants& constants) const;
    /// The first time within from..to at which U is at least `wanted`.
    double reaches(double wanted, double from, double to, const Constants& constants) const;

  private:
    void rebuild(double from, const Constants& constants);
    void add_parts(double from, double to, double steady, double gentle, const Constants& constants);

    std::vector<Source> sources_;
    std::vector<HeatPiece> parts_;  // by time, without gaps
};

}  // namespace lapfx::cautery
