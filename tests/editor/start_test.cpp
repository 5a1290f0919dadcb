#include "app/preview/preview_host.h"
#include "editor/support/editor_test.h"
#include "editor/support/held_jobs.h"
#include "support/wait_until.h"
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

TEST_F(EditorStart, TimeWaitsForTheFirstOrgan) {
    shares_organ = false;
    start({1440, 900}, false);
    HeldJobs held(editor().jobs);
    open_sample();
    editor().timeline.speed = 1;
    ui().frame(0.2).frame(0.2);
    ASSERT_FALSE(editor().preview.ready());
    EXPECT_EQ(editor().timeline.time, 0) << "nobody sees it yet";
    held.let_go();
    EXPECT_TRUE(wait_until([&] { return editor().preview.ready(); }, [&] { ui().frame(0.001); }));
    const double begun = editor().timeline.time;
    ui().frame(0.2);
    EXPECT_NEAR(editor().timeline.time, begun + 0.2, 1e-6);
}

}  // namespace
}  // namespace lapfx::test
