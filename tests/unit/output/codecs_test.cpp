#include "output/codecs.h"

#include <gmock/gmock.h>

#include "lapfx/authoring/formats.h"

namespace lapfx::output {
namespace {

TEST(Codecs, AreFoundByTheirKeys) {
    for (const CodecRow& row : codec_rows()) {
        EXPECT_EQ(codec_keyed(row.key), row.codec);
        EXPECT_EQ(&row_of(row.codec), &row);
    }
    for (const QualityRow& row : quality_rows()) {
        EXPECT_EQ(quality_keyed(row.key), row.quality);
        EXPECT_EQ(&row_of(row.quality), &row);
    }
    EXPECT_EQ(codec_keyed("H264"), std::nullopt);
    EXPECT_EQ(quality_keyed(""), std::nullopt);
}

TEST(Codecs, GoIntoTheVideosThatAreWrittenAndOneGoesIntoAll) {
    const std::vector<std::string> written = extensions(Content::video, true);
    for (const CodecRow& row : codec_rows())
        for (const std::string_view extension : row.extensions)
            EXPECT_THAT(written, testing::Contains(extension)) << row.key;
    EXPECT_EQ(row_of(Codec::h264).extensions.size(), written.size());
}

TEST(CodecFault, SaysWhichNameHoldsIt) {
    EXPECT_EQ(codec_fault(Codec::ffv1, "a/b.mp4"), "\"ffv1\" does not go into .mp4; name the file .mkv or .avi");
    EXPECT_EQ(codec_fault(Codec::ffv1, "b.MOV"), "\"ffv1\" does not go into .mov; name the file .mkv or .avi");
    EXPECT_EQ(codec_fault(Codec::h265, "b.avi"), "\"h265\" does not go into .avi; name the file .mp4, .mov or .mkv");
    for (const char* name : {"b.mp4", "b.mov", "b.mkv", "B.AVI"}) EXPECT_EQ(codec_fault(Codec::h264, name), "") << name;
    for (const char* name : {"b.mkv", "b.avi"}) EXPECT_EQ(codec_fault(Codec::ffv1, name), "") << name;
    for (const char* name : {"b.mp4", "b.mov", "b.mkv"}) EXPECT_EQ(codec_fault(Codec::h265, name), "") << name;
}

TEST(Qualities, AreEachBetterThanTheOneBefore) {
    for (std::size_t i = 1; i < quality_rows().size(); ++i) {
        const QualityRow &worse = quality_rows()[i - 1], &better = quality_rows()[i];
        EXPECT_GT(worse.crf_h264, better.crf_h264);
        EXPECT_GT(worse.crf_h265, better.crf_h265);
        EXPECT_GT(worse.quantizer_mpeg4, better.quantizer_mpeg4);
    }
}

}  // namespace
}  // namespace lapfx::output
