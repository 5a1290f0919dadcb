#include "output/codecs.h"

#include <algorithm>

#include "lapfx/authoring/formats.h"
#include "lapfx/rows.h"

namespace lapfx::output {

namespace {

// MPEG-4 part 2 stands in for H.264, because FFmpeg has that encoder itself.
constexpr std::string_view h264_encoders[] = {"libx264", "mpeg4"}, h265_encoders[] = {"libx265"},
                           ffv1_encoders[] = {"ffv1"};
// AVI has no agreed mark for H.265, and hardly any player takes it from there.
constexpr std::string_view all[] = {".mp4", ".mov", ".mkv", ".avi"}, h265_extensions[] = {".mp4", ".mov", ".mkv"},
                           ffv1_extensions[] = {".mkv", ".avi"};

constexpr std::array<CodecRow, codec_count> codecs = {{
    {.codec = Codec::h264,
     .key = "h264",
     .title = "H.264",
     .help = "plays everywhere",
     .encoders = h264_encoders,
     .extensions = all},
    {.codec = Codec::h265,
     .key = "h265",
     .title = "H.265",
     .help = "half the size, slower, not in .avi",
     .encoders = h265_encoders,
     .extensions = h265_extensions},
    {.codec = Codec::ffv1,
     .key = "ffv1",
     .title = "FFV1",
     .help = "lossless, large, in .mkv and .avi",
     .encoders = ffv1_encoders,
     .extensions = ffv1_extensions,
     .lossless = true},
}};

constexpr std::array<QualityRow, quality_count> qualities = {{
    {.quality = Quality::small,
     .key = "small",
     .title = "Small",
     .help = "small files, to send",
     .crf_h264 = 28,
     .crf_h265 = 30,
     .quantizer_mpeg4 = 9},
    {.quality = Quality::good,
     .key = "good",
     .title = "Good",
     .help = "as seen",
     .crf_h264 = 23,
     .crf_h265 = 25,
     .quantizer_mpeg4 = 4},
    {.quality = Quality::best,
     .key = "best",
     .title = "Best",
     .help = "hardly to be told from the frames themselves",
     .crf_h264 = 16,
     .crf_h265 = 18,
     .quantizer_mpeg4 = 2},
}};

static_assert(rows_follow<&CodecRow::codec>(codecs) && rows_follow<&QualityRow::quality>(qualities));

/// ".mp4, .mov or .mkv"
std::string listed(std::span<const std::string_view> extensions) {
    std::string text;
    for (std::size_t i = 0; i < extensions.size(); ++i) {
        if (i > 0) text += i + 1 == extensions.size() ? " or " : ", ";
        text += extensions[i];
    }
    return text;
}

}  // namespace

const std::array<CodecRow, codec_count>& codec_rows() {
    return codecs;
}

const std::array<QualityRow, quality_count>& quality_rows() {
    return qualities;
}

const CodecRow& row_of(Codec codec) {
    return codecs[static_cast<std::size_t>(codec)];
}

const QualityRow& row_of(Quality quality) {
    return qualities[static_cast<std::size_t>(quality)];
}

std::optional<Codec> codec_keyed(std::string_view key) {
    const auto* const row = std::ranges::find(codecs, key, &CodecRow::key);
    return row == codecs.end() ? std::nullopt : std::optional(row->codec);
}

std::optional<Quality> quality_keyed(std::string_view key) {
    const auto* const row = std::ranges::find(qualities, key, &QualityRow::key);
    return row == qualities.end() ? std::nullopt : std::optional(row->quality);
}

std::string codec_fault(Codec codec, const std::filesystem::path& video) {
    const CodecRow& row = row_of(codec);
    const FileFormat* const format = format_named(video);
    const std::string extension = format == nullptr ? video.extension().string() : std::string(format->extensions[0]);
    if (std::ranges::find(row.extensions, extension) != row.extensions.end()) return {};
    return '"' + std::string(row.key) + "\" does not go into " + extension + "; name the file " +
           listed(row.extensions);
}

}  // namespace lapfx::output
