#include "editor/support/editor_test.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

using EditorStart = EditorTest;

TEST_F(EditorStart, TheSampleSceneIsSeen) {
    open_sample();
    ASSERT_TRUE(editor().preview.ready());
    const Image start = picture(0), later = picture(6);
    EXPECT_EQ(start.width, static_cast<int>(ui().rect("Workspace/View/Preview").w));
    EXPECT_GT(differing(start, later), 1000U);
    EXPECT_EQ(differing(later, picture(6), 0), 0U) << "the same time is the same picture";
}

TEST_F(EditorStart, NothingLacksANameForTheKeyboard) {
    open_sample();
    for (const char* name : {"Tune", "Key", "Compare", "Stage"}) {
        layout(name);
        EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{}) << name;
    }
}

}  // namespace
}  // namespace lapfx::test
