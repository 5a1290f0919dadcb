// The parameters of heat under the tool (paper: "Bleeding and Smoke in a Virtual LAGB Simulator").
//
// Both models: T > cut_temperature under the tip: the tissue is divided and bleeds. The hottest that tissue has been
// decides how charred it is. The heat of several tools at one place adds; nothing cold undoes a burn; a wound is there
// once. A hot tool closes a wound whose tissue is between the coagulation and the cut temperature, unless its own heat
// was there when the wound was opened.
//
// model "radial", the paper's; temperatures in degrees Celsius, lengths mm, times s:
//
//   T(r, t) = 37 + U exp(-(r / R)^2),   R^2 = tip_radius^2 + heat_spread^2 * H
//   dU/dt = sum of heat_rate * power * exp(-(s / tip_radius)^2) - U / cooling_time
//   dH/dt = 1 while a hot tip is within tip_radius of the place, else -H / cooling_time
//
// The sum is over the hot tips within tip_radius of the place, s is the distance of the place from the line of the
// tip's path; H is the duration of contact at a place of a tip's path, r the distance from it; of several places the
// hottest counts. "The amount of heat and its effects on the nearby tissue is proportional to the duration of the
// application"; "the region affected by the heat is expanded radially". The paper gives no numbers.
//
// model "bioheat" (H. H. Pennes, J Appl Physiol 1(2), 1948), on the surface; u is the rise above 37 degrees:
//
//   du/dt = diffusivity * Laplacian(u) - perfusion * u + heat_rate * power * exp(-(r / tip_radius)^2)
//
// In both models maximum_temperature bounds what is read, not the rise itself.
//
// Why these defaults:
// - heat_rate 220 degrees per second: at full power a hook divides fat after about 0.7 s, as in the videos.
// - tip_radius 1.5 mm: half the width of the heel of a 5 mm hook, the part that lies on the tissue.
// - coagulation 60: proteins denature and vessels shrink shut. Char 150: water is gone and the surface blackens. Cut
//   180: tissue parts. Maximum 400: what a monopolar hook reaches; keeps long contacts from running away.
// - heat_spread 0.5 mm in the first second, cooling_time 4.4 s: with these values both models burn equally. The
//   bio-heat equation is the reference, because its constants are measured. Under a resting Gaussian source it spreads
//   so fast (the square of its radius grows by 4 diffusivity t, and later heat has spread less) and takes heat from the
//   middle as if it cooled. The radius that is charred (150) and cooked (60), mm, and the start of the cut, for burns
//   at full power in one place:
//
//     s of burn           1             2             3             4             5           cut at
//     bioheat         1.17, 2.31    1.76, 2.74    2.07, 3.02    2.29, 3.25    2.47, 3.45      0.71 s
//     radial          1.18, 2.32    1.77, 2.74    2.08, 3.02    2.30, 3.24    2.48, 3.43      0.70 s
//
//   Greater values of heat_spread draw the wide pale rims of long burns with a coagulating current, whose sparks reach
//   beyond the tip.
// - diffusivity 0.13 mm2/s: conductivity over density and specific heat of soft tissue, 0.5 W/m/K / (1060 kg/m3 *
//   3600 J/kg/K); F. A. Duck, Physical Properties of Tissue, 1990, lists 0.11 to 0.15.
// - perfusion 0.02 per second: of the order of a well perfused liver (about 1 ml blood per ml of tissue and minute); it
//   also includes heat that goes into the depth of the tissue, which the surface does not model.
// - clip_length 9 mm, clip_reach 3 mm: a medium-large titanium clip, and the tissue that it gathers between its jaws.
#include "lapfx/preset.h"
#include "preset/tables.h"

namespace lapfx::preset {

namespace {

using C = CauteryParameters;

constexpr Range temperature{37, 600, 1, "°C"};

constexpr std::string_view models[] = {"radial", "bioheat"};

constexpr Parameter rows[] = {
    choice<&C::model>(
        "model", "Heat model", models,
        "radial: the paper's heat, a simple formula. bioheat: Pennes' bio-heat equation on the surface of the tissue, "
        "which the paper names as closer to physics."),
    number<&C::heat_rate>("heat_rate", "Heat rate", {0, 2000, 5, "°C/s"},
                          "How fast tissue heats under a tool at full power. In the paper: heat is proportional to how "
                          "long cautery lasts."),
    again(redo::tip_places, number<&C::tip_radius>("tip_radius", "Tip radius", {0.3, 10, 0.1, "mm"},
                                                   "How far around its tip the tool touches the tissue.")),
    number<&C::cut_temperature>(
        "cut_temperature", "Cut temperature", temperature,
        "Above it the tissue divides and may bleed. In the paper: the predetermined temperature threshold."),
    number<&C::coagulation_temperature>(
        "coagulation_temperature", "Coagulation temperature", temperature,
        "Above it wounds close. It must be below the cut temperature and the char temperature."),
    number<&C::char_temperature>("char_temperature", "Char temperature", temperature,
                                 "Above it the surface of the tissue turns black."),
    number<&C::heat_spread>("heat_spread", "Heat spread", {0, 20, 0.1, "mm/sqrt(s)"},
                            "How far heat has spread after one second; it grows with the square root of time. Used by "
                            "the model radial only, which burns like bioheat with 0.5. In the paper: the radial "
                            "expansion."),
    number<&C::cooling_time>(
        "cooling_time", "Cooling time", {0.1, 60, 0.1, "s", Scale::logarithmic},
        "How long tissue takes to cool to 37 % of its rise, also under the tool. Used by the model radial only, which "
        "burns like bioheat with 4.4 s."),
    number<&C::maximum_temperature>("maximum_temperature", "Maximum temperature", temperature,
                                    "What is read of the temperature under the tool never exceeds it."),
    number<&C::diffusivity>("diffusivity", "Diffusivity", {0, 2, 0.01, "mm²/s"},
                            "How fast heat spreads through the tissue: its conductivity divided by its heat capacity. "
                            "Used by the model bioheat only. In the paper: the bio-heat equation."),
    number<&C::perfusion>(
        "perfusion", "Perfusion", {0, 2, 0.005, "1/s"},
        "How fast blood flow carries heat away. Used by the model bioheat only. In the paper: the bio-heat equation."),
    again(redo::metal_clips, number<&C::clip_length>("clip_length", "Clip length", {4, 20, 0.5, "mm"},
                                                     "Length of the metal clips that a clip applier sets.")),
    again(redo::metal_clips,
          number<&C::clip_reach>(
              "clip_reach", "Clip reach", {0.5, 10, 0.1, "mm"},
              "How far from its middle line a clip holds the tissue shut: wounds there stop at once, and what "
              "is cut there later does not bleed.")),
};

constexpr Rule rules[] = {
    {"coagulation_temperature",
     [](const void* owner) {
         const C& c = *static_cast<const C*>(owner);
         return below(c.coagulation_temperature, "cut_temperature", c.cut_temperature);
     }},
    {"char_temperature",
     [](const void* owner) -> std::string {
         const C& c = *static_cast<const C*>(owner);
         return c.char_temperature > c.coagulation_temperature
                    ? ""
                    : below(c.coagulation_temperature, "char_temperature", c.char_temperature);
     }},
};

}  // namespace

Table cautery_table() {
    return again(redo::amounts | redo::heat,
                 table<&Preset::cautery>("cautery", "Cautery", "Heat under the tool: what it cuts, closes and chars.",
                                         {rows, {}, rules}));
}

}  // namespace lapfx::preset
