// The parameters of smoke (paper: "Smoke generation", figures 1 and 2).
//
// Keying makes transparent smoke out of a clip that was filmed before a plain background, per pixel, in 8-bit code values
// (shaders/keying.glsl, smoke/keying_cpu.h):
//
//   l     = ramp(Y, luma_low, luma_high); polarity dark: of 255 - Y
//   c     = ramp(distance of (Cb, Cr) from key_color's, chroma_low, chroma_high); 1 when both bounds are 0
//   alpha = l * c * (1 + noise_strength * noise(position / noise_scale, drifting by noise_drift)), within 0..1
//
// The ramps are linear: mixing smoke of one colour over a flat background is. A plume is a quad at the tool tip; when the
// tool stops it drifts by `rise` and grows by 1 + growth * age. The haze fills the view with optical thickness E:
//
//   emission = power * (1 + fat_gain * fat density under the tool), for the plume too
//   dE/dt = accumulation * emission - (ventilation + suction while one runs) * E
//   transmission per channel = (1 - alpha) ^ extinction;  picture = picture * transmission + color * (1 - transmission)
//
// Why these defaults:
// - luma 16 to 200: black of a video signal to the brightest smoke of clips lit from the side; chroma off, since clips on
//   black carry no colour; spill 0 for the same reason.
// - noise: lobes of a quarter of the clip, a third of alpha, drifting 0.15 clip heights a second: a looping clip never
//   looks the same, but no pattern of its own is seen.
// - plume 110 mm, density 0.35, a cool grey: cautery smoke in real frames (DeSmoke-LAP, Cholec80 video01_091) is a wide veil of
//   a third to a half of the view that shows the tissue through it; small and dense it looks like cotton. Lean 0.7: smoke that
//   rises along tissue is turned away from it, into the room where the camera is. Softness 6 mm: as thick as a wisp. Fades 0.3
//   and 1.2 s: smoke starts at once and lingers. Rise 6 mm/s: warm smoke under gas at rest.
// - fat gain 0.5: fat smokes visibly more than muscle; nobody has measured how much.
// - haze 0.12 per second against 0.05 per second: ten seconds of cautery veil the view, and it clears in half a minute.
// - colours and extinction: haze over a dark cavity measures 96, 83, 99 (8-bit sRGB) against 43, 1, 3 without: it adds
//   about 55, 82, 96, bluish grey before a red cavity. The smoke itself is lit by lamp and tissue, a warm grey of 96, 83, 99
//   where nothing shows through. Red passes more than blue, so extinction rises from red to blue.
#include "preset/tables.h"
#include "preset/text.h"

namespace lapfx::preset {

namespace {

constexpr Range luma{0, 255, 1, "code values"};
constexpr Range chroma{0, 180, 1, "code values"};

using K = KeyingParameters;
constexpr Parameter keying_rows[] = {
    number<&K::luma_low>("luma_low", "Luma low", luma,
                         "Luma up to which a pixel is background: the lower of the paper's luminance thresholds."),
    number<&K::luma_high>("luma_high", "Luma high", luma,
                          "Luma from which a pixel is fully smoke: the upper of the paper's luminance thresholds."),
    color<&K::key_color>(
        "key_color", "Key colour",
        "Colour of the background that the paper's filter removes: chroma distance is measured from it."),
    number<&K::chroma_low>(
        "chroma_low", "Chroma low", chroma,
        "Distance from the key colour in Cb and Cr up to which a pixel is still background. With both "
        "chroma bounds 0, chroma is not used. The lower of the paper's chroma thresholds."),
    number<&K::chroma_high>("chroma_high", "Chroma high", chroma,
                            "Distance from the key colour in Cb and Cr from which a pixel is fully smoke, whatever its "
                            "luma: the upper of the paper's chroma thresholds."),
    number<&K::spill>("spill", "Spill", {0, 1, 0.01}, "How much of the key colour is taken out of the smoke."),
    number<&K::choke>(
        "choke", "Choke", {0, 16, 0.5, "pixels"},
        "How far the smoke is drawn in from its edges, in pixels of the clip: takes off a rim of background."),
    number<&K::feather>("feather", "Feather", {0, 16, 0.5, "pixels"},
                        "How far the smoke's opacity is smoothed, in pixels of the clip: takes off noise and blocks."),
    number<&K::noise_scale>("noise_scale", "Noise scale", {0.01, 2, 0.01, "clip heights", Scale::logarithmic},
                            "Width of one lobe of the paper's Perlin noise on the smoke's opacity (alpha)."),
    number<&K::noise_strength>("noise_strength", "Noise strength", {0, 1, 0.01},
                               "How much the paper's Perlin noise changes the smoke's opacity (alpha), so that a "
                               "looping clip never looks the same."),
    number<&K::noise_drift>("noise_drift", "Noise drift", {0, 2, 0.01, "clip heights/s"}, "How fast the noise moves."),
};

constexpr Rule keying_rules[] = {
    {"luma_low",
     [](const void* owner) {
         const K& k = *static_cast<const K*>(owner);
         return below(k.luma_low, "luma_high", k.luma_high);
     }},
    {"chroma_low",
     [](const void* owner) {
         const K& k = *static_cast<const K*>(owner);
         return not_above(k.chroma_low, "chroma_high", k.chroma_high);
     }},
};

constexpr std::string_view roles[] = {"plume", "haze"};
constexpr std::string_view polarities[] = {"light", "dark"};
constexpr std::string_view starts[] = {"seeded", "beginning"};
constexpr std::string_view mirrors[] = {"seeded", "off", "on"};
constexpr Range clip_time{0, 3600, 0.1, "s"};

using S = SmokeClip;
constexpr Parameter clip_rows[] = {
    required(contained(path<&S::file>("file", "File",
                                      "The smoke video: a file in the folder of the preset, or a bare name that the "
                                      "simulator looks up."))),
    choice<&S::role>("role", "Role", roles,
                     "plume: the paper's source smoke at the tool tip. haze: its environmental smoke over "
                     "the whole view."),
    choice<&S::polarity>("polarity", "Polarity", polarities,
                         "light: light smoke before a dark background. dark: dark smoke before a light background."),
    number<&S::weight>("weight", "Weight", {0, 4, 0.05}, "Share of this clip where several are blended."),
    number<&S::speed>("speed", "Speed", {0.1, 4, 0.05, "x", Scale::logarithmic}, "Speed of playing; 1 is as filmed."),
    number<&S::source_x>(
        "source_x", "Source x", {0, 1, 0.01, "clip widths"},
        "Where in the frame the smoke starts, from the left: this point is placed at the instrument's tip."),
    number<&S::source_y>("source_y", "Source y", {0, 1, 0.01, "clip heights"},
                         "Where in the frame the smoke starts, from the top."),
    number<&S::in>("in", "In", clip_time, "Where in the clip playing starts."),
    number<&S::out>("out", "Out", clip_time, "Where in the clip playing ends and starts over; 0 is the clip's end."),
    number<&S::crossfade>("crossfade", "Cross-fade", {0, 30, 0.1, "s"},
                          "How long the end of the loop is faded into its beginning, at most half of the loop."),
    choice<&S::start>(
        "start", "Start", starts,
        "seeded: starts anywhere in the loop, so that clips named twice never look alike. beginning: at the "
        "in point."),
    choice<&S::mirror>("mirror", "Mirror", mirrors, "Left and right exchanged: by chance, never, or always."),
    number<&S::rotation>(
        "rotation", "Rotation", {0, 180, 1, "degrees"},
        "The clip is turned by a seeded angle, at most this much either way, about where its smoke starts."),
    number<&S::edge_fade>(
        "edge_fade", "Edge fade", {0, 0.5, 0.01, "of the smaller side"},
        "How far smoke fades to nothing at the edges of the frame, or of what is left of it by the crop, and around "
        "masks, so that no straight line shows. It is whole where the smoke starts. Haze fills the view up to its "
        "edges: it "
        "fades around masks alone."),
};

constexpr Rule clip_rules[] = {
    {"in",
     [](const void* owner) {
         const S& c = *static_cast<const S*>(owner);
         return c.out > 0.0 ? below(c.in, "out", c.out) : std::string();
     }},
};

constexpr Range cut{0, 0.9, 0.005, "of the frame"};

using C = ClipCrop;
constexpr Parameter crop_rows[] = {
    number<&C::left>("left", "Left", cut, "What is left out at the left, of the frame's width."),
    number<&C::top>("top", "Top", cut, "What is left out at the top, of the frame's height."),
    number<&C::right>("right", "Right", cut, "What is left out at the right, of the frame's width."),
    number<&C::bottom>("bottom", "Bottom", cut, "What is left out at the bottom, of the frame's height."),
};

std::string all_cut(double one, double other) {
    constexpr double most = 0.95;
    if (one + other <= most) return {};
    return number_text(one) + " and " + number_text(other) +
           " at the other side leave less than a twentieth of the frame";
}

constexpr Rule crop_rules[] = {
    {"left",
     [](const void* owner) {
         const C& c = *static_cast<const C*>(owner);
         return all_cut(c.left, c.right);
     }},
    {"top",
     [](const void* owner) {
         const C& c = *static_cast<const C*>(owner);
         return all_cut(c.top, c.bottom);
     }},
};

constexpr Range place{0, 1, 0.005, "of the frame"};

using M = ClipMask;
constexpr Parameter mask_rows[] = {
    number<&M::x>("x", "X", place, "The mask's left edge, of the frame's width from the left."),
    number<&M::y>("y", "Y", place, "The mask's upper edge, of the frame's height from the top."),
    number<&M::width>("width", "Width", place, "The mask's width, of the frame's."),
    number<&M::height>("height", "Height", place, "The mask's height, of the frame's."),
};

constexpr Table clip_tables[] = {
    table<&S::crop>("crop", "Crop",
                    "What is left out of the frame at its sides, such as black bars: it keys to nothing. A plume keeps "
                    "its place and size, haze shows what is left as large as the view.",
                    {crop_rows, {}, crop_rules}),
    list<&S::masks, most_masks>(
        "masks", "Masks", "Garbage mask: rectangles of the frame that key to nothing, such as a logo.", {mask_rows}),
    optional<&S::own_keying>(table<&S::keying>("keying", "Own keying",
                                               "Keying of this clip alone; without it the preset's keying holds.",
                                               {keying_rows, {}, keying_rules})),
};

constexpr Range extinction{0, 2, 0.01};
constexpr Range fade{0, 10, 0.1, "s"};

using P = PlumeParameters;
constexpr Parameter plume_rows[] = {
    number<&P::size>("size", "Size", {1, 300, 1, "mm", Scale::logarithmic},
                     "Height of the plume when it leaves the tip."),
    number<&P::density>("density", "Density", {0, 4, 0.05}, "How thick the plume is at full emission; 1 is as keyed."),
    number<&P::rise>("rise", "Rise", {0, 100, 0.5, "mm/s"}, "How fast the plume drifts up from the tip."),
    number<&P::growth>("growth", "Growth", {0, 3, 0.01, "1/s"},
                       "By which part of its size the plume grows in a second."),
    number<&P::fade_in>("fade_in", "Fade in", fade, "How long the plume takes to full density once cautery starts."),
    number<&P::fade_out>("fade_out", "Fade out", fade, "How long the plume stays once cautery ends."),
    number<&P::lean>(
        "lean", "Lean", {0, 1.5, 0.05},
        "How far the plume leans towards the camera, mm for each mm that it rises: smoke along a wall is turned "
        "away from it."),
    number<&P::softness>("softness", "Softness", {0.1, 50, 0.1, "mm", Scale::logarithmic},
                         "Over which distance the plume fades where it meets tissue or instruments."),
    number<&P::fat_gain>("fat_gain", "Fat gain", {0, 4, 0.05},
                         "How much more smoke burning fat gives, plume and haze: 1 is twice as much where all is fat. "
                         "The paper's future work: smoke by the density of the fat layer."),
    color<&P::color>("color", "Colour", "Colour of thick plume under the endoscope's lamp."),
    vector<&P::extinction>("extinction", "Extinction", extinction,
                           "How strongly red, green and blue are held back; real smoke passes more red than blue."),
};

using H = HazeParameters;
constexpr Parameter haze_rows[] = {
    number<&H::accumulation>(
        "accumulation", "Accumulation", {0, 5, 0.01, "1/s"},
        "How fast cautery at full emission fills the view with the paper's environmental smoke. Where no clip "
        "has the role haze it is an even veil; a preset without clips has no smoke at all."),
    number<&H::ventilation>(
        "ventilation", "Ventilation", {0, 5, 0.01, "1/s"},
        "Which part of the haze leaves per second: the paper's ventilation capacity. 0 keeps it for ever."),
    number<&H::suction>("suction", "Suction", {0, 10, 0.05, "1/s"},
                        "Which part of the haze a suction tool takes per second while it runs, besides ventilation."),
    number<&H::unevenness>("unevenness", "Unevenness", {0, 1, 0.01},
                           "0 is an even veil, 1 takes all its shape from the haze clips and noise."),
    color<&H::color>("color", "Colour", "Colour of dense haze under the endoscope's lamp."),
    vector<&H::extinction>("extinction", "Extinction", extinction,
                           "How strongly red, green and blue are held back; real smoke passes more red than blue."),
};

using F = ParticleParameters;
constexpr Parameter particle_rows[] = {
    number<&F::rate>("rate", "Rate", {0, 60, 1, "1/s"},
                     "Specks thrown off per second where all of the tissue is fat and power is full: the paper's fat "
                     "particles. 0 is none."),
    number<&F::size>("size", "Size", {0.05, 3, 0.05, "mm", Scale::logarithmic}, "Diameter of the largest specks."),
    number<&F::speed>("speed", "Speed", {0, 200, 1, "mm/s"}, "How fast specks leave the tip; air slows them down."),
    number<&F::lifetime>("lifetime", "Lifetime", {0.05, 5, 0.05, "s", Scale::logarithmic}, "How long a speck is seen."),
    color<&F::color>("color", "Colour", "Colour of a speck under the endoscope's lamp."),
};

constexpr std::size_t most_clips = 64;  // four times the fifteen streams of the paper's benchmark, and a few

}  // namespace

Table smoke_table() {
    using A = SmokeParameters;
    static constexpr Table tables[] = {
        list<&A::clips, most_clips>("clips", "Clips", "Smoke videos and how each is used.",
                                    {clip_rows, clip_tables, clip_rules}),
        table<&A::keying>("keying", "Keying", "How smoke is told from the background of its clip.",
                          {keying_rows, {}, keying_rules}),
        table<&A::plume>("plume", "Plume", "The paper's source smoke, at the tool tip.", {plume_rows}),
        table<&A::haze>("haze", "Haze", "The paper's environmental smoke, over the whole view.", {haze_rows}),
        table<&A::particles>("particles", "Fat particles", "Specks that fly off while fat burns.", {particle_rows}),
    };
    return table<&Preset::smoke>("smoke", "Smoke", "Smoke at the tool tip and over the view.", {{}, tables});
}

}  // namespace lapfx::preset
