#include "ui/paint/painter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <glm/gtc/packing.hpp>

#include "ui/support/count_allocations.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;

constexpr Color red{255, 0, 0, 255}, blue{0, 0, 255, 255};
constexpr Rect whole{0, 0, 200, 100};

/// A painter between start() and finish().
class PainterTest : public testing::Test {
  protected:
    PainterTest() { painter.start({200, 100}); }

    const DrawList& finished() {
        painter.finish(&images);
        return list;
    }
    DrawList picture_of(const std::function<void()>& draw) {
        painter.start({200, 100});
        draw();
        painter.finish(&images);
        return std::move(list);
    }

    DrawList list;
    Fonts fonts{{.hinting = Hinting::none}};
    ImageStore images;
    Painter painter{list, fonts, dark_theme(), 1};
};

Rect rect_of(const Instance& instance) {
    return {instance.x, instance.y, instance.w, instance.h};
}

// --- shapes ---

TEST_F(PainterTest, AFillIsOneInstanceOfTheWholeScreensClip) {
    painter.fill({10, 20, 30, 40}, red, 3.4F);
    const DrawList& drawn = finished();
    ASSERT_EQ(drawn.instances.size(), 1U);
    const Instance& fill = drawn.instances[0];
    EXPECT_EQ(fill.kind, InstanceKind::fill);
    EXPECT_EQ(rect_of(fill), Rect(10, 20, 30, 40));
    EXPECT_EQ(fill.color, red);
    EXPECT_EQ(fill.radius, 3);
    EXPECT_EQ(fill.border, 0);
    EXPECT_EQ(fill.clip, 0);
    EXPECT_THAT(drawn.clips, ElementsAre(whole));
    EXPECT_THAT(drawn.batches, ElementsAre(Batch{.count = 1, .clips = 1}));
}

TEST_F(PainterTest, NothingIsAddedThatCannotBeSeen) {
    painter.fill({10, 10, 10, 10}, {255, 0, 0, 0});
    painter.fill({200, 10, 10, 10}, red);
    painter.fill({10, 10, 0, 10}, red);
    painter.frame({10, -10, 10, 10}, red, 1);
    painter.line({10, -5}, {90, -5}, 6, red);
    painter.shadow({10, 120, 10, 10}, red, 20);
    painter.image({10, 10, 10, 10}, 0);
    painter.gradient({-10, 10, 10, 10}, red, blue, true);
    painter.checker({10, 100, 10, 10}, red, blue, 4);
    painter.icon({10, 10, 14, 14}, Icon::none, red);
    painter.icon({300, 10, 14, 14}, Icon::check, red);
    painter.text({10, 100, 100, 20}, "below", painter.text_style(), red);
    EXPECT_TRUE(finished().instances.empty());
    EXPECT_TRUE(list.batches.empty());
}

TEST_F(PainterTest, WhatReachesIntoTheClipByItsWidthOrSoftnessIsDrawn) {
    painter.line({10, -2}, {90, -2}, 6, red);
    painter.shadow({10, 110, 10, 10}, red, 20);
    ASSERT_EQ(finished().instances.size(), 2U);
    EXPECT_EQ(list.instances[0].uv[0], 6 * 64);
    EXPECT_EQ(list.instances[1].uv[0], 20);
}

TEST_F(PainterTest, AFrameThatFillsItsRectangleIsAFill) {
    painter.frame({10, 10, 30, 4}, red, 2);
    ASSERT_EQ(finished().instances.size(), 1U);
    EXPECT_EQ(list.instances[0].border, 0);
}

TEST_F(PainterTest, ALargeSharpFrameIsFourBarsThatDoNotOverlap) {
    const Rect rect{10, 10, 150, 80};
    painter.frame(rect, {255, 0, 0, 128}, 2.4F);
    ASSERT_EQ(finished().instances.size(), 4U);
    float area = 0;
    for (const Instance& bar : list.instances) {
        EXPECT_EQ(bar.border, 0);
        EXPECT_EQ(intersect(rect_of(bar), rect), rect_of(bar));
        area += bar.w * bar.h;
        for (const Instance& other : list.instances) {
            EXPECT_TRUE(&bar == &other || !rect_of(bar).overlaps(rect_of(other)));
        }
    }
    EXPECT_EQ(area, 150 * 80 - 146 * 76);
}

TEST_F(PainterTest, AFrameRightAfterItsFillBecomesPartOfIt) {
    painter.fill({10, 10, 30, 20}, red, 4);
    painter.frame({10, 10, 30, 20}, blue, 1, 4);
    ASSERT_EQ(finished().instances.size(), 1U);
    const Instance& both = list.instances[0];
    EXPECT_EQ(both.color, blue);
    EXPECT_EQ(both.border, 1);
    EXPECT_EQ(both.uv[0], 0x00ff);
    EXPECT_EQ(both.uv[1], 0xff00);
    EXPECT_EQ(both.uv[2], 1);
}

TEST_F(PainterTest, AFrameOfAnotherRectangleRadiusOrClipStandsForItself) {
    painter.fill({10, 10, 30, 20}, red, 4);
    painter.frame({10, 10, 30, 21}, blue, 1, 4);
    painter.fill({10, 10, 30, 20}, red, 4);
    painter.frame({10, 10, 30, 20}, blue, 1, 3);
    painter.fill({10, 10, 30, 20}, red, 4);
    painter.push_clip({0, 0, 30, 30});
    painter.frame({10, 10, 30, 20}, blue, 1, 4);
    painter.pop_clip();
    EXPECT_EQ(finished().instances.size(), 6U);
}

TEST_F(PainterTest, ColoursAndFiguresArePackedAsTheDrawListSays) {
    painter.gradient({0, 0, 10, 10}, red, {1, 2, 3, 4}, true);
    painter.checker({0, 0, 10, 10}, red, {1, 2, 3, 4}, 8);
    finished();
    EXPECT_THAT(list.instances[0].uv, ElementsAre(0x0201, 0x0403, 1, 0));
    EXPECT_THAT(list.instances[1].uv, ElementsAre(8, 0, 0x0201, 0x0403));
}

TEST_F(PainterTest, CompareIsPackedAsThePainterSays) {
    const ImageHandle own = images.add({1, 1}, std::vector<std::uint8_t>(4));
    painter.compare(
        {0, 0, 10, 10}, 7, own,
        {.mode = CompareMode::onion, .position = 0.25F, .angle = -1.5707963F, .gain = 4, .mix = 1, .nearest = true});
    finished();
    const Instance& compare = list.instances[0];
    EXPECT_EQ(compare.uv[0], 16384);
    EXPECT_EQ(compare.uv[1], 49152);
    EXPECT_EQ(compare.uv[2], glm::packHalf1x16(4));
    EXPECT_EQ(compare.uv[3], 65535);
    EXPECT_EQ(compare.radius, static_cast<int>(CompareMode::onion));
    EXPECT_EQ(compare.border, 1 | 2) << "nearest, and the host's texture upside down";
}

// --- clips and batches ---

TEST_F(PainterTest, ClipsAreCutToTheOneAroundAndShareOneTable) {
    painter.fill({0, 0, 10, 10}, red);
    painter.push_clip({-10, 20, 50, 500});
    EXPECT_EQ(painter.clip(), Rect(0, 20, 40, 80));
    painter.fill({0, 20, 10, 10}, red);
    painter.push_clip({0, 0, 1000, 1000});  // larger than everything
    painter.fill({0, 30, 10, 10}, red);
    painter.pop_clip();
    painter.pop_clip();
    painter.fill({0, 0, 10, 10}, blue);
    finished();
    EXPECT_THAT(list.clips, ElementsAre(whole, Rect(0, 20, 40, 80)));
    const std::vector<int> used{list.instances[0].clip, list.instances[1].clip, list.instances[2].clip,
                                list.instances[3].clip};
    EXPECT_THAT(used, ElementsAre(0, 1, 1, 0));
    EXPECT_EQ(list.batches.size(), 1U);
}

TEST_F(PainterTest, AnEmptyClipHidesAll) {
    painter.push_clip({50, 50, 10, 10});
    painter.push_clip({0, 0, 10, 10});
    painter.fill(whole, red);
    painter.text(whole, "text", painter.text_style(), red);
    painter.pop_clip();
    painter.pop_clip();
    EXPECT_TRUE(finished().instances.empty());
}

TEST_F(PainterTest, ABatchTakes256ClipsAndTheNextBeginsItsTableAnew) {
    for (int i = 0; i < 300; ++i) {
        const auto row = static_cast<float>(i % 100), column = static_cast<float>(i / 100);
        painter.push_clip({column, row, 1, 1});
        painter.fill(whole, red);
        painter.pop_clip();
    }
    painter.fill(whole, blue);
    finished();
    EXPECT_THAT(list.batches, ElementsAre(Batch{.count = 256, .clips = 256},
                                          Batch{.first = 256, .count = 45, .first_clip = 256, .clips = 45}));
    EXPECT_EQ(list.instances[255].clip, 255);
    EXPECT_EQ(list.instances[256].clip, 0);
    EXPECT_EQ(list.clips[256], Rect(2, 56, 1, 1));
    EXPECT_EQ(list.clips[256 + list.instances[300].clip], whole);
}

TEST_F(PainterTest, OnlyOtherImagesEndABatch) {
    painter.fill({0, 0, 10, 10}, red);
    painter.image({0, 0, 10, 10}, 3);
    painter.fill({0, 0, 10, 10}, red);
    painter.image({10, 0, 10, 10}, 3);
    painter.compare({20, 0, 10, 10}, 3, 4, {});
    painter.image({30, 0, 10, 10}, 5);
    painter.fill({0, 0, 10, 10}, red);
    painter.compare({20, 0, 10, 10}, 5, 3, {});
    painter.compare({20, 0, 10, 10}, 5, 4, {});
    finished();
    EXPECT_THAT(list.batches,
                ElementsAre(Batch{.count = 5, .clips = 1, .images = {3, 4}},
                            Batch{.first = 5, .count = 3, .first_clip = 1, .clips = 1, .images = {5, 3}},
                            Batch{.first = 8, .count = 1, .first_clip = 2, .clips = 1, .images = {5, 4}}));
}

// --- text ---

TEST_F(PainterTest, GlyphsStandOnWholePixelsWithTheColourAndTheClip) {
    painter.fill({0, 0, 1, 1}, blue);
    painter.push_clip({0, 0, 150, 90});
    const auto& run = fonts.run("Speed", painter.text_style());
    painter.run(run, {20.4F, 50.6F}, red);
    painter.pop_clip();
    finished();
    ASSERT_EQ(list.instances.size(), 1 + run.glyphs.size());
    for (std::size_t i = 0; i < run.glyphs.size(); ++i) {
        const Instance& glyph = list.instances[i + 1];
        EXPECT_EQ(glyph.x, run.glyphs[i].x + 20);
        EXPECT_EQ(glyph.y, run.glyphs[i].y + 51);
        EXPECT_EQ(glyph.w, run.glyphs[i].w);
        EXPECT_EQ(glyph.color, red);
        EXPECT_EQ(glyph.clip, 1);
        EXPECT_EQ(glyph.kind, InstanceKind::glyph);
        EXPECT_EQ(glyph.uv[0], run.glyphs[i].uv[0]);
    }
}

TEST_F(PainterTest, GlyphsOutsideTheClipAreLeftOut) {
    const auto& run = fonts.run("mmmmmmmmmm", painter.text_style());
    painter.push_clip({50, 0, 20, 100});
    painter.run(run, {0, 50}, red);
    painter.run(run, {0, 150}, red);
    painter.pop_clip();
    finished();
    EXPECT_LE(list.instances.size(), 4U);
    EXPECT_GE(list.instances.size(), 2U);
    for (const Instance& glyph : list.instances) EXPECT_TRUE(rect_of(glyph).overlaps({50, 0, 20, 100}));
}

TEST_F(PainterTest, TextIsCentredUprightByItsMetricsAndAlignedAsAsked) {
    const TextStyle style = painter.text_style();
    const auto& run = fonts.run("Align", style);
    const LineMetrics metrics = fonts.metrics(style);
    const float baseline = 30 + std::floor((40 - metrics.ascent - metrics.descent) / 2 + 0.5F) + metrics.ascent;
    for (const Align align : {Align::start, Align::center, Align::end}) {
        EXPECT_EQ(painter.text({10, 30, 120, 40}, "Align", style, red, align), run.width);
    }
    finished();
    ASSERT_EQ(list.instances.size(), 3 * run.glyphs.size());
    const float lefts[] = {10, 10 + (120 - run.width) / 2, 10 + 120 - run.width};
    for (std::size_t i = 0; i < 3; ++i) {
        const Instance& glyph = list.instances[i * run.glyphs.size()];
        EXPECT_EQ(glyph.y, baseline + run.glyphs[0].y);
        EXPECT_NEAR(glyph.x, lefts[i] + run.glyphs[0].x, 0.5F);
        EXPECT_EQ(glyph.x, std::floor(glyph.x));
    }
}

TEST_F(PainterTest, TextThatIsTooLongEndsInAnEllipsisWithinItsRectangle) {
    const TextStyle style = painter.text_style();
    const float width = fonts.run("Droplet ", style).width + fonts.run("\u2026", style).width + 0.5F;
    const float drawn = painter.text({10, 10, width, 20}, "Droplet speed", style, red);
    EXPECT_NEAR(drawn, fonts.run("Droplet\u2026", style).width, 1e-4) << "no space before the dots";
    EXPECT_LE(drawn, width);
    finished();
    EXPECT_EQ(list.instances.size(), 8U);
    EXPECT_EQ(list.instances.back().uv[0], fonts.run("Droplet\u2026", style).glyphs.back().uv[0]);
}

TEST_F(PainterTest, TextThatJustFitsIsNotCut) {
    const TextStyle style = painter.text_style();
    const float width = fonts.run("Droplet", style).width;
    EXPECT_EQ(painter.text({10, 10, width, 20}, "Droplet", style, red), width);
    EXPECT_EQ(painter.text({10, 10, std::floor(width), 20}, "Droplet", style, red) == width,
              width - std::floor(width) <= 0.5F);
    EXPECT_LT(painter.text({10, 10, width - 1, 20}, "Droplet", style, red), width);
    EXPECT_EQ(painter.text({10, 10, 2, 20}, "Droplet", style, red), 0) << "no room for the dots";
}

TEST_F(PainterTest, SizesAreWholePixelsAtEveryScale) {
    const Painter large(list, fonts, dark_theme(), 1.25F);
    EXPECT_EQ(painter.em(1), 14);
    EXPECT_EQ(large.em(1), 18);
    EXPECT_EQ(large.text_style().size, 18);
    EXPECT_EQ(large.text_style(0.5F, Weight::bold), (TextStyle{.size = 9, .weight = Weight::bold}));
    EXPECT_TRUE(large.number_style().tabular);
}

// --- icons ---

TEST_F(PainterTest, EveryIconHasADrawingOfItsOwnInsideItsSquare) {
    std::vector<DrawList> pictures;
    const int count = static_cast<int>(Icon::sort_down);
    for (int icon = 1; icon <= count; ++icon) {
        for (const float side : {14.0F, 18.0F, 28.0F}) {
            const Rect square{20, 20, side, side};
            pictures.push_back(picture_of([&] { painter.icon(square, static_cast<Icon>(icon), red); }));
            const DrawList& picture = pictures.back();
            ASSERT_FALSE(picture.instances.empty()) << icon;
            for (std::size_t other = 0; other + 1 < pictures.size(); ++other)
                EXPECT_FALSE(same_picture(pictures[other], picture)) << icon << " looks like another";
            for (const Instance& part : picture.instances) {
                const bool line = part.kind == InstanceKind::line;
                const glm::vec2 low(line ? std::min(part.x, part.w) : part.x, line ? std::min(part.y, part.h) : part.y);
                const glm::vec2 high(line ? std::max(part.x, part.w) : part.x + part.w,
                                     line ? std::max(part.y, part.h) : part.y + part.h);
                EXPECT_GE(std::min(low.x, low.y), 20) << icon;
                EXPECT_LE(std::max(high.x, high.y), 20 + side) << icon;
            }
        }
    }
    EXPECT_EQ(pictures.size(), static_cast<std::size_t>(3 * count));
}

TEST_F(PainterTest, UprightAndLevelStrokesOfIconsLieBetweenPixels) {
    for (const float side : {14.0F, 18.0F, 28.0F, 31.0F}) {
        painter.start({200, 100});
        painter.icon({3.3F, 4.6F, side, side + 8}, Icon::plus, red);
        finished();
        ASSERT_EQ(list.instances.size(), 2U);
        const Instance &level = list.instances[0], &upright = list.instances[1];
        const float half = static_cast<float>(level.uv[0]) / 128;
        EXPECT_EQ(level.y, level.h);
        EXPECT_EQ(level.y - half, std::floor(level.y - half));
        EXPECT_EQ(upright.x, upright.w);
        EXPECT_EQ(upright.x + half, std::floor(upright.x + half));
        EXPECT_EQ(half, std::round(0.09F * side) / 2);
    }
}

// --- the whole frame ---

TEST_F(PainterTest, ClearsAreOpaqueAndKeptInOrder) {
    painter.clear({0, 0, 10, 10}, {1, 2, 3, 4});
    painter.clear({5, 5, 10, 10}, red);
    EXPECT_THAT(finished().clears, ElementsAre(Clear{{0, 0, 10, 10}, {1, 2, 3, 255}}, Clear{{5, 5, 10, 10}, red}));
}

TEST_F(PainterTest, AGroundIsClearedOnlyWhereNothingIsUnderIt) {
    painter.push_clip({0, 0, 20, 20});
    painter.begin_node(true);
    painter.ground({10, 10, 50, 50}, red);
    EXPECT_THAT(list.clears, ElementsAre(Clear{{10, 10, 10, 10}, red})) << "within the clip";
    EXPECT_TRUE(list.instances.empty());
    painter.begin_node(false);
    painter.ground({10, 10, 50, 50}, red);
    EXPECT_EQ(list.clears.size(), 1U);
    EXPECT_EQ(list.instances.size(), 1U);
    painter.pop_clip();
    finished();
}

TEST_F(PainterTest, ThePictureIsTheSameWhenItIsDrawnTheSame) {
    const auto draw = [&] {
        painter.clear(whole, blue);
        painter.text(whole, "the same", painter.text_style(), red);
        painter.fill({1, 2, 3, 4}, red);
    };
    const DrawList first = picture_of(draw);
    EXPECT_TRUE(same_picture(picture_of(draw), first));
    EXPECT_FALSE(same_picture(picture_of([] {}), first));
}

TEST_F(PainterTest, EveryFieldOfEveryPartMakesAnotherPicture) {
    const auto draw = [&] {
        painter.clear(whole, blue);
        for (int i = 0; i < 9; ++i) painter.fill({static_cast<float>(i), 2, 30, 4}, red, 2);
        painter.image({0, 0, 10, 10}, 3);
    };
    const DrawList first = picture_of(draw);
    DrawList other = picture_of(draw);
    const auto turn_bits = [&](void* of, std::size_t bytes) {
        auto* at = static_cast<unsigned char*>(of);
        for (std::size_t bit = 0; bit < 8 * bytes; ++bit) {
            at[bit / 8] = static_cast<unsigned char>(at[bit / 8] ^ 1U << bit % 8);
            EXPECT_FALSE(same_picture(first, other)) << bit;
            at[bit / 8] = static_cast<unsigned char>(at[bit / 8] ^ 1U << bit % 8);
        }
        EXPECT_TRUE(same_picture(first, other));
    };
    turn_bits(&other.instances[0], sizeof(Instance));
    turn_bits(&other.instances[4], sizeof(Instance));
    turn_bits(&other.clips[0], sizeof(float) - 1);  // the sign of a zero does not change the picture
    turn_bits(&other.clears[0].color, sizeof(Color));
    turn_bits(&other.batches[0], sizeof(Batch));
    turn_bits(&other.size, sizeof(other.size));
    turn_bits(&other.serials[0], sizeof(std::uint32_t));
}

TEST_F(PainterTest, ChangedPixelsOfAShownImageMakeAnotherPictureAndOthersDoNot) {
    const std::vector<std::uint8_t> pixel(4, 9);
    const ImageHandle shown = images.add({1, 1}, pixel), hidden = images.add({1, 1}, pixel);
    const auto draw = [&] { painter.image({0, 0, 10, 10}, shown); };
    const DrawList first = picture_of(draw);
    images.update(hidden, {1, 1}, pixel);
    EXPECT_TRUE(same_picture(picture_of(draw), first));
    images.update(shown, {1, 1}, pixel);
    EXPECT_FALSE(same_picture(picture_of(draw), first));
}

TEST_F(PainterTest, NewGlyphsInTheAtlasMakeAnotherPicture) {
    const DrawList first = picture_of([] {});
    fonts.run("never seen", {.size = 33});
    EXPECT_FALSE(same_picture(picture_of([] {}), first));
}

TEST_F(PainterTest, ASteadyFrameAllocatesNothing) {
    const ImageHandle image = images.add({1, 1}, std::vector<std::uint8_t>(4));
    const auto frame = [&] {
        painter.start({200, 100});
        painter.clear(whole, blue);
        for (int i = 0; i < 400; ++i) {
            painter.push_clip({static_cast<float>(i % 50), 0, 100, 50});
            painter.fill({60, 0, 20, 20}, red, 2);
            painter.frame({60, 0, 20, 20}, blue, 1, 2);
            painter.text({60, 0, 40, 20}, "A text that is cut off", painter.text_style(), red);
            painter.icon({60, 0, 20, 20}, Icon::gear, red);
            painter.pop_clip();
        }
        painter.image({0, 0, 10, 10}, image);
        painter.finish(&images);
    };
    frame();
    frame();
    const std::size_t before = lapfx::test::allocations_so_far();
    for (int i = 0; i < 10; ++i) frame();
    EXPECT_EQ(lapfx::test::allocations_so_far(), before);
    EXPECT_GT(list.batches.size(), 1U);
}

}  // namespace
}  // namespace lapfx::ui
