#include "ui/widgets/color_field.h"

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

struct ColorFieldTest : testing::Test {
    Color color = rgb(0x804020);
    ColorOptions options;
    Edit all;
    int commits = 0, begins = 0;
    Harness ui{[this](Ui& u) {
        const Edit edit = color_field(u, "Key", color, options);
        commits += edit.committed, begins += edit.began;
        all |= edit;
        button(u, "Below");
    }};

    void open() {
        ui.click("Key");
        all = {};
        commits = begins = 0;
    }
};

TEST_F(ColorFieldTest, TheFieldShowsTheColourAsText) {
    EXPECT_EQ(ui.text("Key"), "#804020");
    EXPECT_EQ(ui.node("Key").role, Role::color);
    options.alpha = true;
    color.a = 0x7f;
    ui.frame();
    EXPECT_EQ(ui.text("Key"), "#8040207f");
}

TEST_F(ColorFieldTest, AClickOrEnterOpensThePickerAndEscapeClosesIt) {
    ui.click("Key");
    EXPECT_TRUE(ui.exists("Key picker"));
    EXPECT_EQ(ui.focused(), "Key picker/Saturation and value");
    ui.key(Key::escape);
    EXPECT_FALSE(ui.exists("Key picker"));
    EXPECT_EQ(ui.focused(), "Key");
    ui.key(Key::enter);
    EXPECT_TRUE(ui.exists("Key picker"));
    EXPECT_FALSE(ui.exists("Key picker/Alpha"));
    EXPECT_FALSE(all.changed);
}

TEST_F(ColorFieldTest, AnEditOfTheSquareIsOneGesture) {
    open();
    ui.press("Key picker/Saturation and value", {0.5F, 0.5F});
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(commits, 0);
    const Rect square = ui.rect("Key picker/Saturation and value");
    ui.move({square.right() + 50, square.y - 50});
    EXPECT_EQ(to_hsv(color).saturation, 1);
    EXPECT_EQ(to_hsv(color).value, 1);
    EXPECT_EQ(ui.text("Key picker/Saturation and value"), "100 %, 100 %");
    EXPECT_EQ(ui.text("Key"), ui.text("Key picker/Now")) << "all of it shows the colour of this frame";
    ui.release();
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(commits, 1);
}

TEST_F(ColorFieldTest, EscapeDuringADragTakesItBack) {
    open();
    ui.press("Key picker/Hue", {0.5F, 0.5F}).drag_by({0, 20});
    EXPECT_NE(color, rgb(0x804020));
    ui.key(Key::escape);
    EXPECT_EQ(color, rgb(0x804020));
    EXPECT_TRUE(all.cancelled);
    EXPECT_EQ(commits, 0);
    EXPECT_TRUE(ui.exists("Key picker"));
    ui.release();
    EXPECT_EQ(color, rgb(0x804020));
}

TEST_F(ColorFieldTest, HueOutlivesGreyAndBlack) {
    color = rgb(0x0000ff);
    ui.frame();
    open();
    const Rect square = ui.rect("Key picker/Saturation and value");
    ui.press("Key picker/Saturation and value", {0.5F, 0.5F}).move({square.x - 9, square.bottom() + 9});
    EXPECT_EQ(color, rgb(0x000000));
    ui.move({square.right() + 9, square.y - 9});
    EXPECT_EQ(color, rgb(0x0000ff));
    ui.release();
}

TEST_F(ColorFieldTest, ArrowsGoByHundredthsFinelyWithShiftAndCoarselyWithCommand) {
    open();
    color = to_color({100, 0.5F, 0.5F});
    ui.frame();
    ui.focus("Key picker/Hue");
    const double hue = ui.value("Key picker/Hue");
    ui.key(Key::down);
    EXPECT_NEAR(ui.value("Key picker/Hue"), hue + 3.6, 1e-3);
    ui.key(Key::up, Mods::shift);
    EXPECT_NEAR(ui.value("Key picker/Hue"), hue + 3.24, 1e-3);
    ui.key(Key::down, Mods::command);
    EXPECT_NEAR(ui.value("Key picker/Hue"), hue + 39.24, 1e-3);
    EXPECT_EQ(begins, commits);
}

TEST_F(ColorFieldTest, AlphaIsKeptUnlessItCanBeEdited) {
    color.a = 0x55;
    ui.frame();
    open();
    ui.drag("Key picker/Hue", {0, 10});
    EXPECT_EQ(color.a, 0x55);
    options.alpha = true;
    ui.frame();
    ui.press("Key picker/Alpha", {0.5F, 0.5F}).move({ui.rect("Key picker/Alpha").center().x, 470});
    EXPECT_EQ(color.a, 0);
    EXPECT_EQ(ui.value("Key picker/Alpha"), 0);
    ui.release();
}

TEST_F(ColorFieldTest, ATypedColourIsTakenWhenItIsOne) {
    open();
    ui.click("Key picker/Hex").key('A', Mods::command).type("#12");
    EXPECT_TRUE(ui.is("Key picker/Hex", Is::invalid));
    EXPECT_NE(ui.dump().find("\"#12\" is no colour: allowed are 3 or 6 digits"), std::string::npos) << ui.dump();
    EXPECT_EQ(color, rgb(0x804020));
    ui.type("3");
    EXPECT_FALSE(ui.is("Key picker/Hex", Is::invalid));
    EXPECT_EQ(color, rgb(0x112233));
    ui.type("456").key(Key::enter);
    EXPECT_EQ(color, rgb(0x123456));
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(commits, 1);
    EXPECT_EQ(ui.text("Key picker/Hex"), "#123456");
    ui.type("0").key(Key::escape);
    EXPECT_EQ(color, rgb(0x123456));
}

TEST_F(ColorFieldTest, WhatIsTypedGoesIntoTheHexFieldWithOneClickOrNone) {
    open();
    ui.click("Key picker/Hex").type("#8a4a3c").key(Key::enter);
    EXPECT_EQ(color, rgb(0x8a4a3c)) << "all was selected";
    ui.key(Key::escape).key(Key::escape);
    open();
    ui.type("#0a1b2c");
    EXPECT_EQ(color, rgb(0x0a1b2c)) << "the keyboard was at the square";
    EXPECT_EQ(ui.text("Key picker/Hex"), "#0a1b2c");
}

TEST_F(ColorFieldTest, EscapeWhileTypingGoesBack) {
    open();
    ui.click("Key picker/Hex").key('A', Mods::command).type("#fff");
    EXPECT_EQ(color, rgb(0xffffff));
    ui.key(Key::escape);
    EXPECT_EQ(color, rgb(0x804020));
    EXPECT_EQ(commits, 0);
    EXPECT_TRUE(all.cancelled);
    EXPECT_TRUE(ui.exists("Key picker"));
}

TEST_F(ColorFieldTest, ClosingThePickerWhileTypingCommits) {
    open();
    ui.click("Key picker/Hex").key('A', Mods::command).type("#fff");
    EXPECT_EQ(commits, 0);
    ui.send({.kind = EventKind::press, .at = {630, 470}});
    EXPECT_FALSE(ui.exists("Key picker"));
    EXPECT_EQ(color, rgb(0xffffff));
    EXPECT_EQ(commits, 1);
    ui.frame().frame();
    EXPECT_EQ(commits, 1);
}

TEST_F(ColorFieldTest, BeforeGoesBackToWhatItWasWhenOpened) {
    open();
    ui.drag("Key picker/Hue", {0, 30});
    EXPECT_NE(color, rgb(0x804020));
    EXPECT_EQ(ui.text("Key picker/Before"), "#804020");
    EXPECT_EQ(ui.tip("Key picker/Before"), "Back to what it was");
    ui.click("Key picker/Before");
    EXPECT_EQ(color, rgb(0x804020));
    EXPECT_EQ(commits, 2);
}

TEST_F(ColorFieldTest, TheEyedropperAsksTheProgramAndTakesWhatItGives) {
    Eyedropper dropper;
    open();
    EXPECT_FALSE(ui.exists("Key picker/Pick from a picture"));
    options.eyedropper = &dropper;
    color.a = 0x40;
    ui.frame().click("Key picker/Pick from a picture");
    EXPECT_FALSE(ui.exists("Key picker")) << "or the press on the picture would only close it";
    EXPECT_EQ(dropper.wanted_by, ui.node("Key").id);
    dropper.picked = rgb(0x00ff00);
    ui.frame();
    EXPECT_EQ(color, (Color{0, 255, 0, 0x40}));
    EXPECT_EQ(ui.text("Key"), "#00ff00");
    EXPECT_EQ(dropper.wanted_by, 0U);
    EXPECT_EQ(commits, 1);
}

TEST_F(ColorFieldTest, AnotherFieldLeavesThePickedColourAlone) {
    Eyedropper dropper{.wanted_by = 12345, .picked = rgb(0x00ff00)};
    options.eyedropper = &dropper;
    ui.frame();
    EXPECT_EQ(color, rgb(0x804020));
    EXPECT_TRUE(dropper.picked.has_value());
}

TEST_F(ColorFieldTest, NumbersShowTheColourAndAreTyped) {
    open();
    EXPECT_EQ(ui.value("Key picker/R"), 0x80);
    EXPECT_EQ(ui.value("Key picker/B"), 0x20);
    EXPECT_NEAR(ui.value("Key picker/S"), 75, 0.01);
    ui.click("Key picker/G", {.clicks = 2}).key('A', Mods::command).type("255").key(Key::enter);
    EXPECT_EQ(color, rgb(0x80ff20));
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(commits, 1);
    ui.click("Key picker/H", {.clicks = 2}).key('A', Mods::command).type("0").key(Key::enter);
    EXPECT_EQ(to_hsv(color).hue, 0);
    EXPECT_EQ(color.r, 0xff);
    EXPECT_EQ(commits, 2);
}

TEST_F(ColorFieldTest, ADraggedNumberIsOneGestureAndEscapeTakesItBack) {
    open();
    ui.press("Key picker/R").drag_by({30, 0});
    EXPECT_GT(color.r, 0x80);
    EXPECT_EQ(color.g, 0x40);
    ui.key(Key::escape);
    EXPECT_EQ(color, rgb(0x804020));
    EXPECT_EQ(commits, 0);
    EXPECT_TRUE(all.cancelled);
}

TEST_F(ColorFieldTest, CopyAndPasteAsText) {
    ui.focus("Key").key('C', Mods::command);
    EXPECT_EQ(ui.clipboard().text, "#804020");
    ui.clipboard().text = "no colour";
    ui.key('V', Mods::command);
    EXPECT_EQ(color, rgb(0x804020));
    EXPECT_FALSE(all.changed);
    ui.clipboard().text = " 0af ";
    ui.key('V', Mods::command);
    EXPECT_EQ(color, rgb(0x00aaff));
    EXPECT_EQ(ui.text("Key"), "#00aaff");
    EXPECT_EQ(commits, 1);
}

TEST_F(ColorFieldTest, ADisabledOneNeitherOpensNorPastes) {
    Harness dead([&](Ui& u) {
        u.push_disabled(true);
        color_field(u, "Key", color, {.tip = "why"});
        u.pop_disabled();
    });
    dead.clipboard().text = "#fff";
    dead.click("Key").key(Key::tab).key('V', Mods::command).key(Key::enter);
    EXPECT_FALSE(dead.exists("Key picker"));
    EXPECT_EQ(color, rgb(0x804020));
    EXPECT_EQ(dead.tip("Key"), "why");
}

TEST_F(ColorFieldTest, SteadyFramesAndDragsAllocateNothing) {
    open();
    ui.press("Key picker/Saturation and value", {0.5F, 0.5F});
    const auto drag = [&](int frames) {
        for (int i = 0; i < frames; ++i) ui.move({100 + static_cast<float>(i % 40), 100});
    };
    drag(300);
    const std::size_t before = test::allocations_so_far();
    drag(50);
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST_F(ColorFieldTest, EveryPartHasAName) {
    options.alpha = true;
    Eyedropper dropper;
    options.eyedropper = &dropper;
    open();
    EXPECT_TRUE(faults_of(ui.ui().tree()).empty());
}

TEST(Hsv, EveryColourComesBack) {
    for (int r = 0; r < 256; r += 5) {
        for (int g = 0; g < 256; g += 3) {
            for (int b = 0; b < 256; b += 5) {
                const Color color{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                  static_cast<std::uint8_t>(b), 255};
                const Hsv hsv = to_hsv(color);
                ASSERT_EQ(to_color(hsv), color);
                ASSERT_GE(hsv.hue, 0);
                ASSERT_LT(hsv.hue, 360);
            }
        }
    }
}

TEST(Hsv, KnownColoursHaveKnownHues) {
    EXPECT_EQ(to_hsv(rgb(0xff0000)).hue, 0);
    EXPECT_EQ(to_hsv(rgb(0xffff00)).hue, 60);
    EXPECT_EQ(to_hsv(rgb(0x00ff00)).hue, 120);
    EXPECT_EQ(to_hsv(rgb(0x00ffff)).hue, 180);
    EXPECT_EQ(to_hsv(rgb(0x0000ff)).hue, 240);
    EXPECT_EQ(to_hsv(rgb(0xff00ff)).hue, 300);
    EXPECT_EQ(to_hsv(rgb(0x808080), {77, 1, 1}).hue, 77);
    EXPECT_EQ(to_hsv(rgb(0x000000), {77, 0.5F, 1}).saturation, 0.5F);
}

TEST(Hex, FourFormsAreRead) {
    EXPECT_EQ(parse_hex("#fa0"), rgb(0xffaa00));
    EXPECT_EQ(parse_hex("FA08"), (Color{0xff, 0xaa, 0, 0x88}));
    EXPECT_EQ(parse_hex("  #12aBcd"), rgb(0x12abcd));
    EXPECT_EQ(parse_hex("12abcd40"), (Color{0x12, 0xab, 0xcd, 0x40}));
    for (const std::string_view bad : {"", "#", "#12", "12345", "#1234567", "#ggg", "0x123", "#12 456", "@aa", "`aa"})
        EXPECT_FALSE(parse_hex(bad)) << bad;
}

TEST(Hex, WhatIsWrittenIsReadBack) {
    char buffer[9];
    for (int i = 0; i < 256; ++i) {
        const Color color{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i),
                          static_cast<std::uint8_t>(i / 2), static_cast<std::uint8_t>(i)};
        EXPECT_EQ(parse_hex(format_hex(buffer, color, true)), color);
    }
}

}  // namespace
}  // namespace lapfx::ui
