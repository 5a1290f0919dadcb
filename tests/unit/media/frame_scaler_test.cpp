// Without memory for a frame there is no frame, and nothing of the attempt stays.
#include "media/frame_scaler.h"

#include <climits>

#include <gtest/gtest.h>

extern "C" {
#include <libavutil/mem.h>
}

#include "media/deinterlacer.h"

namespace lapfx::media {
namespace {

constexpr std::size_t little = std::size_t{1} << 20;  // bytes

/// FFmpeg gives no block of memory over `little` bytes while this is there.
struct LittleMemory {
    LittleMemory() { av_max_alloc(little); }
    ~LittleMemory() { av_max_alloc(INT_MAX); }
};

/// A frame of two fields: rows of that luma and black ones in turn.
libav::Frame fields(int width, int height, std::uint8_t luma) {
    libav::Frame frame = libav::frame_of(width, height, AV_PIX_FMT_GRAY8);
    frame->interlaced_frame = frame->top_field_first = 1;
    for (int y = 0; y < height; ++y) std::fill_n(frame->data[0] + y * frame->linesize[0], width, y % 2 == 0 ? luma : 0);
    return frame;
}

TEST(FrameScalerTest, WithoutMemoryForTheFrameTheNextCallFailsAgain) {
    FrameScaler scaler(AV_PIX_FMT_GRAY8, {SWS_CS_ITU601, /*full_range=*/true});
    const ClipColor color{SWS_CS_ITU601, /*full_range=*/true};
    const libav::Frame frame = fields(16, 16, 80);
    const glm::ivec2 large(2048, 1024);
    EXPECT_EQ(scaler.convert(*frame, color, {16, 16}).data[0][0], 80);
    {
        const LittleMemory here;
        for (int call = 0; call < 2; ++call) EXPECT_THROW(scaler.convert(*frame, color, large), std::bad_alloc) << call;
        EXPECT_EQ(scaler.convert(*frame, color, {16, 16}).data[0][0], 80) << "what it could do it still can";
    }
    const AVFrame& scaled = scaler.convert(*frame, color, large);
    EXPECT_EQ(glm::ivec2(scaled.width, scaled.height), large);
    EXPECT_EQ(scaled.data[0][0], 80);
}

TEST(FrameScalerTest, WithoutMemoryForADeinterlacedFrameTheNextCallFailsAgain) {
    Deinterlacer deinterlacer;
    const libav::Frame small = fields(16, 16, 80), large = fields(2048, 1024, 90);
    EXPECT_EQ(deinterlacer.convert(nullptr, *small, nullptr).data[0][0], 80);
    {
        const LittleMemory here;
        for (int call = 0; call < 2; ++call)
            EXPECT_THROW(deinterlacer.convert(nullptr, *large, nullptr), std::bad_alloc) << call;
        EXPECT_EQ(deinterlacer.convert(nullptr, *small, nullptr).data[0][0], 80);
    }
    EXPECT_EQ(deinterlacer.convert(nullptr, *large, nullptr).data[0][0], 90);
}

}  // namespace
}  // namespace lapfx::media
