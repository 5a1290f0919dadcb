// Clips outside of the preset's folder are copied only into folders of the user.
#include "app/base/file_chooser.h"
#include "app/clips/keying_bench.h"
#include "app/files/files.h"
#include "editor/support/editor_test.h"
#include "support/clips.h"
#include "support/folders.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;

class CopyClips : public SampleTest {
  protected:
    CopyClips() { begins.layout = "Key"; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        fs::create_directories(folder() / "elsewhere");
        fs::copy_file(source_folder() / "samples/clips/wisps_thin.mp4", folder() / "elsewhere/mine.mp4");
        editor().document.change("Add clip", [&](document::Content& c) {
            c.preset.smoke.clips.push_back({.file = (folder() / "elsewhere/mine.mp4").string()});
        });
        editor().clips().selected = editor().document.preset().smoke.clips.size() - 1;
        ui().frame().frame().frame();
    }
};

TEST_F(CopyClips, NothingIsCopiedToWhereTheProgramLies) {
    ASSERT_TRUE(editor().chooser().shipped(editor().clips().home())) << editor().clips().home();
    ASSERT_TRUE(editor().clips().any_outside());
    EXPECT_FALSE(editor().commands.enabled(editor().commands.index_of("clip.copy")));
    EXPECT_FALSE(ui().exists("Workspace/Clips/Copy clips next to the preset"));
    EXPECT_TRUE(ui().exists("**/Save preset as...")) << "the way out: " << ui().dump();
}

TEST_F(CopyClips, OnlyFoldersOfTheUserTakeFiles) {
    EXPECT_TRUE(editor().chooser().takes_files(folder()));
    EXPECT_FALSE(editor().chooser().takes_files(shipped() / "presets"));
    EXPECT_FALSE(editor().chooser().takes_files(shipped() / "samples/clips"));
    EXPECT_FALSE(editor().chooser().takes_files(folder() / "not there"));
    EXPECT_FALSE(editor().chooser().takes_files({}));
}

}  // namespace
}  // namespace lapfx::test
