// An organ that takes the place of another one while frames are drawn.
#include "foundation.h"
#include "lapfx/effects.h"
#include "lapfx/frame.h"
#include "lapfx/prepared_organ.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "render/organ_textures.h"
#include "support/wait_until.h"

namespace lapfx {
namespace {

class SetOrganTest : public test::FrameTest {
  protected:
    void SetUp() override {
        test::FrameTest::SetUp();
        if (IsSkipped()) return;
        Organ sheet = load_organ(folder / "sheet.obj"), hill = sheet;
        for (glm::vec3& p : hill.positions) p.y = static_cast<float>(height(p.x, p.z));
        // Several rows of it are not a multiple of what a frame sends.
        hill.images = {{.width = 1023, .height = 700, .pixels = Picture(std::size_t{4} * 1023 * 700), .name = "spots"}};
        for (std::size_t i = 0; i < hill.images[0].pixels.size(); ++i)
            hill.images[0].pixels[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(120 + i / 4 * 7 % 100);
        hill.materials[0].base_color_image = 0;
        hill.images.push_back({.width = 16, .height = 16, .pixels = blank({16, 16}), .name = "bumps"});
        for (std::size_t i = 0; i < hill.images[1].pixels.size(); ++i)
            hill.images[1].pixels[i] = i % 4 < 2 ? static_cast<std::uint8_t>(100 + i % 57) : 255;
        hill.materials[0].normal_image = 1;
        for (std::size_t v = 0; v < hill.uvs.size(); ++v)
            hill.uvs[v] = glm::vec2(hill.positions[v].x, hill.positions[v].z) / 80.0f;
        flat = prepare_organ(sheet, preset.vessels);
        other = prepare_organ(hill, preset.vessels);
        elsewhere = on_hill(4.0);
    }
    static double height(double x, double z) { return 8.0 * std::exp(-(x * x + z * z) / 400.0); }
    /// The scene's events, beside their places and on the hill.
    std::vector<ToolContact> on_hill(double aside) const {
        std::vector<ToolContact> events = scene.events;
        for (ToolContact& event : events) {
            event.position.x += aside;
            event.position.y = height(event.position.x, event.position.z);
            event.to = event.position;
        }
        return events;
    }
    Effects made(const std::shared_ptr<const PreparedOrgan>& organ, const std::vector<ToolContact>& contacts,
                 bool wait = false) const {
        Effects effects(organ, preset, {.gravity = scene.gravity, .wait_for_clips = wait});
        effects.set_contacts(contacts);
        effects.seek(time);
        return effects;
    }
    /// Tissue only: clips that are late differ from run to run.
    Picture tissue(Effects& effects) { return whole(effects, false); }
    Picture whole(Effects& effects, bool smoke = true) {
        Picture picture = blank();
        draw(effects, render::view_of(scene.camera, SceneLight{}, size), picture, smoke);
        return picture;
    }
    /// Seeks until the organ is here.
    static void come(Effects& effects, double at = time) {
        EXPECT_TRUE(test::wait_until([&] { return !effects.organ_coming(); }, [&] { effects.seek(at); }));
    }
    static void expect_same(const Amounts& a, const Amounts& b) {
        EXPECT_GT(a.blood_area, 0.0);
        EXPECT_EQ(a.blood_area, b.blood_area);
        EXPECT_EQ(a.burnt_area, b.burnt_area);
        EXPECT_EQ(a.wounds, b.wounds);
        EXPECT_EQ(a.haze, b.haze);
    }

    std::shared_ptr<const PreparedOrgan> flat, other;
    std::vector<ToolContact> elsewhere;
};

TEST_F(SetOrganTest, IsThatOfANewEffects) {
    Effects effects = made(flat, scene.events), direct = made(other, elsewhere);
    EXPECT_FALSE(effects.organ_coming());
    effects.set_organ(other, elsewhere);
    EXPECT_TRUE(effects.organ_coming());
    come(effects);
    EXPECT_EQ(tissue(effects), tissue(direct));
    expect_same(effects.amounts(), direct.amounts());
    EXPECT_EQ(effects.contacts().size(), elsewhere.size());
    EXPECT_EQ(effects.contacts()[0].position, elsewhere[0].position);
    EXPECT_EQ(effects.memory_use().geometry, direct.memory_use().geometry);
    EXPECT_EQ(effects.memory_use().textures, direct.memory_use().textures);
    for (Effects* one : {&effects, &direct}) one->seek(time + 1.5);
    EXPECT_EQ(tissue(effects), tissue(direct));
}

TEST_F(SetOrganTest, UntilThenThePresentOneIsShown) {
    Effects effects = made(flat, scene.events), direct = made(flat, scene.events);
    effects.set_organ(other, elsewhere);
    const unsigned buffer = effects.bleed_buffer();
    double at = time;
    int shown = 0;
    const auto turn = [&] {
        for (Effects* one : {&effects, &direct}) one->seek(at);
        at += 0.1;
        if (!effects.organ_coming()) return;
        ++shown;
        effects.seek(std::numeric_limits<double>::quiet_NaN());  // no time to show another organ at
        EXPECT_TRUE(effects.organ_coming());
        EXPECT_EQ(tissue(effects), tissue(direct));
        EXPECT_EQ(effects.bleed_buffer(), buffer);
    };
    EXPECT_TRUE(test::wait_until([&] { return !effects.organ_coming(); }, turn));
    EXPECT_GE(shown, 1);
    EXPECT_NE(tissue(effects), tissue(direct));
}

TEST_F(SetOrganTest, WithExactClipsItIsHereAtTheNextSeek) {
    Effects effects = made(flat, scene.events, true), direct = made(other, elsewhere, true);
    effects.set_organ(other, elsewhere);
    effects.seek(time);
    EXPECT_FALSE(effects.organ_coming());
    EXPECT_EQ(whole(effects), whole(direct));
}

TEST_F(SetOrganTest, WhatIsSetMeanwhileHoldsForItToo) {
    const auto change = [&](Effects& effects) {
        Preset changed = preset;
        changed.bleeding.max_extent = 9.0;
        changed.vessels.vessel_width *= 2.0;
        changed.bleeding.color_thin = {0.2, 0.8, 0.2};
        effects.set_preset(changed);
        effects.set_gravity({1.0, -0.2, 0.0});
        effects.set_seed(17);
        effects.set_curves({.cautery_power = {}, .bleeding_strength = {{0.0, 0.5}, {2.0, 1.0}}, .emission = {}});
        effects.set_organ_color({0.9, 0.7, 0.8});
        effects.set_contacts(on_hill(-5.0));
    };
    Effects effects = made(flat, scene.events), direct = made(other, elsewhere);
    effects.set_organ(other, elsewhere);
    for (Effects* one : {&effects, &direct}) change(*one);
    come(effects, 3.0);
    direct.seek(3.0);
    expect_same(effects.amounts(), direct.amounts());
    EXPECT_EQ(tissue(effects), tissue(direct));
    for (Effects* one : {&effects, &direct}) one->set_overlay(Overlay::bleed);
    EXPECT_EQ(tissue(effects), tissue(direct));
}

TEST_F(SetOrganTest, OverlayAndColourStay) {
    Effects effects = made(flat, scene.events), direct = made(other, elsewhere);
    for (Effects* one : {&effects, &direct}) {
        one->set_overlay(Overlay::vessels);
        one->set_organ_color({0.5, 0.6, 0.7});
    }
    effects.set_organ(other, elsewhere);
    come(effects);
    EXPECT_EQ(tissue(effects), tissue(direct));
}

TEST_F(SetOrganTest, SamplesOfTheToolAreForTheOrganThatIsShown) {
    Effects effects = made(flat, {});
    effects.set_organ(other, {});
    const auto push = [&](double at) {
        return effects.tool_queue().push({.time = at, .position = {2.0, 0.0, 2.0}, .touching = true, .action = {}});
    };
    EXPECT_TRUE(push(time));
    EXPECT_TRUE(push(time + 0.001));
    effects.seek(time);
    ASSERT_TRUE(effects.organ_coming());
    EXPECT_EQ(effects.contacts().size(), 1U);
    EXPECT_TRUE(push(time - 1.0));  // too late
    come(effects);
    EXPECT_TRUE(effects.contacts().empty());
    EXPECT_EQ(effects.amounts().lost_samples, 1U);
    for (const double at : {time - 2.0, time - 1.95, time - 1.97}) EXPECT_TRUE(push(at));
    effects.seek(time);
    ASSERT_EQ(effects.contacts().size(), 1U) << "the clock of samples begins anew";
    EXPECT_EQ(effects.contacts()[0].time, time - 2.0);
    EXPECT_EQ(effects.amounts().lost_samples, 2U) << "of both organs";
}

TEST_F(SetOrganTest, ASecondCallReplacesTheFirst) {
    Effects effects = made(flat, scene.events), direct = made(other, elsewhere);
    for (int i = 0; i < 20; ++i) {  // at every stage of the first one's way
        effects.set_organ(flat, {});
        for (int n = 0; n < i; ++n) effects.seek(time);
        effects.set_organ(other, elsewhere);
        if (i % 2 == 0) come(effects);
    }
    come(effects);
    EXPECT_EQ(tissue(effects), tissue(direct));
}

TEST_F(SetOrganTest, APlateComesAndGoes) {
    scene.reference.file = "clip.avi";
    scene.plate.use = true;
    const auto plate = prepare_organ(scene, preset.vessels);
    ASSERT_NE(plate, nullptr);
    Effects effects = made(other, elsewhere), of_plate = made(plate, {}), of_other = made(other, elsewhere);
    const Picture before = tissue(effects);
    effects.set_organ(plate);
    come(effects);
    EXPECT_EQ(tissue(effects), tissue(of_plate));
    EXPECT_NE(tissue(effects), before);
    effects.set_organ(other, elsewhere);
    come(effects);
    EXPECT_EQ(tissue(effects), tissue(of_other));
    EXPECT_EQ(tissue(effects), before);
}

/// Buffers and textures of the context.
int live_names() {
    int live = 0;
    for (GLuint name = 1; name < 4096; ++name) live += glIsBuffer(name) + glIsTexture(name);
    return live;
}

/// `big` has textures for several frames, so that some of it is on the GPU when it does not come any more.
TEST_F(SetOrganTest, OfAnOrganThatWasReplacedOnItsWayNothingStays) {
    Organ wide = load_organ(folder / "sheet.obj");
    wide.images = {{.width = 2048, .height = 2048, .pixels = blank({2048, 2048}), .name = "a"},
                   {.width = 1024, .height = 1024, .pixels = blank({1024, 1024}), .name = "b"}};
    wide.materials[0].base_color_image = 0;
    wide.materials[0].normal_image = 1;
    const auto big = prepare_organ(wide, preset.vessels);
    Effects direct = made(other, elsewhere);
    const Picture wanted = tissue(direct);
    Effects effects = made(other, elsewhere);
    const int few = live_names();
    int on_the_way = 0;
    for (int stage = 0; stage < 10; ++stage) {
        effects.set_organ(big);
        EXPECT_TRUE(test::wait_until([&] { return live_names() > few; }, [&] { effects.seek(time); }));
        for (int i = 0; i < stage; ++i) effects.seek(time);
        on_the_way += effects.organ_coming() ? 1 : 0;
        effects.set_organ(other, elsewhere);
        come(effects);
        for (int i = 0; i < 8; ++i) effects.seek(time);  // what is gone is freed a part at a time
        EXPECT_EQ(live_names(), few) << "stage " << stage;
        EXPECT_EQ(tissue(effects), wanted);
    }
    EXPECT_GE(on_the_way, 4);
    EXPECT_LT(on_the_way, 10) << "it has come at a later stage";
}

TEST_F(SetOrganTest, EffectsMayEndWhileItComes) {
    const int none = live_names();
    for (int seeks = 0; seeks < 30; ++seeks) {
        Effects effects = made(flat, scene.events);
        effects.set_organ(other, elsewhere);
        const int few = live_names();
        if (seeks > 6) {  // before that the other thread has it
            EXPECT_TRUE(test::wait_until([&] { return live_names() > few; }, [&] { effects.seek(time); }));
        }
        for (int i = 0; i < seeks; ++i) effects.seek(time);
        Effects moved = std::move(effects);
        moved.seek(time);
    }
    EXPECT_EQ(live_names(), none);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

/// The bytes of all levels.
std::vector<Image> levels_of(GLuint texture, glm::ivec2 whole) {
    std::vector<Image> levels;
    for (int level = 0; level < gl::level_count(whole); ++level) {
        const glm::ivec2 at = glm::max(whole >> level, 1);
        levels.push_back({.width = at.x,
                          .height = at.y,
                          .pixels = std::vector<std::uint8_t>(std::size_t{4} * at.x * at.y),
                          .name = ""});
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(texture, level, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(levels.back().pixels.size()),
                          levels.back().pixels.data());
    }
    return levels;
}

TEST_F(SetOrganTest, ATextureThatIsSentInPartsIsWhole) {
    const organ::PixelList& pixels = PreparedOrganAccess::state(*other).foundation->pixels;
    const Organ& organ = other->organ();
    for (const std::size_t bytes : {std::size_t{1}, std::size_t{4} * 1023, std::size_t{1000000}}) {
        const organ::TextureLevels levels = organ::texture_levels(organ, pixels, {.image = 0, .color = true});
        render::OrganTextures textures;
        int parts = 1;
        while (textures.send({&levels, 1}, bytes)) ++parts;
        if (bytes == 1000000) {
            EXPECT_EQ(parts, 5);  // 3.8 MB, and storage
        }
        const auto sent = levels_of(textures.find(0, true), {1023, 700});
        ASSERT_EQ(sent.size(), levels.count());
        for (std::size_t i = 0; i < sent.size(); ++i) {
            EXPECT_EQ(sent[i].width, levels.level(i).width);
            EXPECT_TRUE(sent[i].pixels == levels.level(i).pixels) << i;
        }
        EXPECT_EQ(textures.find(0, false), 0U);
        EXPECT_EQ(textures.find(1, true), 0U);
    }
}

/// Each level as the mean of the four above, without rounding; of light for a colour.
std::vector<std::vector<double>> exact_levels(const Image& image, bool color) {
    const auto light = [&](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    const auto encoded = [&](double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055; };
    std::vector<double> above;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double value = image.pixels[i] / 255.0;
        above.push_back(color && i % 4 != 3 ? light(value) : value);
    }
    std::vector<std::vector<double>> levels;
    for (int width = image.width, height = image.height; width > 1 && height > 1; width /= 2, height /= 2) {
        std::vector<double> half;
        for (int y = 0; y + 1 < height; y += 2)
            for (int x = 0; x + 1 < width; x += 2)
                for (int k = 0; k < 4; ++k) {
                    const auto at = [&](int dx, int dy) { return above[((y + dy) * width + x + dx) * 4 + k]; };
                    half.push_back((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4.0);
                }
        levels.emplace_back();
        for (std::size_t i = 0; i < half.size(); ++i)
            levels.back().push_back(255.0 * (color && i % 4 != 3 ? encoded(half[i]) : half[i]));
        above = half;
    }
    return levels;
}

double mean_error(const std::vector<double>& exact, const std::vector<std::uint8_t>& found) {
    double sum = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) sum += std::abs(exact[i] - found[i]);
    return sum / static_cast<double>(exact.size());
}

/// Some drivers round each level down: half a value of a normal map for every level.
TEST_F(SetOrganTest, LevelsAreNearerToTheTrueOnesThanTheDrivers) {
    const glm::ivec2 whole(64, 64);
    Image noise{.width = whole.x, .height = whole.y, .pixels = blank(whole), .name = ""};
    std::mt19937 random{5};
    for (std::uint8_t& value : noise.pixels) value = static_cast<std::uint8_t>(random() >> 24);
    for (const bool color : {true, false}) {
        const gl::Texture texture({.size = whole,
                                   .format = static_cast<GLenum>(color ? GL_SRGB8_ALPHA8 : GL_RGBA8),
                                   .levels = gl::level_count(whole)});
        texture.upload(GL_RGBA, noise.pixels.data());
        texture.generate_mipmaps();
        const std::vector<Image> of_driver = levels_of(texture.name(), whole),
                                 own = organ::smaller_levels(noise, color);
        const std::vector<std::vector<double>> exact = exact_levels(noise, color);
        ASSERT_EQ(of_driver.size(), own.size() + 1);
        ASSERT_EQ(exact.size(), own.size());
        for (std::size_t i = 0; i < own.size(); ++i) {
            const double error = mean_error(exact[i], own[i].pixels),
                         of_drivers = mean_error(exact[i], of_driver[i + 1].pixels);
            EXPECT_LE(error, of_drivers + 0.02) << "level " << i + 1;
            EXPECT_LE(of_drivers, 4.0) << "level " << i + 1;  // it is the same picture
            for (std::size_t k = 0; k < exact[i].size(); ++k)
                EXPECT_NEAR(exact[i][k], own[i].pixels[k], 0.53) << "level " << i + 1 << ", byte " << k;
        }
    }
}

}  // namespace
}  // namespace lapfx
