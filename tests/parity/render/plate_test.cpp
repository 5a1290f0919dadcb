// A plate: the picture of the reference comes out as it is, and smoke and blood lie over it as over any organ.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapfx/authoring/preview.h"
#include "support/clips.h"
#include "support/endoscope.h"
#include "support/gpu_test.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

constexpr glm::ivec2 size(240, 160);

class PlateTest : public test::GpuTest {
  protected:
    PlateTest() {
        show(test::tissue_picture(size));
        scene.folder = folder.path();
        scene.organ.color = {0.3, 0.9, 0.1};  // a plate shows the reference as it is
        scene.camera = {.eye = {5.0, 30.0, 80.0}, .target = {1.0, 2.0, 0.0}, .up = {0.0, 1.0, 0.1}};
        scene.camera.exposure = 1.9;
        scene.light.focus_distance = glm::distance(scene.camera.eye, scene.camera.target);
        scene.reference.file = "video.png";
        scene.plate.use = true;
        preset.smoke.clips.clear();
        preset.smoke.plume.density = 0.0;
        preset.smoke.particles.rate = 0.0;
    }

    void show(const Image& image) {
        picture = image;
        test::write_picture(folder / "video.png", image);
    }
    Preview preview() const { return Preview(scene, preset, {.clip_folders = {}, .wait_for_clips = true}); }
    Image drawn(double time = 0.0, glm::ivec2 of = size) const { return preview().image(time, of); }
    /// Burns tissue `right` mm from the middle. The haze is even, for the only clip is one of plumes, and these have no
    /// thickness.
    void smoke(double right) {
        test::write_clip(folder / "clip.avi", 4);
        preset.folder = folder.path();
        preset.smoke.clips = {{.file = "clip.avi", .role = ClipRole::plume}};
        preset.smoke.haze.accumulation = 0.3;
        const glm::dvec3 place = middle() + glm::dvec3(right, 0.0, 10.0);  // before the plate: seen on it all the same
        scene.events = {
            {.action = ToolAction::cauterise, .time = 0.0, .duration = 4.0, .position = place, .to = place}};
    }
    glm::dvec3 middle() const { return scene.camera.target; }

    static int largest_difference(const Image& a, const Image& b) {
        EXPECT_EQ(a.pixels.size(), b.pixels.size());
        int largest = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i)
            largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
        return largest;
    }

    test::Folder folder;
    Image picture;
    Scene scene;
    Preset preset;
};

double to_linear(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}
double to_srgb(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

TEST_F(PlateTest, WithoutSmokeAndBloodItIsTheFrame) {
    for (const PlateDepth depth : {PlateDepth::bowl, PlateDepth::flat}) {
        scene.plate.depth = depth;
        EXPECT_LE(largest_difference(drawn(), picture), 1);
    }
}

/// In each channel, next to others.
Image every_code_value(Image image) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                image.pixels[4 * static_cast<std::size_t>(y * image.width + x) + c] =
                    static_cast<std::uint8_t>((x + y * image.width + 85 * static_cast<int>(c)) % 256);
    return image;
}

TEST_F(PlateTest, EveryCodeValueComesOut) {
    const Image ramp = every_code_value(picture);
    show(ramp);
    for (const double exposure : {0.2, 1.0, 6.0}) {
        scene.camera.exposure = exposure;
        EXPECT_LE(largest_difference(drawn(), ramp), 1) << exposure;
    }
}

TEST_F(PlateTest, EveryCodeValueComesOutOfAFilmCurve) {
    const Image ramp = every_code_value(picture);
    show(ramp);
    scene.camera.curve = ResponseCurve::film;
    scene.camera.white_balance = {1.03, 0.96, 1.08};
    scene.camera.sharpening = 0.9;
    for (const double saturation : {0.85, 1.0})
        for (const double exposure : {0.2, 1.0, 6.0}) {
            scene.camera.exposure = exposure, scene.camera.saturation = saturation;
            EXPECT_LE(largest_difference(drawn(), ramp), 1) << exposure << ' ' << saturation;
        }
}

TEST_F(PlateTest, HazeOverAFilmCurveIsLaidOverItsLight) {
    scene.plate.depth = PlateDepth::flat;
    scene.camera.curve = ResponseCurve::film;
    scene.camera.exposure = 1.5;
    smoke(-50.0);
    Preview p = preview();
    const Image image = p.image(4.0, size);
    const double haze = p.amounts().haze;
    ASSERT_GT(haze, 0.2);
    const CameraResponse response = scene.camera.response();
    const glm::dvec3 light = scene.light.color, smoke_color = preset.smoke.haze.color;
    for (const glm::ivec2 at : {glm::ivec2(120, 80), {200, 40}, {220, 130}, {170, 90}})
        for (int c = 0; c < 3; ++c) {
            const double tissue = light_shown_as(to_linear(test::pixel(picture, at)[c] / 255.0), response);
            const double through = std::exp(-haze * preset.smoke.haze.extinction[c]);
            const double veil = to_linear(smoke_color[c]) * to_linear(light[c]) * scene.camera.exposure;
            const double seen = to_srgb(shown_light(tissue * through + veil * (1.0 - through), response));
            EXPECT_NEAR(test::pixel(image, at)[c], 255.0 * seen, 1.5) << at.x << ' ' << c;
        }
}

TEST_F(PlateTest, ARoundViewComesOutWithItsSurround) {
    show(test::behind_round_view(picture, {118.0, 80.0}, 74.0));
    EXPECT_LE(largest_difference(drawn(), picture), 1);
}

TEST_F(PlateTest, AFrameOfAnotherShapeShowsAllOfItBetweenBlackBars) {
    for (const glm::ivec2 wider : {glm::ivec2(300, 160), {240, 220}}) {
        const Image image = drawn(0.0, wider);
        const glm::ivec2 from = (wider - size) / 2;
        for (int y = 0; y < wider.y; ++y)
            for (int x = 0; x < wider.x; ++x) {
                const glm::ivec2 at = glm::ivec2(x, y) - from;
                const bool inside = at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
                const glm::ivec3 wanted = inside ? test::pixel(picture, at) : glm::ivec3(0);
                const glm::ivec3 apart = glm::abs(test::pixel(image, {x, y}) - wanted);
                ASSERT_LE(std::max({apart.r, apart.g, apart.b}), 1) << x << ' ' << y;
            }
    }
}

TEST_F(PlateTest, TheValidViewIsThatOfTheVideo) {
    const auto share = [this](glm::ivec2 of) {
        const std::vector<std::uint8_t> view = preview().layers(0.0, of).view;
        return static_cast<double>(std::ranges::count(view, 255)) / static_cast<double>(view.size());
    };
    EXPECT_NEAR(share({300, 160}), 240.0 / 300.0, 0.01) << "without the bars";
    show(test::behind_round_view(picture, {120.0, 80.0}, 74.0));
    EXPECT_NEAR(share(size), std::numbers::pi * 74.0 * 74.0 / (240.0 * 160.0), 0.02) << "without the surround";
}

TEST_F(PlateTest, AReferenceThatIsStoredSqueezedIsStretched) {
    scene.reference.aspect = 2.0 * size.x / size.y;
    const Image image = drawn(0.0, {2 * size.x, size.y});
    int most = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 4; x < size.x - 4; ++x) {
            const glm::ivec3 here = test::pixel(image, {2 * x, y}), next = test::pixel(image, {2 * x + 1, y});
            const glm::ivec3 apart = glm::abs((here + next) / 2 - test::pixel(picture, {x, y}));
            most = std::max({most, apart.r, apart.g, apart.b});
        }
    EXPECT_LE(most, 24) << "but for what lies between pixels";
}

TEST_F(PlateTest, HazeOverItFollowsTheFormulaOfScattering) {
    scene.plate.depth = PlateDepth::flat;
    Image marked = picture;
    for (const std::size_t at : {200U + 40 * 240, 201U + 40 * 240, 220U + 130 * 240})  // a highlight and a dark place
        for (std::size_t c = 0; c < 3; ++c) marked.pixels[4 * at + c] = at < 120 * 240 ? 255 : 3;
    show(marked);
    smoke(-50.0);  // near the left edge; looked at elsewhere
    Preview p = preview();
    const Image image = p.image(4.0, size);
    const double haze = p.amounts().haze;
    ASSERT_GT(haze, 0.2);
    ASSERT_LT(haze, 2.0);
    const auto shoulder = [](double x) {
        return x <= 0.7 ? x : 0.7 + 0.3 * ((x - 0.7) / 0.3) / (1.0 + (x - 0.7) / 0.3);
    };
    const glm::dvec3 light = scene.light.color, smoke_color = preset.smoke.haze.color;
    for (const glm::ivec2 at : {glm::ivec2(120, 80), {200, 40}, {220, 130}, {170, 90}})
        for (int c = 0; c < 3; ++c) {
            const double tissue = to_linear(test::pixel(picture, at)[c] / 255.0);
            const double through = std::exp(-haze * preset.smoke.haze.extinction[c]);
            const double veil = shoulder(to_linear(smoke_color[c]) * to_linear(light[c]) * scene.camera.exposure);
            const double seen = 255.0 * to_srgb(tissue * through + veil * (1.0 - through));
            EXPECT_NEAR(test::pixel(image, at)[c], seen, 1.5) << at.x << ' ' << c;
        }
}

TEST_F(PlateTest, NoSmokeCoversTheSurroundOfARoundView) {
    show(test::behind_round_view(picture, {120.0, 80.0}, 70.0));
    smoke(-20.0);
    const Image image = drawn(4.0, {300, 160});
    EXPECT_GT(test::pixel(image, {150, 80}).b, test::pixel(picture, {120, 80}).b + 20);
    for (const glm::ivec2 at : {glm::ivec2(5, 80), {32, 5}, {70, 20}, {295, 155}})
        EXPECT_EQ(test::pixel(image, at), glm::ivec3(0)) << at.x;
}

TEST_F(PlateTest, AWoundOnItSpreadsADisc) {
    preset.bleeding.noise_strength = 0.0;
    preset.bleeding.threshold = 3.0;
    preset.bleeding.gravity_bias = 0.0;
    preset.bleeding.max_extent = 12.0;
    preset.vessels.vessel_threshold = 0.0;
    scene.plate.depth = PlateDepth::flat;
    scene.events = {{.action = ToolAction::cut, .time = 0.0, .duration = 0.1, .position = middle(), .to = middle()}};
    Preview p = preview();
    constexpr glm::ivec2 large = 2 * size;
    const Image bleeding = p.image(60.0, large);
    const double area = p.amounts().blood_area;
    EXPECT_NEAR(area, std::numbers::pi * 81.0, 0.02 * area);
    p.set_contacts({});
    const Image dry = p.image(60.0, large);
    const double away = glm::distance(scene.camera.eye, scene.camera.target);
    const double mm = 2.0 * away * std::tan(glm::radians(scene.camera.field_of_view) / 2.0) / large.y;
    int covered = 0, middle_x = 0, middle_y = 0;
    for (int y = 0; y < large.y; ++y)
        for (int x = 0; x < large.x; ++x) {
            const glm::ivec3 apart = glm::abs(test::pixel(bleeding, {x, y}) - test::pixel(dry, {x, y}));
            if (std::max({apart.r, apart.g, apart.b}) > 2) ++covered, middle_x += x, middle_y += y;
        }
    EXPECT_NEAR(covered * mm * mm, area, 0.04 * area);
    EXPECT_NEAR(static_cast<double>(middle_x) / covered, large.x / 2, 1.5);
    EXPECT_NEAR(static_cast<double>(middle_y) / covered, large.y / 2, 1.5);
    const glm::ivec3 blood = test::pixel(bleeding, {large.x / 2 + 20, large.y / 2 + 10});
    EXPECT_GT(blood.r, 2 * blood.g) << "blood, lit by the scene's lamp";
}

TEST_F(PlateTest, APixelPicksThePlaceBelowIt) {
    scene.plate.depth = PlateDepth::flat;
    const Preview p = preview();
    const auto hit = p.pick({120.0, 80.0}, size);
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::distance(hit->position, middle()), 0.05);
    const auto above_bars = p.pick({120.0, 5.0}, {240, 320});
    EXPECT_FALSE(above_bars) << "black bars are no tissue";
    const auto below = p.pick({0.5, 160.0}, {240, 320}), left = p.pick({0.5, 80.0}, size);
    ASSERT_TRUE(below && left);
    EXPECT_LT(glm::distance(below->position, left->position), 1e-6) << "the same pixel of the picture";
}

TEST_F(PlateTest, FromElsewhereItIsASurface) {
    Preview p = preview();
    SceneCamera aside = scene.camera;
    aside.eye.x += 40.0;
    aside.vignette = 0.0;
    p.set_camera(aside);
    const Image image = p.image(0.0, size);
    EXPECT_GT(largest_difference(image, picture), 40);
    EXPECT_EQ(test::pixel(image, {120, 80}).r > 60, true) << "it is seen";
    p.set_camera(scene.camera);
    EXPECT_LE(largest_difference(p.image(0.0, size), picture), 1);
}

TEST_F(PlateTest, AnotherCameraNeedsAnotherPlateButNotAnotherExposure) {
    Preview p = preview();
    Scene other = scene;
    other.camera.exposure = 0.7;
    other.camera.vignette = 0.3;
    ASSERT_TRUE(p.takes(other));
    p.set_scene(other);
    EXPECT_LE(largest_difference(p.image(0.0, size), picture), 1) << "the picture has its own";
    other.camera.eye.x += 1.0;
    EXPECT_FALSE(p.takes(other));
}

TEST_F(PlateTest, MovesWithTheCamera) {
    scene.camera.eye = {-60.0, 10.0, 40.0};
    scene.camera.up = {0.3, 1.0, 0.0};
    EXPECT_LE(largest_difference(drawn(), picture), 1);
}

}  // namespace
}  // namespace lapfx
