// The parameters of smoke (paper: "Smoke generation", figures 1 and 2).
//
// Keying makes transparent smoke out of a clip that was filmed before a plain background, per pixel, in 8-bit code
// values (shaders/keying.glsl, smoke/keying_pixel.h):
//
//   l     = ramp(Y, luma_low, luma_high); polarity dark: of 255 - Y
//   c     = ramp(distance of (Cb, Cr) from key_color's, chroma_low, chroma_high); 1 when both bounds are 0
//   alpha = l * c * (1 + noise_strength * noise(position / noise_scale, drifting by noise_drift)), within 0..1
//
// The ramps are linear, like the mixture of smoke of one colour with a flat background. A plume is a quad at the tool
// tip. Its smoke is age = 2 s * (1 - exp(-t / 2 s)) old at the top after t of burning: by then it has risen by rise *
// age and is 1 + growth * age as wide, and as much thinner. When the tool stops it drifts by `rise` and grows by 1 +
// growth * time. The haze fills the view with optical thickness E:
//
//   emission = power * (1 + fat_gain * fat density under the tool), for the plume too
//   dE/dt = accumulation * emission - (ventilation + suction while one runs) * E
//   transmission per channel = (1 - alpha) ^ extinction;  picture = picture * transmission + color * (1 - transmission)
//
// Why these defaults:
// - luma 16 to 200: black of a video signal to the brightest smoke of clips lit from the side; chroma off, since clips
//   on black carry no colour; spill 0 for the same reason.
// - noise: lobes of a quarter of the clip, a third of alpha, drifting 0.15 clip heights a second: a looping clip never
//   looks the same, but the noise does not show as a pattern.
// - plume 110 mm, density 0.35, a cool grey: cautery smoke in real frames (DeSmoke-LAP, Cholec80 video01_091) is a wide
//   veil of a third to a half of the view that shows the tissue through it; small and dense it looks like cotton. Lean
//   0.7: smoke that rises along tissue is turned away from it, into the room where the camera is. Softness 6 mm: as
//   thick as a wisp. Fades 0.3 and 1.2 s: smoke starts at once and lingers. Rise 6 mm/s: warm smoke under gas at rest.
// - fat gain 0.5: fat smokes visibly more than muscle; nobody has measured how much.
// - haze 0.12 per second against 0.05 per second: ten seconds of cautery veil the view, and it clears in half a minute.
// - colours and extinction: haze over a dark cavity measures 96, 83, 99 (8-bit sRGB) against 43, 1, 3 without: it adds
//   about 55, 82, 96, bluish grey before a red cavity. The smoke itself is lit by lamp and tissue, a warm grey of 96,
//   83, 99 where nothing shows through. Red passes more than blue, so extinction rises from red to blue.
#include "lapfx/authoring/clip_roles.h"
#include "lapfx/preset.h"
#include "preset/tables.h"
#include "preset/text.h"

namespace lapfx::preset {

namespace {

constexpr Range luma{0, 255, 1, "levels"};
constexpr Range chroma{0, 180, 1, "levels"};

using K = KeyingParameters;
constexpr Parameter keying_rows[] = {
    again(redo::keyed_frame,
          number<&K::luma_low>(
              "luma_low", "Luma low", luma,
              "Brightness (luma: 0 black, 255 white) up to which a pixel is background. In the paper: the "
              "lower luminance threshold.")),
    again(redo::keyed_frame,
          number<&K::luma_high>(
              "luma_high", "Luma high", luma,
              "Brightness (luma: 0 black, 255 white) from which a pixel is fully smoke. In the paper: the "
              "upper luminance threshold.")),
    again(redo::keyed_frame,
          color<&K::key_color>(
              "key_color", "Key colour",
              "Colour of the background that keying removes. The two chroma values measure how far a colour "
              "is from it. In the paper: the colour that its filter removes.")),
    again(
        redo::keyed_frame,
        number<&K::chroma_low>("chroma_low", "Chroma low", chroma,
                               "Distance from the key colour, without brightness, up to which a pixel is still "
                               "background. With both chroma "
                               "values 0 only brightness decides. In the paper: the lower chroma threshold (Cb, Cr).")),
    again(redo::keyed_frame,
          number<&K::chroma_high>(
              "chroma_high", "Chroma high", chroma,
              "Distance from the key colour, without brightness, from which a pixel is fully smoke. In "
              "the paper: the upper chroma threshold (Cb, Cr).")),
    again(redo::keyed_frame,
          number<&K::spill>("spill", "Spill", {0, 1, 0.01}, "How much of the key colour is removed from the smoke.")),
    again(redo::keyed_frame,
          number<&K::choke>(
              "choke", "Choke", {0, 16, 0.5, "pixels"},
              "How far the edges of the smoke are drawn in, in pixels of the clip. Removes a rim of background.")),
    again(redo::keyed_frame,
          number<&K::feather>(
              "feather", "Feather", {0, 16, 0.5, "pixels"},
              "How far the opacity of the smoke is smoothed, in pixels of the clip. Removes noise and blocks.")),
    number<&K::noise_scale>(
        "noise_scale", "Noise scale", {0.01, 2, 0.01, "clip heights", Scale::logarithmic},
        "Width of one lobe of the noise that varies the opacity of the smoke. In the paper: Perlin noise on alpha."),
    number<&K::noise_strength>("noise_strength", "Noise strength", {0, 1, 0.01},
                               "How much noise varies the opacity of the smoke, so that a looping clip never looks the "
                               "same. In the paper: Perlin noise on alpha."),
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

constexpr std::string_view polarities[] = {"light", "dark"};
constexpr std::string_view starts[] = {"seeded", "beginning"};
constexpr std::string_view mirrors[] = {"seeded", "off", "on"};
constexpr Range clip_time{0, 3600, 0.1, "s"};

using S = SmokeClip;
constexpr Parameter clip_rows[] = {
    again(redo::clips,
          required(contained(path<&S::file>(
              "file", "File",
              "The smoke video: a file in the folder of the preset, or a bare name that the simulator looks up.")))),
    again(redo::keyed_frame, choice<&S::role>("role", "Role", keys_of<clip_roles>, text_of<[](const auto& put) {
                                                  put_rows(put, clip_roles);
                                                  put(" In the paper: source smoke and environmental smoke.");
                                              }>)),
    again(redo::keyed_frame,
          choice<&S::polarity>("polarity", "Polarity", polarities,
                               "light: light smoke on a dark background. dark: dark smoke on a light background.")),
    number<&S::weight>(
        "weight", "Weight", {0, 4, 0.05}, text_of<[](const auto& put) {
            put("Share of this clip in the smoke of its role, ");
            put_keys(put, clip_roles);
            put(": its weight, divided by the weights of all clips of that role. A clip that is alone shows all of it, "
                "whatever its weight.");
        }>),
    number<&S::speed>("speed", "Speed", {0.1, 4, 0.05, "x", Scale::logarithmic},
                      "How fast the clip plays; 1 is as filmed."),
    again(redo::keyed_frame,
          number<&S::source_x>(
              "source_x", "Source x", {0, 1, 0.01, "clip widths"},
              "Where in the frame the smoke starts, from the left. This point of the clip is placed at the tool tip.")),
    again(redo::keyed_frame, number<&S::source_y>("source_y", "Source y", {0, 1, 0.01, "clip heights"},
                                                  "Where in the frame the smoke starts, from the top.")),
    again(redo::clips, number<&S::in>("in", "In", clip_time, "Time in the clip at which playing starts.")),
    again(redo::clips, number<&S::out>("out", "Out", clip_time,
                                       "Time in the clip at which playing ends and starts over; 0 is the clip's end.")),
    again(redo::clips,
          number<&S::crossfade>("crossfade", "Cross-fade", {0, 30, 0.1, "s"},
                                "How long the end of the loop fades into its beginning, at most half of the loop.")),
    choice<&S::start>("start", "Start", starts,
                      "seeded: starts at a random place in the loop, so that a clip used twice never looks the same. "
                      "beginning: starts at the in point."),
    choice<&S::mirror>("mirror", "Mirror", mirrors, "Swaps left and right: by chance, never, or always."),
    number<&S::rotation>(
        "rotation", "Rotation", {0, 180, 1, "degrees"},
        "The clip is turned by a random angle, at most this much either way, about the point where its smoke starts."),
    again(redo::keyed_frame, number<&S::edge_fade>("edge_fade", "Edge fade", {0, 0.5, 0.01, "of the smaller side"},
                                                   "How far smoke fades out at the edges of the frame or of its crop, "
                                                   "and around masks, so that no straight line "
                                                   "shows. Smoke stays unfaded where it starts. Haze fills the view up "
                                                   "to its edges: it fades around masks only.")),
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
    number<&C::left>("left", "Left", cut, "Part of the frame's width that is left out at the left."),
    number<&C::top>("top", "Top", cut, "Part of the frame's height that is left out at the top."),
    number<&C::right>("right", "Right", cut, "Part of the frame's width that is left out at the right."),
    number<&C::bottom>("bottom", "Bottom", cut, "Part of the frame's height that is left out at the bottom."),
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
    number<&M::x>("x", "X", place, "The mask's left edge, as a part of the frame's width."),
    number<&M::y>("y", "Y", place, "The mask's upper edge, as a part of the frame's height."),
    number<&M::width>("width", "Width", place, "The mask's width, as a part of the frame's."),
    number<&M::height>("height", "Height", place, "The mask's height, as a part of the frame's."),
};

constexpr Table clip_tables[] = {
    again(redo::keyed_frame,
          table<&S::crop>(
              "crop", "Crop",
              "What is left out at the sides of the frame, such as black bars: there is no smoke there. A plume "
              "keeps its place and size; haze is enlarged to fill the view.",
              {crop_rows, {}, crop_rules})),
    again(redo::keyed_frame,
          list<&S::masks, most_masks>(
              "masks", "Masks", "Rectangles of the frame without smoke, such as a logo (garbage masks).", {mask_rows})),
    optional<&S::own_keying>(table<&S::keying>("keying", "Own keying",
                                               "Keying of this clip alone; without it the preset's keying is used.",
                                               {keying_rows, {}, keying_rules})),
};

constexpr Range extinction{0, 2, 0.01};
constexpr Range fade{0, 10, 0.1, "s"};

using P = PlumeParameters;
constexpr Parameter plume_rows[] = {
    number<&P::size>("size", "Size", {1, 300, 1, "mm", Scale::logarithmic},
                     "Height of the plume before it rises and grows."),
    number<&P::density>("density", "Density", {0, 4, 0.05}, "How thick the plume is at full emission; 1 is as keyed."),
    number<&P::rise>(
        "rise", "Rise", {0, 100, 0.5, "mm/s"},
        "How fast the smoke rises: the plume gets longer while the tool burns, and drifts up from the tip afterwards."),
    number<&P::growth>(
        "growth", "Growth", {0, 3, 0.01, "1/s"},
        "How much the smoke widens per second, as a part of its width: the plume gets wider upwards while the "
        "tool burns, and grows as a whole afterwards."),
    number<&P::fade_in>("fade_in", "Fade in", fade,
                        "How long the plume takes to reach full density once cautery starts."),
    number<&P::fade_out>("fade_out", "Fade out", fade, "How long the plume stays once cautery ends."),
    number<&P::lean>("lean", "Lean", {0, 1.5, 0.05},
                     "How far the plume leans towards the camera, in mm for each mm that it rises, and less "
                     "the closer it comes to the lens: smoke moves away from a wall."),
    number<&P::softness>("softness", "Softness", {0.1, 50, 0.1, "mm", Scale::logarithmic},
                         "The distance over which the plume fades out where it meets tissue or instruments."),
    again(redo::amounts | redo::emission,
          number<&P::fat_gain>(
              "fat_gain", "Fat gain", {0, 4, 0.05},
              "How much more smoke burning fat makes, plume and haze: 1 is twice as much where all is fat. "
              "Smoke that depends on the fat layer is the paper's future work.")),
    color<&P::color>("color", "Colour", "Colour of thick plume in the light of the endoscope's lamp."),
    vector<&P::extinction>(
        "extinction", "Extinction", extinction,
        "How strongly the smoke holds back red, green and blue light; real smoke lets more red than blue through."),
};

using H = HazeParameters;
constexpr Parameter haze_rows[] = {
    again(
        redo::amounts | redo::haze,
        number<&H::accumulation>(
            "accumulation", "Accumulation", {0, 5, 0.01, "1/s"},
            "How fast cautery at full emission fills the view with haze. Without a clip for haze it is an even veil; a "
            "preset without clips makes no smoke at all. In the paper: environmental smoke.")),
    again(redo::amounts | redo::haze,
          number<&H::ventilation>(
              "ventilation", "Ventilation", {0, 5, 0.01, "1/s"},
              "Part of the haze that leaves per second; 0 keeps all of it. In the paper: the ventilation capacity.")),
    again(redo::amounts | redo::haze,
          number<&H::suction>(
              "suction", "Suction", {0, 10, 0.05, "1/s"},
              "Part of the haze that a suction tool removes per second while it runs, in addition to ventilation.")),
    number<&H::unevenness>("unevenness", "Unevenness", {0, 1, 0.01},
                           "0 is an even veil; at 1 its shape comes from the haze clips and noise alone."),
    color<&H::color>("color", "Colour", "Colour of dense haze in the light of the endoscope's lamp."),
    vector<&H::extinction>(
        "extinction", "Extinction", extinction,
        "How strongly the smoke holds back red, green and blue light; real smoke lets more red than blue through."),
};

using F = ParticleParameters;
constexpr Parameter particle_rows[] = {
    number<&F::rate>("rate", "Rate", {0, 60, 1, "1/s"},
                     "Specks thrown off per second at full power where all of the tissue is fat; 0 for none. In the "
                     "paper: fat particles, as future work."),
    number<&F::size>("size", "Size", {0.05, 3, 0.05, "mm", Scale::logarithmic}, "Diameter of the largest specks."),
    number<&F::speed>("speed", "Speed", {0, 200, 1, "mm/s"}, "How fast specks leave the tip; air slows them down."),
    number<&F::lifetime>("lifetime", "Lifetime", {0.05, 5, 0.05, "s", Scale::logarithmic},
                         "How long a speck stays visible."),
    color<&F::color>("color", "Colour", "Colour of a speck in the light of the endoscope's lamp."),
};

constexpr std::size_t most_clips = 64;  // four times the fifteen streams of the paper's benchmark, and four more

}  // namespace

Table smoke_table() {
    using A = SmokeParameters;
    static constexpr Table tables[] = {
        again_for_length(redo::amounts | redo::clips,
                         list<&A::clips, most_clips>("clips", "Clips", "Smoke videos and how each is used.",
                                                     {clip_rows, clip_tables, clip_rules})),
        table<&A::keying>("keying", "Keying", "How smoke is separated from the background of its clip.",
                          {keying_rows, {}, keying_rules}),
        table<&A::plume>("plume", "Plume", "Smoke at the tool tip. In the paper: source smoke.", {plume_rows}),
        table<&A::haze>("haze", "Haze", "Smoke over the whole view. In the paper: environmental smoke.", {haze_rows}),
        table<&A::particles>("particles", "Fat particles", "Specks that fly off while fat burns.", {particle_rows}),
    };
    return again(redo::smoke,
                 table<&Preset::smoke>("smoke", "Smoke", "Smoke at the tool tip and over the view.", {{}, tables}));
}

}  // namespace lapfx::preset
