// What one colour says about tissue, without its surroundings. Formulas: vessel_parameters.cpp.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace lapfx::bleeding {

/// 0 up to `low`, 1 from `high` on, linear between.
inline double ramp(double low, double high, double value) {
    return glm::clamp((value - low) / std::max(high - low, 1e-9), 0.0, 1.0);
}

/// How much blood the light has crossed: weights log red against log green, so that shade nearly cancels.
constexpr double red_weight = 0.75;
/// Limits the noise of nearly black texels.
constexpr double least_light = 0.01;

/// Deviations of the two Gaussians whose difference is local contrast, as shares of `vessel_width`.
constexpr double near_share = 0.1, around_share = 2.0;

/// `linear`: linear light, 0..1.
inline double redness(double linear_red, double linear_green) {
    return red_weight * std::log(linear_red + least_light) - std::log(linear_green + least_light);
}

/// CIELAB hue angle, degrees: 0 red, 90 yellow.
inline double hue_of(double a, double b) {
    return std::atan2(b, a) * 57.29577951308232;
}
/// A colour of less chroma counts as grey, without a hue.
constexpr double least_chroma = 6.0;

/// Whether a colour can be that of a vessel, 0..1, from CIELAB a* and b*: crimson to orange, not grey.
inline double bloodiness(double a, double b) {
    const double hue = hue_of(a, b);
    return ramp(-60.0, -40.0, hue) * (1.0 - ramp(65.0, 80.0, hue)) * ramp(4.0, 10.0, std::hypot(a, b));
}

/// How fatty a colour is, 0..1, from CIELAB a* and b*: the hue angle in degrees (0 red, 90 yellow) against the band.
/// Nothing beyond yellow is fat, and grey is not either.
inline double fattiness(double a, double b, double low, double high) {
    const double hue = hue_of(a, b);
    return ramp(low, high, hue) * (1.0 - ramp(100.0, 115.0, hue)) * ramp(least_chroma, 14.0, std::hypot(a, b));
}

/// CIELAB L*, a* and b* of linear sRGB (D65; IEC 61966-2-1, CIE 15).
glm::dvec3 lab_of(const glm::dvec3& linear);
/// The same for an sRGB colour, 0..1.
glm::dvec3 lab_of_srgb(const glm::dvec3& srgb);

/// How close a colour is to that of a vessel, 0..1, from its difference to `wanted`: 1 up to half of `tolerance`, 0
/// from `tolerance` on. A tolerance of 0 accepts no colour. Lightness counts half, as in CMC(2:1), because shade
/// changes it most.
class ColorBand {
  public:
    ColorBand(const glm::dvec3& wanted_srgb, double tolerance)
        : wanted_(lab_of_srgb(wanted_srgb)), tolerance_(tolerance) {}

    /// Compares the band's value at a place with its mean around it: vessels are narrow, and a patch of that colour is
    /// not a vessel.
    static double standing_out(double here, double around) { return ramp(0.25, 0.75, here - around); }

    bool any() const { return tolerance_ > 0.0; }
    double operator()(const glm::dvec3& lab) const {
        const glm::dvec3 off = (lab - wanted_) * glm::dvec3(0.5, 1.0, 1.0);
        return any() ? 1.0 - ramp(0.5 * tolerance_, tolerance_, glm::length(off)) : 0.0;
    }

  private:
    glm::dvec3 wanted_;
    double tolerance_;
};

}  // namespace lapfx::bleeding
