// All schemes show the same picture (streaming.h), and all resolutions almost the same.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "media/schemes.h"
#include "parity/render/scene_fixture.h"
#include "support/folders.h"

namespace lapfx {
namespace {

class SchemesTest : public test::SceneTest {
  protected:
    static constexpr glm::ivec2 frame{240, 180};

    SchemesTest() {
        preset.folder = test::light_folder() / "samples/clips";  // most of the time goes to their decoder
        preset.smoke.clips = {{.file = "plume_thick.mp4", .in = 0.5, .crossfade = 0.6},
                              {.file = "wisps_thin.mp4", .speed = 1.3},
                              {.file = "haze_rolling.mp4", .role = ClipRole::haze, .rotation = 20.0},
                              {.file = "plume_green.mp4", .role = ClipRole::haze, .own_keying = true}};
        KeyingParameters& green = preset.smoke.clips[3].keying;
        green.luma_low = 0.0;
        green.luma_high = 1.0;
        green.key_color = {0.0, 0.69, 0.25};
        green.chroma_high = 90.0;
        green.spill = 1.0;
        preset.smoke.haze.accumulation = 0.8;
        scene.events[1].duration = 30.0;
    }
    std::vector<Image> pictures(const StreamingOptions& streaming) {
        Preview p(scene, preset, {.clip_folders = {}, .wait_for_clips = true, .streaming = streaming});
        std::vector<Image> all;
        for (const double time : {1.0, 1.04, 1.1, 4.2, 2.0, 11.0}) all.push_back(p.image(time, frame));
        return all;
    }
    static double mean_difference(const Image& a, const Image& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += i % 4 == 3 ? 0 : std::abs(a.pixels[i] - b.pixels[i]);
        return sum / (0.75 * static_cast<double>(a.pixels.size()));
    }
};

TEST_F(SchemesTest, ShowTheSamePicture) {
    std::map<media::Layout, std::vector<Image>> all;  // by each layout's first scheme
    for (const media::SchemeRow& row : media::scheme_rows) {
        const std::vector<Image> now = pictures({.scheme = row.scheme});
        const std::vector<Image>& first = all.try_emplace(row.layout, now).first->second;
        for (std::size_t i = 0; i < now.size(); ++i)
            EXPECT_TRUE(now[i].pixels == first[i].pixels) << row.key << ' ' << i;
    }
    const std::vector<Image>&pipeline = all.at(media::Layout::rgb), &resident = all.at(media::Layout::planar);
    for (std::size_t i = 0; i < resident.size(); ++i) {
        // One converts colour on the CPU, the other in the shader: rounding and interpolation of chroma differ.
        EXPECT_LE(mean_difference(pipeline[i], resident[i]), 0.5) << i;
        EXPECT_LE(test::differing(pipeline[i], resident[i], 6), frame.x * frame.y / 500) << i;
    }
    EXPECT_GT(mean_difference(resident[0], resident[3]), 1.0) << "the smoke does change";
}

TEST_F(SchemesTest, ALoopLaterResidentClipsShowTheSame) {
    for (SmokeClip& clip : preset.smoke.clips) clip.speed = 1.0;
    Preview p(scene, preset, {.clip_folders = {}, .wait_for_clips = true});
    const Image first = p.image(2.0, frame);
    for (int i = 0; i < 200; ++i) p.image(2.0 + i / 30.0, {16, 12});
    const auto uploaded = p.streaming_times().uploaded;
    EXPECT_TRUE(p.image(2.0, frame).pixels == first.pixels);
    EXPECT_EQ(p.streaming_times().uploaded, uploaded) << "all of it comes from memory";
    for (const ClipStatus& clip : p.clips()) EXPECT_GT(clip.resident, clip.frames / 2) << clip.file;
}

TEST_F(SchemesTest, OffScreenIsWithinTwoCodeValuesOfLayerOverLayer) {
    const auto direct = pictures({.resolution = SmokeResolution::screen});
    for (const SmokeResolution resolution : {SmokeResolution::clip, SmokeResolution::half, SmokeResolution::balanced}) {
        const auto summed = pictures({.resolution = resolution});
        for (std::size_t i = 0; i < direct.size(); ++i) EXPECT_LE(mean_difference(direct[i], summed[i]), 2.0) << i;
    }
}

}  // namespace
}  // namespace lapfx
