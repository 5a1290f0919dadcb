#include "media/color_tags.h"

#include <algorithm>
#include <iterator>

namespace lapfx::media {

namespace {

using Gamut = PrimariesRow::Gamut;

constexpr TransferRow transfers[] = {
    {AVCOL_TRC_BT709, "BT.709", Curve::power, display_exponent},
    {AVCOL_TRC_SMPTE170M, "BT.601", Curve::power, display_exponent},
    {AVCOL_TRC_SMPTE240M, "SMPTE 240M", Curve::power, display_exponent},
    {AVCOL_TRC_IEC61966_2_4, "xvYCC", Curve::power, display_exponent},
    {AVCOL_TRC_BT1361_ECG, "BT.1361", Curve::power, display_exponent},
    {AVCOL_TRC_BT2020_10, "BT.2020", Curve::power, display_exponent},
    {AVCOL_TRC_BT2020_12, "BT.2020, 12 bit", Curve::power, display_exponent},
    {AVCOL_TRC_GAMMA22, "gamma 2.2", Curve::power, 2.2},
    {AVCOL_TRC_GAMMA28, "gamma 2.8", Curve::power, 2.8},
    {AVCOL_TRC_IEC61966_2_1, "sRGB", Curve::srgb, 0.0},
    {AVCOL_TRC_LINEAR, "linear light", Curve::linear, 0.0},
    {AVCOL_TRC_SMPTE2084, "PQ (SMPTE ST 2084)", Curve::pq, 0.0},
    {AVCOL_TRC_ARIB_STD_B67, "HLG (ARIB STD-B67)", Curve::hlg, 0.0},
    {AVCOL_TRC_LOG, "logarithmic", Curve::unknown, 0.0},
    {AVCOL_TRC_LOG_SQRT, "logarithmic, square root", Curve::unknown, 0.0},
    {AVCOL_TRC_SMPTE428, "SMPTE ST 428", Curve::unknown, 0.0},
};

constexpr glm::dvec2 white{0.3127, 0.3290};  // D65
constexpr PrimariesRow bt709{AVCOL_PRI_BT709, "BT.709", Gamut::usual, {0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}};
constexpr PrimariesRow bt2020{AVCOL_PRI_BT2020, "BT.2020", Gamut::wide, {0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}};
constexpr PrimariesRow primaries[] = {
    bt709,
    bt2020,
    {AVCOL_PRI_SMPTE432, "Display P3", Gamut::wide, {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}},
    {AVCOL_PRI_SMPTE431, "DCI-P3", Gamut::wide, {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}},
    {AVCOL_PRI_BT470BG, "BT.601, 625 lines", Gamut::usual, {}, {}, {}},
    {AVCOL_PRI_SMPTE170M, "BT.601, 525 lines", Gamut::usual, {}, {}, {}},
    {AVCOL_PRI_SMPTE240M, "SMPTE 240M", Gamut::usual, {}, {}, {}},
    {AVCOL_PRI_EBU3213, "EBU 3213", Gamut::usual, {}, {}, {}},
    {AVCOL_PRI_BT470M, "BT.470 M", Gamut::unknown, {}, {}, {}},
    {AVCOL_PRI_FILM, "film", Gamut::unknown, {}, {}, {}},
    {AVCOL_PRI_SMPTE428, "CIE XYZ (SMPTE ST 428)", Gamut::unknown, {}, {}, {}},
};

/// Matrices from R'G'B' to what is stored that nothing here undoes.
struct MatrixRow {
    AVColorSpace space;
    const char* name;
};
constexpr MatrixRow unknown_matrices[] = {
    {AVCOL_SPC_YCGCO, "YCgCo"},
    {AVCOL_SPC_BT2020_CL, "BT.2020 of constant luminance"},
    {AVCOL_SPC_SMPTE2085, "SMPTE ST 2085"},
    {AVCOL_SPC_CHROMA_DERIVED_NCL, "derived from the primaries"},
    {AVCOL_SPC_CHROMA_DERIVED_CL, "derived from the primaries, of constant luminance"},
    {AVCOL_SPC_ICTCP, "ICtCp"},
};

template <class Row, std::size_t count, class Value>
const Row* row_of(const Row (&rows)[count], Value Row::*column, Value value) {
    const auto found =
        std::find_if(std::begin(rows), std::end(rows), [&](const Row& row) { return row.*column == value; });
    return found == std::end(rows) ? nullptr : found;
}

/// From light of these primaries to CIE XYZ, in which the white has Y = 1.
glm::dmat3 to_xyz(const PrimariesRow& row) {
    const auto xyz = [](glm::dvec2 p) { return glm::dvec3(p.x, p.y, 1.0 - p.x - p.y) / p.y; };
    const glm::dmat3 columns(xyz(row.red), xyz(row.green), xyz(row.blue));
    const glm::dvec3 share = glm::inverse(columns) * xyz(white);
    return {columns[0] * share.x, columns[1] * share.y, columns[2] * share.z};
}

bool is_hdr(const TransferRow* transfer) {
    return transfer != nullptr && (transfer->curve == Curve::pq || transfer->curve == Curve::hlg);
}

}  // namespace

bool ColorTags::converted() const {
    if (transfer != nullptr && transfer->curve == Curve::unknown) return false;
    if (primaries != nullptr && primaries->gamut == Gamut::unknown) return false;
    const bool wide = primaries != nullptr && primaries->gamut == Gamut::wide;
    return wide || is_hdr(transfer) || (transfer != nullptr && transfer->curve == Curve::linear);
}

ColorTags color_tags(const AVFrame& frame) {
    ColorTags tags{.transfer = row_of(transfers, &TransferRow::transfer, frame.color_trc),
                   .primaries = row_of(primaries, &PrimariesRow::primaries, frame.color_primaries)};
    if (is_hdr(tags.transfer) && tags.primaries == nullptr) tags.primaries = &bt2020;
    return tags;
}

std::string transfer_words(const ColorTags& tags) {
    if (tags.transfer == nullptr) return "";
    const std::string name = tags.transfer->name;
    if (is_hdr(tags.transfer) && tags.converted()) return name + ", converted to SDR: 203 cd/m2 are white";
    if (tags.transfer->curve == Curve::linear && tags.converted()) return name + ", converted to sRGB";
    return name;
}

std::string primaries_words(const ColorTags& tags) {
    if (tags.primaries == nullptr) return "";
    const bool converted = tags.primaries->gamut == Gamut::wide && tags.converted();
    return tags.primaries->name + std::string(converted ? ", converted to BT.709" : "");
}

std::string color_warning(const AVFrame& frame) {
    const ColorTags tags = color_tags(frame);
    std::string told;
    const auto tell = [&told](const char* what, const char* name) {
        told += (told.empty() ? "" : ", ") + std::string(what) + " " + name;
    };
    const bool known_curve = tags.transfer == nullptr || tags.transfer->curve != Curve::unknown;
    if (!known_curve) tell("transfer", tags.transfer->name);
    if (tags.primaries != nullptr &&
        (tags.primaries->gamut == Gamut::unknown || (tags.primaries->gamut == Gamut::wide && !known_curve)))
        tell("primaries", tags.primaries->name);
    if (const MatrixRow* row = row_of(unknown_matrices, &MatrixRow::space, frame.colorspace)) tell("matrix", row->name);
    return told.empty() ? "" : "its colours are not converted and look wrong: " + told;
}

glm::mat3 to_bt709(const PrimariesRow& row) {
    if (row.gamut != Gamut::wide) return glm::mat3(1.0f);
    return glm::mat3(glm::inverse(to_xyz(bt709)) * to_xyz(row));
}

glm::vec3 luminance_of(const PrimariesRow& row) {
    const glm::dmat3 m = to_xyz(row.gamut == Gamut::wide ? row : bt709);
    return {m[0].y, m[1].y, m[2].y};
}

}  // namespace lapfx::media
