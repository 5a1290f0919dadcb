#include "ui/widgets/combo.h"

#include "ui/core/node.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

struct ComboTest : testing::Test {
    std::vector<std::string> names = {"Apple", "Apricot", "Banana", "Cherry", "Damson"};
    std::vector<std::string_view> choices;
    int chosen = 2, edits = 0;
    ComboOptions options;
    Harness ui{[this](Ui& u) {
        choices.assign(names.begin(), names.end());
        const Edit edit = combo(u, "Fruit", chosen, choices, options);
        EXPECT_EQ(edit.began, edit.committed);
        edits += edit.changed;
        button(u, "Below");
    }};

    void make_long(int count) {
        names.clear();
        for (int i = 0; i < count; ++i) names.push_back("item " + std::to_string(i));
        choices.reserve(names.size());
        ui.frame();
    }
    bool open() { return ui.exists("Fruit choices"); }
    std::string marked() {
        for (const Node& node : ui.ui().tree()) {
            if (node.role == Role::list_item && has(node.is, Is::selected)) return std::string(node.text);
        }
        return "";
    }
    std::size_t rows() {
        return static_cast<std::size_t>(std::count_if(ui.ui().tree().begin(), ui.ui().tree().end(),
                                                      [](const Node& n) { return n.role == Role::list_item; }));
    }
};

TEST_F(ComboTest, AClickOpensAndAClickOnARowTakesIt) {
    ui.click("Fruit");
    ASSERT_TRUE(open());
    EXPECT_TRUE(ui.is("Fruit", Is::expanded));
    EXPECT_TRUE(ui.is("**/Banana", Is::checked));
    ui.click("**/Cherry");
    EXPECT_FALSE(open());
    EXPECT_EQ(chosen, 3);
    EXPECT_EQ(edits, 1);
    EXPECT_EQ(ui.text("Fruit"), "Cherry");
    EXPECT_EQ(ui.value("Fruit"), 3);
    EXPECT_EQ(ui.focused(), "Fruit");
}

TEST_F(ComboTest, TheListLiesBelowTheFieldAndIsAsWide) {
    ui.click("Fruit");
    EXPECT_GE(ui.rect("Fruit choices").y, ui.rect("Fruit").bottom());
    EXPECT_GE(ui.rect("Fruit choices").w, ui.rect("Fruit").w);
}

TEST_F(ComboTest, EnterAndSpaceOpenArrowsMoveEnterTakes) {
    ui.focus("Fruit").key(Key::enter);
    ASSERT_TRUE(open());
    EXPECT_EQ(marked(), "Banana");
    ui.key(Key::down).key(Key::down);
    EXPECT_EQ(marked(), "Damson");
    ui.key(Key::down);
    EXPECT_EQ(marked(), "Apple") << "round the end";
    ui.key(Key::up).key(Key::home).key(Key::down).key(Key::enter);
    EXPECT_FALSE(open());
    EXPECT_EQ(chosen, 1);
    ui.key(Key::space);
    EXPECT_TRUE(open());
}

TEST_F(ComboTest, EscapeAndAPressOutsideLeaveAllAsItWas) {
    ui.focus("Fruit").key(Key::enter).key(Key::down).key(Key::escape);
    EXPECT_FALSE(open());
    EXPECT_EQ(chosen, 2);
    EXPECT_EQ(ui.focused(), "Fruit");
    ui.click("Fruit").send({.kind = EventKind::press, .at = {600, 470}});
    EXPECT_FALSE(open());
    EXPECT_EQ(edits, 0);
}

TEST_F(ComboTest, ClosedArrowsChooseWithoutGoingRound) {
    ui.focus("Fruit").key(Key::down);
    EXPECT_EQ(chosen, 3);
    EXPECT_EQ(ui.text("Fruit"), "Cherry");
    ui.key(Key::down).key(Key::down);
    EXPECT_EQ(chosen, 4);
    for (int i = 0; i < 6; ++i) ui.key(Key::up);
    EXPECT_EQ(chosen, 0);
    EXPECT_EQ(edits, 6);
}

TEST_F(ComboTest, OnlyTheCommandWheelChooses) {
    ui.wheel("Fruit", {0, -1});
    EXPECT_EQ(chosen, 2);
    ui.wheel("Fruit", {0, -1}, Mods::command);
    EXPECT_EQ(chosen, 3);
    ui.wheel("Fruit", {0, 1}, Mods::command);
    EXPECT_EQ(chosen, 2);
}

TEST_F(ComboTest, PartsOfANotchAddUp) {
    for (int i = 0; i < 4; ++i) ui.wheel("Fruit", {0, -0.25F}, Mods::command);
    EXPECT_EQ(chosen, 3);
    EXPECT_EQ(edits, 1);
    ui.wheel("Fruit", {0, -0.75F}, Mods::command).wheel("Fruit", {0, 0.5F}, Mods::command);
    EXPECT_EQ(chosen, 3) << "turning back begins anew";
    ui.wheel("Fruit", {0, 2}, Mods::command);
    EXPECT_EQ(chosen, 1);
}

TEST_F(ComboTest, LettersGoToTheNextThatBeginsSo) {
    ui.focus("Fruit").type("a");
    EXPECT_EQ(chosen, 0);
    ui.type("p").type("r");
    EXPECT_EQ(chosen, 1) << "typed together: apr";
    ui.frame(2).type("a");
    EXPECT_EQ(chosen, 0) << "a new word after a pause, on from where it was";
    ui.type("a");
    EXPECT_EQ(chosen, 1) << "the same letter again: the next of it";
}

TEST_F(ComboTest, LettersMoveInAnOpenListToo) {
    ui.focus("Fruit").key(Key::enter).type("d");
    EXPECT_EQ(marked(), "Damson");
    EXPECT_EQ(chosen, 2);
    ui.key(Key::enter);
    EXPECT_EQ(chosen, 4);
}

TEST_F(ComboTest, ALongListHasAFilterThatTakesTheKeyboard) {
    make_long(200);
    ui.focus("Fruit").key(Key::enter);
    EXPECT_EQ(ui.focused(), "Fruit choices/Filter");
    ui.type("ITEM 19");
    EXPECT_EQ(marked(), "item 19");
    EXPECT_EQ(rows(), 12U) << "19, 119 and 190 to 199";
    ui.key(Key::down).key(Key::enter);
    EXPECT_EQ(names[static_cast<std::size_t>(chosen)], "item 119");
}

TEST_F(ComboTest, AFilterThatNothingFitsTakesNothing) {
    make_long(50);
    ui.focus("Fruit").key(Key::enter).type("xyz");
    EXPECT_EQ(rows(), 0U);
    ui.key(Key::down).key(Key::enter);
    EXPECT_EQ(edits, 0);
    ui.key(Key::backspace).key(Key::backspace).key(Key::backspace);
    EXPECT_GT(rows(), 10U);
}

TEST_F(ComboTest, TenThousandChoicesBuildOnlyWhatIsSeen) {
    make_long(10000);
    chosen = 5000;
    ui.frame().click("Fruit");
    EXPECT_LE(rows(), 16U);
    EXPECT_EQ(marked(), "item 5000");
    EXPECT_TRUE(ui.exists("**/item 5000"));
    const Rect list = ui.rect("Fruit choices/Choices"), row = ui.rect("**/item 5000");
    EXPECT_NEAR(row.center().y, list.center().y, row.h) << "in the middle, in the first frame";
    ui.key(Key::page_down);
    EXPECT_EQ(marked(), "item 5012");
    ui.wheel("Fruit choices/Choices", {0, -1000000});
    EXPECT_TRUE(ui.exists("**/item 9999"));
    ui.key(Key::down);
    EXPECT_TRUE(marked().starts_with("item 50")) << "keys come back to the mark";
}

TEST_F(ComboTest, TheBarIsDragged) {
    make_long(1000);
    chosen = 0;
    ui.frame().click("Fruit");
    ui.press("Fruit choices/Choices/Scroll", {0.5F, 0.02F}).drag_by({0, 100});
    EXPECT_GT(ui.value("Fruit choices/Choices/Scroll"), 2000);
    EXPECT_FALSE(ui.exists("**/item 0"));
    ui.release();
    EXPECT_TRUE(open());
    EXPECT_EQ(ui.focused(), "Fruit choices/Filter");
}

TEST_F(ComboTest, APointerThatMovesMarksWhatItIsOver) {
    ui.focus("Fruit").key(Key::enter);
    ui.move_to("**/Damson");
    EXPECT_EQ(marked(), "Damson");
    ui.key(Key::up);
    EXPECT_EQ(marked(), "Cherry") << "the pointer rests: the keys have the mark";
}

TEST_F(ComboTest, NothingChosenIsShownByThePlaceholder) {
    chosen = -1;
    options.placeholder = "Choose";
    ui.frame();
    EXPECT_EQ(ui.text("Fruit"), "");
    ui.focus("Fruit").key(Key::down);
    EXPECT_EQ(chosen, 0);
    chosen = 99;
    ui.frame();
    EXPECT_EQ(chosen, 4);
}

TEST_F(ComboTest, AListWithoutChoicesDoesNotOpen) {
    names.clear();
    ui.frame().click("Fruit").key(Key::enter).key(Key::down).type("a");
    EXPECT_FALSE(open());
    EXPECT_EQ(chosen, -1);
}

TEST_F(ComboTest, ADisabledOneTakesNothing) {
    Harness dead([&](Ui& u) {
        u.push_disabled(true);
        combo(u, "Fruit", chosen, choices, {.tip = "why"});
        u.pop_disabled();
    });
    dead.click("Fruit").key(Key::tab).key(Key::down);
    EXPECT_FALSE(dead.exists("Fruit choices"));
    EXPECT_EQ(chosen, 2);
    EXPECT_EQ(dead.tip("Fruit"), "why");
    EXPECT_EQ(dead.text("Fruit"), "Banana");
}

TEST_F(ComboTest, EqualChoicesAreToldApart) {
    names = {"same", "same", "same"};
    chosen = 0;
    ui.frame().focus("Fruit").key(Key::enter).key(Key::down).key(Key::enter);
    EXPECT_EQ(chosen, 1);
    EXPECT_EQ(ui.ui().duplicates(), 0U);
}

TEST_F(ComboTest, SteadyFramesAllocateNothingOpenOrClosed) {
    make_long(500);
    for (const bool opened : {false, true}) {
        if (opened) ui.click("Fruit");
        for (int i = 0; i < 200; ++i) ui.frame(0);
        const std::size_t before = test::allocations_so_far();
        for (int i = 0; i < 50; ++i) ui.frame(0.02);
        EXPECT_EQ(test::allocations_so_far(), before) << opened;
    }
}

TEST(ContainsWords, WantsAllOfThemInAnyOrderAndCase) {
    EXPECT_TRUE(contains_words("Colour matte", ""));
    EXPECT_TRUE(contains_words("Colour matte", "MATTE col"));
    EXPECT_TRUE(contains_words("Colour matte", "  our  "));
    EXPECT_FALSE(contains_words("Colour matte", "matte x"));
    EXPECT_FALSE(contains_words("", "x"));
}

/// Space and letters as the program's shortcuts.
struct Pressed : Shortcuts {
    std::string keys;
    bool press(Key key, Mods) override {
        if (!printable(key)) return false;
        keys += static_cast<char>(key);
        return key == Key::space || key == key_of('P');
    }
};

TEST(Combo, AfterAChoiceByThePointerKeysAreTheProgramsAgain) {
    const std::vector<std::string_view> choices = {"Apple", "Pear", "Plum"};
    int chosen = 0;
    Pressed shortcuts;
    Harness ui([&](Ui& u) { combo(u, "Fruit", chosen, choices, {}); }, {640, 480}, 1, &shortcuts);
    ui.click("Fruit").click("**/Pear");
    EXPECT_EQ(chosen, 1);
    ui.type("p l");
    EXPECT_EQ(shortcuts.keys, "P L");
    EXPECT_EQ(chosen, 1) << "no letter changes the choice";
    EXPECT_FALSE(ui.exists("Fruit choices")) << "Space does not open it again";
    ui.key(Key::down);
    EXPECT_EQ(chosen, 2) << "arrows still do";
    ui.key(Key::escape).focus("Fruit").type("a");
    EXPECT_EQ(chosen, 0) << "by keyboard, letters choose";
    ui.key(Key::space);
    EXPECT_TRUE(ui.exists("Fruit choices"));
}

}  // namespace
}  // namespace lapfx::ui
