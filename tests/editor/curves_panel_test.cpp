// Curves over time are drawn on the panel and seen in the preview. Each gesture is one undo step.
#include <gmock/gmock.h>

#include "editor/support/editor_test.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

using testing::HasSubstr;
using Points = std::vector<CurvePoint>;

class CurvesPanel : public SampleTest {
  protected:
    CurvesPanel() { begins.layout = "Stage"; }
    void choose(const std::string& curve) { ui().click("**/Area/Curve/" + curve); }
    const Curves& curves() { return editor().document.scene().curves; }
    std::string steps() {
        std::string names;
        for (const auto& step : editor().document.steps()) names += step.name + ";";
        return names;
    }
};

TEST_F(CurvesPanel, APointThatIsDraggedChangesThePicture) {
    choose("Bleeding strength");
    EXPECT_EQ(ui().text("**/Area/Bleeding strength"), "1 point");
    const Image before = picture(6);
    ui().drag("**/Area/Bleeding strength/Point 1", {0, 400});
    ASSERT_EQ(curves().bleeding_strength, (Points{{0.0, 0.0}}));
    EXPECT_GT(differing(before, picture(6)), 100U) << "nothing bleeds";
    EXPECT_EQ(steps(), "Bleeding strength;");
    editor().document.undo();
    EXPECT_TRUE(curves().bleeding_strength.empty());
    EXPECT_EQ(differing(before, picture(6), 0), 0U);
}

TEST_F(CurvesPanel, EachCurveIsItsOwn) {
    choose("Cautery power");
    ui().drag("**/Area/Cautery power/Point 1", {0, 400});
    EXPECT_EQ(curves().cautery_power, (Points{{0.0, 0.0}}));
    choose("Emission");
    ui().drag("**/Area/Emission/Point 1", {0, -400});
    EXPECT_EQ(curves().emission, (Points{{0.0, 2.0}}));
    EXPECT_TRUE(curves().bleeding_strength.empty());
    ui().drag("**/Area/Emission/Point 1", {0, -400});
    EXPECT_EQ(curves().emission, (Points{{0.0, 4.0}})) << "the axis goes on where the curve has come to its end";
}

TEST_F(CurvesPanel, PointsAreAddedAndRemovedAtTheTime) {
    choose("Emission");
    editor().timeline.seek(3);
    ui().frame().click("**/Area/Add point");
    editor().timeline.seek(5);
    ui().frame().click("**/Area/Add point");
    EXPECT_EQ(curves().emission, (Points{{3.0, 1.0}, {5.0, 1.0}}));
    EXPECT_TRUE(ui().is("**/Area/Add point", ui::Is::disabled)) << "one is there";
    ui().drag("**/Area/Emission/Point 2", {0, 400});
    EXPECT_EQ(curves().emission, (Points{{3.0, 1.0}, {5.0, 0.0}}));
    editor().timeline.seek(4);
    ui().frame();
    EXPECT_THAT(ui().dump(), HasSubstr("x 0.50 at 4.00 s"));
    editor().timeline.seek(3.2);
    ui().frame().click("**/Area/Remove point");
    EXPECT_EQ(curves().emission, (Points{{5.0, 0.0}}));
    ui().click("**/Area/Reset");
    EXPECT_TRUE(curves().emission.empty());
    EXPECT_EQ(steps(), "Add curve point;Add curve point;Emission;Remove curve point;Reset Emission;");
}

TEST_F(CurvesPanel, ThePointNearestToTheTimeIsTyped) {
    choose("Emission");
    EXPECT_FALSE(ui().exists("**/Area/Time")) << "there is no point";
    editor().document.change("Curve", [](auto& c) { c.scene.curves.emission = {{1.0, 1.0}, {2.0, 0.5}, {4.0, 2.0}}; });
    editor().timeline.seek(2.2);
    ui().frame();
    EXPECT_EQ(ui().value("**/Area/Time"), 2.0);
    ui().click("**/Area/Value", {.clicks = 2}).type("0.75").key(ui::Key::enter);
    EXPECT_EQ(curves().emission, (Points{{1.0, 1.0}, {2.0, 0.75}, {4.0, 2.0}}));
    ui().click("**/Area/Time", {.clicks = 2}).type("2500 ms").key(ui::Key::enter);
    EXPECT_EQ(curves().emission, (Points{{1.0, 1.0}, {2.5, 0.75}, {4.0, 2.0}}));
    ui().click("**/Area/Time", {.clicks = 2}).type("9").key(ui::Key::enter);
    EXPECT_EQ(curves().emission, (Points{{1.0, 1.0}, {3.999, 0.75}, {4.0, 2.0}})) << "points stay in order";
    EXPECT_THAT(ui().dump(), HasSubstr("allowed are 1.001 to 3.999 s: 3.999 s is taken"));
    EXPECT_EQ(steps(), "Curve;Curve point;Curve point;Curve point;");
}

TEST_F(CurvesPanel, TextIsCopiedAndPasted) {
    choose("Emission");
    ui().clipboard().set("0 1\n2.5 0.25\n");
    ui().click("**/Area/Paste");
    EXPECT_EQ(curves().emission, (Points{{0.0, 1.0}, {2.5, 0.25}}));
    ui().click("**/Area/Copy as text");
    EXPECT_EQ(ui().clipboard().get(), "0\t1\n2.5\t0.25\n");
    ui().clipboard().set("1 2\n0.5 2\n");
    ui().click("**/Area/Paste").settle();
    EXPECT_EQ(curves().emission, (Points{{0.0, 1.0}, {2.5, 0.25}})) << "as it was";
    EXPECT_THAT(ui().dump(), HasSubstr("line 2: 0.5 s is not after 1 s, the time of the point before"));
}

TEST_F(CurvesPanel, KeysMoveAndEraseAndOtherKindsOfPointsAreNoChange) {
    choose("Emission");
    editor().document.change("Curve", [](auto& c) { c.scene.curves.emission = {{1.0, 1.0}, {2.0, 0.5}}; });
    ui().frame().click("**/Area/Emission/Point 2");
    ui().key(ui::Key::up);
    EXPECT_EQ(curves().emission, (Points{{1.0, 1.0}, {2.0, 0.55}}));
    const std::size_t steps_before = editor().document.steps().size();
    ui().key('A').frame();
    EXPECT_EQ(editor().document.steps().size(), steps_before);
    ui().key(ui::Key::del);
    EXPECT_EQ(curves().emission, (Points{{1.0, 1.0}}));
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
}

}  // namespace
}  // namespace lapfx::test
