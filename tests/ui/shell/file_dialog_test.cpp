#include "ui/shell/file_dialog.h"

#include <filesystem>
#include <fstream>

#include "ui/shell/file_dialog_fixture.h"
#include "ui/support/count_allocations.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;

TEST(FileNames, ComeAsPeopleCount) {
    EXPECT_TRUE(natural_less("shot 9.exr", "shot 10.exr"));
    EXPECT_TRUE(natural_less("a", "B"));
    EXPECT_TRUE(natural_less("B", "c"));
    EXPECT_TRUE(natural_less("shot", "shot 1"));
    EXPECT_FALSE(natural_less("a", "a"));
    EXPECT_NE(natural_less("a", "A"), natural_less("A", "a")) << "one order for every two names";
    EXPECT_NE(natural_less("a01", "a1"), natural_less("a1", "a01"));
    EXPECT_TRUE(natural_less("99999999999999999999998", "99999999999999999999999"));
}

TEST(FileNames, PathsAreWorkedOut) {
    EXPECT_EQ(resolve_path("/home/u", "a.exr"), "/home/u/a.exr");
    EXPECT_EQ(resolve_path("/home/u", "../v/./b//c/"), "/home/v/b/c");
    EXPECT_EQ(resolve_path("/home/u", "/tmp"), "/tmp");
    EXPECT_EQ(resolve_path("/", "../.."), "/");
    EXPECT_EQ(parent_of("/home/u"), "/home");
    EXPECT_EQ(parent_of("/home"), "/");
    EXPECT_EQ(parent_of("/"), "/");
    EXPECT_EQ(name_of_path("/home/u"), "u");
}

TEST(FileNames, ATildeIsHome) {
    EXPECT_EQ(expand_home("~", "/home/u"), "/home/u");
    EXPECT_EQ(expand_home("~/a", "/home/u"), "/home/u/a");
    EXPECT_EQ(expand_home("~a", "/home/u"), "~a");
    EXPECT_EQ(expand_home("a/~", "/home/u"), "a/~");
}

TEST(FileNames, SizesAreReadAtAGlance) {
    EXPECT_EQ(size_text(0), "0 B");
    EXPECT_EQ(size_text(999), "999 B");
    EXPECT_EQ(size_text(1000), "1.0 kB");
    EXPECT_EQ(size_text(999'949), "999.9 kB");
    EXPECT_EQ(size_text(999'950), "1.0 MB");
    EXPECT_EQ(size_text(1'234'567'890), "1.2 GB");
    EXPECT_EQ(size_text(~std::uint64_t{0}), "18.4 EB");
}

TEST(SystemFiles, ListsAFolderAndSaysWhyItCannot) {
    std::string made = (std::filesystem::temp_directory_path() / "lapfx-ui-XXXXXX").string();
    ASSERT_NE(::mkdtemp(made.data()), nullptr);
    const std::filesystem::path folder = made;
    std::filesystem::create_directories(folder / "inner");
    const std::string odd = "bad\xff name";
    std::ofstream(folder / odd) << "12345";
    std::vector<FileEntry> entries;
    EXPECT_EQ(system_files().list(folder.string(), entries), "");
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].name, odd);
    EXPECT_EQ(entries[0].size, 5U);
    EXPECT_FALSE(entries[0].folder);
    EXPECT_GT(entries[0].changed, 1'600'000'000);
    EXPECT_TRUE(entries[1].folder);
    EXPECT_EQ(system_files().kind(folder.string()), FileSystem::Kind::folder);
    EXPECT_EQ(system_files().kind((folder / "none").string()), FileSystem::Kind::nothing);
    EXPECT_NE(system_files().list((folder / "none").string(), entries), "");
    EXPECT_EQ(system_files().make_folder((folder / "made").string()), "");
    EXPECT_TRUE(std::filesystem::is_directory(folder / "made"));
    EXPECT_EQ(system_files().make_folder((folder / "made").string()), "there is a file or folder of this name already");
    EXPECT_EQ(system_files().make_folder((folder / "none" / "made").string()), "No such file or directory");
    EXPECT_EQ(system_files().make_folder((folder / std::string(300, 'x')).string()), "File name too long");
    std::filesystem::remove_all(folder);
}

TEST_F(FileDialogTest, FoldersComeFirstAndOnlyWhatIsLookedFor) {
    open(request(FileTask::open));
    EXPECT_THAT(rows(), ElementsAre("locked", "plates", "shot 9.exr", "shot 10.exr"));
    ui.click("**/Hidden files");
    EXPECT_THAT(rows(), ElementsAre("locked", "plates", ".secret.exr", "shot 9.exr", "shot 10.exr"));
    EXPECT_EQ(ui.focused(), "Plates/Hidden files");
}

TEST_F(FileDialogTest, TheFilterIsOneOfSeveral) {
    open(request(FileTask::open));
    ui.click("**/Kind of file").click("**/All files");
    EXPECT_THAT(rows(), ElementsAre("locked", "plates", "notes.txt", "shot 9.exr", "shot 10.exr"));
}

TEST_F(FileDialogTest, HeadersSort) {
    open(request(FileTask::open));
    ui.click("Plates/Files/Size");
    EXPECT_THAT(rows(), ElementsAre("locked", "plates", "shot 10.exr", "shot 9.exr"));
    ui.click("Plates/Files/Size");
    EXPECT_THAT(rows(), ElementsAre("locked", "plates", "shot 9.exr", "shot 10.exr"));
    ui.click("Plates/Files/Changed");
    EXPECT_THAT(rows(), ElementsAre("locked", "plates", "shot 9.exr", "shot 10.exr"));
    ui.click("Plates/Files/Changed");
    EXPECT_THAT(rows(), ElementsAre("locked", "plates", "shot 10.exr", "shot 9.exr"));
}

TEST_F(FileDialogTest, ADoubleClickOpensAFileOnceAndRemembersItsFolder) {
    open(request(FileTask::open));
    ui.click("**/shot 9.exr", {.clicks = 2});
    ui.frame().frame();
    EXPECT_THAT(chosen, ElementsAre("/home/u/shot 9.exr"));
    EXPECT_EQ(times, 1);
    EXPECT_FALSE(ui.exists("Plates"));
    EXPECT_THAT(dialog.recent(), ElementsAre("/home/u"));
}

TEST_F(FileDialogTest, ADoubleClickGoesIntoAFolderAndTheBarBack) {
    open(request(FileTask::open));
    ui.click("**/plates", {.clicks = 2});
    EXPECT_EQ(dialog.folder(), "/home/u/plates");
    EXPECT_THAT(rows(), ElementsAre("a.EXR"));
    ui.click("**/Folder above");
    EXPECT_EQ(dialog.folder(), "/home/u");
    ui.click("Plates/home");
    EXPECT_EQ(dialog.folder(), "/home");
    ui.click("Plates/Computer");
    EXPECT_EQ(dialog.folder(), "/");
    EXPECT_EQ(times, 0);
}

TEST_F(FileDialogTest, WithTheKeyboardAlone) {
    open(request(FileTask::open));
    EXPECT_EQ(ui.focused(), "Plates/Name");
    ui.type("shot 9.exr").key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/shot 9.exr"));
    open(request(FileTask::open));
    ui.focus("Plates/Files").key(Key::home).key(Key::down).key(Key::enter);
    EXPECT_EQ(dialog.folder(), "/home/u/plates");
    ui.key(Key::home).key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/plates/a.EXR"));
}

TEST_F(FileDialogTest, APathCanBeTyped) {
    open(request(FileTask::open));
    ui.type("../u/plates").key(Key::enter);
    EXPECT_EQ(dialog.folder(), "/home/u/plates");
    EXPECT_EQ(ui.text("Plates/Name"), "");
    ui.type("/home/u/notes.txt").key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/notes.txt"));
}

TEST_F(FileDialogTest, FaultsAreToldInPlace) {
    open(request(FileTask::open));
    ui.click("**/locked", {.clicks = 2});
    EXPECT_TRUE(says("cannot be read: Permission denied"));
    EXPECT_EQ(dialog.folder(), "/home/u") << "and what was there stays";
    EXPECT_EQ(rows().size(), 4U);
    ui.click("Plates/Name").type("gone.exr").key(Key::enter);
    EXPECT_TRUE(says("does not exist"));
    EXPECT_EQ(times, 0);
    files.folders.erase("/home/u");
    ui.click("**/Read again");
    EXPECT_TRUE(says("No such file"));
    EXPECT_TRUE(rows().empty());
}

TEST_F(FileDialogTest, SeveralAreOpenedTogether) {
    open(request(FileTask::open_many));
    ui.click("**/shot 9.exr").click("**/shot 10.exr", {.mods = Mods::command});
    ui.click("Plates/Open");
    EXPECT_THAT(chosen, testing::UnorderedElementsAre("/home/u/shot 9.exr", "/home/u/shot 10.exr"));
}

TEST_F(FileDialogTest, SavingAddsTheExtensionAndAsksBeforeItReplaces) {
    FileRequest save = request(FileTask::save);
    save.name = "untitled";
    open(save);
    EXPECT_EQ(ui.text("Plates/Name"), "untitled");
    ui.key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/untitled.exr"));
    save.name = "shot 9";
    open(save);
    ui.key(Key::enter);
    EXPECT_EQ(times, 1);
    ASSERT_TRUE(ui.exists("Replace the file?"));
    ui.key(Key::enter);
    EXPECT_TRUE(ui.exists("Plates")) << "Enter does not destroy";
    EXPECT_EQ(times, 1);
    ui.click("Plates/Save").click("Replace the file?/Replace");
    EXPECT_THAT(chosen, ElementsAre("/home/u/shot 9.exr"));
    EXPECT_FALSE(ui.frame().exists("Plates"));
}

TEST_F(FileDialogTest, SavingIntoAFolderThatIsNotThereIsRefused) {
    open(request(FileTask::save));
    ui.type("nowhere/a.exr").key(Key::enter);
    EXPECT_TRUE(says("There is no folder"));
    EXPECT_EQ(times, 0);
}

TEST_F(FileDialogTest, AFolderIsChosen) {
    open(request(FileTask::folder));
    EXPECT_THAT(rows(), ElementsAre("locked", "plates"));
    ui.click("**/plates").click("Plates/Choose folder");
    EXPECT_THAT(chosen, ElementsAre("/home/u/plates"));
    open(request(FileTask::folder));
    ui.click("Plates/Choose folder");
    EXPECT_EQ(chosen[0], dialog.folder()) << "with nothing selected: the one that is shown";
}

TEST_F(FileDialogTest, EscapeAndCancelChooseNothing) {
    open(request(FileTask::open));
    ui.key(Key::escape).key(Key::escape).key(Key::escape);
    EXPECT_FALSE(ui.exists("Plates"));
    open(request(FileTask::open));
    ui.click("Plates/Cancel");
    EXPECT_FALSE(ui.frame().exists("Plates"));
    EXPECT_EQ(times, 0);
}

TEST_F(FileDialogTest, NamesThatAreNoUtf8AreShownAndKept) {
    files.folders["/home/u"].push_back({.name = "bad\xff.exr"});
    open(request(FileTask::open));
    ui.click("**/bad\xff.exr");
    EXPECT_EQ(ui.text("Plates/Name"), "bad\xff.exr");
    ui.click("Plates/Open");
    EXPECT_THAT(chosen, ElementsAre("/home/u/bad\xff.exr"));
}

TEST_F(FileDialogTest, RecentFoldersHaveTheirPaths) {
    dialog.set_recent({"/data/one hospital/a/smoke", "/data/another hospital/b/smoke"});
    open(request(FileTask::open));
    EXPECT_GT(ui.rect("Plates/\u2026/a/smoke").w, 0) << "where that is too long, its end";
    EXPECT_GT(ui.rect("Plates/\u2026/b/smoke").w, 0) << "which tells two of one name apart";
}

TEST_F(FileDialogTest, NamesWithTwoHashesAreShownWhole) {
    files.folders["/home/u"].push_back({.name = "a##b", .folder = true});
    files.folders["/home/u/a##b"] = {{.name = "#c##d.exr"}};
    dialog.set_recent({"/home/u/a##b"});
    open(request(FileTask::open));
    EXPECT_GT(ui.rect("Plates//home/u/a##b").w, 0) << "a recent one, with its path";
    ui.click("Plates/Files/a##b", {.clicks = 2});
    EXPECT_EQ(dialog.folder(), "/home/u/a##b");
    ui.click("Plates/Name").type("gone##1.exr").key(Key::enter);
    EXPECT_TRUE(says("\"/home/u/a##b/gone##1.exr\" does not exist")) << ui.dump();
    ui.click("Plates/Home");
    files.faults["/home/u/a##b"] = "Permission denied";
    ui.click("Plates//home/u/a##b");
    EXPECT_TRUE(says("\"/home/u/a##b\" cannot be read: Permission denied")) << ui.dump();
}

TEST_F(FileDialogTest, AFileCalledLikeHomeIsOpenedFromTheList) {
    files.folders["/home/u/plates"].push_back({.name = "~"});
    FileRequest any = request(FileTask::open);
    any.filters.clear();
    any.folder = "/home/u/plates";
    open(any);
    ui.click("Plates/Files/~").click("Plates/Open");
    EXPECT_THAT(chosen, ElementsAre("/home/u/plates/~"));
    any.folder = "/home";
    open(any);
    ui.click("Plates/Name").type("~").key(Key::escape).key(Key::enter);
    EXPECT_EQ(dialog.folder(), "/home/u") << "typed it is home";
}

TEST_F(FileDialogTest, AFolderIsMadeInPlaceAndGoneInto) {
    open(request(FileTask::save));
    ui.click("Plates/New folder");
    EXPECT_EQ(ui.focused(), "Plates/Name of the new folder");
    EXPECT_EQ(ui.text("Plates/Name of the new folder"), "New folder");
    ui.type("takes").key(Key::enter);
    EXPECT_EQ(dialog.folder(), "/home/u/takes") << "what was proposed is typed over";
    EXPECT_FALSE(ui.exists("Plates/Name of the new folder"));
    EXPECT_EQ(ui.focused(), "Plates/Name");
    EXPECT_EQ(times, 0) << "Enter was for the folder";
    ui.click("**/Folder above");
    EXPECT_THAT(rows(), testing::Contains("takes"));
    ui.click("Plates/Name").type("takes/a").key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre("/home/u/takes/a.exr"));
}

TEST_F(FileDialogTest, WhyAFolderCannotBeMadeIsToldInOneLine) {
    open(request(FileTask::open));
    ui.key('n', Mods::command | Mods::shift);
    EXPECT_EQ(ui.focused(), "Plates/Name of the new folder");
    const auto refused = [&](const std::string& name, const std::string& reason) {
        ui.key('a', Mods::command).key(Key::del).type(name).key(Key::enter);
        EXPECT_TRUE(says("\"" + name + "\" cannot be made: " + reason)) << name << "\n" << ui.dump();
        EXPECT_EQ(ui.focused(), "Plates/Name of the new folder") << "to be mended there";
        EXPECT_EQ(dialog.folder(), "/home/u");
    };
    refused("", "a name is missing");
    refused("a/b", "a name has no \"/\"");
    refused("..", "this name means another folder");
    refused("plates", "there is a file or folder of this name already");
    files.faults["/home/u/+"] = "Read-only file system";
    refused("more", "Read-only file system");
    ui.type("x");
    EXPECT_FALSE(says("cannot be made")) << "until it is typed in again";
    ui.key(Key::escape);
    EXPECT_FALSE(ui.exists("Plates/Name of the new folder"));
    EXPECT_TRUE(ui.exists("Plates")) << "Esc gave up the folder alone";
    EXPECT_EQ(ui.focused(), "Plates/Name");
}

TEST_F(FileDialogTest, AFolderIsMadeByThePointerToo) {
    open(request(FileTask::folder));
    ui.click("Plates/New folder").type("b").click("Plates/Make the folder");
    EXPECT_EQ(dialog.folder(), "/home/u/b");
    ui.click("Plates/New folder").click("Plates/No new folder");
    EXPECT_FALSE(ui.exists("Plates/Name of the new folder"));
    ui.click("Plates/New folder").click("Plates/Computer");
    EXPECT_FALSE(ui.exists("Plates/Name of the new folder")) << "it was for the folder that was shown";
    EXPECT_EQ(files.folders["/home/u/b"].size(), 0U);
    ui.click("Plates/New folder").type("c").key(Key::enter);
    EXPECT_EQ(dialog.folder(), "/c");
}

TEST_F(FileDialogTest, HasKeysOfItsOwnWhereverTheKeyboardIs) {
    open(request(FileTask::open));
    for (const char* place : {"Plates/Name", "Plates/Files", "Plates/Kind of file", "Plates/Cancel"}) {
        ui.focus(place).key('h', Mods::command);
        EXPECT_TRUE(dialog.shows_hidden()) << place;
        ui.key('h', Mods::command);
        ui.key(Key::up, Mods::alt);
        EXPECT_EQ(dialog.folder(), "/home") << place;
        ui.click("Plates/Home").focus(place);
        files.listed.clear();
        ui.key(Key::f5);
        EXPECT_THAT(files.listed, ElementsAre("/home/u")) << place;
        ui.focus(place).key('l', Mods::command);
        EXPECT_EQ(ui.focused(), "Plates/Name") << place;
    }
}

TEST_F(FileDialogTest, DownGoesFromTheNameToTheList) {
    open(request(FileTask::open));
    ui.key(Key::down);
    EXPECT_EQ(ui.focused(), "Plates/Files");
    EXPECT_TRUE(ui.is("Plates/Files/locked", Is::selected)) << "the first, to be seen";
    ui.key(Key::down).key(Key::enter);
    EXPECT_EQ(dialog.folder(), "/home/u/plates");
    ui.click("Plates/Name").type("zz").key(Key::down);
    EXPECT_EQ(ui.focused(), "Plates/Files");
    EXPECT_EQ(ui.text("Plates/Name"), "zz") << "what was typed stays";
}

TEST_F(FileDialogTest, TypedLettersGoToTheNextNameThatBeginsSo) {
    open(request(FileTask::open));
    ui.focus("Plates/Files").type("sh");
    EXPECT_TRUE(ui.is("Plates/Files/shot 9.exr", Is::selected));
    EXPECT_EQ(ui.text("Plates/Name"), "shot 9.exr");
    ui.type("ot 1");
    EXPECT_TRUE(ui.is("Plates/Files/shot 10.exr", Is::selected)) << "a space is a letter then";
    ui.frame(1.5).type("p");
    EXPECT_TRUE(ui.is("Plates/Files/plates", Is::selected)) << "after a second it is another word";
    ui.key(Key::enter);
    EXPECT_EQ(dialog.folder(), "/home/u/plates");
    ui.type("a");
    EXPECT_TRUE(ui.is("Plates/Files/a.EXR", Is::selected)) << "what led here is over, however quickly it goes on";
}

TEST_F(FileDialogTest, OneLetterOverAndOverGoesFromOneToTheNext) {
    open(request(FileTask::open_many));
    ui.focus("Plates/Files").type("s");
    EXPECT_TRUE(ui.is("Plates/Files/shot 9.exr", Is::selected));
    ui.type("s");
    EXPECT_TRUE(ui.is("Plates/Files/shot 10.exr", Is::selected));
    EXPECT_FALSE(ui.is("Plates/Files/shot 9.exr", Is::selected));
    ui.type("s");
    EXPECT_TRUE(ui.is("Plates/Files/shot 9.exr", Is::selected));
    ui.frame(1.5).type("x");
    EXPECT_TRUE(ui.is("Plates/Files/shot 9.exr", Is::selected)) << "nothing begins so";
    ui.frame(1.5).type(" ");
    EXPECT_FALSE(ui.is("Plates/Files/shot 9.exr", Is::selected)) << "space alone marks, as ever";
}

TEST_F(FileDialogTest, TenThousandFilesAreReadOnceAndASteadyFrameAllocatesNothing) {
    auto& all = files.folders["/home/u"];
    for (int i = 0; i < 10000; ++i) all.push_back({.name = "frame " + std::to_string(i * 7919 % 10000) + ".exr"});
    const std::size_t start = test::allocated_bytes_so_far();
    open(request(FileTask::open));
    EXPECT_LT(test::allocated_bytes_so_far() - start, 4U << 20) << "the entries and their order, once";
    EXPECT_THAT(files.listed, ElementsAre("/home/u"));
    EXPECT_LT(rows().size(), 60U);
    EXPECT_EQ(rows()[2], "frame 0.exr");
    EXPECT_EQ(rows()[11], "frame 9.exr");
    ui.frame(30).frame(30);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 20; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

}  // namespace
}  // namespace lapfx::ui
