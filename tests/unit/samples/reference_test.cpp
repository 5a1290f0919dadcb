// The sample reference: the committed file matches its page, and the camera that filmed it.
#include <cmath>
#include <filesystem>

#include "lapfx/authoring/video.h"
#include "lapfx/scene.h"
#include "reference/camera.h"
#include "support/folders.h"

#include <gtest/gtest.h>

namespace lapfx {
namespace {

namespace fs = std::filesystem;

/// Mean colour, code values, of a box of pixels where the wound is.
glm::dvec3 at_the_wound(const Image& image) {
    glm::dvec3 sum(0);
    constexpr int side = 40;
    for (int y = 290; y < 290 + side; ++y)
        for (int x = 320; x < 320 + side; ++x) {
            const std::uint8_t* p = image.pixels.data() + 4 * (y * image.width + x);
            sum += glm::dvec3(p[0], p[1], p[2]);
        }
    return sum / double{side * side};
}

TEST(SampleReference, IsTheSceneReferenceAndBleeds) {
    const Scene scene = load_scene(test::source_folder() / "samples" / "lagb.scene.json");
    const fs::path file = scene.folder / scene.reference.file;
    EXPECT_DOUBLE_EQ(scene.reference.offset, 0.5);
    EXPECT_LT(fs::file_size(file), 600'000U);
    VideoReader video(file);
    EXPECT_EQ(video.info().size, glm::ivec2(640, 512));
    EXPECT_EQ(video.info().frames, 200);
    EXPECT_NEAR(video.info().frames_per_second, 25.0, 1e-6);
    EXPECT_EQ(video.info().warning, "");
    Image start, end;
    ASSERT_TRUE(video.read(5, start));
    ASSERT_TRUE(video.read(199, end));
    const glm::dvec3 clean = at_the_wound(start), bloody = at_the_wound(end);
    EXPECT_LT(bloody.r, clean.r - 50) << "blood where fat was";
    EXPECT_LT(bloody.g, clean.g - 30);
    EXPECT_GT(bloody.b, clean.b - 20) << "seen through haze, which is bluish";
    EXPECT_LT(end.pixels[0] + end.pixels[1] + end.pixels[2], 60) << "the round picture of an endoscope";
}

struct Statistics {
    double mean = 0, deviation = 0;
};
Statistics of(const clips::RgbFrame& frame, std::size_t channel) {
    double sum = 0, squares = 0, count = 0;
    for (std::size_t i = channel; i < frame.rgb.size(); i += 3) {
        sum += frame.rgb[i];
        squares += static_cast<double>(frame.rgb[i]) * frame.rgb[i];
        ++count;
    }
    return {sum / count, std::sqrt(squares / count - sum / count * sum / count)};
}

clips::RgbFrame flat(float code) {
    clips::RgbFrame frame(160, 120);
    for (float& value : frame.rgb) value = code;
    return frame;
}

TEST(SampleCamera, NoiseGrowsWithTheLightAndKeepsTheMean) {
    const camera::Camera plain{.softness = 0, .electrons = 1000, .read_noise = 4, .seed = 9};
    for (const float code : {60.0f, 128.0f, 200.0f}) {
        clips::RgbFrame frame = flat(code);
        camera::film(frame, plain);
        // Shot noise, by way of the display curve: d code / d linear = 255 / 2.4 / linear^(1 - 1/2.4), nearly.
        const double linear = std::pow((code / 255.0 + 0.055) / 1.055, 2.4);
        const double slope = 255.0 * 1.055 / 2.4 * std::pow(linear, 1 / 2.4 - 1);
        const double expected = slope * std::sqrt(linear * 1000 + 16) / 1000 * std::sqrt(1 + 0.7 * 0.7);
        const Statistics red = of(frame, 0);
        EXPECT_NEAR(red.mean, code, 0.6) << code;
        EXPECT_NEAR(red.deviation, expected, 0.08 * expected) << code;
    }
}

TEST(SampleCamera, TheSameSeedIsTheSameNoise) {
    clips::RgbFrame a = flat(90), b = flat(90), c = flat(90);
    camera::film(a, {.seed = 1});
    camera::film(b, {.seed = 1});
    camera::film(c, {.seed = 2});
    EXPECT_EQ(a.rgb, b.rgb);
    EXPECT_NE(a.rgb, c.rgb);
}

TEST(SampleCamera, ABlurKeepsTheLight) {
    clips::RgbFrame frame = flat(0);
    frame.rgb[3 * (60 * 160 + 80)] = 1000.0f;
    camera::blur(frame, 0, 1.5f);
    double sum = 0;
    for (std::size_t i = 0; i < frame.rgb.size(); i += 3) sum += frame.rgb[i];
    EXPECT_NEAR(sum, 1000.0, 0.1);
    EXPECT_NEAR(frame.rgb[3 * (60 * 160 + 80)], 1000.0 / (2 * 3.14159 * 1.5 * 1.5), 2.0) << "a Gaussian's height";
}

}  // namespace
}  // namespace lapfx
