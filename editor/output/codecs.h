// How a video is compressed: one row for each codec and each quality. The encoder, `lapfx render` and the dialog use
// these rows.
//
//     const std::string fault = output::codec_fault(output::Codec::ffv1, "out.mp4");
//     // "\"ffv1\" does not go into .mp4; name the file .mkv or .avi"
//
// Any thread.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lapfx::output {

enum class Codec { h264, h265, ffv1 };
enum class Quality { small, good, best };

struct CodecRow {
    Codec codec;
    std::string_view key;    ///< "h264", as `lapfx render` takes it
    std::string_view title;  ///< "H.264"
    std::string_view help;
    std::span<const std::string_view> encoders;    ///< FFmpeg's names; the first one that it has is used
    std::span<const std::string_view> extensions;  ///< the usual ones of the formats that it goes into
    bool lossless = false;                         ///< every pixel is kept, and there is no quality to choose
};

struct QualityRow {
    Quality quality;
    std::string_view key;    ///< "good"
    std::string_view title;  ///< "Good"
    std::string_view help;
    int crf_h264, crf_h265;  ///< constant rate factor, 0..51: less is better, 6 less about doubles the size
    int quantizer_mpeg4;     ///< 1..31: less is better
};

inline constexpr std::size_t codec_count = 3, quality_count = 3;
/// All rows, in the order of Codec and of Quality.
const std::array<CodecRow, codec_count>& codec_rows();
const std::array<QualityRow, quality_count>& quality_rows();
const CodecRow& row_of(Codec codec);
const QualityRow& row_of(Quality quality);
/// By the key; none: no row has it.
std::optional<Codec> codec_keyed(std::string_view key);
std::optional<Quality> quality_keyed(std::string_view key);

/// Why a video of this name cannot hold the codec, and which name can; empty: it can.
std::string codec_fault(Codec codec, const std::filesystem::path& video);

}  // namespace lapfx::output
