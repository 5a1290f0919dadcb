// Strokes of blood, painted over the picture of the Measure panel.
#include <fstream>

#include "app/measure/blood_strokes.h"
#include "editor/support/measure_panel.h"

namespace lapfx::test {
namespace {

using ui::Key;
using ui::Mods;

class PaintedStrokes : public MeasurePanelOfKnown {};

TEST_F(PaintedStrokes, BloodIsPaintedOverThePicture) {
    const double fresh = bench().amounts().blood.value;
    const std::string strokes = picture_path + "/strokes";
    ui().key('B', Mods::command | Mods::shift).frame();
    ASSERT_TRUE(holds(app::MeasureTool::paint_blood));
    EXPECT_TRUE(says("Paint over blood"));
    ui().press(strokes, {0.5F, 0.55F}).drag_by({30, 0});
    EXPECT_EQ(steps(), 0U) << "it is still being painted";
    ui().release().frame().frame();
    ASSERT_EQ(measure().strokes.size(), 1U);
    EXPECT_EQ(last_step(), "Paint blood");
    const BloodStroke first = measure().strokes[0];
    EXPECT_EQ(first.marks, StrokeMark::blood);
    EXPECT_EQ(editor().reference().video()->frame_at(first.time), bench().frame());
    EXPECT_GE(first.points.size(), 2U);
    EXPECT_NEAR(first.points.front().x, 0.5, 0.01);
    EXPECT_GT(first.points.back().x, first.points.front().x + 0.02);
    EXPECT_TRUE(editor().reference().held()) << "the frame does not run away from the brush";
    EXPECT_FALSE(ui().exists(panel + "Amounts")) << "nor the picture, when the curves come and go";
    const ui::Rect place = ui().rect(picture_path);

    ui().press(strokes, {0.2F, 0.3F}, Mods::shift).drag_by({60, 20}, Mods::shift).release(Mods::shift).frame().frame();
    ASSERT_EQ(measure().strokes.size(), 2U);
    EXPECT_EQ(measure().strokes[1].marks, StrokeMark::other);
    EXPECT_EQ(last_step(), "Paint what is no blood");
    EXPECT_TRUE(bench().by_strokes()) << ui().dump();
    EXPECT_GT(bench().amounts().blood.value, 0.5 * fresh);
    EXPECT_GT(yellow_pixels(), 500U);
    EXPECT_EQ(ui().rect(picture_path), place);
    EXPECT_TRUE(says("1 blood, 1 other"));
    EXPECT_TRUE(says("redness, rise and brightness do not count"));
    EXPECT_TRUE(ui().is(rows + "Blood/Pick blood", ui::Is::disabled));

    ui().key(Key::escape).frame();
    EXPECT_TRUE(holds(app::MeasureTool::none));
    EXPECT_FALSE(ui().exists(strokes));
    EXPECT_TRUE(ui().is(panel + "Hold", ui::Is::checked)) << "that the brush has held the frame is seen";
    EXPECT_TRUE(says("Reference held at ")) << "also where neither panel is";
    ui().click(panel + "Hold").frame().frame();
    EXPECT_FALSE(editor().reference().held());
    EXPECT_FALSE(says("Reference held at "));
    ui().click(rows + "Blood/Remove strokes of this frame").frame().frame();
    EXPECT_TRUE(measure().strokes.empty());
    EXPECT_FALSE(bench().by_strokes());
    EXPECT_EQ(bench().amounts().blood.value, fresh);
    undo();
    ui().frame();
    EXPECT_EQ(measure().strokes.size(), 2U);
    EXPECT_TRUE(bench().by_strokes());
}

TEST_F(PaintedStrokes, StrokesAreNothingWhileTheyDoNotSayWhatIsNoBlood) {
    editor().document.change("Blood", [&](document::Content& c) {
        c.scene.reference.measure.strokes = {{.time = bloody_time, .points = {{0.5, 0.55}}}};
        c.scene.reference.measure.baseline = bloody_time;
    });
    go(bloody_time);
    EXPECT_TRUE(bench().ready()) << "the picture stays, to paint on";
    EXPECT_FALSE(bench().by_strokes());
    EXPECT_TRUE(says("Nothing is learned from the strokes yet: no stroke marks what is no blood")) << ui().dump();
}

TEST_F(PaintedStrokes, AStrokeThatCannotBeLearnedIsNamed) {
    editor().document.change("Blood", [&](document::Content& c) {
        c.scene.reference.measure.strokes = {{.time = bloody_time, .points = {{0.5, 0.55}}},
                                             {.time = 500.0, .marks = StrokeMark::other, .points = {{0.2, 0.3}}}};
    });
    go(bloody_time);
    EXPECT_TRUE(says("stroke 2 at 500.00 s: 500.00 s is outside the video")) << ui().dump();
    ui().click(panel + "Measure").frame().frame();
    EXPECT_TRUE(says("/reference/measure/strokes/1/time: 500.00 s is outside the video")) << ui().dump();
    EXPECT_FALSE(says("operation.mp4: /reference")) << "the scene says so, not the video";
}

TEST_F(PaintedStrokes, AnotherReferenceTakesTheBrushAway) {
    ui().click(rows + "Blood/Paint blood").frame();
    ASSERT_TRUE(bench().look.paints());
    editor().reference().choose_sample();
    for (int i = 0; i < 10; ++i) ui().frame();
    EXPECT_FALSE(bench().look.paints());
}

TEST_F(PaintedStrokes, EscDropsAStrokeAndBracketsSizeTheBrush) {
    ui().click(rows + "Blood/Paint other").frame();
    const double brush = bench().look.brush;
    ui().key(']').frame().key(']').frame();
    EXPECT_NEAR(bench().look.brush, brush * 1.25 * 1.25, 1e-9);
    ui().key('[').frame();
    EXPECT_NEAR(bench().look.brush, brush * 1.25, 1e-9);
    for (int i = 0; i < 30; ++i) ui().key(']');
    EXPECT_EQ(bench().look.brush, app::MeasureLook::most_brush);
    ui().press(picture_path + "/strokes", {0.3F, 0.3F}).drag_by({40, 0});
    EXPECT_TRUE(bench().look.stroke);
    ui().key(Key::escape).frame();
    EXPECT_FALSE(bench().look.stroke);
    ui().release().frame();
    EXPECT_TRUE(measure().strokes.empty());
    EXPECT_EQ(steps(), 0U);
}

TEST_F(PaintedStrokes, AFrameWithoutBloodIsNamedOnlyForStrokes) {
    const std::string button = rows + "Blood/No blood in this frame";
    EXPECT_TRUE(says("Without blood: none"));
    EXPECT_FALSE(ui().exists(rows + "Blood/Without blood")) << "-1 s is no time";
    EXPECT_TRUE(ui().is(button, ui::Is::disabled));
    EXPECT_NE(ui().tip(button).find("nothing is painted over it"), std::string::npos) << ui().tip(button);
    editor().document.change("Paint", [&](document::Content& c) {
        c.scene.reference.measure.strokes = {{.time = bloody_time, .points = {{0.5, 0.55}}}};
    });
    go(clear_time);
    ASSERT_FALSE(ui().is(button, ui::Is::disabled));
    ui().click(button).frame().frame();
    EXPECT_EQ(editor().reference().video()->frame_at(measure().without_blood), editor().reference().frame());
    EXPECT_EQ(last_step(), "No blood in this frame");
    EXPECT_FALSE(says("Without blood: none"));
    EXPECT_TRUE(ui().exists(rows + "Blood/Without blood"));
    ui().click(rows + "Blood/No frame without blood").frame().frame();
    EXPECT_EQ(measure().without_blood, -1.0);
    EXPECT_TRUE(says("Without blood: none"));
    undo();
    EXPECT_GT(measure().without_blood, 0.0);
}

TEST_F(PaintedStrokes, StrokesAreExportedAndOpenedAgain) {
    std::vector<BloodStroke> strokes{{.time = bloody_time, .radius = 0.02, .points = {{0.5, 0.55}, {0.55, 0.55}}},
                                     {.time = bloody_time, .marks = StrokeMark::other, .points = {{0.2, 0.3}}}};
    editor().document.change("Paint", [&](document::Content& c) { c.scene.reference.measure.strokes = strokes; });
    ui().frame().frame();
    ui().click(rows + "Blood/No blood in this frame").frame().frame();
    const double without = measure().without_blood;
    EXPECT_EQ(editor().reference().video()->frame_at(without), bench().frame());
    const auto choose = [&](const std::string& file) {
        ui().type("\b").key('A', Mods::command).type((folder() / file).string()).key(Key::enter);
        ui().frame().frame();
    };
    ui().click(rows + "Blood/Export strokes...").frame().frame();
    choose("strokes.json");
    ASSERT_TRUE(says("Exported strokes.json")) << ui().dump();
    editor().commands.run("measure.remove_strokes");
    ui().frame().frame();
    EXPECT_TRUE(measure().strokes.empty());
    EXPECT_EQ(measure().without_blood, -1.0);
    app::open_strokes(editor().document, editor().reference(), folder() / "strokes.json", editor().toasts);
    ASSERT_EQ(measure().strokes.size(), 2U);
    EXPECT_EQ(measure().strokes[0].points, strokes[0].points);
    EXPECT_EQ(measure().strokes[1].marks, StrokeMark::other);
    EXPECT_EQ(measure().without_blood, without);
    EXPECT_EQ(last_step(), "Open strokes");
    std::ofstream(folder() / "late.json") << R"({"format": "lapfx.blood_strokes", "version": 1, "strokes": [
                {"time": 500, "marks": "blood", "radius": 0.01, "points": [[0.5, 0.5]]}]})";
    app::open_strokes(editor().document, editor().reference(), folder() / "late.json", editor().toasts);
    ui().frame();
    EXPECT_TRUE(says("late.json: /strokes/0/time: 500.00 s is outside the video")) << ui().dump();
    EXPECT_EQ(measure().strokes.size(), 2U);
    std::ofstream(folder() / "broken.json") << "{";
    app::open_strokes(editor().document, editor().reference(), folder() / "broken.json", editor().toasts);
    ui().frame();
    EXPECT_EQ(measure().strokes.size(), 2U);
    EXPECT_TRUE(says("broken.json: line 1: is no JSON")) << ui().dump();
}

}  // namespace
}  // namespace lapfx::test
