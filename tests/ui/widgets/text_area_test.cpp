#include "ui/widgets/text_area.h"

#include <random>

#include "ui/core/paragraph.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

struct TextAreaTest : testing::Test {
    std::string text = "one\ntwo two\nthree";
    TextAreaOptions options{.lines = 4};
    int commits = 0, cancels = 0;
    Harness ui{[this](Ui& u) {
                   const Edit edit = text_area(u, "Notes", text, options);
                   commits += edit.committed, cancels += edit.cancelled;
                   std::string other;
                   u.leaf(Role::button, "Other", Sense::focus | Sense::hover | Sense::press).size[1] = px(20);
               },
               {300, 300}};

    float line_height() { return Harness::fonts().metrics(ui.ui().text_style()).height; }
    void click_line(int line, float x = 4) {
        const Rect rect = ui.rect("Notes");
        const glm::vec2 at{rect.x + ui.ui().em(0.5F) + x,
                           rect.y + ui.ui().em(0.3F) + (static_cast<float>(line) + 0.5F) * line_height()};
        ui.send({.kind = EventKind::press, .at = at});
        ui.release();
    }
    std::string copied() {
        ui.clipboard().text = "(nothing)";
        ui.key('C', Mods::command);
        return ui.clipboard().text;
    }
};

TEST_F(TextAreaTest, EnterMakesALineAndCommandEnterCommits) {
    click_line(0, 0);
    ui.key(Key::enter);
    EXPECT_EQ(text, "\none\ntwo two\nthree");
    EXPECT_EQ(commits, 0);
    ui.key(Key::enter, Mods::command);
    EXPECT_EQ(commits, 1);
    EXPECT_EQ(text, "\none\ntwo two\nthree");
}

TEST_F(TextAreaTest, EscapeGoesBackAndLeavingCommits) {
    ui.focus("Notes").type("x").key(Key::escape);
    EXPECT_EQ(text, "one\ntwo two\nthree");
    EXPECT_EQ(cancels, 1);
    ui.type("y").key(Key::tab);
    EXPECT_EQ(text, "one\ntwo two\nthreey");
    EXPECT_EQ(commits, 1);
    EXPECT_EQ(ui.focused(), "Other");
}

TEST_F(TextAreaTest, APressPlacesTheCaretInItsLine) {
    click_line(1, 0);
    ui.type(">");
    EXPECT_EQ(text, "one\n>two two\nthree");
    click_line(3, 200);
    ui.type("!");
    EXPECT_EQ(text, "one\n>two two\nthree!") << "below the last line is in it";
}

TEST_F(TextAreaTest, UpAndDownKeepTheirPlaceOverShorterLines) {
    text = "long line\na\nlong line";
    ui.frame();
    click_line(0, 200);
    ui.key(Key::down).key(Key::down).type("|");
    EXPECT_EQ(text, "long line\na\nlong line|");
    ui.key(Key::up).type("b").key(Key::up).type("c");
    EXPECT_EQ(text.substr(0, 2), "lo");
    EXPECT_EQ(text.find("ab|"), std::string::npos);
    EXPECT_NE(text.find("\nab\n"), std::string::npos);
}

TEST_F(TextAreaTest, UpInTheFirstLineGoesToTheBeginAndDownInTheLastToTheEnd) {
    click_line(0, 200);
    ui.key(Key::up).type("<").key(Key::end, Mods::command).key(Key::home).key(Key::down).type(">");
    EXPECT_EQ(text, "<one\ntwo two\nthree>");
}

TEST_F(TextAreaTest, LongLinesWrapAndHomeAndEndKeepToWhatIsSeen) {
    text.clear();
    for (int i = 0; i < 20; ++i) text += "word ";
    ui.frame();
    click_line(1, 0);
    ui.key(Key::home).type("<").key(Key::end).type(">");
    const std::size_t open = text.find('<'), close = text.find('>');
    EXPECT_GT(open, 20U);
    EXPECT_EQ(text[open - 1], ' ') << "a line begins after a space";
    EXPECT_GT(close, open + 20);
    EXPECT_EQ(text[close + 1], ' ');
    EXPECT_LT(close, text.size() - 10);
}

TEST_F(TextAreaTest, ShiftSelectsOverLinesAndThreePressesTakeOne) {
    click_line(0, 0);
    ui.key(Key::down, Mods::shift);
    EXPECT_EQ(copied(), "one\n");
    ui.frame(1);
    const Rect rect = ui.rect("Notes");
    const float y = (ui.ui().em(0.3F) + 1.5F * line_height()) / rect.h;
    ui.click("Notes", {.clicks = 2, .at = {0.1F, y}});
    EXPECT_EQ(copied(), "two");
    ui.frame(1).click("Notes", {.clicks = 3, .at = {0.1F, y}});
    EXPECT_EQ(copied(), "two two\n");
}

TEST_F(TextAreaTest, TheWheelScrollsAndTypingComesBackToTheCaret) {
    text.clear();
    for (int i = 0; i < 100; ++i) text += "line " + std::to_string(i) + "\n";
    ui.frame();
    click_line(0, 0);
    const auto offset = [&] { return ui.node("Notes").scroll->offset.y; };
    ui.wheel("Notes", {0, -5});
    EXPECT_GT(offset(), 100);
    ui.type("x");
    EXPECT_EQ(offset(), 0);
    EXPECT_TRUE(text.starts_with("xline 0"));
    ui.key(Key::end, Mods::command);
    EXPECT_NEAR(offset(), 101 * line_height() + 2 * ui.ui().em(0.3F) - ui.rect("Notes").h, 1.01F);
    ui.key(Key::page_up).type("p");
    EXPECT_NE(text.find("p"), std::string::npos);
    EXPECT_NE(text.substr(text.size() - 1), "p");
}

TEST_F(TextAreaTest, SelectingAllAndCopyingDoNotScroll) {
    text.clear();
    for (int i = 0; i < 100; ++i) text += "line\n";
    ui.frame();
    click_line(0, 0);
    ui.key('A', Mods::command);
    EXPECT_EQ(copied(), text);
    EXPECT_EQ(ui.node("Notes").scroll->offset.y, 0);
    ui.key('X', Mods::command);
    EXPECT_EQ(text, "");
}

TEST_F(TextAreaTest, TheBarIsDraggedAndPressedByPages) {
    text.clear();
    for (int i = 0; i < 100; ++i) text += "line\n";
    ui.frame();
    const auto offset = [&] { return ui.node("Notes").scroll->offset.y; };
    const float x = 1 - ui.ui().em(0.4F) / ui.rect("Notes").w;
    ui.click("Notes", {.at = {x, 0.9F}});
    EXPECT_NEAR(offset(), 0.9F * ui.rect("Notes").h, 1);
    const float before = offset();
    ui.press("Notes", {x, 0.35F}).drag_by({0, 10});
    EXPECT_GT(offset(), before + 100);
    ui.drag_by({0, 1000}).release();
    EXPECT_NEAR(offset(), ui.node("Notes").scroll->content.y - ui.rect("Notes").h, 1);
}

TEST_F(TextAreaTest, ADragBelowTheEdgeScrolls) {
    text.clear();
    for (int i = 0; i < 50; ++i) text += "line\n";
    ui.frame();
    ui.press("Notes", {0.1F, 0.1F}).move({40, ui.rect("Notes").bottom() + 30});
    for (int i = 0; i < 40; ++i) ui.frame();
    EXPECT_GT(ui.node("Notes").scroll->offset.y, 50);
    ui.release();
    EXPECT_GT(copied().size(), 40U);
}

TEST_F(TextAreaTest, ADragBelowTheEndLetsTheMachineSleep) {
    ui.press("Notes", {0.1F, 0.1F}).move({40, ui.rect("Notes").bottom() + 30});
    EXPECT_GT(ui.output().wake_at, ui.time + 0.1);
}

TEST_F(TextAreaTest, ARightClickOffersWhatIsUsual) {
    click_line(1, 0);
    ui.key(Key::end, Mods::shift).right_click("Notes").click("Notes menu/Cut");
    EXPECT_EQ(text, "one\n\nthree");
    EXPECT_EQ(ui.focused(), "Notes");
    ui.right_click("Notes").click("Notes menu/Paste");
    EXPECT_EQ(text, "one\ntwo two\nthree");
    EXPECT_EQ(commits, 0);
}

TEST_F(TextAreaTest, AReadOnlyOneTakesNoLineBreaks) {
    options.read_only = true;
    ui.frame().focus("Notes").type("x").key(Key::enter).key(Key::backspace);
    EXPECT_EQ(text, "one\ntwo two\nthree");
}

TEST_F(TextAreaTest, SteadyFramesAllocateNothing) {
    click_line(1);
    for (int i = 0; i < 200; ++i) ui.frame(0);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) ui.frame(0.02);
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST(BreakLines, NoLineIsWiderThanAllowedAndNothingIsLost) {
    std::mt19937 random(7);
    Fonts& fonts = Harness::fonts();
    const TextStyle style{.size = 14};
    const std::string_view pieces[] = {"a", "word", " ", " ", "\n", "extraordinarily", "\u6f22\u5b57", "WWW", "\xff"};
    std::vector<std::uint32_t> begins;
    for (int round = 0; round < 200; ++round) {
        std::string text;
        for (int i = 0; i < 60; ++i) text += pieces[random() % std::size(pieces)];
        const float width = 20.0F + static_cast<float>(random() % 200);
        break_lines(fonts, text, style, width, begins);
        ASSERT_EQ(begins.front(), 0U);
        ASSERT_TRUE(std::is_sorted(begins.begin(), begins.end()));
        std::size_t breaks = 0;
        for (std::size_t i = 0; i < begins.size(); ++i) {
            const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : text.size();
            std::string_view line(text.data() + begins[i], end - begins[i]);
            if (line.ends_with('\n')) ++breaks, line.remove_suffix(1);
            ASSERT_EQ(line.find('\n'), std::string_view::npos);
            while (line.ends_with(' ')) line.remove_suffix(1);
            if (line.size() <= 3) continue;
            ASSERT_LE(fonts.run(line, style).width, width * 1.04F + 1) << line;
        }
        ASSERT_EQ(breaks, static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
    }
}

TEST(BreakLines, WordsStayWholeWhereTheyFit) {
    std::vector<std::uint32_t> begins;
    Fonts& fonts = Harness::fonts();
    const float width = fonts.run("hello world", {}).width;
    break_lines(fonts, "hello world again", {}, width + 1, begins);
    EXPECT_THAT(begins, testing::ElementsAre(0, 12));
    break_lines(fonts, "", {}, width, begins);
    EXPECT_THAT(begins, testing::ElementsAre(0));
    break_lines(fonts, "a\n", {}, width, begins);
    EXPECT_THAT(begins, testing::ElementsAre(0, 2));
}

}  // namespace
}  // namespace lapfx::ui
