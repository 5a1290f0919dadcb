#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

constexpr std::string_view views[] = {"Colour", "Matte", "False colour"};

struct ChoiceTest : testing::Test {
    int chosen = 0, edits = 0;
    bool disabled = false;
    Harness ui{[this](Ui& u) {
        u.push_disabled(disabled);
        const Edit edit = segmented(u, "View", chosen, views);
        u.pop_disabled();
        EXPECT_EQ(edit.changed, edit.committed);
        edits += edit.changed;
        button(u, "After");
    }};
};

TEST_F(ChoiceTest, AClickChoosesAndIsSeenInTheSameFrame) {
    ui.click("View/Matte");
    EXPECT_EQ(chosen, 1);
    EXPECT_EQ(edits, 1);
    EXPECT_TRUE(ui.is("View/Matte", Is::checked));
    EXPECT_FALSE(ui.is("View/Colour", Is::checked));
    ui.click("View/Matte");
    EXPECT_EQ(edits, 1) << "it was chosen";
}

TEST_F(ChoiceTest, ArrowsChooseAndGoRound) {
    ui.focus("View/Colour").key(Key::right).key(Key::down);
    EXPECT_EQ(chosen, 2);
    EXPECT_EQ(ui.focused(), "View/False colour");
    EXPECT_TRUE(ui.is("View/False colour", Is::ringed));
    ui.key(Key::right);
    EXPECT_EQ(chosen, 0);
    ui.key(Key::left);
    EXPECT_EQ(chosen, 2);
    ui.key(Key::up).key(Key::home);
    EXPECT_EQ(chosen, 0);
    ui.key(Key::end);
    EXPECT_EQ(chosen, 2);
}

TEST_F(ChoiceTest, TabStopsOnceAtWhatIsChosen) {
    ui.click("View/Matte").key(Key::tab);
    EXPECT_EQ(ui.focused(), "After");
    ui.key(Key::tab);
    EXPECT_EQ(ui.focused(), "View/Matte");
}

TEST_F(ChoiceTest, ADisabledOneKeepsItsChoice) {
    disabled = true;
    ui.frame().click("View/Matte").key(Key::tab).key(Key::right);
    EXPECT_EQ(chosen, 0);
    EXPECT_TRUE(ui.is("View/Colour", Is::checked));
    EXPECT_TRUE(ui.is("View/Matte", Is::disabled));
}

TEST_F(ChoiceTest, AChoiceThatIsNotThereIsBroughtIntoRange) {
    chosen = 9;
    ui.frame();
    EXPECT_EQ(chosen, 2);
    chosen = -1;
    ui.frame();
    EXPECT_EQ(chosen, 0);
    EXPECT_EQ(edits, 0);
}

TEST_F(ChoiceTest, TheRolesAreThoseOfRadioButtonsInAGroup) {
    EXPECT_EQ(ui.node("View").role, Role::group);
    EXPECT_EQ(ui.node("View/Matte").role, Role::radio);
    EXPECT_TRUE(faults_of(ui.ui().tree()).empty());
    for (const std::string_view view : views) EXPECT_GE(ui.rect("View/" + std::string(view)).h, 24);
}

TEST_F(ChoiceTest, SteadyFramesAllocateNothing) {
    ui.click("View/Matte").move({600, 400});
    for (int i = 0; i < 200; ++i) ui.frame();
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 50; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST(Choice, NothingToChooseFromIsNoFault) {
    int chosen = 3;
    Harness ui([&](Ui& u) { segmented(u, "None", chosen, {}); });
    EXPECT_EQ(chosen, 3);
}

TEST(Choice, SegmentsTouchAndShareTheWidth) {
    int chosen = 0;
    Harness ui([&](Ui& u) { segmented(u, "View", chosen, views); });
    EXPECT_EQ(ui.rect("View/Colour").right(), ui.rect("View/Matte").x);
    EXPECT_EQ(ui.rect("View/False colour").right(), 640);
}

TEST(Choice, SegmentsThatHaveTooLittleRoomStayWithinIt) {
    int chosen = 0;
    float width = 640;
    Harness ui([&](Ui& u) {
        Row row(u, {.width = px(width)});
        segmented(u, "View", chosen, views);
        button(u, "Beside");
    });
    ui.move_to("View/False colour");
    EXPECT_EQ(ui.tip("View/False colour"), "");
    width = 200;
    ui.frame();
    EXPECT_LE(ui.rect("View/False colour").right(), ui.rect("Beside").x);
    EXPECT_EQ(ui.rect("Beside").right(), 200);
    EXPECT_EQ(ui.frame().tip("View/False colour"), "False colour");
    float fit = 0;
    Harness toolbar([&](Ui& u) {
        Row row(u, {.width = ui::fit()});
        segmented(u, "View", chosen, views);
        fit = 0;
        for (const std::string_view view : views) fit += u.text_width(view);
    });
    EXPECT_GT(toolbar.rect("View/False colour").right(), fit) << "they wish to be seen whole";
}

}  // namespace
}  // namespace lapfx::ui
