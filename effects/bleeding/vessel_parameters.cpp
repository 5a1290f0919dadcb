// The parameters of vessel and fat density (paper: figure 9).
//
//   r        = 0.75 log(R + 0.01) - log(G + 0.01), R and G in linear light: how much blood the light has crossed
//   contrast = r * Gaussian(0.1 vessel_width) - r * Gaussian(2 vessel_width)     what is redder than the tissue around it
//   vessels  = ramp(contrast, vessel_low, vessel_high) * Gaussian(smoothing)     0..1, same size as the texture
//   fat      = ramp(CIELAB hue, fat_low, fat_high) * Gaussian(smoothing)         grey and beyond yellow: 0
//   density  = mean over a disc of radius `region` on the surface, around the tool tip
//   strength of a wound = 0 where density < vessel_threshold,
//                         else 1 + vessel_strength * (density / vessel_reference - 1), at most 4
//
// Gaussians are given by their standard deviation in mm; texels per mm follow from how the texture lies on the organ, along
// u and v apart. What is not on the surface (gutters between UV islands) has no weight. Vertex colours instead of a texture:
// the same, over the vertices.
//
// TABLE
#include "preset/tables.h"

namespace lapfx::preset {

namespace {

using V = VesselParameters;

constexpr Range contrast{0, 3, 0.01, "log", Scale::linear};
constexpr Range hue{0, 110, 1, "degrees"};
constexpr Range share{0, 1, 0.01};

constexpr Parameter rows[] = {
    number<&V::vessel_low>("vessel_low", "Vessel low", contrast,
                           "How much redder than the tissue around it a texel is before it counts as vessel at all: "
                           "the lower end of the paper's band pass. 0.1 is a tenth more absorption of green."),
    number<&V::vessel_high>("vessel_high", "Vessel high", contrast,
                            "How much redder than the tissue around it a texel is when it is wholly vessel."),
    number<&V::vessel_width>("vessel_width", "Vessel width", {0.1, 20, 0.05, "mm", Scale::logarithmic},
                             "Width of the vessels that are looked for; twice of it is what counts as around them. "
                             "Texture that is much finer or coarser is not taken for vessels."),
    number<&V::fat_low>("fat_low", "Fat low", hue,
                        "Hue (CIELAB: 0 red, 90 yellow) up to which tissue is not fat: the lower end of its band."),
    number<&V::fat_high>("fat_high", "Fat high", hue, "Hue from which tissue is wholly fat."),
    number<&V::smoothing>("smoothing", "Smoothing", {0, 20, 0.05, "mm"},
                          "Standard deviation of the paper's Gaussian filter, which smooths the pixelated result."),
    number<&V::region>("region", "Region", {0.1, 20, 0.1, "mm", Scale::logarithmic},
                       "Radius of the tool tip's region of influence, over which density is averaged."),
    number<&V::vessel_threshold>("vessel_threshold", "Vessel threshold", share,
                                 "Density below which a cut does not bleed: the paper's preset density threshold. 0: "
                                 "every cut bleeds."),
    number<&V::vessel_reference>("vessel_reference", "Vessel reference", {0.01, 1, 0.01},
                                 "Density at which a wound bleeds with the preset's own speed."),
    number<&V::vessel_strength>("vessel_strength", "Vessel strength", share,
                                "How much the density of vessels decides how strongly a cut bleeds: 0 not at all, 1 in "
                                "proportion to it."),
};

constexpr Rule rules[] = {
    {"vessel_low",
     [](const void* owner) {
         const auto& v = *static_cast<const V*>(owner);
         return below(v.vessel_low, "vessel_high", v.vessel_high);
     }},
    {"fat_low",
     [](const void* owner) {
         const auto& v = *static_cast<const V*>(owner);
         return below(v.fat_low, "fat_high", v.fat_high);
     }},
};

}  // namespace

Table vessels_table() {
    return table<&Preset::vessels>("vessels", "Vessels",
                                   "Where the organ's colours show vessels and fat, and what that does to a wound.",
                                   {.rows = rows, .rules = rules});
}

}  // namespace lapfx::preset
