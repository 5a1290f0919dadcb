// Pictures of keying on the CPU, compared with the references of smoke/keying_pixel.h and with known values.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/keying.h"
#include "smoke/keying_pixel.h"
#include "support/clips.h"
#include "support/folders.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

namespace fs = std::filesystem;

KeyingFrame random_frame(glm::ivec2 size, bool alpha) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> luma(0.0f, 255.0f), chroma(-40.0f, 40.0f), opacity(0.0f, 1.0f);
    KeyingFrame frame;
    frame.size = size;
    for (int i = 0; i < size.x * size.y; ++i) {
        frame.luma.push_back(luma(random));
        frame.cb.push_back(chroma(random));
        frame.cr.push_back(chroma(random));
        if (alpha) frame.opacity.push_back(opacity(random));
    }
    return frame;
}

float bilinear(const std::vector<float>& plane, glm::ivec2 size, glm::vec2 place) {
    const glm::vec2 at = place - 0.5f, f = at - glm::floor(at);
    const glm::ivec2 first(glm::floor(at));
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 corner(i & 1, i >> 1), texel = glm::clamp(first + corner, glm::ivec2(0), size - 1);
        const float weight = (corner.x == 1 ? f.x : 1.0f - f.x) * (corner.y == 1 ? f.y : 1.0f - f.y);
        sum += weight * plane[static_cast<std::size_t>(texel.y * size.x + texel.x)];
    }
    return sum;
}

/// As the shader looks them up: code values between pixels, then keyed.
float opacity_at(const KeyingFrame& frame, const smoke::Keying& key, glm::vec2 place) {
    if (!frame.opacity.empty()) return bilinear(frame.opacity, frame.size, place);
    return smoke::key_luma(bilinear(frame.luma, frame.size, place), key) *
           smoke::key_chroma({bilinear(frame.cb, frame.size, place), bilinear(frame.cr, frame.size, place)}, key);
}

struct Case {
    const char* name;
    KeyingParameters keying;
    ClipPolarity polarity = ClipPolarity::light;
    bool alpha = false;
};

const std::vector<Case>& cases() {
    const KeyingParameters chroma{
        .luma_low = 40, .luma_high = 180, .key_color = {0.2, 0.5, 0.3}, .chroma_low = 5, .chroma_high = 40};
    static const std::vector<Case> all{
        {"luma", {.luma_low = 40, .luma_high = 180}},
        {"dark", {.luma_low = 40, .luma_high = 180}, ClipPolarity::dark},
        {"chroma", chroma},
        {"choke", {.luma_low = 40, .luma_high = 180, .choke = 1.5}},
        {"feather", {.luma_low = 40, .luma_high = 180, .feather = 2.5}},
        {"edges_wider_than_the_picture", {.luma_low = 40, .luma_high = 180, .choke = 16, .feather = 16}},
        {"opacity_with_edges", {.choke = 2, .feather = 1}, ClipPolarity::light, true},
    };
    return all;
}

TEST(KeyingPicture, OpacityIsThatOfTheReference) {
    for (const glm::ivec2 size : {glm::ivec2(17, 11), glm::ivec2(1, 1), glm::ivec2(3, 40)})
        for (const Case& tested : cases()) {
            const KeyingFrame frame = random_frame(size, tested.alpha);
            const smoke::Keying key = smoke::keying_of(tested.keying, tested.polarity);
            std::vector<float> opacity;
            keyed_opacity(frame, tested.keying, {.file = {}, .polarity = tested.polarity}, opacity);
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    ASSERT_NEAR(opacity[static_cast<std::size_t>(y * size.x + x)],
                                smoke::edged([&](glm::vec2 p) { return opacity_at(frame, key, p); },
                                             glm::vec2(x, y) + 0.5f, static_cast<float>(tested.keying.choke),
                                             static_cast<float>(tested.keying.feather)),
                                2e-4)
                        << tested.name << ' ' << x << ' ' << y;
        }
}

TEST(KeyingPicture, CodeValuesAreThoseOfLumaAndChroma) {
    const KeyingFrame frame = random_frame({5, 4}, false);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x) {
            const glm::vec3 code = frame.code({x, y});
            const auto i = static_cast<std::size_t>(y * 5 + x);
            ASSERT_NEAR(smoke::luma(code), frame.luma[i], 1e-3);
            ASSERT_NEAR(smoke::chroma(code).x, frame.cb[i], 1e-3);
            ASSERT_NEAR(smoke::chroma(code).y, frame.cr[i], 1e-3);
        }
}

/// Grey pixels of luma 0, 50, 100, ...
KeyingFrame steps() {
    KeyingFrame frame{.size = {6, 1}, .luma = {0, 50, 100, 150, 200, 250}, .cb = {}, .cr = {}, .opacity = {}};
    frame.cb.assign(6, 0.0f);
    frame.cr.assign(6, 0.0f);
    return frame;
}

TEST(KeyingPicture, MatteIsTheRampBetweenTheThresholds) {
    const Image matte = matte_picture(steps(), {.keying = {.luma_low = 50, .luma_high = 150}});
    const int expected[] = {0, 0, 128, 255, 255, 255};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(matte.pixels[4 * i], expected[i]) << i;
        EXPECT_EQ(matte.pixels[4 * i + 3], 255);
    }
    const Image dark = matte_picture(
        steps(), {.keying = {.luma_low = 50, .luma_high = 150}, .clip = {.file = {}, .polarity = ClipPolarity::dark}});
    EXPECT_EQ(dark.pixels[0], 255);
    EXPECT_EQ(dark.pixels[4 * 5], 0);
}

TEST(KeyingPicture, SmokeIsLaidOverItsBackground) {
    const KeyingLook look{
        .keying = {.luma_low = 0, .luma_high = 200}, .color = {0.5, 0.5, 0.5}, .extinction = {1, 1, 1}};
    std::vector<float> opacity;
    const KeyingFrame frame = steps();
    keyed_opacity(frame, look.keying, look.clip, opacity);
    const Image red{.width = 1, .height = 1, .pixels = {200, 10, 10, 255}, .name = ""};
    const Image over = composite_picture(frame, look, opacity, red);
    EXPECT_EQ(over.pixels[0], 200);
    EXPECT_EQ(over.pixels[1], 10) << "where there is no smoke it is the background's own byte";
    // Half smoke, in linear light: (0.5776 + 0.2140) / 2 and (0.0030 + 0.2140) / 2, as sRGB.
    EXPECT_NEAR(over.pixels[8], 168, 1);
    EXPECT_NEAR(over.pixels[9], 92, 1);
    EXPECT_NEAR(over.pixels[16], 128, 1) << "whole smoke is its colour";
    const Image alone = keyed_picture(frame, look, opacity);
    EXPECT_EQ(alone.pixels[3], 0);
    EXPECT_NEAR(alone.pixels[11], 128, 1);
    EXPECT_EQ(alone.pixels[8], 128);
}

TEST(KeyingPicture, TheMiddleOfAWiderBackgroundIsTaken) {
    const KeyingLook look{.keying = {.luma_low = 254, .luma_high = 255}};  // nothing is smoke
    KeyingFrame frame = random_frame({2, 2}, false);
    std::fill(frame.luma.begin(), frame.luma.end(), 0.0f);
    Image wide{.width = 6, .height = 2, .pixels = {}, .name = ""};
    for (int i = 0; i < 12; ++i)
        for (const int v : {10 * (i % 6), 0, 0, 255}) wide.pixels.push_back(static_cast<std::uint8_t>(v));
    const std::vector<float> none(4, 0.0f);
    const Image over = composite_picture(frame, look, none, wide);
    EXPECT_EQ(over.pixels[0], 20);
    EXPECT_EQ(over.pixels[4], 30);
    EXPECT_EQ(composite_picture(frame, look, none, {}).pixels[0], 0) << "none is black";
}

TEST(KeyingReader, GivesTheFramesOfAClip) {
    const test::Folder folder;
    const fs::path path = folder / "reader.avi";
    test::write_clip(path, 12, {34, 22});  // an odd number of chroma samples
    KeyingReader reader(path);
    EXPECT_EQ(reader.report().frames, 12);
    EXPECT_EQ(reader.report().size, glm::ivec2(34, 22));
    EXPECT_FALSE(reader.report().alpha);
    KeyingFrame frame;
    for (const int index : {0, 7, 3, 11}) {
        ASSERT_TRUE(reader.read(index, frame));
        EXPECT_EQ(frame.size, glm::ivec2(34, 22));
        EXPECT_NEAR(frame.code({16, 10}).g, test::level_of(index), 2.0) << index;
        EXPECT_NEAR(frame.code({33, 21}).r, test::level_of(index), 2.0) << index;
        EXPECT_EQ(reader.frame_at(reader.time_of(index)), index);
    }
    EXPECT_TRUE(reader.read(99, frame)) << "clamped";
    EXPECT_NEAR(frame.luma[0], test::level_of(11), 2.0);
}

TEST(KeyingReader, AFrameThatCannotBeReadIsTold) {
    const test::Folder folder;
    const fs::path path = folder / "cut.avi";
    {
        cv::VideoWriter writer(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20.0,
                               cv::Size(640, 480));
        cv::Mat noise(480, 640, CV_8UC3);  // large frames, so that the missing part has not been read ahead
        for (int i = 0; i < 24; ++i) {
            cv::randu(noise, 0, 255);
            writer.write(noise);
        }
    }
    KeyingReader reader(path);
    fs::resize_file(path, fs::file_size(path) / 2);
    KeyingFrame frame;
    EXPECT_FALSE(reader.read(23, frame));
    EXPECT_EQ(frame.luma.size(), 640U * 480U);
    fs::remove(path);
    EXPECT_THROW(KeyingReader{path}, Error);
}

TEST(KeyingReader, AStopIsHeeded) {
    const test::Folder folder;
    const fs::path path = folder / "stop.avi";
    test::write_clip(path, 12);
    std::atomic<bool> stop = true;
    EXPECT_EQ(test::faults_of([&] { KeyingReader(path, &stop); }, Failure::runtime),
              std::vector{path.string() + ": was not read to its end"});
    KeyingReader reader(path);
    KeyingFrame frame;
    EXPECT_FALSE(reader.read(9, frame, &stop));
    stop = false;
    EXPECT_TRUE(reader.read(9, frame, &stop));
    EXPECT_NEAR(frame.luma[0], test::level_of(9), 2.0);
}

TEST(FindPublicClip, LooksInThePresetsFolderThenOnTheSearchPath) {
    const fs::path clips = test::source_folder() / "samples" / "clips";
    const fs::path folders[] = {clips};
    EXPECT_EQ(find_clip("wisps_thin.mp4", "/nowhere", folders), clips / "wisps_thin.mp4");
    EXPECT_EQ(find_clip("wisps_thin.mp4", clips, {}), clips / "wisps_thin.mp4");
    EXPECT_THROW(find_clip("no.mp4", clips, folders), Error);
    EXPECT_THROW(find_clip("clips/wisps_thin.mp4", "/nowhere", std::array{clips.parent_path()}), Error);
}

}  // namespace
}  // namespace lapfx
