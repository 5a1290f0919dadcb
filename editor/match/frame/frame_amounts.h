// What is told about one frame: its amounts of blood and veil, the light that smoke adds and the camera's gain with
// their intervals, and flags.
//
//     if (match::measurable(frame, match::Curve::blood)) add(frame.time, frame.blood.value);
//
// Pure, any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace lapfx::match {

/// A measured share, 0..1 (a gain: least_gain..most_gain), and its interval: it holds the true one in about nine of ten
/// pictures whose amounts are known, renders and known smoke and blood over real frames, to which it was fitted
/// (interval.cpp). How often it does for smoke and blood of real videos, which nobody knows, is not known.
struct Amount {
    double value = 0.0, low = 0.0, high = 0.0;
};

/// A camera's gain is told between these.
inline constexpr double least_gain = 0.25, most_gain = 4.0;

/// What is told about a frame besides its amounts: bits of FrameAmounts::flags.
namespace told {
enum : unsigned {
    cut = 1U << 0,             ///< another view than in the frame before, which showed one
    motion = 1U << 1,          ///< the camera moved strongly since the frame before
    not_measurable = 1U << 2,  ///< the tissue of the baseline is not in view: amounts mean nothing
    dark = 1U << 3,            ///< the picture is black: amounts mean nothing
    missing = 1U << 4,         ///< the file could not give this frame: it has no amounts
    bleached = 1U << 5,        ///< large parts are at full white: nothing can be read there
    tinted = 1U << 6,          ///< the white balance differs from the baseline's
    dense = 1U << 7,           ///< the veil is denser than dense_veil: blood behind it means nothing
    bag = 1U << 8,             ///< no tissue, but something plain fills the view: amounts mean nothing
    trocar = 1U << 9,          ///< the inside of a trocar is around what is seen: amounts mean nothing
    no_baseline = 1U << 10,    ///< no clear frame shows this shot's tissue: there is nothing to measure against
    unregistered = 1U << 11,   ///< tissue, but hardly anything of the baseline is found again: blood means nothing
    /// Any of those without which both amounts are found.
    unmeasured = not_measurable | dark | missing | bag | trocar | no_baseline,
    bloodless = unmeasured | dense | unregistered,  ///< any of those without which blood is found
};
}

enum class InView : std::uint8_t;  // match/picture/traps.h
/// The bit of told:: that says what else than tissue fills the view; 0 of tissue.
unsigned flag_of(InView shown);

/// Mean veil beyond which blood is hidden: of a veil of one half nine tenths of the blood were missed.
inline constexpr double dense_veil = 0.4;

/// One row for each bit, in their order.
struct ToldRow {
    unsigned bit;
    std::string_view key;   ///< in the flags of CSV and JSON: "not_measurable"
    std::string_view help;  ///< for people, as the end of "12 frames: ..."
};
inline constexpr ToldRow told_rows[] = {
    {told::cut, "cut", "another view than in the frame before"},
    {told::motion, "motion", "the camera moves strongly; the baseline is laid over the new place"},
    {told::not_measurable, "not_measurable",
     "not measurable, because the tissue of the baseline is not in view: another view, something before it, or liquid "
     "on the lens"},
    {told::dark, "dark", "not measurable, because the picture is black"},
    {told::missing, "missing", "not measurable, because the file cannot give them"},
    {told::bleached, "bleached", "a quarter or more of the view is at full white, where nothing can be read"},
    {told::tinted, "tinted",
     "the white balance differs from that of the baseline, which may be taken for smoke or blood"},
    {told::dense, "dense", "blood is not measurable, because the veil before it is denser than 40 %"},
    {told::bag, "bag",
     "not measurable, because no tissue is in view: a bag, a cloth, a title card or another plain thing fills it"},
    {told::trocar, "trocar", "not measurable, because the view is that out of a trocar"},
    {told::no_baseline, "no_baseline", "not measurable, because no clear frame of the same view is known"},
    {told::unregistered, "unregistered",
     "blood is not measurable, because hardly anything of the baseline's tissue is found again: the camera or the "
     "tissue moved far"},
};

struct FrameAmounts {
    double time = 0.0;  ///< s of the video
    Amount blood = {};  ///< area fraction of the valid view
    Amount veil = {};   ///< mean over the valid view of 1 - transmission of the smoke
    /// How much of the veil stands out over an even one, as a plume does: the mean over the valid view of what is above
    /// its median. Missing where the baseline does not lie well, which makes a map uneven.
    std::optional<Amount> plume = {};
    Amount light = {};  ///< mean over the valid view of the light that smoke adds, as a share of white: luminance in
                        ///< linear light before the camera's gain
    /// Factor of the camera against the baseline; 1: as the baseline. A veil that lies evenly over the view and throws
    /// no light back cannot be told from it: unless bright smoke explains why the camera darkened, the interval of a
    /// gain below 1 reaches up to 1.
    Amount gain = {1.0, 1.0, 1.0};
    double valid = 0.0;     ///< share of the picture that is the valid view, 0..1
    double likeness = 0.0;  ///< how much of the baseline's texture is there, also where it moved; 0 none .. 1 all
    double rest = 0.0;      ///< share of the frame's light that neither tissue, smoke nor blood explain
    double hidden = 0.0;    ///< share of the valid view where smoke or the dark hides the colour
    unsigned flags = 0;     ///< bits of told::
    /// Without a baseline: how hazy the frame looks by itself, 0 the least and 1 the most of its shot, and how far that
    /// differs from frame to frame. Only order and course mean something: pale tissue looks as thick smoke does.
    std::optional<Amount> course = {};
    bool measurable() const { return (flags & told::unmeasured) == 0; }
    bool blood_measurable() const { return (flags & told::bloodless) == 0; }
};

/// The curves that frames make over time.
enum class Curve { blood, veil, course };

/// Whether a frame has that amount: blood behind dense smoke has none, and only frames without a baseline have a
/// course.
bool measurable(const FrameAmounts& frame, Curve curve);
/// Of a frame that has it.
const Amount& amount_of(const FrameAmounts& frame, Curve curve);

}  // namespace lapfx::match
