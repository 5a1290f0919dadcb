#include "ui/shell/path_completion.h"

#include <system_error>

#include "ui/shell/file_dialog_fixture.h"
#include "ui/support/count_allocations.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;
using Names = std::vector<std::string_view>;

TEST(LongestCommon, IsWhatAllBeginWith) {
    EXPECT_EQ(longest_common(Names{"shot 9", "shot 10"}, "s"), "shot ");
    EXPECT_EQ(longest_common(Names{"shot 9"}, "s"), "shot 9");
    EXPECT_EQ(longest_common(Names{"shot", "shots"}, "shot"), "shot");
    EXPECT_EQ(longest_common(Names{}, "x"), "x");
}

TEST(LongestCommon, SpellsAsTheFilesDoWhereTheyAgree) {
    EXPECT_EQ(longest_common(Names{"Shot A", "Shot B"}, "sh"), "Shot ");
    EXPECT_EQ(longest_common(Names{"Shot A", "shot B"}, "sh"), "shot ") << "as typed where they do not";
    EXPECT_EQ(longest_common(Names{"Shot", "sHoT"}, "s"), "s");
}

TEST(LongestCommon, IsNeverHalfACharacter) {
    EXPECT_EQ(longest_common(Names{"fil\xc3\xa9", "fil\xc3\xa8"}, "f"), "fil") << "two letters that share a byte";
    EXPECT_EQ(longest_common(Names{"\xff\xfe", "\xff\xfd"}, ""), "\xff") << "what is no UTF-8 stays as it is";
}

class PathCompletionTest : public FileDialogTest {
  protected:
    PathCompletionTest() = default;
    explicit PathCompletionTest(RunBeside beside) : FileDialogTest(std::move(beside)) {}
    std::vector<std::string> suggested() {
        std::vector<std::string> all;
        for (const Node& node : ui.ui().tree())
            if (node.role == Role::list_item) all.emplace_back(node.text);
        return all;
    }
    std::string name() { return ui.text("Plates/Name"); }
};

TEST_F(PathCompletionTest, ListsWhatBeginsSoAndOnlyWhatIsLookedFor) {
    open(request(FileTask::open));
    EXPECT_THAT(suggested(), ElementsAre());
    ui.type("SH");
    EXPECT_THAT(suggested(), ElementsAre("shot 9.exr", "shot 10.exr"));
    EXPECT_EQ(ui.focused(), "Plates/Name");
    ui.type("x");
    EXPECT_THAT(suggested(), ElementsAre());
    EXPECT_FALSE(ui.exists("Suggestions"));
    ui.key(Key::backspace).key(Key::backspace).key(Key::backspace).type("n");
    EXPECT_THAT(suggested(), ElementsAre()) << "no text is looked for";
    ui.key(Key::backspace).type(".s");
    EXPECT_THAT(suggested(), ElementsAre(".secret.exr")) << "hidden, and asked for by name";
}

TEST_F(PathCompletionTest, TabTakesTheLongestCommonPart) {
    open(request(FileTask::open));
    ui.type("s").key(Key::tab);
    EXPECT_EQ(name(), "shot ");
    EXPECT_EQ(ui.focused(), "Plates/Name");
    EXPECT_EQ(suggested().size(), 2U);
    ui.type("1").key(Key::tab);
    EXPECT_EQ(name(), "shot 10.exr");
    EXPECT_THAT(suggested(), ElementsAre()) << "there is nothing more to offer";
    ui.key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/shot 10.exr"));
}

TEST_F(PathCompletionTest, TabGoesOnWhereThereIsNothingToTake) {
    open(request(FileTask::open));
    ui.type("shot ").key(Key::tab);
    EXPECT_EQ(name(), "shot ");
    EXPECT_EQ(ui.focused(), "Plates/Kind of file");
    EXPECT_THAT(suggested(), ElementsAre()) << "the list goes with the keyboard";
    ui.focus("Plates/Name").type("s").key(Key::tab, Mods::shift);
    EXPECT_NE(ui.focused(), "Plates/Name") << "Shift+Tab goes back in any case";
}

TEST_F(PathCompletionTest, ArrowsMarkAndEnterTakes) {
    open(request(FileTask::open));
    ui.type("s").key(Key::down).key(Key::down);
    EXPECT_TRUE(ui.is("Suggestions/shot 10.exr", Is::selected));
    ui.key(Key::enter);
    EXPECT_EQ(name(), "shot 10.exr");
    EXPECT_EQ(times, 0) << "one more Enter opens it";
    ui.key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/shot 10.exr"));
    open(request(FileTask::open));
    ui.type("s").key(Key::up).key(Key::enter);
    EXPECT_EQ(name(), "shot 10.exr") << "up begins at the end";
}

TEST_F(PathCompletionTest, AClickTakesAndTheKeyboardStays) {
    open(request(FileTask::open));
    ui.type("s").click("Suggestions/shot 9.exr");
    EXPECT_EQ(name(), "shot 9.exr");
    EXPECT_EQ(ui.focused(), "Plates/Name");
    EXPECT_FALSE(ui.exists("Suggestions"));
}

TEST_F(PathCompletionTest, LeavesTheButtonsInSight) {
    open(request(FileTask::open));
    ui.type("s");
    EXPECT_LE(ui.rect("Suggestions").bottom(), ui.rect("Plates/Name").y);
    EXPECT_GE(ui.rect("Suggestions").y, ui.rect("Plates/Name").y - 100) << "close to what is typed";
    ui.type("hot 9.exr").click("Plates/Open");
    EXPECT_THAT(chosen, ElementsAre("/home/u/shot 9.exr"));
}

TEST_F(PathCompletionTest, EscClosesTheListAndThenTheDialog) {
    open(request(FileTask::open));
    ui.type("s").key(Key::escape);
    EXPECT_FALSE(ui.exists("Suggestions"));
    EXPECT_EQ(name(), "s");
    ui.key(Key::escape);
    EXPECT_FALSE(ui.frame().exists("Plates"));
}

TEST_F(PathCompletionTest, GoesFromFolderToFolder) {
    open(request(FileTask::open));
    ui.type("/h").key(Key::tab);
    EXPECT_EQ(name(), "/home/");
    ui.key(Key::tab);
    EXPECT_EQ(name(), "/home/u/");
    EXPECT_THAT(suggested(), ElementsAre("locked/", "plates/", "shot 9.exr", "shot 10.exr"));
    ui.type("PL").key(Key::tab);
    EXPECT_EQ(name(), "/home/u/plates/") << "as it is spelled";
    ui.key(Key::tab).key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/plates/a.EXR"));
}

TEST_F(PathCompletionTest, ATildeIsHome) {
    FileRequest at_root = request(FileTask::open);
    at_root.folder = "/";
    open(at_root);
    ui.type("~").key(Key::tab);
    EXPECT_EQ(name(), "~/");
    ui.type("pl").key(Key::tab).key(Key::tab);
    EXPECT_EQ(name(), "~/plates/a.EXR");
    ui.key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/plates/a.EXR"));
    open(at_root);
    ui.type("~").key(Key::escape).key(Key::enter);
    EXPECT_EQ(dialog.folder(), "/home/u");
}

TEST_F(PathCompletionTest, OnlyFoldersAreOfferedForAFolderAndFilesToSaveOver) {
    open(request(FileTask::folder));
    ui.type("s");
    EXPECT_THAT(suggested(), ElementsAre());
    ui.key(Key::backspace).type("../u/");
    EXPECT_THAT(suggested(), ElementsAre("locked/", "plates/"));
    ui.key(Key::escape).key(Key::escape);
    open(request(FileTask::save));
    ui.type("s");
    EXPECT_THAT(suggested(), ElementsAre("shot 9.exr", "shot 10.exr"));
    ui.key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/s.exr")) << "what is only offered is not taken";
}

TEST_F(PathCompletionTest, AFolderThatCannotBeReadOffersNothing) {
    open(request(FileTask::open));
    ui.type("locked/");
    EXPECT_THAT(suggested(), ElementsAre());
    ui.type("a").key(Key::tab);
    EXPECT_EQ(name(), "locked/a");
}

TEST_F(PathCompletionTest, ALongListGoesWithTheMarkAndSaysHowManyThereAre) {
    for (int i = 100; i < 130; ++i) files.folders["/home/u"].push_back({.name = "take " + std::to_string(i) + ".exr"});
    open(request(FileTask::open));
    ui.type("t");
    EXPECT_EQ(suggested().size(), PathCompletion::rows);
    EXPECT_TRUE(says("30 names"));
    for (std::size_t i = 0; i < PathCompletion::rows + 2; ++i) ui.key(Key::down);
    EXPECT_TRUE(ui.is("Suggestions/take 109.exr", Is::selected));
    EXPECT_EQ(suggested().front(), "take 102.exr");
    ui.frame(30);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 5; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

TEST_F(PathCompletionTest, TypingInTheShownFolderReadsNothing) {
    open(request(FileTask::open));
    files.listed.clear();
    ui.type("shot ").key('a', Mods::command).type("./s");
    EXPECT_THAT(files.listed, ElementsAre());
    ui.key('a', Mods::command).type("/home/u/plates/a.E");
    EXPECT_THAT(files.listed, ElementsAre("/", "/home", "/home/u/plates")) << "once, not with every letter";
}

/// Folders are read only when the test says so.
class SlowFolders : public PathCompletionTest {
  protected:
    SlowFolders() : PathCompletionTest([this](std::function<void()> work) { waiting.push_back(std::move(work)); }) {}
    void come() {
        for (const auto& work : std::exchange(waiting, {})) work();
        ui.frame();
    }
    std::vector<std::function<void()>> waiting;
};

TEST_F(SlowFolders, AreNotWaitedForAndTabIsKept) {
    open(request(FileTask::open));
    files.listed.clear();
    ui.type("plates/").key(Key::tab);
    EXPECT_THAT(files.listed, ElementsAre()) << "no frame reads it";
    EXPECT_EQ(name(), "plates/");
    EXPECT_EQ(ui.focused(), "Plates/Name");
    ASSERT_EQ(waiting.size(), 1U);
    come();
    EXPECT_THAT(files.listed, ElementsAre("/home/u/plates"));
    EXPECT_EQ(name(), "plates/a.EXR");
}

TEST_F(SlowFolders, WhatComesTooLateIsNobodys) {
    open(request(FileTask::open));
    ui.type("plates/");
    ui.key(Key::backspace).key(Key::backspace).key(Key::backspace);
    EXPECT_THAT(suggested(), ElementsAre("plates/"));
    come();
    EXPECT_THAT(suggested(), ElementsAre("plates/"));
    EXPECT_EQ(name(), "plat");
}

TEST_F(SlowFolders, HangingOnesDoNotHeapUp) {
    open(request(FileTask::open));
    for (int i = 0; i < 20; ++i) {
        ui.type("/" + std::to_string(i) + "/");
        for (int k = 0; k < 5; ++k) ui.key(Key::backspace);
    }
    EXPECT_LE(waiting.size(), 5U);
    ui.type("/home/u/plates/");
    EXPECT_THAT(suggested(), ElementsAre());
    come();
    EXPECT_THAT(ui.type("a").key(Key::backspace).focused(), "Plates/Name");
}

class NoThreads : public PathCompletionTest {
  protected:
    NoThreads()
        : PathCompletionTest([](const std::function<void()>&) {
              throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
          }) {}
};

TEST_F(NoThreads, SuggestNothingFromOtherFolders) {
    open(request(FileTask::open));
    ui.type("plates/");
    EXPECT_THAT(suggested(), ElementsAre());
    EXPECT_EQ(name(), "plates/");
    ui.type("a.EXR").key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/plates/a.EXR"));
}

}  // namespace
}  // namespace lapfx::ui
