#include <gmock/gmock.h>

#include <random>

#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/support/texts.h"
#include "ui/widgets/field.h"
#include "ui/widgets/param.h"

namespace lapfx::ui {
namespace {

/// "Luma", which changes by one unit for each px.
class RangeParam : public testing::Test {
  protected:
    RangeParam() { ui.frame(); }
    void build(Ui& u) {
        Column column(u, {.width = px(640)});
        u.push_disabled(disabled);
        const Edit edit = range_param(u, "Luma", low, high, options, standards);
        u.pop_disabled();
        began += edit.began, committed += edit.committed;
    }
    double low = 100, high = 200, standards[2] = {100, 200};
    int began = 0, committed = 0;
    bool disabled = false;
    ParamOptions options{.maximum = 352, .hard_minimum = 0, .hard_maximum = 1000, .step = 10, .tip = "What is kept"};
    Harness ui{[this](Ui& u) { build(u); }};
};

TEST_F(RangeParam, EachHandleIsANodeOfItsOwn) {
    EXPECT_EQ(ui.value("Luma/Low"), 100);
    EXPECT_EQ(ui.value("Luma/High"), 200);
    EXPECT_EQ(ui.node("Luma").role, Role::range);
    EXPECT_EQ(ui.text("Luma"), "100 \u2013 200");
    EXPECT_EQ(ui.tip("Luma/Low"), "What is kept");
    EXPECT_EQ(ui.key(Key::tab).focused(), "Luma/Low");
    EXPECT_EQ(ui.key(Key::tab).focused(), "Luma/High");
    EXPECT_THAT(faults_of(ui.ui().tree()), testing::IsEmpty());
}

TEST_F(RangeParam, HandlesAreDraggedAndStopAtEachOther) {
    ui.drag("Luma/Low", {3 + 50, 0});
    EXPECT_EQ(low, 150);
    ui.drag("Luma/Low", {300, 0});
    EXPECT_EQ(low, 200);
    ui.drag("Luma/High", {-300, 0});
    EXPECT_EQ(high, 200);
    ui.drag("Luma/High", {3 + 30, 0});
    EXPECT_EQ(high, 230);
    EXPECT_EQ(began, 3);
    EXPECT_EQ(committed, 3);
}

TEST_F(RangeParam, ThePointerTakesTheNearerHandle) {
    const float left = ui.rect("Luma").x + 288;
    const auto under = [&](float value) { return ui.move({left + value, ui.rect("Luma").center().y}).ui().hot(); };
    EXPECT_EQ(under(0), ui.node("Luma/Low").id);
    EXPECT_EQ(under(149), ui.node("Luma/Low").id);
    EXPECT_EQ(under(151), ui.node("Luma/High").id);
    low = high = 0;
    ui.frame();
    EXPECT_GE(ui.rect("Luma/Low").w, 24) << "always room for the pointer";
    EXPECT_EQ(ui.rect("Luma/Low").right(), ui.rect("Luma/High").x);
    EXPECT_EQ(ui.rect("Luma/High").right(), ui.rect("Luma").right());
}

TEST_F(RangeParam, TypingKeepsThemInOrder) {
    ui.focus("Luma/Low").type("500").key(Key::enter);
    EXPECT_EQ(low, 200);
    ui.key(Key::enter).type("50").key(Key::tab);
    EXPECT_EQ(low, 50);
    EXPECT_EQ(ui.focused(), "Luma/High");
    EXPECT_EQ(ui.text("Luma/High"), "200");
    EXPECT_NEAR(ui.rect("Luma/High").w, 176, 1) << "half of the field to type in";
    ui.type("20").key(Key::enter);
    EXPECT_EQ(high, 50);
}

TEST_F(RangeParam, KeysAndMenuBelongToEachHandle) {
    ui.focus("Luma/High").key(Key::right);
    EXPECT_EQ(high, 210);
    EXPECT_EQ(low, 100);
    EXPECT_TRUE(ui.is("Luma", Is::changed));
    ui.key(Key::backspace);
    EXPECT_EQ(high, 200);
    EXPECT_FALSE(ui.is("Luma", Is::changed));
    ui.key(Key::page_down);
    ui.right_click("Luma/High").click("High menu/Reset");
    EXPECT_EQ(high, 200);
}

TEST_F(RangeParam, ADoubleClickOnTheLabelResetsBoth) {
    low = 5, high = 6;
    ui.frame().click("Luma/name", {.clicks = 2});
    EXPECT_EQ(low, 100);
    EXPECT_EQ(high, 200);
    EXPECT_EQ(committed, 1) << "in one edit";
}

TEST_F(RangeParam, EscapePutsAHandleBack) {
    ui.press("Luma/High").drag_by({40, 0}).key(Key::escape);
    EXPECT_EQ(high, 200);
    EXPECT_EQ(committed, 0);
}

TEST_F(RangeParam, DisabledItTakesNothing) {
    low = 5;
    disabled = true;
    ui.frame().drag("Luma/Low", {40, 0}).click("Luma/name", {.clicks = 2}).key(Key::tab);
    EXPECT_EQ(low, 5);
    EXPECT_EQ(ui.focused(), "");
}

TEST_F(RangeParam, WhateverIsDoneTheyStayInOrderAndInTheHardRange) {
    std::mt19937 random(11);
    const char* const names[] = {"Luma/Low", "Luma/High"};
    const Key keys[] = {Key::left, Key::right, Key::page_up, Key::page_down, Key::home, Key::end, Key::backspace};
    for (int i = 0; i < 1500; ++i) {
        const std::string name = names[random() % 2];
        switch (random() % 4) {
            case 0:
                ui.drag(name, {static_cast<int>(random() % 800) - 400, 0}, static_cast<Mods>(random() % 4));
                break;
            case 1:
                ui.focus(name).type(std::to_string(static_cast<int>(random() % 3000) - 1000)).key(Key::enter);
                break;
            default:
                ui.focus(name).key(keys[random() % std::size(keys)], static_cast<Mods>(random() % 4));
        }
        ASSERT_LE(low, high) << i;
        ASSERT_GE(low, 0);
        ASSERT_LE(high, 1000);
    }
    EXPECT_EQ(began, committed);
}

TEST_F(RangeParam, StillFramesAllocateNothing) {
    for (int i = 0; i < 5; ++i) ui.frame();
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 300; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST(VectorParam, EachPartIsANodeOfItsOwn) {
    double at[] = {1, 2, 3};
    double flat[] = {4, 5};
    const double standards[] = {1, 2, 0};
    int committed = 0;
    Harness ui([&](Ui& u) {
        Column column(u, {.width = px(640)});
        committed += vector_param(u, "At", at, {.minimum = -10, .maximum = 10, .step = 1}, standards).committed ? 1 : 0;
        vector_param(u, "Flat", flat, {.maximum = 10});
    });
    EXPECT_EQ(ui.value("At/Z"), 3);
    EXPECT_TRUE(ui.is("At", Is::changed));
    EXPECT_FALSE(ui.is("At/X", Is::changed));
    EXPECT_NEAR(ui.rect("At/X").w, ui.rect("At/Z").w, 1);
    EXPECT_EQ(ui.rect("At/Z").right(), ui.rect("At").right());
    EXPECT_EQ(ui.rect("At/X").x, field_part(ui.rect("At"), true).x) << "where the fields of other params begin";
    ui.focus("At/X").type("7").key(Key::tab);
    EXPECT_THAT(at, testing::ElementsAre(7, 2, 3));
    EXPECT_EQ(ui.text("At/Y"), "2") << "Tab goes on to the next part";
    ui.key(Key::escape).click("At/name", {.clicks = 2});
    EXPECT_THAT(at, testing::ElementsAre(1, 2, 0));
    EXPECT_EQ(committed, 2);
    ui.focus("Flat/Y").key(Key::right);
    EXPECT_DOUBLE_EQ(flat[1], 5.1);
    EXPECT_THAT(faults_of(ui.ui().tree()), testing::IsEmpty());
}

TEST(VectorParam, ItsNumbersAreCalledWhatTheyAre) {
    double value[] = {0.2, 0.5, 0.8};
    Harness ui([&](Ui& u) {
        Column column(u, {.width = px(640)});
        vector_param(u, "Extinction", value, {.maximum = 2}, {}, "RGB");
    });
    EXPECT_EQ(ui.value("Extinction/R"), 0.2);
    EXPECT_EQ(ui.value("Extinction/B"), 0.8);
    EXPECT_FALSE(ui.exists("Extinction/X"));
}

TEST(VectorParam, StandsOneBelowTheOtherWhereItsDigitsHaveNoRoom) {
    double value[] = {-3.456, 8.25, -4.125};
    Harness ui([&](Ui& u) {
        Column column(u, {.width = px(340)});
        vector_param(u, "Eye", value, {.minimum = -1000, .maximum = 1000, .step = 1});
    });
    EXPECT_EQ(ui.rect("Eye/X").y, ui.rect("Eye/Z").y);
    value[0] = -73.456, value[2] = -20400.125;
    ui.frame().frame();
    EXPECT_GE(ui.rect("Eye/Z").y, ui.rect("Eye/Y").bottom());
    EXPECT_THAT(
        cut_texts(ui.ui().tree(), texts_seen(*ui.output().list, Harness::fonts(), ui.ui().em(1)), ui.ui().em(1)),
        testing::IsEmpty());
}

TEST(VectorParam, StandsOneBelowTheOtherWhereNothingWouldBeLeftOfItsNumbers) {
    double value[] = {-120, 250, 40};
    Harness ui([&](Ui& u) {
        Column column(u);
        vector_param(u, "Port", value, {.minimum = -1000, .maximum = 1000});
    });
    EXPECT_EQ(ui.rect("Port/X").y, ui.rect("Port/Z").y);
    ui.size.x = 240;
    ui.frame();
    EXPECT_GE(ui.rect("Port/Z").y, ui.rect("Port/Y").bottom());
    EXPECT_GE(ui.rect("Port/Y").y, ui.rect("Port/X").bottom());
    EXPECT_EQ(ui.rect("Port").h, ui.rect("Port/Z").bottom() - ui.rect("Port/X").y);
    EXPECT_THAT(
        cut_texts(ui.ui().tree(), texts_seen(*ui.output().list, Harness::fonts(), ui.ui().em(1)), ui.ui().em(1)),
        testing::IsEmpty());
    ui.size.x = 640;
    ui.frame();
    EXPECT_EQ(ui.rect("Port/X").y, ui.rect("Port/Z").y);
}

TEST(VectorParam, ZeroIsShownAsWhatItStandsFor) {
    double scale = 0;
    Harness ui([&](Ui& u) {
        Column column(u, {.width = px(640)});
        param(u, "Scale", scale, {.maximum = 1000, .unit = "mm per unit", .zero = "automatic"});
    });
    EXPECT_EQ(ui.text("Scale"), "automatic");
    scale = 10;
    EXPECT_THAT(ui.frame().text("Scale"), testing::EndsWith(" mm per unit"));
}

}  // namespace
}  // namespace lapfx::ui
