// Marks on the reference and the loop range: set at the present frame, shown and moved on the timeline, kept in the
// scene file.
#include "app/files/files.h"
#include "app/preview/timeline.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "support/clips.h"
#include "support/folders.h"

namespace lapfx::test {
namespace {

class MarksTest : public SampleTest {
  protected:
    MarksTest() { begins.layout = "Compare"; }
    const SceneReference& named() { return editor().document.scene().reference; }
    const std::string& last_step() { return editor().document.steps().at(editor().document.done() - 1).name; }
    void at(double time) {
        editor().timeline.seek(time);
        ui().frame();
    }
    std::string item(const std::string& name) { return "**/" + name; }
};

TEST_F(MarksTest, AKeyMarksThePresentFrameInTheReferencesTime) {
    at(2);
    ui().key('1', ui::Mods::alt).frame();
    EXPECT_NEAR(named().marks.smoke_starts, 2.5, 1e-4) << "the sample's offset is half a second";
    EXPECT_EQ(last_step(), "Mark: Smoke starts");
    EXPECT_TRUE(ui().exists(item("Smoke starts")));
    at(3);
    ui().key('2', ui::Mods::alt).key('4', ui::Mods::alt).frame();
    EXPECT_NEAR(named().marks.smoke_peaks, 3.5, 1e-4);
    EXPECT_NEAR(named().marks.blood_starts, 3.5, 1e-4);
    EXPECT_EQ(named().marks.smoke_clears, -1);
    EXPECT_FALSE(ui().exists(item("Smoke clears")));
    editor().document.undo();
    ui().frame();
    EXPECT_EQ(named().marks.blood_starts, -1);
    EXPECT_FALSE(ui().exists(item("Blood starts")));
}

TEST_F(MarksTest, AFrameThatIsHeldIsTheOneThatIsMarked) {
    at(2);
    editor().reference().hold(100);
    ui().frame().key('3', ui::Mods::alt).frame();
    EXPECT_NEAR(named().marks.smoke_clears, 4, 0.021);
}

TEST_F(MarksTest, WhereTheReferenceHasNoFrameNothingIsMarked) {
    editor().document.change("Offset", [](document::Content& c) { c.scene.reference.offset = -2; });
    at(1);
    const std::size_t steps = editor().document.done();
    ui().key('1', ui::Mods::alt).frame();
    EXPECT_EQ(named().marks.smoke_starts, -1);
    EXPECT_EQ(editor().document.done(), steps);
}

TEST_F(MarksTest, TheyAreMovedOnTheTimelineInOneStep) {
    at(4);
    ui().key('1', ui::Mods::alt).frame();
    at(0);
    const std::size_t steps = editor().document.done();
    ui().drag(item("Smoke starts"), {60, 0}).frame();
    EXPECT_GT(named().marks.smoke_starts, 4.6);
    EXPECT_EQ(editor().document.done(), steps + 1);
    EXPECT_EQ(last_step(), "Move mark");
    editor().document.undo();
    EXPECT_NEAR(named().marks.smoke_starts, 4.5, 1e-4);
}

TEST_F(MarksTest, AMarkThatIsMovedStaysSelected) {
    at(4);
    ui().key('1', ui::Mods::alt).frame();
    at(0);
    ui().drag(item("Smoke starts"), {60, 0}).frame();
    EXPECT_TRUE(ui().is(item("Smoke starts"), ui::Is::selected));
    ui().click(item("Cauterise 1")).frame().frame();
    EXPECT_FALSE(ui().is(item("Smoke starts"), ui::Is::selected));
    ui().click(item("Smoke starts")).frame();
    editor().selected = {0};  // the view does the same
    ui().frame().frame();
    EXPECT_FALSE(ui().is(item("Smoke starts"), ui::Is::selected));
}

TEST_F(MarksTest, ThoseOutsideOfTheSceneAreReachedAndMoved) {
    const double length = editor().document.scene().duration;
    editor().document.change("Marks", [&](document::Content& c) {
        c.scene.reference.offset = 4;
        c.scene.reference.marks.smoke_starts = 1;  // three seconds before the scene
        c.scene.reference.marks.smoke_peaks = 6;
        c.scene.reference.marks.smoke_clears = 4 + length + 2;
    });
    ui().frame().frame();
    const ui::Rect lane = ui().rect("**/Time/Reference");
    for (const char* name : {"Smoke starts", "Smoke clears"}) {
        ASSERT_TRUE(ui().exists(item(name)));
        const ui::Rect mark = ui().rect(item(name));
        EXPECT_GE(mark.x + mark.w / 2, lane.x) << name;
        EXPECT_LE(mark.x + mark.w / 2, lane.x + lane.w) << name;
    }
    ui().drag(item("Smoke starts"), {30, 0}).frame();
    EXPECT_GT(named().marks.smoke_starts, 1.1);
    EXPECT_LT(named().marks.smoke_starts, 3) << "as far as the pointer, not to the scene's start";
    const double moved = named().marks.smoke_starts;
    ui().click(item("Smoke peaks")).frame();
    ui().click(item("Smoke starts"), {.mods = ui::Mods::shift}).frame();
    ui().click(item("Smoke clears"), {.mods = ui::Mods::shift}).frame();
    ui().drag(item("Smoke peaks"), {-30, 0}).frame();
    EXPECT_EQ(named().marks.smoke_peaks, 6) << "one is farther out already than it could go";
    EXPECT_EQ(named().marks.smoke_starts, moved);
    EXPECT_EQ(named().marks.smoke_clears, 4 + length + 2);
}

TEST_F(MarksTest, EventsAndMarksAreMovedEachForItself) {
    at(4);
    ui().key('1', ui::Mods::alt).frame();
    const auto events = editor().document.scene().events;
    at(0);
    ui().drag(item("Cauterise 1"), {40, 0}).frame();
    EXPECT_GT(editor().document.scene().events[0].time, events[0].time);
    EXPECT_EQ(last_step(), "Move event");
    EXPECT_NEAR(named().marks.smoke_starts, 4.5, 1e-4);
}

TEST_F(MarksTest, DeleteTakesAMarkAwayAndACommandAll) {
    at(3);
    ui().key('1', ui::Mods::alt).frame();
    at(5);
    ui().key('2', ui::Mods::alt).frame();
    const std::size_t events = editor().document.scene().events.size();
    ui().click(item("Smoke starts")).key(ui::Key::del).frame();
    EXPECT_EQ(named().marks.smoke_starts, -1);
    EXPECT_NEAR(named().marks.smoke_peaks, 5.5, 1e-4);
    EXPECT_EQ(editor().document.scene().events.size(), events);
    EXPECT_EQ(last_step(), "Delete mark");
    editor().commands.run("reference.clear_marks");
    ui().frame();
    EXPECT_EQ(named().marks.smoke_peaks, -1);
    EXPECT_FALSE(editor().reference().any_mark());
    editor().document.undo();
    EXPECT_NEAR(named().marks.smoke_peaks, 5.5, 1e-4);
}

TEST_F(MarksTest, TheyStayWithTheReferenceWhenItIsAligned) {
    at(3);
    ui().key('1', ui::Mods::alt).frame();
    const float before = ui().rect(item("Smoke starts")).x;
    editor().document.change("Offset", [](document::Content& c) { c.scene.reference.offset = -0.5; });
    ui().frame();
    EXPECT_NEAR(named().marks.smoke_starts, 3.5, 1e-4);
    EXPECT_GT(ui().rect(item("Smoke starts")).x, before + 5) << "a second later in the scene";
}

TEST_F(MarksTest, TheLoopRangeIsPartOfTheSceneFile) {
    at(2);
    ui().key('I').frame();
    at(5);
    ui().key('O').frame();
    EXPECT_TRUE(editor().timeline.has_range);
    EXPECT_NEAR(named().loop.from, 2.5, 1e-4);
    EXPECT_NEAR(named().loop.to, 5.5, 1e-4);
    EXPECT_EQ(last_step(), "Loop range");
    editor().document.save_scene(folder() / "loop.scene.json");
    editor().commands.run("play.range_drop");
    ui().frame();
    EXPECT_FALSE(editor().timeline.has_range);
    EXPECT_FALSE(named().loop.set());
    editor().document.undo();
    ui().frame();
    EXPECT_TRUE(editor().timeline.has_range) << "undo brings it back to the timeline, too";
    editor().files().open_anyway({(folder() / "loop.scene.json").string()});
    ui().frame().frame();
    EXPECT_TRUE(editor().timeline.has_range);
    EXPECT_NEAR(editor().timeline.range.low, 2, 1e-4);
    EXPECT_NEAR(editor().timeline.range.high, 5, 1e-4);
}

TEST_F(MarksTest, TheLoopRangeIsDraggedInOneStep) {
    at(2);
    ui().key('I').frame();
    at(5);
    ui().key('O').frame();
    at(0);
    const std::size_t steps = editor().document.done();
    ui().drag(item("Out"), {40, 0}).frame();
    EXPECT_GT(named().loop.to, 5.6);
    EXPECT_EQ(editor().document.done(), steps + 1);
    editor().document.undo();
    ui().frame();
    EXPECT_NEAR(editor().timeline.range.high, 5, 1e-3);
}

TEST_F(MarksTest, AnotherDocumentHasItsOwn) {
    at(2);
    ui().key('I').frame();
    editor().files().open_anyway({(source_folder() / "samples/lagb.scene.json").string()});
    ui().frame().frame();
    EXPECT_FALSE(editor().timeline.has_range);
}

}  // namespace
}  // namespace lapfx::test
