// Names from outside become paths in a single place.
#include <gmock/gmock.h>

#include "lapfx/authoring/file.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

namespace fs = std::filesystem;

class NamedPath : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(folder / "case/maps");
        fs::create_directories(folder / "case-of-others");
        folder.write("secret", "x");
        fs::create_symlink(folder / "secret", folder / "case/skin.png");
        fs::create_symlink("../..", folder / "case/maps/up");
        fs::create_symlink("maps", folder / "case/textures");
        fs::create_symlink("loop", folder / "case/loop");
    }
    std::string fault(const std::string& name, Reach reach = Reach::inside) const {
        const auto lines = test::faults_of([&] { named_path(folder / "case", name, reach, "a.obj", "here"); });
        return lines.empty() ? "" : lines.front();
    }
    test::Folder folder;
};

TEST_F(NamedPath, StaysInTheFolderWhateverTheNameSays) {
    using testing::StartsWith;
    EXPECT_EQ(fault(""), "a.obj: here: no file name");
    EXPECT_EQ(fault(std::string("a\0b", 3)), "a.obj: here: the file name contains a NUL character");
    EXPECT_EQ(
        fault("../secret"),
        "a.obj: here: \"../secret\" leads out of the folder; only plain files in the folder of the file that names "
        "them, or below, are read");
    EXPECT_THAT(fault("maps/../../secret"), testing::HasSubstr("leads out of the folder;"));
    EXPECT_THAT(fault(".."), testing::HasSubstr("leads out of the folder;"));
    EXPECT_THAT(fault((folder / "case/maps/a.png").string()), testing::HasSubstr("is an absolute path;"));
    EXPECT_THAT(fault("../case-of-others/a.png"), testing::HasSubstr("leads out of the folder;"));
    for (const char* url : {"file:///etc/passwd", "http://x/a.png", "concat:a|b", "file:a.png"})
        EXPECT_THAT(fault(url), testing::HasSubstr("is a URL;")) << url;
    EXPECT_THAT(fault("C:\\a.png"), testing::HasSubstr("is an absolute path;"));
    EXPECT_THAT(fault("C:/a.png", Reach::anywhere), testing::HasSubstr("is a path of Windows;"));
    EXPECT_THAT(fault("skin.png"), testing::HasSubstr("leads out of the folder by a symbolic link;"));
    EXPECT_THAT(fault("maps/up/secret"), testing::HasSubstr("leads out of the folder by a symbolic link;"));
    EXPECT_THAT(fault("loop/a.png"), testing::HasSubstr("cannot be followed"));
}

TEST_F(NamedPath, WhatLiesInsideIsFoundAlsoByLinks) {
    EXPECT_EQ(named_path(folder / "case", "maps/a b.png"), folder / "case/maps/a b.png");
    EXPECT_EQ(named_path(folder / "case", "./maps/../a.png"), folder / "case/a.png");
    EXPECT_EQ(named_path(folder / "case", "textures/a.png"), folder / "case/textures/a.png");
    EXPECT_EQ(named_path(folder / "case", "..a.png"), folder / "case/..a.png");
    fs::create_directory_symlink(folder / "case", folder / "linked");
    EXPECT_EQ(named_path(folder / "linked", "maps/a.png"), folder / "linked/maps/a.png") << "the folder may be a link";
    EXPECT_EQ(named_path("", "nowhere/a.png"), "nowhere/a.png");
}

TEST_F(NamedPath, LettersWithMarksMayBeSpelledInTwoWays) {
    const std::string one = "gr\u00f6\u00dfe",
                      two = "gro\u0308\u00dfe";  // composed, as most write it, and decomposed, as macOS does
    fs::create_directories(folder / "case" / two);
    folder.write("case/" + two + "/clip " + one + ".mp4", "x");
    const fs::path there = folder / "case" / two / ("clip " + one + ".mp4");
    for (const std::string& in : {one, two})
        for (const std::string& name : {one, two})
            for (const Reach reach : {Reach::inside, Reach::anywhere})
                EXPECT_EQ(named_path(folder / "case", in + "/clip " + name + ".mp4", reach), there);
    folder.write("case/" + one + ".png", "x");
    folder.write("case/" + two + ".png", "x");
    for (const std::string& name : {one, two})
        EXPECT_EQ(named_path(folder / "case", name + ".png"), folder / "case" / (name + ".png"))
            << "the name itself first";
    EXPECT_EQ(named_path(folder / "case", one + "/gone.mp4"), folder / "case" / two / "gone.mp4");
    EXPECT_EQ(named_path(folder / "case", "\u00e4/gone.mp4"), folder / "case" / "\u00e4/gone.mp4");
    fs::create_symlink(folder / "secret", folder / "case" / ("link " + two));
    EXPECT_THAT(fault("link " + one), testing::HasSubstr("leads out of the folder by a symbolic link;"));
}

TEST_F(NamedPath, WhereAPathLiesDoesNotDependOnHowItIsWritten) {
    for (const fs::path& inside : {folder / "case/a.json", folder / "case/../case/maps/a.json",
                                   fs::path("/tmp") / ".." / folder.path().relative_path() / "case/a.json"})
        EXPECT_TRUE(lies_in(folder / "case", inside)) << inside;
    for (const fs::path& outside :
         {folder / "secret", folder / "case/skin.png", folder / "case-of-others/a.json", fs::path("/")})
        EXPECT_FALSE(lies_in(folder / "case", outside)) << outside;
    EXPECT_TRUE(lies_in("", "nowhere/a.png"));
}

TEST_F(NamedPath, WhatAPersonHasChosenMayLieAnywhereButIsAFile) {
    EXPECT_EQ(named_path(folder / "case", "../secret", Reach::anywhere), folder / "case/../secret");
    EXPECT_EQ(named_path(folder / "case", "/data/liver.glb", Reach::anywhere), "/data/liver.glb");
    EXPECT_EQ(fault("file:///etc/passwd", Reach::anywhere),
              "a.obj: here: \"file:///etc/passwd\" is a URL; only plain files are read");
    EXPECT_EQ(fault("", Reach::anywhere), "a.obj: here: no file name");
}

}  // namespace
}  // namespace lapfx
