#include "ui/shell/dialog.h"

#include <gmock/gmock.h>

#include "ui/core/tree.h"
#include "ui/support/harness.h"
#include "ui/widgets/combo.h"

namespace lapfx::ui {
namespace {

class DialogTest : public testing::Test {
  protected:
    std::vector<std::size_t> answers;
    std::vector<std::size_t> pressed;
    int cancelled = 0, below = 0;
    bool can_create = true, has_standard = true;
    Harness ui{[this](Ui& u) {
        below += button(u, "Below") ? 1 : 0;
        if (button(u, "Quit")) open_dialog(u, "quit");
        if (button(u, "New")) open_dialog(u, "new");
        const auto answer = ask(
            u, "quit", "Quit?", "There are changes that are not saved.",
            {{.label = "Discard"}, {.label = "Cancel", .cancel = true}, {.label = "Save", .standard = has_standard}},
            Tone::warning);
        if (answer) answers.push_back(*answer);
        Dialog dialog(u, "new", "New preset");
        cancelled += dialog.cancelled() ? 1 : 0;
        if (!dialog) return;
        Node& field = u.leaf(Role::text_field, "Name", Sense::press | Sense::focus | Sense::typing);
        field.size[1] = px(u.row_height());
        u.respond(field);
        const auto index = dialog.buttons({{.label = "Cancel", .cancel = true, .tip = "Makes none"},
                                           {.label = "Create", .standard = true, .enabled = can_create}});
        if (index) pressed.push_back(*index);
    }};
};

TEST_F(DialogTest, IsAsWideAsItsTitleAndItsButtonsWhereThereIsRoom) {
    bool open = true;
    const std::string title = "Save the changes of a preset with a rather long name.json before another is opened?";
    Harness wide{[&](Ui& u) {
        if (std::exchange(open, false)) open_dialog(u, "wide");
        ask(u, "wide", title, "A question",
            {{.label = "Copy the clips and save", .standard = true},
             {.label = "Save under another name..."},
             {.label = "Cancel", .cancel = true}});
    }};
    wide.size = {1000, 700};
    wide.frame().frame();
    const float y = wide.rect(title + "/Copy the clips and save").y;
    EXPECT_EQ(wide.rect(title + "/Cancel").y, y) << "Cancel does not stand alone in a second row";
    EXPECT_GE(wide.rect(title + "/" + title).w, wide.ui().text_width(title)) << "the title is seen whole";
    wide.size = {300, 400};
    wide.frame().frame();
    EXPECT_GT(wide.rect(title + "/" + title).h, 2 * wide.ui().em(1)) << "here it has several lines";
}

TEST_F(DialogTest, ButtonsThatAreTooWideGoOnInAnotherRow) {
    bool open = true;
    Harness narrow{[&](Ui& u) {
        if (std::exchange(open, false)) open_dialog(u, "long");
        const auto answer = ask(u, "long", "Clips lie outside", "A question",
                                {{.label = "Copy the clips and save", .standard = true},
                                 {.label = "Export as a bundle..."},
                                 {.label = "Save under another name..."},
                                 {.label = "Cancel", .cancel = true}});
        if (answer) answers.push_back(*answer);
    }};
    const std::vector<std::string> labels = {"Copy the clips and save", "Export as a bundle...",
                                             "Save under another name...", "Cancel"};
    for (const auto& [scale, size] : {std::pair{1.0F, glm::ivec2(1000, 700)}, {2.0F, {500, 400}}, {1.0F, {200, 300}}}) {
        narrow.scale = scale, narrow.size = size;
        narrow.frame().frame();
        const Rect whole = narrow.rect("Clips lie outside");
        EXPECT_LE(whole.right(), float(size.x));
        for (const std::string& label : labels) {
            const Rect rect = narrow.rect("Clips lie outside/" + label);
            EXPECT_GE(rect.x, whole.x) << label;
            EXPECT_LE(rect.right(), whole.right()) << label;
            EXPECT_LE(rect.bottom(), whole.bottom()) << label;
        }
    }
    narrow.click("Clips lie outside/Cancel");
    EXPECT_THAT(answers, testing::ElementsAre(3));
}

TEST_F(DialogTest, WhatIsTallerThanTheWindowScrollsAboveTheButtons) {
    bool open = true;
    Harness tall{[&](Ui& u) {
        if (std::exchange(open, false)) open_dialog(u, "tall");
        Dialog dialog(u, "tall", "Tall");
        if (!dialog) return;
        for (int i = 0; i < 20; ++i) button(u, "Line " + std::to_string(i));
        dialog.buttons({{.label = "Close", .standard = true, .cancel = true}});
    }};
    tall.size = {500, 300};
    tall.frame().frame();
    EXPECT_LE(tall.rect("Tall/Close").bottom(), 300);
    EXPECT_GT(tall.rect("Tall/Line 19").y, 300) << "out of sight";
    tall.wheel("Tall/Line 2", {0, -100}).frame();
    EXPECT_LE(tall.rect("Tall/Line 19").bottom(), tall.rect("Tall/Close").y);
    tall.size = {500, 900};
    tall.frame().frame();
    EXPECT_FALSE(tall.exists("Tall/vertical scroll bar")) << "with room for all of it nothing scrolls";
    EXPECT_LT(tall.rect("Tall/Line 19").bottom(), tall.rect("Tall/Close").y);
    EXPECT_LT(tall.rect("Tall").h, 900) << "and it is as tall as its content";
}

TEST_F(DialogTest, AListThatIsOpenClosesUnderADialog) {
    bool ask_now = false;
    int chosen = 0;
    Harness both{[&](Ui& u) {
        constexpr std::array<std::string_view, 2> choices = {"One", "Two"};
        combo(u, "Choice", chosen, choices);
        if (std::exchange(ask_now, false)) open_dialog(u, "late");
        const auto answer = ask(u, "late", "Late", "It came by itself.", {{.label = "Close", .cancel = true}});
        if (answer) answers.push_back(*answer);
    }};
    both.click("Choice").frame();
    ASSERT_TRUE(both.exists("Choice choices"));
    ask_now = true;
    both.frame().frame();
    EXPECT_TRUE(both.exists("Late"));
    EXPECT_FALSE(both.exists("Choice choices"));
    both.click("Late/Close").frame();
    EXPECT_EQ(both.focused(), "Choice") << "the keyboard is where it was before the list";
}

TEST_F(DialogTest, AnAnswerIsGivenOnceAndClosesIt) {
    ui.click("Quit").click("Quit?/Discard");
    ui.frame();
    EXPECT_THAT(answers, testing::ElementsAre(0));
    EXPECT_FALSE(ui.exists("Quit?"));
    EXPECT_EQ(ui.focused(), "Quit");
}

TEST_F(DialogTest, AQuestionBeginsAtTheStandardButtonAndEnterPressesIt) {
    ui.focus("Quit").key(Key::enter);
    EXPECT_EQ(ui.focused(), "Quit?/Save");
    EXPECT_TRUE(ui.is("Quit?/Save", Is::ringed));
    ui.key(Key::enter);
    EXPECT_THAT(answers, testing::ElementsAre(2));
}

TEST_F(DialogTest, OpenedByThePointerItShowsWhatEnterPresses) {
    ui.click("Quit");
    EXPECT_EQ(ui.focused(), "Quit?/Save");
    EXPECT_TRUE(ui.is("Quit?/Save", Is::ringed));
}

TEST_F(DialogTest, WithoutAStandardButtonItBeginsWhereNothingIsLost) {
    has_standard = false;
    ui.click("Quit");
    EXPECT_EQ(ui.focused(), "Quit?/Cancel");
    EXPECT_TRUE(ui.is("Quit?/Cancel", Is::ringed));
    ui.key(Key::enter);
    EXPECT_THAT(answers, testing::ElementsAre(1));
}

TEST_F(DialogTest, EscapeIsTheCancelButton) {
    ui.click("Quit").key(Key::escape);
    ui.frame().frame();
    EXPECT_THAT(answers, testing::ElementsAre(1));
}

TEST_F(DialogTest, TheKeyboardStaysInsideAndWhatIsBelowWaits) {
    ui.click("Quit");
    EXPECT_TRUE(ui.is("Quit?", Is::modal));
    std::vector<std::string> reached;
    for (int i = 0; i < 4; ++i) reached.push_back(ui.key(Key::tab).focused());
    EXPECT_THAT(reached, testing::ElementsAre("Quit?/Discard", "Quit?/Cancel", "Quit?/Save", "Quit?/Discard"));
    const glm::vec2 at = ui.rect("Below").center();
    ui.send({.kind = EventKind::press, .at = at}).send({.kind = EventKind::release, .at = at});
    EXPECT_EQ(below, 0);
    EXPECT_TRUE(ui.exists("Quit?"));
    const glm::vec2 ground = ui.rect("Quit?").at() + 3.0F;
    ui.send({.kind = EventKind::press, .at = ground}).send({.kind = EventKind::release, .at = ground});
    EXPECT_EQ(ui.focused(), "Quit?/Discard") << "a press on its ground takes the keyboard from nobody";
}

TEST_F(DialogTest, EnterInATextFieldIsTheStandardButton) {
    ui.click("New");
    EXPECT_EQ(ui.focused(), "New preset/Name") << "content comes first";
    ui.key(Key::enter);
    EXPECT_THAT(pressed, testing::ElementsAre(1));
    EXPECT_FALSE(ui.exists("New preset"));
    EXPECT_EQ(cancelled, 0);
}

TEST_F(DialogTest, AStandardButtonThatIsDisabledIsNotPressed) {
    can_create = false;
    ui.click("New").key(Key::enter).click("New preset/Create");
    EXPECT_THAT(pressed, testing::ElementsAre());
    EXPECT_TRUE(ui.exists("New preset"));
}

TEST_F(DialogTest, EscapeIsToldAndClosesOnlyTheTop) {
    ui.click("New").key(Key::escape);
    EXPECT_EQ(cancelled, 1);
    EXPECT_EQ(ui.frame().focused(), "New");
    EXPECT_EQ(cancelled, 1);
}

TEST_F(DialogTest, ItLiesInTheMiddleWithItsButtonsAtTheRight) {
    ui.click("New");
    const Rect rect = ui.rect("New preset"), create = ui.rect("New preset/Create");
    EXPECT_NEAR(rect.center().x, 320, 1);
    EXPECT_NEAR(rect.center().y, 240, 1);
    EXPECT_EQ(create.right(), rect.right() - 14);
    EXPECT_EQ(ui.tip("New preset/Cancel"), "Makes none");
    EXPECT_TRUE(faults_of(ui.ui().tree()).empty());
}

TEST_F(DialogTest, ASmallWindowHoldsIt) {
    ui.click("Quit");
    ui.size = {200, 120};
    ui.frame();
    EXPECT_LE(ui.rect("Quit?").w, 200);
    EXPECT_GE(ui.rect("Quit?").x, 0);
}

class WaitingDialog : public testing::Test {
  protected:
    bool ready = false;
    std::optional<std::size_t> answer;
    Harness ui{[this](Ui& u) {
        if (button(u, "Open")) open_dialog(u, "load");
        if (const auto a =
                ask(u, "load", "Load?", "A file is being read.",
                    {{.label = "Cancel", .cancel = true}, {.label = "Load", .standard = true, .enabled = ready}}))
            answer = a;
    }};
};

TEST_F(WaitingDialog, TheKeyboardGoesToTheStandardButtonOnceItCanBePressed) {
    ui.focus("Open").key(Key::enter);
    EXPECT_EQ(ui.focused(), "Load?/Cancel");
    ready = true;
    ui.frame().frame();
    EXPECT_EQ(ui.focused(), "Load?/Load");
    ui.key(Key::enter);
    EXPECT_EQ(answer, 1U);
}

}  // namespace
}  // namespace lapfx::ui
