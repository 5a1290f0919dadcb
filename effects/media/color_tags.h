// What a file says about its colours: how light becomes code values (transfer), and which red, green and blue are meant
// (primaries). ITU-T H.273 numbers both.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "media/libav.h"

namespace lapfx::media {

/// How code values 0..1 become light.
enum class Curve {
    power,    ///< a display's: code to the power of TransferRow::exponent
    srgb,     ///< IEC 61966-2-1
    linear,   ///< they are light
    pq,       ///< SMPTE ST 2084, cd/m2
    hlg,      ///< ARIB STD-B67, light of the scene
    unknown,  ///< none that is converted here
};

inline constexpr double display_exponent = 2.4;  ///< ITU-R BT.1886: what video is graded on

struct TransferRow {
    AVColorTransferCharacteristic transfer;
    const char* name;
    Curve curve;
    double exponent;
};

struct PrimariesRow {
    AVColorPrimaries primaries;
    const char* name;
    enum class Gamut { usual, wide, unknown } gamut;  ///< usual: so close to BT.709 that they are taken for it
    glm::dvec2 red, green, blue;                      ///< CIE 1931 x and y; the white is D65
};

/// What is said of a frame; HDR without primaries is BT.2020, as its standards have it. `transfer` is null where
/// nothing is said, `primaries` too.
struct ColorTags {
    const TransferRow* transfer = nullptr;
    const PrimariesRow* primaries = nullptr;

    /// Whether its colours have to be converted to those of an ordinary display, and can be.
    bool converted() const;
};

ColorTags color_tags(const AVFrame& frame);

/// A file's words: empty where it says nothing.
std::string transfer_words(const ColorTags& tags);
std::string primaries_words(const ColorTags& tags);
/// What of a frame's colours is shown as if it were of an ordinary display, although it is not; empty: nothing.
std::string color_warning(const AVFrame& frame);

/// From linear light of wide primaries to that of BT.709.
glm::mat3 to_bt709(const PrimariesRow& primaries);
/// The share of each primary in luminance.
glm::vec3 luminance_of(const PrimariesRow& primaries);

}  // namespace lapfx::media
