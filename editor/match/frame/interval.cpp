#include "match/frame/interval.h"

#include <algorithm>

namespace lapfx::match {

namespace {

// Half of an interval grows with the amount and with what the model leaves unexplained, the upper half of blood's with
// the smoke before the tissue and what cannot be read, too; of a veil, half as strong is the least known. The factors
// were fitted to the pictures of `lapfx bench measure`, seeds 1 and 2, renders and known smoke and blood over real
// frames, so that about nine of ten intervals hold the true amount. A veil is harder to tell in renders, where they
// hold some 86 to 92 %, than over real frames, where they hold 97 %.
constexpr double veil_least = 0.018, veil_of_middle = 0.34, veil_of_rest = 0.25;
constexpr double blood_least = 0.01, blood_of_blood = 0.28, blood_of_veil = 0.28, blood_of_rest = 0.05,
                 blood_of_hidden = 0.1;
// Where the tissue of the baseline is not in its place, blood behind a veil is missed and red tissue that came near is
// taken for blood. What is left unexplained there (rest) says nothing of that: over known blood on real tissue that
// moves it goes with the error at r = .1, the likeness at -.5.
constexpr double usual_likeness = 0.8, blood_of_unlike = 0.1;
// All of what is told may be false where so little of the baseline is there.
constexpr double doubtful_likeness = 0.5;

// What the flags say about a frame makes its intervals wider.
struct Wider {
    unsigned bit;
    double factor;
};
constexpr Wider wider[] = {
    {told::tinted, 1.3}, {told::bleached, 1.25}, {told::motion, 1.25}, {told::unregistered, 1.1}};

// Half of a gain's interval grows with how far apart the places are that tell it, half of added light's with the light
// and with the light that so much of a gain would be; both grow the less of the baseline's tissue is in its place.
// Of made-up puffs and gains over 270 frames of nine clips (Cholec80, video01_010, 024, 064, 192, 194, 196, 198, 200
// and 203) they hold nine of ten.
constexpr double gain_least = 0.02, gain_of_spread = 0.5, gain_of_unlike = 0.5;
constexpr double light_least = 0.008, light_of_light = 0.25, light_of_doubt = 0.5, light_of_unlike = 0.1;
// How a camera answers to added light, after 13 puffs of one system: 1 / gain = 1 + 0.7 * light / tissue, where both
// are means; how far a gain is off it.
constexpr double dip = 0.7, dip_error = 0.14;

void set(Amount& amount, double below, double above) {
    amount.low = std::max(amount.value - below, 0.0);
    amount.high = std::min(amount.value + above, 1.0);
}

}  // namespace

void set_intervals(FrameAmounts& a) {
    if (!a.measurable()) {  // nothing is known
        set(a.veil, 1.0, 1.0);
        set(a.blood, 1.0, 1.0);
        return;
    }
    double factor = 1.0;
    for (const Wider& row : wider)
        if ((a.flags & row.bit) != 0) factor *= row.factor;
    const double middle = a.veil.value * (1.0 - a.veil.value);
    const double half = factor * (veil_least + veil_of_middle * middle + veil_of_rest * a.rest);
    set(a.veil, half, half);
    const double doubt = std::clamp((usual_likeness - a.likeness) / (usual_likeness - doubtful_likeness), 0.0, 1.0);
    const double known = factor * (blood_least + blood_of_blood * a.blood.value + blood_of_rest * a.rest +
                                   blood_of_unlike * std::max(usual_likeness - a.likeness, 0.0));
    // Smoke and the dark hide blood, and make none.
    const double missed = factor * (blood_of_veil * a.veil.value + blood_of_hidden * a.hidden);
    set(a.blood, std::max(known, doubt * a.blood.value), std::max(known + missed, doubt * a.blood.value));
}

void set_camera_intervals(FrameAmounts& a, const AddedLight& found) {
    if (!a.measurable() || !found.known) {  // nothing is known
        a.light = {0.0, 0.0, 1.0};
        a.gain = {1.0, least_gain, most_gain};
        return;
    }
    double factor = 1.0;
    for (const Wider& row : wider)
        if ((a.flags & row.bit) != 0) factor *= row.factor;
    const double unlike = std::max(usual_likeness - a.likeness, 0.0);
    const double doubt = factor * (gain_least * found.gain + gain_of_spread * found.spread + gain_of_unlike * unlike);
    a.gain.value = found.gain;
    a.gain.low = std::max(found.of_bright_smoke - doubt, least_gain);
    a.gain.high = std::min(found.of_dim_smoke + doubt, most_gain);
    const double answer = 1.0 / (1.0 + dip * found.light / std::max(found.tissue, 1e-3));
    a.gain.high = std::max(a.gain.high, std::min(answer + dip_error, 1.0));
    const double half = factor * (light_least + light_of_light * found.light + light_of_unlike * unlike) +
                        light_of_doubt * doubt * found.tissue;
    a.light.value = std::min(found.light, 1.0);
    set(a.light, half, half);
}

void set_plume_interval(Amount& plume) {
    // The sample scene with plumes of 0 to 2 times the density of two presets: 0.55 to 1.05 of the true one is told.
    constexpr double least = 0.004, too_much = 0.3, too_little = 0.8;
    set(plume, too_much * plume.value + least, too_little * plume.value + least);
}

void set_painted_interval(Amount& blood) {
    constexpr double factor = 2.0, least = 0.005;
    set(blood, blood.value * (1.0 - 1.0 / factor) + least, blood.value * (factor - 1.0) + least);
}

}  // namespace lapfx::match
