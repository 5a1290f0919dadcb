// The parameters of bleeding (paper: "Simulation of bleeding", figures 6 and 7).
//
//   s(t)    = min(max_extent, speed * strength * time the wound has been open), pulsing if arterial          mm
//   d(x)    = travel distance from the contact point over the surface - gravity_bias * drop from it to x      mm
//             (a mm along a crease counts as 0.35 mm at crease_bias 1, a mm across a ridge as up to 1.33)
//   b(x, t) = max over wounds of s - d: the paper's animation variable, carried on below 0 as far as noise reaches   mm
//   blood where b > threshold + noise_strength * noise(x / noise_scale), noise in -1..1 with mean 0
//   depth   = b - threshold - noise; colour runs from color_thin to color_deep, which is reached at deep_at   mm
//   noise is pressed together along gravity by 0.6 rivulets (first octave) to 0.8 rivulets (the others), which draws
//   lobes out downhill on walls and does nothing on level tissue; on steep tissue it is up to 1 + rivulets times as
//   strong
//   hidden  = opacity * (1 - 2^(-a (depth / deep_at + 0.06))), a = 2.6, 8, 7.5 for red, green, blue: Beer and Lambert
//
// Lengths are mm so that a preset means the same on a coarse and a fine mesh and on organs of any scale.
//
// Why these defaults:
// - speed 4 mm/s and max_extent 16 mm: an oozing cut reaches the size of a thumbnail in four seconds. The paper's
//   subjects found its bleeding "far greater" than in the videos (question 7), so the default is modest.
// - threshold 0.3 mm: less is not seen on wet tissue.
// - noise 4.5 mm per lobe, 3 mm strong, two octaves: runs and lobes of real strips are 3 to 8 mm wide; two thirds of
//   the lobe as strength hide the polygons of figure 7b without tearing the pool apart, and fluid has no finer edge.
// - rivulets 0.7: on a wall runs three times as long as wide, as in Cholec80's video01_193 to 204; at 1 five times.
// - gravity_bias 0.35: blood runs visibly downhill, but a pool on a flat organ stays round.
// - crease_bias 0.5: in real strips blood leaves a pool along the folds. bridge_gap 1 mm: organs of a scene touch
//   without sharing vertices, and every visible gap is wider.
// - suction 8 mm: a 5 mm cannula clears a little more than its own width; irrigation 15 mm: its jet spreads and runs
//   off.
// - pulse 0: venous. An artery is 1 to 1.5 Hz with a strength near 0.6.
// - coagulation_time 1.5 s: "coagulated within a short period of time".
// - colours: dark saturated red. Measured in surgery videos (8-bit sRGB): thin running strip 145, 7, 10; pool 93, 15,
//   17. color_thin and color_deep are darker: the lamp near the tissue and the exposure bring them to that. Median of
//   the dark red pixels in the sample scene at 8.6 s, without smoke: 69, 19, 15; in the bloodiest clips 67 to 87, 15 to
//   18, 18 to 22.
// - deep_at 5 mm, opacity 0.9, thickness 0.6 mm, gloss 0.85: a pool hides the texture below, a film does not; its
//   highlights are small, sharp and white.
// - clot_darkening 0.85: old clots next to fresh blood are brown-black; they are dull whatever this value is.
#include "lapfx/preset.h"
#include "preset/tables.h"

namespace lapfx::preset {

namespace {

using B = BleedingParameters;

constexpr unsigned changes_values = redo::bleed | redo::amounts, changes_fronts = redo::fronts | changes_values,
                   changes_sums = redo::blood_sums | redo::amounts;

constexpr Parameter rows[] = {
    again(changes_values,
          number<&B::speed>(
              "speed", "Speed", {0, 60, 0.1, "mm/s"},
              "How fast the edge of the blood moves over the tissue from a wound of strength 1. In the paper: "
              "the bleeding speed, at which the animation variable grows.")),
    again(changes_values,
          number<&B::max_extent>(
              "max_extent", "Level extent", {0, 200, 0.5, "mm"},
              "How far blood spreads from its wound over level, smooth tissue, at most. It is no bound "
              "elsewhere: gravity bias and crease bias let it run farther, at their defaults one and a half "
              "times as far downhill or along a fold, and three times down a fold. In the paper: the upper "
              "threshold of the animation variable.")),
    again(changes_sums,
          number<&B::threshold>(
              "threshold", "Threshold", {0, 10, 0.05, "mm"},
              "Bleed value from which blood shows; noise is added to it. In the paper: the predefined threshold.")),
    number<&B::noise_scale>(
        "noise_scale", "Noise scale", {0.2, 50, 0.1, "mm", Scale::logarithmic},
        "Width of one lobe of the edge, measured on the organ. In the paper: the scale of the Perlin noise."),
    again(changes_values,
          number<&B::noise_strength>(
              "noise_strength", "Noise strength", {0, 20, 0.1, "mm"},
              "How far noise moves the edge of the blood. 0 shows a sharp, plain edge, as in the paper's figure 7b.")),
    again(changes_sums, integer<&B::noise_octaves>("noise_octaves", "Noise octaves", {1, 6, 1},
                                                   "How many layers of ever finer noise shape the edge.")),
    again(changes_fronts, number<&B::gravity_bias>(
                              "gravity_bias", "Gravity bias", {0, 0.9, 0.01},
                              "How much easier blood runs downhill than uphill. 0 spreads evenly, as in the paper.")),
    again(
        changes_fronts,
        number<&B::crease_bias>(
            "crease_bias", "Crease bias", {0, 1, 0.01},
            "How strongly creases of the tissue attract blood and ridges hold it off. 0: creases make no difference.")),
    again(changes_fronts,
          number<&B::bridge_gap>(
              "bridge_gap", "Bridge gap", {0, 5, 0.1, "mm"},
              "Parts of an organ that are closer than this count as touching: blood runs from one to the "
              "other. 0 keeps it within one part.")),
    again(changes_sums,
          number<&B::rivulets>(
              "rivulets", "Rivulets", {0, 1, 0.01},
              "How far the edge is drawn out into narrow runs where tissue is steep. 0 makes round lobes everywhere.")),
    again(changes_values, number<&B::pulse_rate>("pulse_rate", "Pulse rate", {0, 4, 0.05, "Hz"},
                                                 "Heart beats per second of an arterial wound. 0: venous.")),
    again(changes_values,
          number<&B::pulse_strength>("pulse_strength", "Pulse strength", {0, 1, 0.01},
                                     "How much of the flow comes in beats. 0: venous; 1: no flow between beats.")),
    again(changes_values, number<&B::coagulation_time>(
                              "coagulation_time", "Coagulation time", {0, 30, 0.1, "s"},
                              "How long a wound has to be cauterised until it stops bleeding. The paper stops the "
                              "spread within a short period.")),
    again(redo::amounts | redo::clearing,
          number<&B::suction_radius>("suction_radius", "Suction radius", {0, 50, 0.5, "mm"},
                                     "How far around its tip suction removes blood.")),
    again(redo::amounts | redo::clearing,
          number<&B::irrigation_radius>(
              "irrigation_radius", "Irrigation radius", {0, 100, 0.5, "mm"},
              "How far around its tip irrigation rinses blood away; downhill it reaches half as far again.")),
    color<&B::color_thin>(
        "color_thin", "Thin colour",
        "Colour of a thin film of blood, at the edge. In the paper: the start of the colour gradient."),
    color<&B::color_deep>("color_deep", "Deep colour",
                          "Colour of a deep pool of blood. In the paper: the end of the colour gradient."),
    again(changes_sums, number<&B::deep_at>("deep_at", "Deep at", {0.1, 30, 0.1, "mm", Scale::logarithmic},
                                            "Bleed value above the edge at which blood has the deep colour.")),
    number<&B::opacity>("opacity", "Opacity", {0, 1, 0.01}, "How much of the tissue a deep pool hides."),
    again(changes_sums,
          number<&B::thickness>(
              "thickness", "Thickness", {0, 3, 0.05, "mm"},
              "Height of a deep pool above the tissue. It shapes the highlights. In the paper: bump mapping.")),
    number<&B::gloss>(
        "gloss", "Gloss", {0, 1, 0.01},
        "How sharp and strong the reflection of the lamp is in fresh blood. In the paper: the wet surface effect."),
    number<&B::clot_darkening>("clot_darkening", "Clot darkening", {0, 1, 0.01},
                               "How far clotted blood turns from red to brown-black. It always loses its gloss."),
};

}  // namespace

Table bleeding_table() {
    return table<&Preset::bleeding>("bleeding", "Bleeding", "Blood spreading over the organ.", {rows});
}

}  // namespace lapfx::preset
