#include "ui/text/fonts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>

#include "ui/support/count_allocations.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {
namespace {

const FontOptions fixed{.hinting = Hinting::slight};  // settings of the host are ignored

class Text : public testing::Test {
  protected:
    Fonts fonts{fixed};

    float width(std::string_view text, const TextStyle& style = {}) { return fonts.run(text, style).width; }
};

struct Picture {
    int width, height;
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(static_cast<std::size_t>(width * height));

    void draw(const Atlas& atlas, const Run& run, int x0, int baseline) {
        for (const Instance& glyph : run.glyphs) {
            for (int y = 0; y < glyph.uv[3] - glyph.uv[1]; ++y) {
                for (int x = 0; x < glyph.uv[2] - glyph.uv[0]; ++x) {
                    const int to_x = x0 + static_cast<int>(glyph.x) + x,
                              to_y = baseline + static_cast<int>(glyph.y) + y;
                    if (to_x < 0 || to_y < 0 || to_x >= width || to_y >= height) continue;
                    std::uint8_t& to = pixels[static_cast<std::size_t>(to_y * width + to_x)];
                    to = std::max(
                        to, atlas.pixels[static_cast<std::size_t>((glyph.uv[1] + y) * atlas.size.x + glyph.uv[0] + x)]);
                }
            }
        }
    }
};

Picture drawn(Fonts& fonts, std::string_view text, const TextStyle& style) {
    const Run& run = fonts.run(text, style);
    const LineMetrics line = fonts.metrics(style);
    Picture picture{static_cast<int>(run.width) + 4, static_cast<int>(line.height) + 4};
    picture.draw(fonts.atlas(), run, 2, static_cast<int>(line.ascent) + 2);
    return picture;
}

bool same(const Run& a, const Run& b) {
    const auto equal = [](const Instance& p, const Instance& q) {
        return p.x == q.x && p.y == q.y && p.w == q.w && p.h == q.h && std::equal(p.uv, p.uv + 4, q.uv);
    };
    const auto equal_stop = [](const CaretStop& p, const CaretStop& q) { return p.byte == q.byte && p.x == q.x; };
    return a.width == b.width && std::ranges::equal(a.stops, b.stops, equal_stop) &&
           std::ranges::equal(a.glyphs, b.glyphs, equal);
}

std::vector<std::uint32_t> bytes_of_stops(const Run& run) {
    std::vector<std::uint32_t> bytes;
    for (const CaretStop& stop : run.stops) bytes.push_back(stop.byte);
    return bytes;
}

TEST_F(Text, WidthsGrowEvenlyWithTheSize) {
    const std::string_view text = "Smoke density, turbulence and wind: 12.5 mm/s";
    const float at_100 = width(text, {.size = 100});
    EXPECT_GT(at_100, 1500);
    for (float size = 8; size < 60; size += 0.25F) {
        EXPECT_NEAR(width(text, {.size = size}) / (at_100 * size / 100), 1, 0.001) << size;
    }
}

TEST_F(Text, SizesAreLimited) {
    EXPECT_EQ(width("a", {.size = -5}), width("a", {.size = 4}));
    EXPECT_EQ(width("a", {.size = 1e9F}), width("a", {.size = 400}));
    EXPECT_EQ(width("a", {.size = std::nanf("")}), width("a", {.size = 4}));
}

TEST_F(Text, TabularDigitsAreEquallyWide) {
    for (const bool monospace : {false, true}) {
        const TextStyle style{.tabular = true, .monospace = monospace};
        const float zero = width("0", style);
        for (const char* digit : {"1", "2", "3", "4", "5", "6", "7", "8", "9"}) EXPECT_EQ(width(digit, style), zero);
        EXPECT_EQ(width("111.11", style), width("888.88", style));
        EXPECT_EQ(width("-7.4", style), width("-1.1", style));
    }
    EXPECT_FLOAT_EQ(width("AV", {.tabular = true}), width("A", {.tabular = true}) + width("V", {.tabular = true}))
        << "kerning would move the digits";
    EXPECT_LT(width("111"), width("888") - 3) << "Inter's own ones are narrow";
}

TEST_F(Text, KernsPairs) {
    EXPECT_LT(width("AV", {.size = 40}), width("A", {.size = 40}) + width("V", {.size = 40}) - 1);
}

TEST_F(Text, DoesNotMakeLigaturesOrArrows) {
    const ui::Run& run = fonts.run("fi->", {});
    EXPECT_EQ(run.glyphs.size(), 4U);
    EXPECT_EQ(bytes_of_stops(run), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST_F(Text, StopsAscendFromTheStartToTheEnd) {
    const std::string_view text = "d\xc3\xa9j\xc3\xa0 vu AVAWA 1.5";
    const ui::Run& run = fonts.run(text, {});
    EXPECT_EQ(run.stops.front().byte, 0U);
    EXPECT_EQ(run.stops.front().x, 0);
    EXPECT_EQ(run.stops.back().byte, text.size());
    EXPECT_EQ(run.stops.back().x, run.width);
    EXPECT_EQ(run.stops.size(), 18U);
    for (std::size_t i = 1; i < run.stops.size(); ++i) {
        EXPECT_GT(run.stops[i].byte, run.stops[i - 1].byte);
        EXPECT_GT(run.stops[i].x, run.stops[i - 1].x);
    }
}

TEST_F(Text, NothingIsARunOfOneStop) {
    const ui::Run& run = fonts.run("", {});
    EXPECT_EQ(bytes_of_stops(run), std::vector<std::uint32_t>{0});
    EXPECT_EQ(run.width, 0);
    EXPECT_TRUE(run.glyphs.empty());
    EXPECT_EQ(run.byte_at(5), 0U);
    EXPECT_EQ(run.bytes_within(5), 0U);
    EXPECT_EQ(run.x_of(3), 0);
}

TEST(Run, FindsStopsByByteAndByPosition) {
    ui::Run run;
    run.stops = {{0, 0}, {1, 10}, {3, 20}, {4, 40}};
    run.width = 40;
    EXPECT_EQ(run.x_of(0), 0);
    EXPECT_EQ(run.x_of(2), 10) << "in the middle of a character";
    EXPECT_EQ(run.x_of(3), 20);
    EXPECT_EQ(run.x_of(99), 40);
    EXPECT_EQ(run.byte_at(-3), 0U);
    EXPECT_EQ(run.byte_at(4.9F), 0U);
    EXPECT_EQ(run.byte_at(5.1F), 1U);
    EXPECT_EQ(run.byte_at(29), 3U);
    EXPECT_EQ(run.byte_at(31), 4U);
    EXPECT_EQ(run.byte_at(1000), 4U);
    EXPECT_EQ(run.bytes_within(-1), 0U);
    EXPECT_EQ(run.bytes_within(9.9F), 0U);
    EXPECT_EQ(run.bytes_within(10), 1U);
    EXPECT_EQ(run.bytes_within(39.9F), 3U);
    EXPECT_EQ(run.bytes_within(40), 4U);
}

TEST_F(Text, ACombiningMarkSharesTheStopOfItsLetter) {
    const ui::Run& run = fonts.run("ae\xcc\x81z", {});  // a, e with U+0301, z
    EXPECT_EQ(bytes_of_stops(run), (std::vector<std::uint32_t>{0, 1, 4, 5}));
    EXPECT_EQ(run.width, width("a\xc3\xa9z")) << "and looks like the letter made in one";
    const ui::Run& lone = fonts.run("\xcc\x81", {});
    EXPECT_EQ(bytes_of_stops(lone), (std::vector<std::uint32_t>{0, 2}));
    // This holds even where a font has the mark, but none has the letter, U+10FFFE.
    const ui::Run& mixed = fonts.run("\xf4\x8f\xbf\xbe\xcc\x81z", {});
    EXPECT_EQ(bytes_of_stops(mixed), (std::vector<std::uint32_t>{0, 6, 7}));
}

TEST_F(Text, MarksStandAboveTheirLetter) {
    const ui::Run& run = fonts.run("x\xcc\x84", {.size = 40});  // x with macron, which does not exist as one code point
    ASSERT_EQ(run.glyphs.size(), 2U);
    const Instance &letter = run.glyphs[0], &mark = run.glyphs[1];
    EXPECT_LT(mark.y + mark.h, letter.y);
    EXPECT_NEAR(mark.x + mark.w / 2, letter.x + letter.w / 2, 1.5);
}

TEST_F(Text, EveryInvalidByteIsAStopAndAReplacement) {
    // A byte that cannot start a character, a sequence cut short, an overlong slash, a surrogate.
    const std::string_view text =
        "a\xff\xe2\x82"
        "b\xc0\xaf\xed\xa0\x80";
    const ui::Run& run = fonts.run(text, {});
    EXPECT_EQ(run.stops.size(), text.size() + 1);
    const float replaced = width("\xef\xbf\xbd");
    EXPECT_NEAR(run.stops[2].x - run.stops[1].x, replaced, 0.01);
    EXPECT_NEAR(run.stops[9].x - run.stops[8].x, replaced, 0.01);
}

TEST_F(Text, ControlCharactersAreShownAndTabsAreSpaces) {
    EXPECT_EQ(width("a\tb"), width("a b"));
    EXPECT_EQ(width("\x01"), width("\xef\xbf\xbd"));
    EXPECT_EQ(width("\n"), width("\xef\xbf\xbd"));
    EXPECT_EQ(width("\xc2\x85"), width("\xef\xbf\xbd"));
    EXPECT_EQ(width(std::string_view("\0", 1)), width("\xef\xbf\xbd"));
}

TEST_F(Text, OtherScriptsComeFromOtherFonts) {
    EXPECT_NE(fonts.file_for(U'a').find("Inter-Regular"), std::string::npos);
    EXPECT_NE(fonts.file_for(U'a', {.weight = Weight::bold}).find("Inter-Bold"), std::string::npos);
    EXPECT_NE(fonts.file_for(U'a', {.weight = Weight::medium}).find("Inter-Medium"), std::string::npos);
    EXPECT_NE(fonts.file_for(U'a', {.monospace = true}).find("DejaVuSansMono.ttf"), std::string::npos);
    EXPECT_NE(fonts.file_for(U'\u0416').find("Inter-Regular"), std::string::npos) << "Cyrillic";
    EXPECT_NE(fonts.file_for(U'\u0531').find("DejaVu"), std::string::npos) << "Armenian";
    EXPECT_EQ(fonts.run("a\xd4\xb1z", {}).glyphs.size(), 3U);
    EXPECT_EQ(fonts.file_for(U'\U0010fffe'), "");
}

TEST_F(Text, WhatNoFontHasIsABoxWithItsNumber) {
    const std::string_view first = "\xf4\x8f\xbf\xbe", second = "\xf4\x8f\xbf\xbd";  // U+10FFFE and U+10FFFD
    const ui::Run& run = fonts.run(first, {});
    ASSERT_EQ(run.glyphs.size(), 1U);
    EXPECT_EQ(run.glyphs[0].w, 15);  // three digits of 3 px, 1 px around each, 1 px of frame
    EXPECT_EQ(run.glyphs[0].h, 15);
    EXPECT_EQ(bytes_of_stops(run), (std::vector<std::uint32_t>{0, 4}));
    EXPECT_GE(run.width, 17);
    EXPECT_EQ(fonts.run("\xf4\x8f\xbf\xbe\xef\xb8\x8f", {}).glyphs.size(), 1U) << "a variation selector is never seen";
    EXPECT_NE(drawn(fonts, first, {}).pixels, drawn(fonts, second, {}).pixels);

    // The first digit is a 1: its middle column is set from top to bottom.
    const Picture picture = drawn(fonts, first, {});
    const int x = 2 + static_cast<int>(run.glyphs[0].x) + 3;
    const int y = 2 + static_cast<int>(fonts.metrics({}).ascent) + static_cast<int>(run.glyphs[0].y) + 2;
    for (int i = 0; i < 5; ++i) EXPECT_EQ(picture.pixels[static_cast<std::size_t>((y + i) * picture.width + x)], 255);
    EXPECT_EQ(picture.pixels[static_cast<std::size_t>((y + 1) * picture.width + x + 1)], 0);
}

TEST_F(Text, MetricsAreWholePixels) {
    for (const float size : {9.25F, 14.0F, 17.5F, 33.0F}) {
        const LineMetrics m = fonts.metrics({.size = size});
        EXPECT_EQ(m.ascent, std::round(m.ascent));
        EXPECT_EQ(m.descent, std::round(m.descent));
        EXPECT_GE(m.height, m.ascent + m.descent);
        EXPECT_NEAR(m.ascent, size * 0.96875F, 0.51F);  // 1984 of 2048 units in Inter
    }
}

TEST_F(Text, GlyphsStandOnWholePixelsAndStemsAreSharp) {
    const ui::Run& run = fonts.run("HIE", {.size = 28});
    for (const Instance& glyph : run.glyphs) {
        EXPECT_EQ(glyph.x, std::round(glyph.x));
        EXPECT_EQ(glyph.y, std::round(glyph.y));
        EXPECT_EQ(glyph.y + glyph.h, 0) << "capitals end exactly on the baseline";
        EXPECT_EQ(glyph.kind, InstanceKind::glyph);
        EXPECT_EQ(glyph.uv[2] - glyph.uv[0], glyph.w);
        EXPECT_EQ(glyph.uv[3] - glyph.uv[1], glyph.h);
    }
}

TEST_F(Text, SmallLettersAreDrawnAtQuartersOfAPixel) {
    const auto pictures = [&](float size) {
        std::set<std::uint32_t> different;
        for (const Instance& glyph : fonts.run("iiiiiiiiiiiiiiii", {.size = size}).glyphs) {
            different.insert(glyph.uv[0] << 16U | glyph.uv[1]);
        }
        return different.size();
    };
    EXPECT_EQ(pictures(13), 4U);
    EXPECT_EQ(pictures(24), 1U);
}

TEST_F(Text, SmallLettersAreEvenlySpaced) {
    const ui::Run& run = fonts.run("llllllllllll", {.size = 13});
    const Atlas& atlas = fonts.atlas();
    std::vector<float> centers;
    for (const Instance& glyph : run.glyphs) {
        float sum = 0, moment = 0;
        for (int x = glyph.uv[0]; x < glyph.uv[2]; ++x) {
            const float coverage = atlas.pixels[static_cast<std::size_t>((glyph.uv[1] + 4) * atlas.size.x + x)];
            sum += coverage;
            moment += coverage * (glyph.x + static_cast<float>(x - glyph.uv[0]));
        }
        centers.push_back(moment / sum);
    }
    ASSERT_EQ(centers.size(), 12U);
    for (std::size_t i = 0; i < centers.size(); ++i) {
        EXPECT_NEAR(centers[i] - centers[0], run.stops[i].x, 0.26) << i;  // twice the rounding to quarters of a px
    }
}

TEST(Hints, ChangeThePicture) {
    Fonts none({.hinting = Hinting::none}), slight({.hinting = Hinting::slight});
    EXPECT_NE(drawn(none, "Smoke", {.size = 13}).pixels, drawn(slight, "Smoke", {.size = 13}).pixels);
    EXPECT_EQ(none.run("Smoke", {.size = 13}).width, slight.run("Smoke", {.size = 13}).width);
}

TEST(Fonts, AreTheSameEveryTime) {
    Fonts first(fixed), second(fixed);
    for (const char* text : {"Smoke 12.5", "d\xc3\xa9j\xc3\xa0 vu", "\xd0\x96 \xe4\xb8\xad"}) {
        EXPECT_TRUE(same(first.run(text, {}), second.run(text, {})));
    }
    EXPECT_EQ(first.atlas().pixels, second.atlas().pixels);
}

TEST(Fonts, FindTheNearestForAFamilyThatIsNotThere) {
    Fonts fonts({.family = "No Such Family Anywhere", .hinting = Hinting::slight});
    EXPECT_GT(fonts.run("abc", {}).width, 10);
    EXPECT_FALSE(fonts.file_for(U'a').empty());
}

TEST_F(Text, TheSecondCallAllocatesNothing) {
    const TextStyle style{.tabular = true};
    const ui::Run* first = &fonts.run("12.5 mm/s", style);
    const std::size_t before = test::allocations_so_far();
    for (int frame = 0; frame < 300; ++frame) {
        EXPECT_EQ(&fonts.run("12.5 mm/s", style), first);
        fonts.next_frame();
    }
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST_F(Text, ANumberThatChangesEveryFrameAllocatesNothingEither) {
    char text[16] = "000.00 mm";
    const auto frames = [&](int from, int to) {
        for (int i = from; i < to; ++i) {
            for (int at : {0, 1, 2, 4, 5}) text[at] = static_cast<char>('0' + (i * 7919 >> at) % 10);
            text[0] = static_cast<char>('0' + i / 100), text[1] = static_cast<char>('0' + i / 10 % 10);
            text[2] = static_cast<char>('0' + i % 10);
            fonts.run(text, {.tabular = true});
            fonts.next_frame();
        }
    };
    frames(0, 20);  // every digit has been at every place
    const std::size_t before = test::allocations_so_far();
    frames(20, 900);
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST_F(Text, StylesDoNotGetMixedUp) {
    const std::string_view text = "Va11";
    const TextStyle styles[] = {{},
                                {.size = 14.25F},
                                {.weight = Weight::medium},
                                {.weight = Weight::bold},
                                {.tabular = true},
                                {.monospace = true},
                                {.size = 15}};
    std::set<float> widths;
    for (const TextStyle& style : styles) widths.insert(width(text, style));
    EXPECT_EQ(widths.size(), std::size(styles));
    EXPECT_NE(width("Va1"), width("Va11"));
}

TEST_F(Text, TheAtlasTellsWhatHasChanged) {
    fonts.run("a", {});
    const ui::Run& run = fonts.run("g", {});
    const Atlas& atlas = fonts.atlas();
    const std::uint32_t serial = atlas.serial;
    EXPECT_GE(serial, 2U);
    EXPECT_GE(atlas.dirty.z, run.glyphs[0].uv[2]);
    EXPECT_GE(atlas.dirty.w, run.glyphs[0].uv[3]);
    fonts.clear_dirty();
    fonts.run("g", {});
    EXPECT_EQ(atlas.serial, serial);
    EXPECT_EQ(atlas.dirty, glm::ivec4(0));
    const Instance next = fonts.run("W", {}).glyphs[0];
    EXPECT_EQ(atlas.serial, serial + 1);
    EXPECT_EQ(atlas.dirty, glm::ivec4(next.uv[0], next.uv[1], next.uv[2], next.uv[3]));
    EXPECT_EQ(atlas.resets, 0U);
}

/// Makes large letters, each in another size: more than fit into the atlas.
void fill_atlas(Fonts& fonts, int glyphs) {
    for (int i = 0; i < glyphs; ++i) {
        const char letter[] = {static_cast<char>('A' + i % 26), 0};
        fonts.run(letter, {.size = 60 + static_cast<float>(i) / 26});
    }
}

TEST_F(Text, TheAtlasGrowsAndKeepsWhatItHas) {
    const Picture before = drawn(fonts, "Smoke 12.5", {});
    const ui::Run kept = fonts.run("Smoke 12.5", {});
    fill_atlas(fonts, 500);
    EXPECT_EQ(fonts.atlas().size, glm::ivec2(2048));
    EXPECT_EQ(fonts.atlas().resets, 1U);
    EXPECT_TRUE(same(fonts.run("Smoke 12.5", {}), kept));
    EXPECT_EQ(drawn(fonts, "Smoke 12.5", {}).pixels, before.pixels);
}

TEST_F(Text, AFullAtlasStartsAnewBetweenFrames) {
    const TextStyle big{.size = 200};
    const Picture right = drawn(fonts, "Q", big);
    const Picture small = drawn(fonts, "Smoke", {});
    fonts.next_frame();
    fill_atlas(fonts, 3000);
    const std::uint32_t resets = fonts.atlas().resets;
    EXPECT_TRUE(fonts.run("RST", big).glyphs.empty()) << "no room is left in this frame";
    EXPECT_GT(fonts.run("RST", big).width, 200) << "but it is as wide as ever";
    EXPECT_EQ(drawn(fonts, "Q", big).pixels, right.pixels) << "and nothing moves before the frame ends";
    fonts.next_frame();
    EXPECT_EQ(fonts.atlas().resets, resets + 1);
    EXPECT_EQ(fonts.run("RST", big).glyphs.size(), 3U);
    EXPECT_EQ(drawn(fonts, "Q", big).pixels, right.pixels);
    EXPECT_EQ(drawn(fonts, "Smoke", {}).pixels, small.pixels);
}

TEST_F(Text, GlyphsDoNotTouchEachOther) {
    fill_atlas(fonts, 200);
    std::vector<glm::ivec4> places;
    for (int i = 0; i < 200; ++i) {
        const char letter[] = {static_cast<char>('A' + i % 26), 0};
        const Instance glyph = fonts.run(letter, {.size = 60 + static_cast<float>(i) / 26}).glyphs.at(0);
        const glm::ivec4 place(glyph.uv[0], glyph.uv[1], glyph.uv[2], glyph.uv[3]);
        if (std::ranges::find(places, place) == places.end()) places.push_back(place);
    }
    EXPECT_GT(places.size(), 190U);
    for (const glm::ivec4& a : places) {
        EXPECT_GE(a.x, 1);
        EXPECT_LE(a.w, fonts.atlas().size.y - 1);
        for (const glm::ivec4& b : places) {
            const bool apart = a.z < b.x || b.z < a.x || a.w < b.y || b.w < a.y;
            EXPECT_TRUE(apart || a == b);
        }
    }
}

TEST_F(Text, AMegabyteIsCutToWhatARunHolds) {
    std::string text;
    while (text.size() < 1'000'000) text += "lapfx ";
    const ui::Run& run = fonts.run(text, {});
    EXPECT_EQ(run.stops.size(), max_run_bytes + 1);
    EXPECT_EQ(run.stops.back().byte, max_run_bytes);
    EXPECT_EQ(run.byte_at(1e9F), max_run_bytes);
    EXPECT_EQ(run.x_of(999'999), run.width);

    std::string wide = "ab";
    while (wide.size() < 1'000'000) wide += "\xe2\x82\xac";  // euro signs; the limit is inside one of them
    EXPECT_EQ(fonts.run(wide, {}).stops.back().byte, 2 + (max_run_bytes - 2) / 3 * 3);
}

TEST_F(Text, TowersOfMarksAndOtherOddTextsAreOneLine) {
    std::string tower = "a";
    for (int i = 0; i < 8000; ++i) tower += "\xcc\x81";
    EXPECT_EQ(bytes_of_stops(fonts.run(tower, {})), (std::vector<std::uint32_t>{0, 16001}));
    // Arabic, shaped from left to right; Devanagari, where vowels move; a family of emoji held together by joiners.
    for (const std::string_view text : {"\xd8\xb3\xd9\x84\xd8\xa7\xd9\x85", "\xe0\xa4\xb9\xe0\xa4\xbf\xe0\xa4\x82",
                                        "\xf0\x9f\x91\xa9\xe2\x80\x8d\xf0\x9f\x91\xa7"}) {
        const ui::Run& run = fonts.run(text, {});
        EXPECT_EQ(run.stops.back().byte, text.size());
        EXPECT_TRUE(std::ranges::is_sorted(run.stops, {}, &CaretStop::x));
        EXPECT_TRUE(std::ranges::is_sorted(run.stops, {}, &CaretStop::byte));
        EXPECT_FALSE(run.glyphs.empty());
    }
}

TEST_F(Text, TheCaretStopsWhereEditingStepsTo) {
    const std::string texts[] = {
        "e\u0301a\u0302\u0323b",                                                     // combining marks
        "x\U0001F44D\U0001F3FDy",                                                    // a skin tone
        "x\U0001F469\u200D\U0001F4BB\U0001F469\u200D\u2764\uFE0F\u200D\U0001F468y",  // joined pictures
        "a\u200Db\u2713\uFE0E",                                                      // a joiner between letters
        "\U0001F3F4\U000E0067\U000E0062\U000E007Fz",                                 // a flag of tags
        "\u0915\u094D\u0937\u093F",                                                  // vowel signs
        "x\U0001F1E9\U0001F1EA\U0001F1EB\U0001F1F7\U0001F1EBy",                      // two flags and a half
        "\u1112\u1161\u11AB\u1100\u1173\u11AF",                                      // Hangul by its sounds
        "\u0E19\u0E49\u0E33z",                                                       // Thai
        "a\xF0\x9F\x98z\xC0\xAF\u0301"};                                             // no UTF-8
    for (const std::string& text : texts) {
        std::vector<std::uint32_t> steps = {0}, stops;
        for (std::size_t at = 0; at < text.size();)
            steps.push_back(static_cast<std::uint32_t>(at += next_character(text, at)));
        for (const CaretStop& stop : fonts.run(text, {}).stops) stops.push_back(stop.byte);
        EXPECT_EQ(stops, steps) << text;
    }
}

}  // namespace
}  // namespace lapfx::ui
