#include "ui/canvas/scope.h"

#include <gmock/gmock.h>

#include <numeric>
#include <random>

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

TEST(LumaChroma, IsThatOfKeying) {
    // effects/smoke/keying.h: luma 0.299 0.587 0.114, (b - y) / 1.772 and (r - y) / 1.402.
    for (const glm::vec3 code : {glm::vec3(0, 255, 0), glm::vec3(12, 99, 240), glm::vec3(255, 255, 255)}) {
        const float y = glm::dot(code, glm::vec3(0.299F, 0.587F, 0.114F));
        const glm::vec3 got = luma_chroma(code);
        EXPECT_NEAR(got.x, y, 1e-3);
        EXPECT_NEAR(got.y, (code.b - y) / 1.772F, 1e-3);
        EXPECT_NEAR(got.z, (code.r - y) / 1.402F, 1e-3);
    }
    EXPECT_NEAR(luma_chroma({0, 0, 255}).y, 127.5, 1e-3);
    EXPECT_NEAR(luma_chroma({255, 0, 0}).z, 127.5, 1e-3);
}

TEST(LumaChroma, GoesThereAndBack) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> code(0, 255);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 rgb(code(random), code(random), code(random));
        EXPECT_LT(glm::distance(rgb_of(luma_chroma(rgb)), rgb), 1e-3F);
    }
}

std::uint32_t sum(const DensityGrid& grid) {
    return std::accumulate(grid.counts.begin(), grid.counts.end(), 0U);
}

TEST(CountChroma, PutsGreyInTheMiddleAndColoursWhereTheyBelong) {
    const std::uint8_t rgb[] = {90, 90, 90, 0, 0, 0, 0, 0, 255, 255, 0, 0};
    DensityGrid grid;
    count_chroma({.bytes = rgb, .size = {2, 2}}, grid);
    EXPECT_EQ(sum(grid), 4U);
    EXPECT_EQ(grid.at(128, 128), 2U);
    // Blue: Cb 127.5 rounds beyond the last column, Cr (0 - 29.07) / 1.402 = -20.7.
    EXPECT_EQ(grid.at(255, 149), 1U);
    // Red: Cr 127.5, Cb (0 - 76.2) / 1.772 = -43.0.
    EXPECT_EQ(grid.at(85, 0), 1U);
}

TEST(CountChroma, TakesFourChannelsAndSkips) {
    std::vector<std::uint8_t> rgba(10 * 6 * 4, 77);
    DensityGrid grid;
    count_chroma({.bytes = rgba, .size = {10, 6}, .channels = 4}, grid);
    EXPECT_EQ(grid.at(128, 128), 60U);
    count_chroma({.bytes = rgba, .size = {10, 6}, .channels = 4, .every = 4}, grid);
    EXPECT_EQ(sum(grid), 6U) << "columns 0, 4, 8 of rows 0 and 4; counted anew";
    EXPECT_THROW(count_chroma({.bytes = rgba, .size = {10, 7}, .channels = 4}, grid), std::invalid_argument);
    EXPECT_THROW(count_chroma({.bytes = rgba, .size = {10, 6}, .channels = 1}, grid), std::invalid_argument);
    count_chroma({.bytes = {}, .size = {0, 0}}, grid);
    EXPECT_EQ(sum(grid), 0U);
}

TEST(CountLuma, SpreadsThePictureOverAllColumns) {
    const std::uint8_t rgb[] = {0, 0, 0, 255, 255, 255, 100, 100, 100, 0, 255, 0};
    DensityGrid grid;
    count_luma({.bytes = rgb, .size = {4, 1}}, grid);
    EXPECT_EQ(grid.at(32, 255), 1U);
    EXPECT_EQ(grid.at(96, 0), 1U);
    EXPECT_EQ(grid.at(160, 155), 1U);
    EXPECT_EQ(grid.at(224, 255 - 150), 1U) << "green: 0.587 * 255 = 149.7";
    EXPECT_EQ(sum(grid), 4U);
}

TEST(ShadeChroma, IsBrighterTheMoreAndInTheColoursMeant) {
    DensityGrid grid;
    grid.counts.assign(65536, 0);
    grid.counts[128 * 256 + 128] = 1000;
    grid.counts[128 * 256 + 228] = 1;
    std::vector<std::uint8_t> rgba;
    shade_chroma(grid, rgba);
    ASSERT_EQ(rgba.size(), 65536U * 4);
    const auto pixel = [&](std::size_t x, std::size_t y) { return &rgba[4 * (y * 256 + x)]; };
    EXPECT_EQ(pixel(128, 128)[3], 255);
    EXPECT_EQ(pixel(128, 128)[0], pixel(128, 128)[2]) << "grey";
    EXPECT_GT(pixel(228, 128)[3], 50);
    EXPECT_LT(pixel(228, 128)[3], 120);
    EXPECT_GT(pixel(228, 128)[2], pixel(228, 128)[0]) << "bluish";
    EXPECT_EQ(pixel(0, 0)[3], 0);
}

TEST(ShadeLuma, NothingCountedIsNothingSeen) {
    DensityGrid grid;
    grid.counts.assign(65536, 0);
    std::vector<std::uint8_t> rgba;
    shade_luma(grid, {1, 2, 3, 255}, rgba);
    EXPECT_EQ(rgba[3], 0);
    grid.counts[0] = 3;
    shade_luma(grid, {1, 2, 3, 255}, rgba);
    EXPECT_THAT(std::span(rgba).first(4), testing::ElementsAre(1, 2, 3, 255));
}

TEST(ScopeImage, KeepsOneImageAndGivesItBack) {
    ImageStore store;
    const std::uint8_t rgb[] = {90, 90, 90};
    {
        ScopeImage scope(store);
        EXPECT_EQ(scope.handle(), 0U);
        scope.update_chroma({.bytes = rgb, .size = {1, 1}});
        const ImageHandle handle = scope.handle();
        ASSERT_NE(store.find(handle), nullptr);
        EXPECT_EQ(store.find(handle)->size, glm::ivec2(256));
        const std::uint32_t serial = store.find(handle)->serial;
        scope.update_luma({.bytes = rgb, .size = {1, 1}});
        EXPECT_EQ(scope.handle(), handle);
        EXPECT_NE(store.find(handle)->serial, serial);
    }
    EXPECT_EQ(store.find(own_images), nullptr);
}

/// A square of 512 px, 2 px for each level. The key's Cb and Cr are 0 unless set.
struct Shown {
    KeyCircles key{.color = {128, 128, 128}, .chroma_low = 40, .chroma_high = 80, .reset_low = 10, .reset_high = 90};
    VectorscopeOptions options{.width = px(512), .height = px(512)};
    VectorscopeResult last;
    int began = 0, committed = 0, cancelled = 0;
    bool disabled = false;
    Harness ui{[this](Ui& u) {
                   u.push_disabled(disabled);
                   last = vectorscope(u, "Colours", 9, &key, options);
                   u.pop_disabled();
                   for (const Edit& edit : {last.low, last.high})
                       began += edit.began, committed += edit.committed, cancelled += edit.cancelled;
               },
               {640, 640}};
    float way(std::string_view handle) const { return glm::distance(ui.rect(handle).center(), {256, 256}); }
};

TEST(Vectorscope, GripsLieOnTheirCircles) {
    Shown s;
    EXPECT_NEAR(s.way("Colours/Chroma low"), 80, 1);
    EXPECT_NEAR(s.way("Colours/Chroma high"), 160, 1);
    EXPECT_EQ(s.ui.value("Colours/Chroma low"), 40);
    EXPECT_EQ(s.ui.node("Colours/Chroma low").number->maximum, 79);
    EXPECT_EQ(s.ui.node("Colours/Chroma high").number->minimum, 41);
    s.options.zoom = 2;
    s.ui.frame();
    EXPECT_NEAR(s.way("Colours/Chroma low"), 160, 1);
}

TEST(Vectorscope, AGripDraggedOutwardsWidensItsCircle) {
    Shown s;
    const glm::vec2 way = (s.ui.rect("Colours/Chroma low").center() - glm::vec2(256)) / 80.0F;
    s.ui.drag("Colours/Chroma low", way * 20.0F);
    EXPECT_NEAR(s.key.chroma_low, 50, 0.6);
    s.ui.drag("Colours/Chroma low", way * 400.0F);
    EXPECT_EQ(s.key.chroma_low, 79) << "not past the other";
    s.ui.drag("Colours/Chroma low", way * -400.0F);
    EXPECT_EQ(s.key.chroma_low, 0);
    EXPECT_EQ(s.began, 3);
    EXPECT_EQ(s.committed, 3);
    s.key.chroma_low = 40;
    s.ui.frame().drag("Colours/Chroma high", {-600, -600});
    EXPECT_EQ(s.key.chroma_high, 41);
}

TEST(Vectorscope, KeysResetAndEscapeAsOfAnyHandle) {
    Shown s;
    s.ui.focus("Colours/Chroma high").key(Key::right).key(Key::up, Mods::shift);
    EXPECT_NEAR(s.key.chroma_high, 81.1, 1e-9);
    s.ui.key(Key::backspace);
    EXPECT_EQ(s.key.chroma_high, 90);
    s.ui.press("Colours/Chroma low").drag_by({30, 0}).key(Key::escape);
    EXPECT_EQ(s.key.chroma_low, 40);
    EXPECT_EQ(s.cancelled, 1);
    s.ui.release().click("Colours/Chroma low", {.clicks = 2});
    EXPECT_EQ(s.key.chroma_low, 10);
}

TEST(Vectorscope, GripsStayInTheSquareHoweverFarTheCircleReaches) {
    Shown s;
    s.key.color = {0, 255, 0};
    s.key.chroma_high = 255;
    s.options.zoom = 8;
    s.ui.frame();
    for (const char* grip : {"Colours/Chroma low", "Colours/Chroma high"}) {
        const glm::vec2 at = s.ui.rect(grip).center();
        EXPECT_TRUE((Rect{0, 0, 513, 513}.contains(at))) << grip;
    }
}

TEST(Vectorscope, TellsTheColourUnderThePointer) {
    Shown s;
    s.ui.move({256, 256 - 60});
    EXPECT_TRUE(s.last.over);
    EXPECT_EQ(s.last.chroma, glm::vec2(0, 30));
    EXPECT_EQ(s.ui.text("Colours"), "Cb 0   Cr 30   30 at 90\xC2\xB0");
    s.ui.move({600, 600});
    EXPECT_FALSE(s.last.over);
}

TEST(Vectorscope, TheCellOfGreyLiesOnTheCross) {
    Shown s;
    for (const Instance& each : s.ui.output().list->instances) {
        if (each.kind != InstanceKind::image) continue;
        EXPECT_EQ(each.x + each.w * 128.5F / 256, 256);
        EXPECT_EQ(each.y + each.h * 128.5F / 256, 256);
    }
}

TEST(Vectorscope, DisabledOrWithoutAKeyThereIsNothingToDrag) {
    Shown s;
    s.disabled = true;
    s.ui.frame().drag("Colours/Chroma low", {30, 0});
    EXPECT_EQ(s.key.chroma_low, 40);
    Harness ui([&](Ui& u) { vectorscope(u, "Colours", 9, nullptr); });
    EXPECT_FALSE(ui.exists("Colours/Chroma low"));
}

TEST(Vectorscope, SteadyFramesAndDragsAllocateNothing) {
    Shown s;
    s.ui.press("Colours/Chroma low").drag_by({20, 0});
    const auto steps = [&] {
        for (int i = 0; i < 50; ++i) {
            s.ui.ui().push({.kind = EventKind::pointer, .at = {250 + i % 7, 150}});
            s.ui.frame();
        }
    };
    steps();
    const std::size_t before = lapfx::test::allocations_so_far();
    steps();
    EXPECT_EQ(lapfx::test::allocations_so_far(), before);
    EXPECT_THAT(faults_of(s.ui.ui().tree()), testing::IsEmpty());
}

TEST(Waveform, ReadsOutTheLumaUnderThePointer) {
    Harness ui([](Ui& u) { waveform(u, "Luma", 9, {.width = px(300), .height = px(270)}); });
    // There is half an em above and below: the 256 levels are the 256 px from 7 to 263.
    ui.move({100, 7.5F});
    EXPECT_EQ(ui.text("Luma"), "Y 255");
    ui.move({100, 262.5F});
    EXPECT_EQ(ui.text("Luma"), "Y 0");
    ui.move({100, 163.5F});
    EXPECT_EQ(ui.text("Luma"), "Y 99");
    ui.move({10, 163.5F});
    EXPECT_EQ(ui.text("Luma"), "") << "beside it";
}

}  // namespace
}  // namespace lapfx::ui
