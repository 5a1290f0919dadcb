// The amounts panel, where it shows what the organ has: the preview's amounts over the scene's time, computes them
// again after each change, and a click goes to a time.
#include "app/measure/amounts.h"

#include <gmock/gmock.h>

#include <cmath>

#include "editor/support/editor_test.h"
#include "editor/support/held_jobs.h"
#include "support/wait_until.h"
#include "ui/canvas/plot_data.h"

namespace lapfx::test {
namespace {

using testing::HasSubstr;

class AmountsPanel : public SampleTest {
  protected:
    AmountsPanel() { begins.layout = "Compare"; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        ui().click("**/Amounts/On organ").frame();
        ui().settle();
    }
    const app::AmountSeries& series() { return *editor().amounts().scene(); }
    double last(AmountMember member) { return series().of(member).back(); }
};

TEST_F(AmountsPanel, HasTheFiguresOfThePreview) {
    ASSERT_NE(editor().amounts().scene(), nullptr);
    EXPECT_FALSE(editor().amounts().stale());
    EXPECT_DOUBLE_EQ(series().times.back(), editor().timeline.duration());
    for (const std::size_t i : {40U, 120U, 240U}) {
        picture(series().times[i]);
        const Amounts shown = editor().preview.preview()->amounts();
        EXPECT_EQ(series().of(&Amounts::blood_area)[i], shown.blood_area) << i;
        EXPECT_EQ(series().of(&Amounts::haze)[i], shown.haze) << i;
    }
    EXPECT_GT(last(&Amounts::blood_area), 1.0);
}

TEST_F(AmountsPanel, FollowsTheDocument) {
    const double before = last(&Amounts::haze), area = last(&Amounts::blood_area);
    editor().document.change("Curve", [](auto& c) { c.scene.curves.emission = {{0.0, 2.0}}; });
    ui().frame().settle();
    EXPECT_NEAR(last(&Amounts::haze), 2.0 * before, 1e-9);
    EXPECT_EQ(last(&Amounts::blood_area), area);
    editor().document.undo();
    ui().frame().settle();
    EXPECT_EQ(last(&Amounts::haze), before);
    const std::uint64_t version = editor().amounts().version();
    editor().document.change("Camera", [](auto& c) { c.scene.camera.eye.x += 5; });
    ui().frame().settle();
    EXPECT_EQ(editor().amounts().version(), version) << "amounts have nothing to do with the camera";
}

TEST_F(AmountsPanel, AClickGoesToTheTimeAndTheLegendHasItsValue) {
    ui().click("**/All plots/Blood area", {.at = {0.6F, 0.6F}});
    const double there = editor().timeline.time;
    EXPECT_GT(there, 0.3 * editor().timeline.duration());
    EXPECT_LT(there, 0.9 * editor().timeline.duration());
    ui().frame();
    ui::PlotData area;
    area.set(series().of(&Amounts::blood_area), series().times);
    const auto value = std::to_string(std::lround(area.value_at(there)));
    EXPECT_TRUE(ui().exists("**/All plots/Blood area/" + value)) << value;
}

TEST_F(AmountsPanel, AFaultIsToldInPlace) {
    editor().document.change("Organ", [](auto& c) { c.scene.organ.file = "gone.glb"; });
    ui().frame().settle();
    EXPECT_EQ(editor().amounts().scene(), nullptr);
    EXPECT_THAT(ui().dump(), HasSubstr("gone.glb"));
    editor().document.undo();
    ui().frame().settle();
    EXPECT_NE(editor().amounts().scene(), nullptr);
}

TEST_F(AmountsPanel, PlotsStayWhereTheyAreWhileNewOnesAreWorkedOut) {
    start({1440, 900}, false);
    open_sample();
    layout("Compare");
    ui().click("**/Amounts/On organ");
    const auto until = [&](const auto& met) { return wait_until(met, [&] { ui().frame(); }); };
    const app::AmountsOverTime& amounts = editor().amounts();
    ASSERT_TRUE(until([&] { return amounts.scene() != nullptr && !amounts.stale() && !editor().jobs.busy(); }));
    ui().frame().frame();
    const auto rects = [&] { return std::pair(ui().rect("**/All plots/Blood area"), ui().rect("**/All plots/Haze")); };
    const auto before = rects();
    EXPECT_THAT(ui().dump(), HasSubstr("Of the scene as it is now"));
    EXPECT_LE(before.second.bottom(), ui().rect("**/All plots").bottom()) << "no bar is needed";
    HeldJobs held(editor().jobs);  // they take longer than a frame
    editor().document.change("Curve", [](auto& c) { c.scene.curves.emission = {{0.0, 2.0}}; });
    ASSERT_TRUE(until([&] { return amounts.stale() && amounts.busy(); }));
    ui().frame();
    ASSERT_TRUE(amounts.stale() && amounts.busy());
    EXPECT_THAT(ui().dump(), HasSubstr("From before the last change"));
    EXPECT_EQ(rects(), before);
}

TEST_F(AmountsPanel, NothingIsWorkedOutWhileNobodyLooks) {
    layout("Tune");
    ui().settle();
    const std::uint64_t version = editor().amounts().version();
    editor().document.change("Curve", [](auto& c) { c.scene.curves.emission = {{0.0, 2.0}}; });
    ui().frame().settle();
    EXPECT_EQ(editor().amounts().version(), version);
    EXPECT_TRUE(editor().amounts().stale());
}

}  // namespace
}  // namespace lapfx::test
