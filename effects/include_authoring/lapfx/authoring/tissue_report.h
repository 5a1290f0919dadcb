// Vessels and fat found on a whole organ, for people who set the bands that find them.
//
//     const lapfx::TissueReport found = lapfx::report_tissue(organ, preset.vessels);
//     if (found.vessels == 0.0) log("every cut bleeds equally");
//
// Any thread.
#pragma once

#include <array>
#include <cstdint>

#include "lapfx/bleeding_parameters.h"
#include "lapfx/organ.h"

namespace lapfx {

class PreparedOrgan;

/// What `lapfx inspect` says about the tissue.
struct TissueReport {
    double known = 0.0;  ///< share of the surface that has colour, 0..1; the shares below are of this
    double alike = 1.0;  ///< share of the surface where every cut bleeds equally, 0..1: no colour, or no vessels found
    double vessels = 0.0;        ///< share that is vessel, 0..1
    double fat = 0.0;            ///< share that is fat, 0..1
    double texels_per_mm = 0.0;  ///< pixels of the finest texture for each mm; 0: vertex colours, or none
};

/// Histograms of the values that the band passes of vessels and fat look at, over the texels (or coloured vertices) of
/// the surface, so that a person can set the bands by looking. Values outside the range are not counted.
struct TissueHistogram {
    static constexpr std::size_t bins = 96;
    static constexpr double least_contrast = 0.0, most_contrast = 0.96;  ///< vessel_low and vessel_high lie within
    static constexpr double least_hue = 0.0, most_hue = 96.0;            ///< fat_low and fat_high lie within, degrees
    std::array<std::uint32_t, bins> contrast{};  ///< contrast at this vessel_width, where the hue can be that of blood
    std::array<std::uint32_t, bins> hue{};       ///< hue, where there is a colour

    void add_contrast(double value) { add(contrast, (value - least_contrast) / (most_contrast - least_contrast)); }
    void add_hue(double degrees) { add(hue, (degrees - least_hue) / (most_hue - least_hue)); }

  private:
    static void add(std::array<std::uint32_t, bins>& counts, double place) {
        if (place >= 0.0 && place < 1.0) ++counts[static_cast<std::size_t>(place * static_cast<double>(bins))];
    }
};

/// As report_tissue().
TissueHistogram tissue_histogram(const Organ& organ, const VesselParameters& parameters = {});
/// Only counting remains for a prepared organ (prepared_organ.h).
TissueHistogram tissue_histogram(const PreparedOrgan& organ, const VesselParameters& parameters = {});

/// Throws nothing but std::bad_alloc. `parameters` must be in range (they are when they come from a preset).
TissueReport report_tissue(const Organ& organ, const VesselParameters& parameters = {});

}  // namespace lapfx
