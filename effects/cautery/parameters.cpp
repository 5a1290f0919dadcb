// The parameters of heat under the tool (paper: "Bleeding and Smoke in a Virtual LAGB Simulator").
//
//   T(r, t) = 37 + min(heat_rate * power * t, maximum_temperature - 37) * exp(-(r / R)^2)        degrees Celsius
//   R(t)    = 1.5 + heat_spread * sqrt(t): radius of the heated region, t the duration of contact at a place   mm
//   T > cut_temperature: the tissue is divided and bleeds
//   coagulation_temperature < T: wounds close        T > char_temperature: the surface chars
//
// "The amount of heat and its effects on the nearby tissue is proportional to the duration of the application"; "the region
// affected by the heat is expanded radially". The paper gives no numbers.
//
// Why these defaults:
// - heat_rate 220 degrees per second: at full power a hook divides fat after about 0.7 s, as in the videos.
// - coagulation 60: proteins denature and vessels shrink shut. Char 150: water is gone and the surface blackens. Cut 180:
//   tissue parts. Maximum 400: what a monopolar hook reaches; keeps long contacts from running away.
// - heat_spread 2.2 mm in the first second: heat diffuses, so the radius grows with the square root of time; pale cooked
//   rims in the videos are 2 to 4 mm wide.
#include "preset/tables.h"

namespace lapfx::preset {

namespace {

using C = CauteryParameters;

constexpr Range temperature{37, 600, 1, "°C"};

constexpr Parameter rows[] = {
    number<&C::heat_rate>(
        "heat_rate", "Heat rate", {0, 2000, 5, "°C/s"},
        "How fast tissue heats under a tool at full power: the paper's heat, proportional to the duration "
        "of the cautery."),
    number<&C::cut_temperature>("cut_temperature", "Cut temperature", temperature,
                                "Above it the tissue is divided and may bleed: the paper's pre-determined temperature "
                                "threshold."),
    number<&C::coagulation_temperature>("coagulation_temperature", "Coagulation temperature", temperature,
                                        "Above it wounds close. It has to lie below the cut and the char temperature."),
    number<&C::char_temperature>("char_temperature", "Char temperature", temperature,
                                 "Above it the surface of the tissue blackens."),
    number<&C::heat_spread>("heat_spread", "Heat spread", {0, 20, 0.1, "mm/sqrt(s)"},
                            "Radius of the heated region after one second; it grows with the square root of time. The "
                            "paper's radial expansion."),
    number<&C::maximum_temperature>("maximum_temperature", "Maximum temperature", temperature,
                                    "The heat under the tool never exceeds it."),
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
    return table<&Preset::cautery>("cautery", "Cautery", "Heat under the tool: what it cuts, closes and chars.",
                                   {rows, {}, rules});
}

}  // namespace lapfx::preset
