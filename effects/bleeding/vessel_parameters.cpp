// The parameters of vessel and fat density (paper: figure 9).
//
//   r        = 0.75 log(R + 0.01) - log(G + 0.01), R and G in linear light: how much blood the light has crossed
//   contrast = r * Gaussian(0.1 vessel_width) - r * Gaussian(2 vessel_width)     what is redder than what is around
//   difference = |(L / 2, a, b) - (L / 2, a, b) of vessel_color|, CIELAB
//   c        = 1 - ramp(difference, vessel_tolerance / 2, vessel_tolerance)      0..1; 0 at a tolerance of 0
//   vessels  = max(ramp(contrast, vessel_low, vessel_high),
//                  ramp(c - c * Gaussian(2 vessel_width), 0.25, 0.75)) * Gaussian(smoothing)
//                                                                                0..1, same size as the texture
//   fat      = ramp(CIELAB hue, fat_low, fat_high) * Gaussian(smoothing)         grey and beyond yellow: 0
//   density  = mean over a disc of radius `region` on the surface, around the tool tip
//   strength of a wound = 0 where density < vessel_threshold,
//                         else 1 + vessel_strength * (density / vessel_reference - 1), at most 4
//                       1 where nothing shows vessels: no colour, or a texture (or the vertex colours)
//                         of which less than
//                         0.1 % is vessel. A liver's capsule bleeds where it is cut all the same
//
// Gaussians are given by their standard deviation in mm; texels per mm follow from how the texture lies on the organ,
// along u and v apart. Texels that are not on the surface (gutters between UV islands) have no weight. Vertex colours
// are treated in the same way, over the vertices.
//
// How the channel was chosen: on the five textures of samples/lagb.glb whose vessels are redder than the tissue,
// against the artery and vein cover that its generator (samples/organs/canvas.cpp) drew before painting; 60000 texels
// of each, vessel where the cover is above 0.4, left out between 0.08 and 0.4. Area under the ROC curve / best F1 of
// one threshold for all five. "Global": the channel itself. "Local": its contrast, as above, vessel_width 1.25.
// "Shaded": the same after the linear light was multiplied by exp of noise (1 and 5 mm, 0.25 each), as baked shadows
// do.
//
//   channel               global          local           local, shaded
//   CIELAB a*             0.871 / 0.639   0.956 / 0.741   0.920 / 0.654
//   CIELAB -L             0.760 / 0.115   0.963 / 0.826   0.911 / 0.635
//   HSV saturation        0.809 / 0.507   0.912 / 0.732   0.913 / 0.731
//   HSV hue               0.790 / 0.419   0.948 / 0.705   0.946 / 0.700
//   R / (R + G + B)       0.845 / 0.459   0.957 / 0.797   0.956 / 0.793
//   R - G                 0.855 / 0.609   0.882 / 0.647   0.818 / 0.461
//   -log G                0.803 / 0.117   0.980 / 0.850   0.943 / 0.756
//   log R - log G         0.852 / 0.548   0.972 / 0.831   0.964 / 0.815
//   0.75 log R - log G    0.843 / 0.448   0.979 / 0.845   0.975 / 0.827
//
// So a global range fails on tissue that varies, and the last channel keeps nearly all of -log G without its weakness
// for shade. With the defaults, texels of density above 0.3 are within two texels of a painted vessel in 99, 99, 94 and
// 99 % of cases (stomach, lesser and greater omentum, cardia fat) and are 88, 82, 87 and 80 % of the vessels.
//
// Why these defaults:
// - vessel_low 0.2, high 0.4: half a vessel at the threshold of the best F1, 0.28. Lower values take the reddish
//   creases between lobules of fat for vessels: at 0.1 these are more than half of what is found on the greater
//   omentum.
// - vessel_width 1.25 mm: best of 0.75, 1.25 and 2 when shaded; arteries with their veins on a stomach are 0.3 to 3 mm
//   wide.
// - fat 56 to 66 degrees: measured on textures, from the 5th to the 95th percentile, liver is at 24 to 36, a stomach's
//   muscle and serosa at 34 to 53, a gallbladder at 29 to 36, painted fat of two sources at 57 to 75 and 65 to 69.
// - smoothing 0.4 mm, region 2 mm: a hook is about 1 mm thick.
// - reference 0.1: a vessel of 0.3 mm across a region of 2 mm.
// - threshold 0.01: a tenth of that, so almost any visible vessel. On the stomach, omenta and cardia fat of
//   samples/lagb.glb 19 to 27 % of the surface bleeds then (0.02: 16 to 24, 0.05: 12 to 19 %): a stroke across it
//   bleeds where it meets vessels, as in the paper's figure 9.
// - strength 0.7: a cut at the threshold bleeds at 0.37 of the speed, one on an artery (density 0.4) at 3.1.
// - tolerance 0: contrast alone. It finds what is redder than its surroundings on any tissue, without being told a
//   colour; a colour has to be picked for the organ, since what is bluer or paler than its surroundings may as well be
//   a highlight or a fibre. 12 to 20 takes a vein of a texture that was painted or photographed in even light. On a
//   simulator's photographed fat contrast finds two vessels at the defaults (0.13 % of it), a tolerance of 16 around
//   the red-brown of its capillaries three times as much; around the grey-brown of its veins even 10 takes patches of
//   the fat itself for vessels, so c counts only where it stands out of what is around it, like contrast.
// - color 92, 107, 153: a vein seen through serosa.
#include "lapfx/preset.h"
#include "preset/tables.h"

namespace lapfx::preset {

namespace {

using V = VesselParameters;

constexpr Range contrast{0, 3, 0.01, "log", Scale::linear};
constexpr Range hue{0, 110, 1, "degrees"};
constexpr Range share{0, 1, 0.01};

constexpr Parameter rows[] = {
    number<&V::vessel_low>("vessel_low", "Vessel low", contrast,
                           "How much redder than the tissue around it a place must be to count as vessel at all. 0.1 "
                           "is a tenth more absorption of green. In the paper: the lower end of the band pass."),
    number<&V::vessel_high>("vessel_high", "Vessel high", contrast,
                            "How much redder than the tissue around it a place must be to count fully as vessel. In "
                            "the paper: the upper end of the band pass."),
    number<&V::vessel_width>("vessel_width", "Vessel width", {0.1, 20, 0.05, "mm", Scale::logarithmic},
                             "Width of the vessels to find; twice this width counts as the tissue around them. Much "
                             "finer or coarser texture does not count as vessels."),
    color<&V::vessel_color>(
        "vessel_color", "Vessel colour",
        "Colour of vessels that contrast does not find, such as blue veins, or pale ones under a liver's capsule. The "
        "next row says how close a colour must be. In the paper: the middle of a band pass on colour."),
    number<&V::vessel_tolerance>("vessel_tolerance", "Vessel tolerance", {0, 100, 0.5, "CIELAB"},
                                 "How far a colour may be from the vessel colour and still count as vessel; up to half "
                                 "as far it counts fully. Lightness counts half. Patches much wider than the vessel "
                                 "width do not count. 0: colour is not used, contrast alone finds vessels."),
    number<&V::fat_low>("fat_low", "Fat low", hue,
                        "Hue (CIELAB: 0 red, 90 yellow) up to which tissue is not fat. The fat layer is the paper's "
                        "future work; this is the lower end of its band."),
    number<&V::fat_high>("fat_high", "Fat high", hue,
                         "Hue from which tissue is fully fat. The fat layer is the paper's future work; this is the "
                         "upper end of its band."),
    number<&V::smoothing>("smoothing", "Smoothing", {0, 20, 0.05, "mm"},
                          "How far the maps of vessels and fat are blurred, so that single pixels do not matter. In "
                          "the paper: the standard deviation of the Gaussian filter."),
    number<&V::region>(
        "region", "Region", {0.1, 20, 0.1, "mm", Scale::logarithmic},
        "Radius around the tool tip over which density is averaged. In the paper: the region of influence."),
    number<&V::vessel_threshold>(
        "vessel_threshold", "Vessel threshold", share,
        "A cut where vessels are less dense than this does not bleed. 0: every cut bleeds. On organs whose colours "
        "show no vessels at all every cut bleeds, whatever this value is. In the paper: the preset density threshold."),
    number<&V::vessel_reference>("vessel_reference", "Vessel reference", {0.01, 1, 0.01},
                                 "Density at which a wound bleeds at the speed set under Bleeding."),
    number<&V::vessel_strength>("vessel_strength", "Vessel strength", share,
                                "How much the density of vessels decides how strongly a cut bleeds. 0: not at all; 1: "
                                "in proportion to it, as in the paper."),
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
    return again(
        redo::amounts | redo::densities,
        table<&Preset::vessels>("vessels", "Vessels",
                                "Where the organ's colours show vessels and fat, and how that changes a wound.",
                                {.rows = rows, .rules = rules}));
}

}  // namespace lapfx::preset
