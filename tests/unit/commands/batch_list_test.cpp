// Which files of a folder are items of lapfx batch.
#include "commands/batch_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "commands/batch_result.h"
#include "unit/preset/support.h"

namespace lapfx::commands {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

class BatchListTest : public ::testing::Test {
  protected:
    test::Folder folder;

    fs::path write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder / name).parent_path());
        return folder.write(name, text);
    }
    std::vector<std::string> names(const fs::path& results = {}) {
        const BatchList list = batch_items(folder / "", results);
        notes = list.notes;
        std::vector<std::string> found;
        for (const BatchItem& item : list.items) found.push_back(item.name);
        return found;
    }
    std::vector<std::string> notes;
};

TEST_F(BatchListTest, ScenesAndVideosByName) {
    write("b.mp4", "b"), write("a.MKV", "aa"), write("week/c.scene.json", "{}"), write("week.mov", "ccc");
    EXPECT_THAT(names(), ElementsAre("a.MKV", "b.mp4", "week.mov", "week/c.scene.json"));
    EXPECT_THAT(notes, IsEmpty());
    EXPECT_EQ(batch_items(folder / "").items[3], (BatchItem{"week/c.scene.json", ItemKind::scene}));
    EXPECT_EQ(batch_items(folder / "").items[0], (BatchItem{"a.MKV", ItemKind::video}));
}

TEST_F(BatchListTest, OtherFilesAreToldInOneLine) {
    write("b.mp4", "b"), write("z.txt", "z"), write("a.json", "a"), write("._b.mp4", "m"), write("k.glb", "k");
    write(".hidden/c.mp4", "c"), write("line\nbreak.mp4", "two lines");
    EXPECT_THAT(names(), ElementsAre("b.mp4"));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0], EndsWith(": 5 other files are left out: ._b.mp4, a.json, k.glb, ..."));
}

TEST_F(BatchListTest, BrokenVideosAreListedAndCopiesAreNot) {
    write("b.mp4", "same"), write("a/late.mov", "same"), write("c.mp4", "else"), write("d.mp4", ""), write("e.mp4", "");
    EXPECT_THAT(names(), ElementsAre("a/late.mov", "c.mp4", "d.mp4", "e.mp4"));
    EXPECT_THAT(notes, ElementsAre("b.mp4: has the content of a/late.mov and is left out"));
}

TEST_F(BatchListTest, ScenesOfTwoFoldersAreTwoThoughAlike) {
    write("one/s.scene.json", "{}"), write("two/s.scene.json", "{}"), write("two/copy.scene.json", "{}");
    EXPECT_THAT(names(), ElementsAre("one/s.scene.json", "two/copy.scene.json"));
    EXPECT_THAT(notes, ElementsAre("two/s.scene.json: has the content of two/copy.scene.json and is left out"));
}

TEST_F(BatchListTest, TheReferenceOfASceneIsFittedWithIt) {
    write("videos/a.mp4", "a"), write("videos/b.mp4", "bb");
    write("s.scene.json", test::scene_text(R"(, "organ": {"file": "o.ply"}, "reference": {"file": "videos/a.mp4"})"));
    EXPECT_THAT(names(), ElementsAre("s.scene.json", "videos/b.mp4"));
    EXPECT_THAT(notes, ElementsAre("videos/a.mp4: is the reference of s.scene.json, which is fitted to it"));
}

TEST_F(BatchListTest, ACopyOfAReferenceIsNoVideoOfItsOwn) {
    write("a.mp4", "same"), write("z.mp4", "same");
    write("s.scene.json", test::scene_text(R"(, "organ": {"file": "o.ply"}, "reference": {"file": "z.mp4"})"));
    EXPECT_THAT(names(), ElementsAre("s.scene.json"));
    EXPECT_THAT(notes, ElementsAre("a.mp4: has the content of z.mp4 and is left out",
                                   "z.mp4: is the reference of s.scene.json, which is fitted to it"));
}

TEST_F(BatchListTest, LinksAreFollowedOnceAndFilesHaveTheirOwnPlace) {
    write("z/a.mp4", "a");
    fs::create_directory_symlink(folder / "z", folder / "b");
    fs::create_directory_symlink("..", folder / "z" / "loop");
    fs::create_symlink("nowhere.mp4", folder / "gone.mp4");
    EXPECT_THAT(names(), ElementsAre("z/a.mp4"));
    EXPECT_EQ(notes.size(), 3U);
    EXPECT_THAT(notes, Contains(HasSubstr("gone.mp4: is a link to nothing")));
    EXPECT_THAT(notes, Contains(EndsWith("b: leads to a folder that is not looked through again")));
    EXPECT_THAT(notes, Contains(EndsWith("loop: leads to a folder that is not looked through again")));
    const test::Folder outside;
    outside.write("c.mp4", "ccc");
    fs::create_directory_symlink(outside / "", folder / "more");
    EXPECT_THAT(names(), ElementsAre("z/a.mp4"));
    EXPECT_THAT(notes, Contains(EndsWith("more: leads out of the folder and is not looked through")));
}

TEST_F(BatchListTest, ResultsAreNoItems) {
    write("a.mp4", "a"), write("out/b.mp4", "bb");
    write("results/a.mp4/result.json", text_of({})), write("results/a.mp4/fitted.scene.json", "{}");
    write("results/b.mp4/running.lock", ""), write("results/b.mp4/fitted.scene.json", "{ }");
    EXPECT_THAT(names(), ElementsAre("a.mp4", "out/b.mp4"));
    EXPECT_THAT(notes,
                ElementsAre(EndsWith(": 2 folders of results are not looked through: results/a.mp4, results/b.mp4")));
    EXPECT_THAT(names(folder / "out"), ElementsAre("a.mp4"));
    write("mine/result.json", "{\"another\": 1}"), write("mine/c.mp4", "ccc");
    EXPECT_THAT(names(), ElementsAre("a.mp4", "mine/c.mp4", "out/b.mp4"));
}

TEST_F(BatchListTest, NoNameIsAnOption) {
    write("-1.mp4", "a"), write("-week/s.scene.json", "{}"), write("week/-2.mp4", "bb");
    EXPECT_THAT(names(), ElementsAre("./-1.mp4", "./-week/s.scene.json", "week/-2.mp4"));
    for (const std::string name : {"./-1.mp4", "-1.mp4"})
        EXPECT_EQ(batch_item(folder / "", name), (BatchItem{"./-1.mp4", ItemKind::video})) << name;
}

TEST_F(BatchListTest, NothingLeftIsAFaultThatSaysWhatWasThere) {
    write("notes.txt", "x");
    const auto faults = test::faults_of([&] { batch_items(folder / ""); });
    ASSERT_EQ(faults.size(), 2U);
    EXPECT_THAT(faults[0], HasSubstr("1 other file is left out: notes.txt"));
    EXPECT_THAT(faults[1], HasSubstr("holds neither scenes (*.scene.json) nor videos (.mp4,"));
    EXPECT_THAT(test::faults_of([&] { batch_items(folder / "none"); }), ElementsAre(EndsWith("no such folder")));
    EXPECT_THAT(test::faults_of([&] { batch_items(folder / "notes.txt"); }), ElementsAre(EndsWith("is not a folder")));
}

TEST_F(BatchListTest, AnItemIsNamedAsInTheList) {
    write("week/a.mp4", "a"), write("notes.txt", "x");
    fs::create_directory(folder / "folder.mp4");
    EXPECT_EQ(batch_item(folder / "", "week/a.mp4"), (BatchItem{"week/a.mp4", ItemKind::video}));
    for (const std::string name : {"", ".", "./week/a.mp4", "../a.mp4", "week/../../a.mp4", "week//a.mp4", "week/",
                                   "none.mp4", "notes.txt", "folder.mp4"})
        EXPECT_THAT(test::faults_of([&] { batch_item(folder / "", name); }), ElementsAre(HasSubstr("ITEM: "))) << name;
    EXPECT_THAT(test::faults_of([&] { batch_item(folder / "", (folder / "week/a.mp4").string()); }),
                ElementsAre(HasSubstr("is not a path below")));
}

}  // namespace
}  // namespace lapfx::commands
