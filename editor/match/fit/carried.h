// Amounts that a scene would show, told without drawing it: what was measured of it as it was drawn last, changed by as
// much as the core's own amounts change. The core knows what most parameters do, but not what a camera sees of it; one
// drawn curve tells that. (Space mapping: Bandler et al., "Space mapping: the state of the art", 2004, whose response
// correction this is, with Broyden's update of what the core does not explain.)
//
//     veil:  tau = tau_drawn + haze_factor * (E - E_drawn) + plume_factor * (emission - emission_drawn) + B_veil * step
//            veil = 1 - exp(-tau)
//     plume: what stands out = that of the drawn curve + haze_factor * (E - E_drawn)
//            + plume_factor * (emission - emission_drawn) + B_plume * step, with factors of its own
//     blood: share = share_drawn + area_factor * (area - area_drawn) + B_blood * step
//
// `emission` is that of the core times the density of the plume, which multiplies its depth. `step` is the change of
// the free parameters' coordinates. The factors are found from the drawn curve; B is 0 at first and learns from each
// drawn curve what the core does not tell. Pure, any thread.
#pragma once

#include <span>
#include <vector>

#include "lapfx/amounts.h"
#include "match/frame/frame_amounts.h"

namespace lapfx::match {

/// Blood, veil, and what of it stands out, at the target's times.
struct ShownCurves {
    std::vector<double> blood, veil, plume;
};

/// As measured; where an amount is not measurable, interpolated between its neighbours, and 0 where it never is.
ShownCurves curves_of(std::span<const FrameAmounts> frames);

class Carried {
  public:
    /// `share_per_mm2`: what one mm2 of blood covers of the view, until a first drawn curve with blood tells it.
    Carried(std::size_t parameters, double share_per_mm2);

    /// The scene has been drawn with these coordinates. The first time B is 0; later what was told wrongly about this
    /// place is learnt.
    void drawn(std::span<const double> coordinates, std::span<const Amounts> core, const ShownCurves& curves);
    /// What another curve, drawn with one parameter changed, says about that parameter; for those of which the core
    /// knows nothing.
    void learn(std::size_t parameter, double step, const ShownCurves& curves);

    /// Tells from a place that was drawn before, such as a better one; what was learnt stays.
    void stand_at(std::span<const double> coordinates, std::span<const Amounts> core, const ShownCurves& curves);

    ShownCurves at(std::span<const double> coordinates, std::span<const Amounts> core) const;

  private:
    void find_factors(std::span<const Amounts> core, const ShownCurves& curves);
    std::size_t parameters_;
    /// A drawn curve had blood; smoke; a plume.
    bool area_known_ = false, haze_known_ = false, plume_known_ = false;
    double haze_factor_ = 1.0, plume_factor_ = 0.0, area_factor_;
    /// Of what stands out. The second is that of the sample scene until a drawn curve tells it.
    double haze_stands_out_ = 0.0, plume_stands_out_ = 0.04;
    std::vector<double> coordinates_;
    std::vector<Amounts> core_;
    ShownCurves curves_;
    std::vector<double> blood_slopes_, depth_slopes_, plume_slopes_;  ///< B: row by row, one row for each time
};

}  // namespace lapfx::match
