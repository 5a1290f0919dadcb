#include "ui/widgets/section.h"

#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

struct One {
    void build(Ui& u) {
        u.push_disabled(disabled);
        constexpr SectionButton buttons[] = {{Icon::reset, "Reset"}, {Icon::copy, "Copy"}};
        if (Section section(u, "Bleeding", {.changed = changed, .open = open, .tip = "Of vessels", .buttons = buttons});
            true) {
            if (section) button(u, "Speed");
            if (section.clicked() >= 0) clicked = section.clicked();
        }
        u.pop_disabled();
        button(u, "After");
    }
    int changed = -1, clicked = -1;
    bool open = true, disabled = false;
    Harness ui{[this](Ui& u) { build(u); }};
};

TEST(Section, FoldsByClickEnterAndSpaceAndRemembersIt) {
    One t;
    EXPECT_TRUE(t.ui.exists("Bleeding/Speed"));
    const float open_height = t.ui.rect("Bleeding").h;
    t.ui.click("Bleeding/header");
    EXPECT_FALSE(t.ui.exists("Bleeding/Speed"));
    EXPECT_FALSE(t.ui.is("Bleeding", Is::expanded));
    EXPECT_EQ(t.ui.rect("Bleeding").h, t.ui.rect("Bleeding/header").h);
    t.ui.frame().focus("Bleeding/header").key(Key::enter);
    EXPECT_TRUE(t.ui.is("Bleeding", Is::expanded));
    EXPECT_EQ(t.ui.rect("Bleeding").h, open_height);
    t.ui.key(Key::space);
    EXPECT_FALSE(t.ui.exists("Bleeding/Speed"));
}

TEST(Section, LeftClosesAndRightOpens) {
    One t;
    t.ui.focus("Bleeding/header").key(Key::right);
    EXPECT_TRUE(t.ui.is("Bleeding", Is::expanded));
    t.ui.key(Key::left).key(Key::left);
    EXPECT_FALSE(t.ui.is("Bleeding", Is::expanded));
    t.ui.key(Key::right);
    EXPECT_TRUE(t.ui.is("Bleeding/header", Is::expanded));
    EXPECT_EQ(t.ui.focused(), "Bleeding/header");
}

TEST(Section, CanBeClosedToBeginWith) {
    bool open = false;
    Harness ui([&](Ui& u) {
        if (Section section(u, "More", {.open = false}); section) open = true;
    });
    EXPECT_FALSE(open);
    ui.click("More");
    EXPECT_TRUE(open);
}

TEST(Section, TellsHowManyValuesHaveChanged) {
    One t;
    EXPECT_FALSE(t.ui.is("Bleeding", Is::changed));
    EXPECT_EQ(t.ui.text("Bleeding/header"), "Bleeding");
    t.changed = 3;
    t.ui.frame();
    EXPECT_TRUE(t.ui.is("Bleeding", Is::changed));
    EXPECT_EQ(t.ui.text("Bleeding/header"), "Bleeding, 3 changed");
    EXPECT_EQ(t.ui.tip("Bleeding/header"), "Of vessels");
}

TEST(Section, ItsButtonsDoNotFoldIt) {
    One t;
    t.ui.click("Bleeding/Copy");
    EXPECT_EQ(t.clicked, 1);
    t.ui.click("Bleeding/Reset");
    EXPECT_EQ(t.clicked, 0);
    EXPECT_TRUE(t.ui.is("Bleeding", Is::expanded));
    EXPECT_EQ(t.ui.rect("Bleeding/Copy").right(), t.ui.rect("Bleeding").right());
}

TEST(Section, DisabledItStaysAsItIs) {
    One t;
    t.disabled = true;
    t.ui.frame().click("Bleeding/header");
    EXPECT_TRUE(t.ui.is("Bleeding/header", Is::disabled));
    EXPECT_TRUE(t.ui.exists("Bleeding/Speed"));
    EXPECT_EQ(t.ui.key(Key::tab).focused(), "After");
}

TEST(Section, SteadyFramesAllocateNothing) {
    One t;
    t.changed = 12;
    for (int i = 0; i < 10; ++i) t.ui.frame();
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) t.ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

TEST(Section, TwoOfOneNameFoldEachOnItsOwn) {
    bool first = false, second = false;
    Harness ui([&](Ui& u) {
        {
            const Section section(u, "Vessels");
            first = static_cast<bool>(section);
        }
        const Section section(u, "Vessels");
        second = static_cast<bool>(section);
    });
    ui.send({.kind = EventKind::press, .at = {100, 10}}).send({.kind = EventKind::release, .at = {100, 10}});
    EXPECT_FALSE(first);
    EXPECT_TRUE(second);
}

}  // namespace
}  // namespace lapfx::ui
