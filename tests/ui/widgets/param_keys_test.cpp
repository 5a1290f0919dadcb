#include "ui/core/tree.h"
#include "ui/widgets/param_fixture.h"

namespace lapfx::ui {
namespace {

TEST_F(Param, ArrowsStepAndShiftTakesTenths) {
    ui.focus("Speed").key(Key::right);
    EXPECT_EQ(speed, 105);
    ui.key(Key::up).key(Key::left).key(Key::down);
    EXPECT_EQ(speed, 100);
    ui.key(Key::right, Mods::shift);
    EXPECT_EQ(speed, 100.5);
    ui.key(Key::left, Mods::shift).key(Key::page_up);
    EXPECT_EQ(speed, 150);
    ui.key(Key::page_down).key(Key::page_down);
    EXPECT_EQ(speed, 50);
    for (int i = 0; i < 20; ++i) ui.key(Key::page_down);
    EXPECT_EQ(speed, 0) << "the soft range bounds them";
}

TEST_F(Param, AnArrowHeldDownIsOneEdit) {
    ui.focus("Speed");
    for (int i = 0; i < 5; ++i) ui.send({.kind = EventKind::key, .key = Key::right, .repeat = i > 0});
    EXPECT_EQ(speed, 125);
    EXPECT_EQ(edits.began, 1);
    EXPECT_EQ(edits.committed, 0);
    ui.send({.kind = EventKind::key_up, .key = Key::right});
    EXPECT_EQ(edits.committed, 1);
    ui.send({.kind = EventKind::key, .key = Key::right}).send({.kind = EventKind::key, .key = Key::tab});
    EXPECT_EQ(edits.committed, 2) << "leaving ends it as well";
}

TEST_F(Param, WhateverComesWhileAnArrowIsDownThereIsOneEditAtATime) {
    const auto open = [&] { return edits.began - edits.committed - edits.cancelled; };
    const auto hold = [&] {
        ui.focus("Speed").send({.kind = EventKind::key, .key = Key::right});
        ASSERT_EQ(open(), 1);
    };
    hold();
    ui.send({.kind = EventKind::key, .key = Key::backspace});
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(edits.began, 1) << "within the edit that is open";
    EXPECT_EQ(edits.committed, 1) << "which ends so";
    ui.send({.kind = EventKind::key_up, .key = Key::right}).send({.kind = EventKind::key_up, .key = Key::backspace});
    EXPECT_EQ(edits.committed, 1);
    hold();
    ui.key(Key::enter);
    EXPECT_EQ(open(), 0) << "an open text";
    ui.key(Key::escape).send({.kind = EventKind::key_up, .key = Key::right});
    hold();
    ui.send({.kind = EventKind::press, .at = field_center()});
    EXPECT_EQ(open(), 0) << "a press";
    ui.drag_by({10, 0});
    EXPECT_EQ(open(), 1);
    ui.release();
    EXPECT_EQ(edits.began, 4);
    EXPECT_EQ(open(), 0);
}

TEST_F(Param, CtrlHomeAndCtrlEndGoToTheEndsHomeAloneDoesNot) {
    ui.focus("Speed").key(Key::home).key(Key::end);
    EXPECT_EQ(speed, 100);
    ui.key(Key::end, Mods::command);
    EXPECT_EQ(speed, 352);
    ui.key(Key::home, Mods::command);
    EXPECT_EQ(speed, 0);
}

TEST_F(Param, CtrlAndTheWheelStep) {
    ui.wheel("Speed", {0, 1}, Mods::command);
    EXPECT_EQ(speed, 105);
    ui.wheel("Speed", {0, -2}, Mods::command);
    EXPECT_EQ(speed, 95);
    ui.wheel("Speed", {0, 1}, Mods::command | Mods::shift);
    EXPECT_EQ(speed, 95.5);
    for (int i = 0; i < 4; ++i) ui.wheel("Speed", {0, 0.25F}, Mods::command);
    EXPECT_EQ(speed, 100.5) << "parts of a notch add up";
    ui.wheel("Speed", {0, 1});
    EXPECT_EQ(speed, 100.5) << "without the focus it is for scrolling";
}

TEST(ParamWheel, WithTheFocusItEditsOnlyWhenNothingWasScrolledJustBefore) {
    double speed = 10;
    ScrollState scroll;
    Harness ui([&](Ui& u) {
        Node& area = u.open(Role::scroll_area, "Area", Axis::y, Sense::wheel);
        area.size[0] = px(300), area.size[1] = px(100);
        area.scrolls[1] = area.clips = true;
        area.scroll = &scroll;
        param(u, "Speed", speed, {.maximum = 60, .step = 1});
        space(u, 100);
        u.close();
    });
    ui.frame(1).wheel("**/Speed", {0, -1});
    EXPECT_EQ(speed, 10);
    EXPECT_GT(scroll.offset.y, 0);
    ui.wheel("**/Speed", {0, 5}).frame(1);
    EXPECT_EQ(scroll.offset.y, 0);
    ui.click("**/Speed").wheel("**/Speed", {0, 1});
    EXPECT_EQ(speed, 11);
    ui.wheel("**/Speed", {0, 1});
    EXPECT_EQ(speed, 12) << "goes on at once";
    ui.move({150, 80}).send({.kind = EventKind::wheel, .delta = {0, -0.01F}});
    ui.wheel("**/Speed", {0, 1});
    EXPECT_EQ(speed, 12) << "half a second after scrolling";
    ui.frame(0.4).wheel("**/Speed", {0, 1});
    EXPECT_EQ(speed, 12) << "and half a second after the last of it, though there was nothing left to scroll";
    ui.frame(0.6).wheel("**/Speed", {0, 1});
    EXPECT_EQ(speed, 13);
}

TEST_F(Param, ADigitIsItsOnlyWithTheRingOfTheKeyboard) {
    ui.drag("Speed", {10, 0});
    const double dragged = speed;
    ui.type("7").key(Key::enter).key(Key::escape);
    EXPECT_EQ(speed, dragged) << "who has dragged it last and presses a tool's key means the tool";
    ui.click("Speed", {.clicks = 2}).key('A', Mods::command).type("80").key(Key::enter);
    EXPECT_EQ(speed, 80);
    ui.type("7").key(Key::enter).key(Key::escape);
    EXPECT_EQ(speed, 80) << "nor after an entry that was opened by pointer";
    ui.focus("Speed").type("9").key(Key::enter);
    EXPECT_EQ(speed, 9);
}

TEST_F(Param, CopyAndPasteKeepEveryDigit) {
    speed = 1.0 / 3;
    ui.focus("Speed").key('C', Mods::command);
    EXPECT_EQ(ui.clipboard().text, "0.3333333333333333");
    speed = 0;
    ui.key('V', Mods::command);
    EXPECT_EQ(speed, 1.0 / 3);
    EXPECT_EQ(edits.committed, 1);
    ui.clipboard().text = "3 cm/s";
    ui.key('V', Mods::command);
    EXPECT_EQ(speed, 30);
    ui.clipboard().text = "hello";
    ui.key('V', Mods::command);
    EXPECT_EQ(speed, 30);
    ui.click("Else").move_to("Speed").key('C', Mods::command);
    EXPECT_EQ(ui.clipboard().text, "30") << "under the pointer";
}

TEST_F(Param, PastingWhatIsNoNumberIsNoEdit) {
    options = {.minimum = -180, .maximum = 180, .step = 1, .unit = "deg", .display = 180 / std::numbers::pi};
    for (speed = 0.1; speed < 3; speed += 0.01) {  // 180/pi and back is not always the same number
        const double before = speed;
        ui.clipboard().text = "hello";
        ui.frame().move_to("Speed").key('V', Mods::command);
        ASSERT_EQ(speed, before);
        ui.right_click("Speed").click(menu("Paste"));
        ASSERT_EQ(speed, before);
    }
    EXPECT_EQ(edits.began + edits.changed, 0);
}

TEST_F(Param, TheMenuResetsCopiesAndPastes) {
    speed = 7;
    ui.right_click("Speed");
    EXPECT_TRUE(ui.exists(menu("Reset")));
    ui.click(menu("Reset"));
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(edits.committed, 1);
    EXPECT_FALSE(ui.exists(menu("Reset")));
    EXPECT_EQ(ui.focused(), "Speed");
    ui.right_click("Speed");
    EXPECT_TRUE(ui.is(menu("Reset"), Is::disabled)) << "nothing to reset";
    ui.click(menu("Copy"));
    EXPECT_EQ(ui.clipboard().text, "100");
    ui.clipboard().text = "5";
    ui.right_click("Size").click("Size menu/Paste");
    EXPECT_EQ(size, 5);
    EXPECT_EQ(speed, 100);
}

TEST_F(Param, TheMenuTellsTheProgramWhatIsItsToDo) {
    ui.right_click("Speed").click(menu("Copy path"));
    EXPECT_TRUE(actions.copy_path);
    EXPECT_FALSE(actions.toggle_lock || actions.toggle_favourite);
    ui.right_click("Speed").click(menu("Lock"));
    EXPECT_TRUE(actions.toggle_lock);
    ui.right_click("Speed").click(menu("Favourite"));
    EXPECT_TRUE(actions.toggle_favourite);
    options.locked = options.favourite = true;
    ui.right_click("Speed");
    EXPECT_TRUE(ui.is(menu("Lock"), Is::checked));
    EXPECT_TRUE(ui.is(menu("Favourite"), Is::checked));
    ui.key(Key::escape).right_click("Size");
    EXPECT_FALSE(ui.exists("Size menu/Copy path")) << "nobody would do it";
}

TEST_F(Param, TheMenuKeyOpensItBelowTheField) {
    ui.focus("Speed").key(Key::menu);
    EXPECT_GE(ui.rect(menu("Reset")).y, ui.rect("Speed").bottom());
}

TEST_F(Param, TheRangeIsSetInAFieldOfItsOwn) {
    ui.right_click("Speed").click(menu("Set range..."));
    ASSERT_TRUE(ui.exists("Range/From"));
    EXPECT_EQ(ui.value("Range/To"), 352);
    ui.click("Range/To", {.clicks = 2, .at = {0.8F, 0.5F}}).type("60").key(Key::enter);
    ASSERT_TRUE(actions.range.has_value());
    EXPECT_EQ(actions.range->low, 0);
    EXPECT_EQ(actions.range->high, 60);
    options.minimum = actions.range->low, options.maximum = actions.range->high;
    ui.click("Range/From", {.clicks = 2, .at = {0.8F, 0.5F}}).type("80").key(Key::enter);
    EXPECT_LT(actions.range->low, 60) << "never empty";
    EXPECT_EQ(speed, 100) << "the value stays";
    ui.key(Key::escape);
    EXPECT_FALSE(ui.exists("Range"));
}

TEST_F(Param, ALockIsShownAndDoesNotHinder) {
    options.locked = true;
    ui.frame();
    EXPECT_TRUE(ui.is("Speed", Is::locked));
    EXPECT_TRUE(ui.output().changed) << "the padlock is drawn";
    ui.drag("Speed", {13, 0});
    EXPECT_EQ(speed, 110);
}

TEST_F(Param, DisabledItTakesNothing) {
    disabled = true;
    ui.frame().drag("Speed", {40, 0}).click("Speed", {.clicks = 2}).right_click("Speed");
    ui.wheel("Speed", {0, 1}, Mods::command).key(Key::backspace);
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(ui.ui().overlay_count(), 0U);
    EXPECT_EQ(ui.key(Key::tab).focused(), "Size");
    EXPECT_TRUE(ui.is("Speed", Is::disabled));
}

TEST_F(Param, TypingIsGivenUpWhenItIsDisabled) {
    ui.focus("Speed").type("7");
    disabled = true;
    ui.frame();
    disabled = false;
    ui.frame();
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(ui.text("Speed"), "100 mm/s");
}

TEST_F(Param, TheSemanticTreeHasValueRangeStepAndText) {
    const Node& node = ui.node("Speed");
    EXPECT_EQ(node.role, Role::slider);
    EXPECT_EQ(node.number->value, 100);
    EXPECT_EQ(node.number->minimum, 0);
    EXPECT_EQ(node.number->maximum, 352);
    EXPECT_EQ(node.number->step, 5);
    EXPECT_EQ(node.text, "100 mm/s");
    EXPECT_EQ(node.tip, "How fast blood flows");
    EXPECT_GE(node.rect().h, 24);
    EXPECT_THAT(faults_of(ui.ui().tree()), testing::IsEmpty());
}

TEST_F(Param, TheValueIsShownInTheFrameOfTheEvent) {
    ui.press("Speed").drag_by({3, 0});
    ui.send({.kind = EventKind::pointer, .at = ui.rect("Speed").center() + glm::vec2(13, 0)});
    EXPECT_EQ(ui.value("Speed"), 110);
    EXPECT_EQ(ui.text("Speed"), "110 mm/s");
    EXPECT_TRUE(ui.output().changed);
}

TEST_F(Param, FramesThatStandStillAllocateNothingNorDoDragsAndOpenTexts) {
    const auto allocations = [&](auto&& act) {
        for (int i = 0; i < 3; ++i) act();
        const std::size_t before = test::allocations_so_far();
        for (int i = 0; i < 100; ++i) act();
        return test::allocations_so_far() - before;
    };
    EXPECT_EQ(allocations([&] { ui.frame(); }), 0U);
    ui.press("Speed").drag_by({10, 0});
    const glm::vec2 at = field_center();
    for (int i = 0; i < 400; ++i) ui.send({.kind = EventKind::pointer, .at = at + glm::vec2(i % 200, 0)});
    int x = 0;
    EXPECT_EQ(allocations([&] {
                  ui.ui().push({.kind = EventKind::pointer, .at = at + glm::vec2(++x % 200, 0)});
                  ui.frame();
              }),
              0U);
    ui.release().focus("Speed").type("12/");
    for (int i = 0; i < 200; ++i) ui.frame();
    EXPECT_EQ(allocations([&] { ui.frame(); }), 0U);
}

TEST_F(Param, AnOpenTextAsksForTwoFramesASecondAtMost) {
    ui.focus("Speed").type("7").settle();
    EXPECT_NEAR(ui.output().wake_at, ui.time + 0.5, 0.1);
    ui.key(Key::escape).move({5, 400}).frame(2);
    EXPECT_EQ(ui.output().wake_at, never);
}

TEST(ParamKinds, FloatsIntegersAnglesAndSharesAreWhatTheyAre) {
    float single = 0.1F;
    int whole = 3;
    double tilt = std::numbers::pi / 4, share = 0.25, delay = 1;
    int changes = 0;
    Harness ui([&](Ui& u) {
        Column column(u, {.width = px(400)});
        changes += param(u, "Float", single, {.step = 0.1, .standard = 0.1}).changed ? 1 : 0;
        param(u, "Int", whole, {.maximum = 10});
        param(u, "Tilt", tilt,
              {.minimum = -180,
               .maximum = 180,
               .step = 1,
               .unit = "deg",
               .standard = 45.0,
               .display = 180 / std::numbers::pi});
        param(u, "Share", share, percent());
        param(u, "Delay", delay, seconds({.maximum = 5, .step = 0.01}));
    });
    EXPECT_EQ(ui.text("Float"), "0.1");
    EXPECT_FALSE(ui.is("Float", Is::changed));
    ui.focus("Float").key('C', Mods::command);
    EXPECT_EQ(ui.clipboard().text, "0.1");
    ui.type("0.7").key(Key::enter);
    EXPECT_EQ(single, 0.7F);
    ui.type("0.70").key(Key::enter);
    EXPECT_EQ(changes, 1) << "the same float";
    ui.focus("Int").type("2.6").key(Key::enter);
    EXPECT_EQ(whole, 3);
    ui.type("1e300").key(Key::enter);
    EXPECT_EQ(whole, std::numeric_limits<int>::max());
    EXPECT_EQ(ui.text("Tilt"), "45\u00B0");
    EXPECT_FALSE(ui.is("Tilt", Is::changed));
    ui.focus("Tilt").key(Key::right);
    EXPECT_DOUBLE_EQ(tilt, 46 * std::numbers::pi / 180);
    EXPECT_EQ(ui.text("Tilt"), "46\u00B0");
    EXPECT_EQ(ui.text("Share"), "25%");
    ui.focus("Share").type("40%").key(Key::enter);
    EXPECT_DOUBLE_EQ(share, 0.4);
    ui.focus("Delay").type("250ms").key(Key::enter);
    EXPECT_DOUBLE_EQ(delay, 0.25);
    EXPECT_EQ(ui.text("Delay"), "0.25 s");
}

TEST(ParamKinds, DragsGoEquallyFarAlongScales) {
    double hertz = 10;
    Harness ui([&](Ui& u) {
        Column column(u, {.width = px(640)});
        param(u, "Rate", hertz, {.minimum = 1, .maximum = 10000, .unit = "Hz", .scale = ValueScale::logarithmic});
    });
    ui.drag("Rate", {3 + 88, 0});
    EXPECT_NEAR(hertz, 100, 1) << "a quarter of the field, a decade";
    ui.drag("Rate", {3 + 88, 0});
    EXPECT_NEAR(hertz, 1000, 10);
}

TEST(ParamKinds, TheFieldAloneWorksAsWell) {
    double red = 100;
    Harness ui([&](Ui& u) {
        Row row(u, {.width = px(200)});
        number_field(u, "R", red, {.maximum = 200, .step = 1});
    });
    ui.press("R", {0.05F, 0.5F}).drag_by({23, 0}).release();
    EXPECT_EQ(red, 120);
    ui.click("R", {.clicks = 2}).type("7").key(Key::enter);
    EXPECT_EQ(red, 7);
}

TEST(ParamKinds, TheMarkStandsBelowTheDigitsAndTheCaptionClearOfTheRing) {
    for (const float scale : {0.75F, 1.0F, 1.25F, 1.5F, 2.0F, 3.0F}) {
        double value = 98;
        const auto build = [&](Ui& u) { param(u, "H", value, {.maximum = 100, .step = 1}); };
        Harness ui(build, {640, 480}, scale);
        float text_bottom = 0, text_left = 1e9F, mark_top = 1e9F;
        for (const Instance& each : ui.output().list->instances) {
            if (each.kind == InstanceKind::glyph) {
                text_bottom = std::max(text_bottom, each.y + each.h), text_left = std::min(text_left, each.x);
            } else if (each.color == dark_theme().accent) {
                mark_top = std::min(mark_top, each.y);
            }
        }
        EXPECT_GE(mark_top, text_bottom) << scale;
        EXPECT_LT(mark_top, ui.rect("H").bottom() - 2 * scale) << "and can be seen";
        EXPECT_GE(text_left, ui.rect("H").x + 3 * scale);
    }
}

TEST(ParamKinds, RangesThatMakeNoSenseAreNoFault) {
    const double endless = std::numeric_limits<double>::infinity(), none = std::nan("");
    double value = 0.5, low = 0.2, high = 0.8;
    ParamOptions options;
    Harness ui([&](Ui& u) {
        Column column(u, {.width = px(640)});
        param(u, "One", value, options);
        range_param(u, "Two", low, high, options);
    });
    for (const auto& [from, to] : {std::pair{5.0, 1.0}, {none, none}, {0.0, endless}, {-endless, 1.0}, {3.0, none}}) {
        for (const ValueScale scale : {ValueScale::linear, ValueScale::logarithmic}) {
            options = {.minimum = from, .maximum = to, .hard_minimum = none, .scale = scale};
            ui.frame().focus("One").key(Key::right).drag("One", {20, 0}).drag("Two/High", {-20, 0});
            EXPECT_TRUE(std::isfinite(value) && std::isfinite(low) && std::isfinite(high));
        }
    }
    options = {.minimum = 5, .maximum = 1};
    ui.frame().focus("One").key(Key::end, Mods::command);
    EXPECT_EQ(value, 5);
}

TEST(ParamKinds, ALabelThatIsCutIsWholeInItsTooltip) {
    double value = 0;
    Harness ui([&](Ui& u) {
        Column column(u, {.width = px(200)});
        param(u, "Diffusion of carbonised tissue", value, {.tip = "Per second"});
        param(u, "Short", value, {.tip = "Per second"});
    });
    ui.move_to("Diffusion of carbonised tissue").move_to("Diffusion of carbonised tissue", {0.6F, 0.5F});
    EXPECT_EQ(ui.tip("Diffusion of carbonised tissue"), "Diffusion of carbonised tissue\nPer second");
    ui.move_to("Short");
    EXPECT_EQ(ui.tip("Short"), "Per second");
}

}  // namespace
}  // namespace lapfx::ui
