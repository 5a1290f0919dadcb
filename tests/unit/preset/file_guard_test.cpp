// What is read is not replaced, whatever it is called.
#include "lapfx/authoring/file_guard.h"

#include <gmock/gmock.h>

#include "lapfx/authoring/file.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

namespace fs = std::filesystem;
using test::faults_of;
using testing::ElementsAre;
using testing::IsEmpty;

class FileGuardTest : public testing::Test {
  protected:
    FileGuardTest() { guard_files(FileGuard::refuse); }
    ~FileGuardTest() override { guard_files(FileGuard::off); }
    std::vector<std::string> written(const fs::path& path) const {
        return faults_of([&] { write_file(path, "new"); });
    }
    std::vector<std::string> claimed(const std::string& option, const fs::path& path) const {
        return faults_of([&] { claim_output(option, path); });
    }
    std::vector<std::string> noted(const fs::path& path) const {
        return faults_of([&] { note_read(path); });
    }
    std::string refusal(const fs::path& path) const {
        return path.string() + ": is a file that is read here, so it is not written";
    }

    test::Folder folder;
};

TEST_F(FileGuardTest, WhatIsReadIsNotWritten) {
    const fs::path file = folder.write("a.csv", "old");
    note_read(file);
    EXPECT_THAT(written(file), ElementsAre(refusal(file)));
    EXPECT_EQ(test::read_text(file), "old");
    EXPECT_THAT(written(folder / "b.csv"), IsEmpty());
}

TEST_F(FileGuardTest, OtherSpellingsAndLinksAreTheSameFile) {
    const fs::path file = folder.write("a.csv", "old");
    note_read(file);
    fs::create_directory(folder / "in");
    fs::create_directory_symlink(folder.path(), folder / "also");
    fs::create_hard_link(file, folder / "hard.csv");
    for (const fs::path& path :
         {folder / "in/../a.csv", folder / "./a.csv", folder / "also/a.csv", folder / "hard.csv"})
        EXPECT_THAT(written(path), ElementsAre(refusal(path)));
    EXPECT_EQ(test::read_text(file), "old");
}

TEST_F(FileGuardTest, ThroughALinkItIsReadToo) {
    const fs::path file = folder.write("a.csv", "old");
    fs::create_symlink(file, folder / "link.csv");
    note_read(folder / "link.csv");
    EXPECT_THAT(written(file), ElementsAre(refusal(file)));
}

TEST_F(FileGuardTest, AnImageOfASequenceIsRead) {
    const fs::path image = folder.write("f_0002.png", "old");
    note_read(folder / "f_%04d.png");
    EXPECT_THAT(written(image), ElementsAre(refusal(image)));
    EXPECT_THAT(written(folder / "f_0003.png"), IsEmpty()) << "there is no such image";
    EXPECT_THAT(written(folder / "f_a.png"), IsEmpty());
    EXPECT_THAT(claimed("-o", folder / "f_%04d.png"),
                ElementsAre("-o: \"" + (folder / "f_%04d.png").string() + "\" is a file that is read here"));
}

TEST_F(FileGuardTest, APatternIsReadWhenOneOfItsImagesIs) {
    note_read(folder.write("f_0005.png", "old"));
    EXPECT_TRUE(is_read(folder / "f_%04d.png"));
    EXPECT_TRUE(is_read(folder / "./f_%d.png")) << "whatever the width of its number";
    EXPECT_THAT(claimed("-o", folder / "f_%04d.png"),
                ElementsAre("-o: \"" + (folder / "f_%04d.png").string() + "\" is a file that is read here"));
    EXPECT_FALSE(is_read(folder / "g_%04d.png"));
    EXPECT_FALSE(is_read(folder / "f_%04d.jpg"));
    EXPECT_FALSE(is_read(folder / "in/f_%04d.png"));
    allow_rewriting(folder / "f_0005.png");
    EXPECT_FALSE(is_read(folder / "f_%04d.png"));
}

TEST_F(FileGuardTest, AnImageOfANotedPatternIsNotNotedAlone) {
    const fs::path image = folder.write("f_0002.png", "old");
    note_read(folder / "f_%04d.png");
    note_read(image);
    EXPECT_TRUE(is_read(image));
    EXPECT_TRUE(is_read(folder / "f_%03d.png")) << "the same images";
    fs::create_hard_link(image, folder / "hard.png");
    EXPECT_FALSE(is_read(folder / "hard.png")) << "the images of a sequence are known by name alone";
    EXPECT_FALSE(is_read(folder / "f_0003.png")) << "there is no such image";
}

TEST_F(FileGuardTest, AFileThatIsGoneLeavesItsNumberToOthers) {
    const fs::path gone = folder.write("gone.csv", "old");
    fs::create_hard_link(gone, folder / "heir.csv");  // what has the number that a removed file had
    note_read(gone);
    fs::remove(gone);
    EXPECT_THAT(written(folder / "heir.csv"), IsEmpty());
}

TEST_F(FileGuardTest, AClaimedOutputThatIsReadLaterIsToldAtItsOption) {
    const fs::path file = folder.write("v.csv", "old");
    EXPECT_THAT(claimed("--json", file), IsEmpty());
    EXPECT_THAT(noted(folder / "v.csv"), ElementsAre("--json: \"" + file.string() + "\" is a file that is read here"));
    EXPECT_THAT(written(file), ElementsAre(refusal(file))) << "whoever catches the fault of the reader";
}

TEST_F(FileGuardTest, TwoOutputsHaveTwoNames) {
    EXPECT_THAT(claimed("--layers", folder / "amounts.csv"), IsEmpty());
    EXPECT_THAT(claimed("--amounts", folder / "./amounts.csv"),
                ElementsAre("--amounts: \"" + (folder / "./amounts.csv").string() + "\" is the file of --layers, too"));
    EXPECT_THAT(claimed("-o", folder / "x_%04d.png"), IsEmpty());
    EXPECT_THAT(claimed("--amounts", folder / "x_0007.png"),
                ElementsAre("--amounts: \"" + (folder / "x_0007.png").string() + "\" is the file of -o, too"));
    EXPECT_THAT(claimed("--amounts", folder / "x_7.csv"), IsEmpty());
}

TEST_F(FileGuardTest, WhatADocumentNamesIsRead) {
    const fs::path scene = folder.write(
        "s.scene.json",
        test::scene_text(R"(, "organ": {"file": "o.ply"}, "reference": {"file": "r.mp4"}, "preset": "p.json")"));
    const fs::path video = folder.write("r.mp4", "video");
    (void)load_scene(scene);
    for (const char* name : {"s.scene.json", "r.mp4", "o.ply", "p.json"}) EXPECT_TRUE(is_read(folder / name)) << name;
    EXPECT_THAT(written(video), ElementsAre(refusal(video)));
    const fs::path preset = folder.write("other.json", test::preset_text());
    (void)load_preset(preset);
    EXPECT_THAT(written(preset), ElementsAre(refusal(preset)));
    (void)named_path(folder.path(), "skin.png");
    EXPECT_TRUE(is_read(folder / "skin.png"));
}

TEST_F(FileGuardTest, WhatIsRewrittenInPlaceIsAllowed) {
    const fs::path file = folder.write("a.json", "old");
    note_read(file);
    allow_rewriting(file);
    EXPECT_THAT(written(file), IsEmpty());
    EXPECT_EQ(test::read_text(file), "new");
}

TEST_F(FileGuardTest, TheEditorSavesWhatItHasOpened) {
    guard_files(FileGuard::note);
    const fs::path file = folder.write("a.json", "old");
    note_read(file);
    EXPECT_TRUE(is_read(file));
    EXPECT_THAT(written(file), IsEmpty());
    guard_files(FileGuard::off);
    EXPECT_FALSE(is_read(file));
    note_read(file);
    EXPECT_FALSE(is_read(file)) << "a host is not watched";
}

}  // namespace
}  // namespace lapfx
