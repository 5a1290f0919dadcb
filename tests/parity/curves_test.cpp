// Curves over time and amounts without drawing, against what Effects draws.
#include "lapfx/amounts.h"
#include "lapfx/effects.h"
#include "parity/render/scene_fixture.h"
#include "support/folders.h"
#include "support/meshes.h"

namespace lapfx {
namespace {

class CurvesTest : public test::SceneTest {
  protected:
    static std::vector<ToolContact> events() {
        return {
            {.action = ToolAction::cut, .time = 0.5, .duration = 0.5, .position = {0, 0, 0}, .to = {6, 0, 0}},
            {.action = ToolAction::cauterise, .time = 1.0, .duration = 3.0, .position = {-20, 0, 0}, .to = {-8, 0, 5}},
            {.action = ToolAction::suction, .time = 4.5, .duration = 1.0, .position = {3, 0, 0}, .to = {3, 0, 0}}};
    }
    static Curves curves() {
        return {.cautery_power = {{0.0, 1.0}, {2.0, 0.3}, {5.0, 1.0}},
                .bleeding_strength = {{1.0, 0.0}, {2.0, 2.0}, {4.0, 0.5}},
                .emission = {{1.5, 0.2}, {3.0, 3.0}}};
    }
    static void expect_same(const Amounts& a, const Amounts& b, double time) {
        EXPECT_EQ(a.blood_area, b.blood_area) << time;
        EXPECT_EQ(a.blood_volume, b.blood_volume) << time;
        EXPECT_EQ(a.haze, b.haze) << time;
        EXPECT_EQ(a.wounds, b.wounds) << time;
        EXPECT_EQ(a.bleeding_wounds, b.bleeding_wounds) << time;
    }
    Organ organ = test::plane(100.0, 60);
    Preset preset = [] {
        Preset p;
        p.bleeding.speed = 2.0;
        p.smoke.clips = {{.file = "wisps_thin.mp4"}};
        p.folder = test::source_folder() / "samples/clips";
        return p;
    }();
};

TEST_F(CurvesTest, AmountsModelHasTheFiguresOfEffects) {
    Effects effects(organ, preset);
    AmountsModel model(organ);
    for (const Curves& wanted : {Curves{}, curves(), Curves{}}) {
        effects.set_curves(wanted);
        effects.set_contacts(events());
        model.set(preset, events(), wanted);
        for (const double time : {0.0, 1.0, 2.4, 6.0, 3.1, 12.0}) {
            effects.seek(time);
            expect_same(model.at(time), effects.amounts(), time);
        }
    }
    EXPECT_GT(model.at(6.0).blood_area, 20.0);
    EXPECT_GT(model.at(3.0).haze, 0.0);
}

TEST_F(CurvesTest, EachCurveScalesItsOwnAndNothingElse) {
    AmountsModel model(organ);
    model.set(preset, events());
    const Amounts plain = model.at(3.0);
    model.set(preset, events(), {.cautery_power = {}, .bleeding_strength = {}, .emission = {{0.0, 2.0}}});
    EXPECT_NEAR(model.at(3.0).haze, 2.0 * plain.haze, 1e-12);
    EXPECT_EQ(model.at(3.0).blood_area, plain.blood_area);
    model.set(preset, events(), {.cautery_power = {}, .bleeding_strength = {{0.0, 0.0}}, .emission = {}});
    EXPECT_EQ(model.at(3.0).blood_area, 0.0);
    EXPECT_EQ(model.at(3.0).haze, plain.haze);
    EXPECT_EQ(model.at(3.0).wounds, plain.wounds) << "they are open, and wait";
    model.set(preset, events(), {.cautery_power = {{0.0, 0.5}}, .bleeding_strength = {}, .emission = {}});
    EXPECT_NEAR(model.at(3.0).haze, 0.5 * plain.haze, 1e-12);
}

TEST_F(CurvesTest, SeekingAnyWayGivesTheSameAndASetTwiceChangesNothing) {
    Effects there(organ, preset), back(organ, preset);
    for (Effects* effects : {&there, &back}) {
        effects->set_contacts(events());
        effects->set_curves(curves());
    }
    for (double time = 0.0; time <= 5.0; time += 0.01) there.seek(time);
    back.seek(11.0);
    back.seek(5.0);
    there.seek(5.0);
    expect_same(there.amounts(), back.amounts(), 5.0);
    there.set_curves(curves());
    there.seek(5.0);
    EXPECT_EQ(there.uploaded(), 0u);
}

TEST_F(CurvesTest, ACutOrganKeepsTheCurves) {
    Effects effects(organ, preset);
    effects.set_contacts(events());
    effects.set_curves({.cautery_power = {}, .bleeding_strength = {{0.0, 0.0}}, .emission = {{0.0, 0.0}}});
    effects.seek(0.0);
    std::vector<std::uint32_t> origin(organ.positions.size());
    for (std::uint32_t v = 0; v < origin.size(); ++v) origin[v] = v;
    effects.set_topology(organ, origin);
    effects.seek(4.0);
    EXPECT_EQ(effects.amounts().blood_area, 0.0);
    EXPECT_EQ(effects.amounts().haze, 0.0);
    EXPECT_GT(effects.amounts().wounds, 0);
}

TEST_F(CurvesTest, AmountsModelRefusesWhatCannotBe) {
    EXPECT_THROW(AmountsModel(organ, {.gravity = {0, 0, 0}}), Error);
    AmountsModel model(organ);
    model.set(preset, events());
    const Amounts before = model.at(3.0);
    Preset bad = preset;
    bad.bleeding.speed = -1.0;
    EXPECT_THROW(model.set(bad, events()), Error);
    expect_same(model.at(3.0), before, 3.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(model.at(nan).blood_area, 0.0);
}

}  // namespace
}  // namespace lapfx
