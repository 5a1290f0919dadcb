#include "commands/file_kind.h"

#include <gtest/gtest.h>

#include "lapfx/error.h"
#include "unit/preset/support.h"

namespace lapfx::commands {
namespace {

class FileKindTest : public ::testing::Test {
  protected:
    lapfx::test::Folder folder;

    std::filesystem::path file(const std::string& name, const std::string& text) const {
        return folder.write(name, text);
    }
};

TEST_F(FileKindTest, IsByTheNameElseByTheFirstBytes) {
    EXPECT_EQ(kind_of_file(file("a.scene.json", "x")), FileKind::document);
    EXPECT_EQ(kind_of_file(file("a.mp4", "x")), FileKind::video);
    EXPECT_EQ(kind_of_file(file("a.glb", "x")), FileKind::organ);
    EXPECT_EQ(kind_of_file(file("a.png", "x")), FileKind::image);
    EXPECT_EQ(kind_of_file(file("scene", " {\"format\": 1}")), FileKind::document);
    EXPECT_EQ(kind_of_file(file("operation", std::string("\0\1\2\3", 4))), FileKind::video);
    EXPECT_EQ(kind_of_file(file("marked", "\xef\xbb\xbf{\"format\": 1}")), FileKind::document);
    EXPECT_EQ(kind_of_file(folder / "frame_%04d.png"), FileKind::video);
    EXPECT_THROW(kind_of_file(file("notes", "just words")), Error);
    EXPECT_THROW(kind_of_file(file("a.mov", "")), Error);
    EXPECT_THROW(kind_of_file(folder / "none.mp4"), Error);
    EXPECT_THROW(kind_of_file(folder / "."), Error);
}

TEST_F(FileKindTest, FilesOfOtherProgramsAreRefusedByWhatTheyAre) {
    for (const char* name : {"a.fbx", "a.blend", "a.3mf", "a.usdz", "a.vtk", "a.nrrd", "a.nii.gz", "a.dcm"}) {
        try {
            kind_of_file(file(name, std::string("\0\1\2", 3)));
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_NE(error.faults().front().reason.find(", which is not read: "), std::string::npos) << name;
        }
    }
}

TEST_F(FileKindTest, TheSameFileHasManyNames) {
    const std::filesystem::path one = file("one", "x"), other = file("other", "x");
    std::filesystem::create_symlink(one, folder / "link");
    EXPECT_TRUE(is_same_file(one, folder / "." / "one"));
    EXPECT_TRUE(is_same_file(one, folder / "link"));
    EXPECT_FALSE(is_same_file(one, other));
    EXPECT_FALSE(is_same_file(folder / "none", folder / "none"));
}

}  // namespace
}  // namespace lapfx::commands
