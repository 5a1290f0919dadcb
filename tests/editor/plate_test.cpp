// The plate in the editor: a switch in the view and by the reference, made for the scene's camera, and what is told
// when it cannot be made.
#include <fstream>

#include "app/base/layouts.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "editor/support/held_jobs.h"
#include "support/endoscope.h"
#include "support/wait_until.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;

class PlateSwitch : public SampleTest {
  protected:
    PlateSwitch() { scene_scale = 1; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        ASSERT_TRUE(editor().preview.ready() || !begins.exact);
    }
    const Scene& scene() { return editor().document.scene(); }
    const std::string& organ() { return editor().preview.preview()->organ().name; }
    app::Reference& reference() { return editor().reference(); }
    app::ReferenceComparison& comparison() { return reference().comparison(); }
};

TEST_F(PlateSwitch, IsInTheViewAndOneUndoStep) {
    const Image before = picture(3);
    const std::string former = organ();
    editor().looking.endoscope = false;
    ui().click("Workspace/View/Plate").frame();
    EXPECT_TRUE(scene().plate.use);
    EXPECT_EQ(editor().document.steps().back().name, "Plate from the reference");
    EXPECT_TRUE(editor().looking.endoscope) << "it is the picture of the scene's camera";
    EXPECT_TRUE(organ().starts_with("frame at ")) << organ();
    const Image plate = picture(3);
    EXPECT_GT(differing(before, plate), before.pixels.size() / 16);
    ui().key('P').frame();
    EXPECT_FALSE(scene().plate.use);
    EXPECT_EQ(organ(), former);
    EXPECT_EQ(differing(before, picture(3)), 0U) << "the organ again, with all that happened to it";
    editor().document.undo();
    ui().frame();
    EXPECT_EQ(differing(plate, picture(3)), 0U);
    editor().document.undo();
    ui().frame();
    EXPECT_FALSE(scene().plate.use);
    EXPECT_EQ(differing(before, picture(3)), 0U);
}

TEST_F(PlateSwitch, TheFrameThatIsShownComesOutPixelByPixel) {
    layout("Compare");
    comparison().way = app::CompareWay::difference;
    editor().timeline.seek(0);
    ui().frame();
    editor().commands.run("reference.plate_here");
    ui().frame().frame();
    EXPECT_EQ(scene().plate.frame, PlateFrame::chosen);
    EXPECT_NEAR(scene().plate.time, reference().time(), 0.05);
    const ui::Picture preview = comparison().preview(), video = comparison().reference();
    ASSERT_NE(preview.pixels, nullptr);
    ASSERT_EQ(preview.size, video.size);
    for (int y = 3; y < preview.size.y; y += 37)
        for (int x = 5; x < preview.size.x; x += 41) {
            const glm::vec4 apart = glm::abs(preview.pixels->pixel({x, y}) - video.pixels->pixel({x, y}));
            ASSERT_LE(std::max({apart.r, apart.g, apart.b}), 1.0F) << x << ' ' << y;
        }
    // Now smoke and blood come, and only these differ.
    editor().timeline.seek(7);
    reference().hold(reference().video()->frame_at(scene().plate.time + 5e-4));
    ui().frame().frame();
    const ui::Picture later = comparison().preview(), still = comparison().reference();
    const auto apart = [&](glm::ivec2 at) {
        return glm::distance(glm::vec3(later.pixels->pixel(at)), glm::vec3(still.pixels->pixel(at)));
    };
    EXPECT_GT(apart(later.size / 2), 30.0F) << "blood in the middle";
    EXPECT_LT(apart({later.size.x / 2, later.size.y - 6}), 40.0F) << "thin haze below";
}

TEST_F(PlateSwitch, LiesWhereTheReferenceIsPlaced) {
    layout("Compare");
    comparison().way = app::CompareWay::difference;
    editor().timeline.seek(0);
    ui().frame();
    editor().commands.run("reference.plate_here");
    const auto apart = [&] {
        ui().frame().frame();
        const ui::Picture preview = comparison().preview(), video = comparison().reference();
        EXPECT_EQ(preview.size, video.size);
        double sum = 0, count = 0;
        for (int y = 3; y < preview.size.y; y += 11)
            for (int x = 5; x < preview.size.x; x += 13) {
                const glm::vec4 off = glm::abs(preview.pixels->pixel({x, y}) - video.pixels->pixel({x, y}));
                sum += static_cast<double>(off.r + off.g + off.b), count += 3;
            }
        return sum / count;
    };
    EXPECT_LT(apart(), 2);
    editor().document.change("Place", [](document::Content& c) {
        c.scene.reference.placement = {.right = 0.08, .up = -0.05, .scale = 0.71, .rotation = 9};
    });
    EXPECT_LT(apart(), 2) << "code values, on average";
    editor().document.change("Aspect", [](document::Content& c) { c.scene.reference.aspect = 16.0 / 9; });
    EXPECT_LT(apart(), 2);
    editor().document.change("Large", [](document::Content& c) { c.scene.reference.placement.scale = 1.6; });
    EXPECT_LT(apart(), 2);
}

/// Beside the UI, as in the window.
class PlateOnItsWay : public PlateSwitch {
  protected:
    PlateOnItsWay() { begins.exact = false; }
    void SetUp() override {
        PlateSwitch::SetUp();
        if (IsSkipped()) return;
        ASSERT_TRUE(wait_until([&] { return editor().preview.ready() && reference().video() != nullptr; },
                               [&] { ui().frame(0.02); }));
        ASSERT_TRUE(wait_until([&] { return !editor().preview.loading(); }, [&] { ui().frame(0.02); }));
    }
};

TEST_F(PlateOnItsWay, IsToldAndASecondClickDoesNotTakeItAway) {
    layout("Compare");
    ui().frame().frame();
    HeldJobs held(editor().jobs);
    ui().click("Workspace/Reference/Plate").frame();
    ASSERT_TRUE(scene().plate.use);
    EXPECT_TRUE(reference().look().plate_progress());
    EXPECT_NE(ui().dump().find("Making the plate"), std::string::npos) << ui().dump();
    EXPECT_TRUE(ui().is("Workspace/Reference/Plate", ui::Is::disabled));
    ui().key('P').frame();
    EXPECT_TRUE(scene().plate.use) << "a second press does nothing";
    held.let_go();
    ASSERT_TRUE(wait_until([&] { return organ().starts_with("frame at "); }, [&] { ui().frame(0.02); }));
    ui().frame();
    EXPECT_FALSE(reference().look().plate_progress());
    EXPECT_EQ(ui().dump().find("Making the plate"), std::string::npos);
    ui().key('P').frame();
    EXPECT_FALSE(scene().plate.use);
}

TEST_F(PlateOnItsWay, IsCancelledAndTheOrganIsStillThere) {
    layout("Compare");
    ui().frame().frame();
    const std::string former = organ();
    HeldJobs held(editor().jobs);
    ui().click("Workspace/Reference/Plate").frame();
    ASSERT_TRUE(reference().look().plate_progress());
    ui().click("Workspace/Reference/Cancel Making the plate").frame();
    EXPECT_FALSE(scene().plate.use);
    EXPECT_FALSE(editor().preview.loading()) << "the organ that is shown is not loaded again";
    EXPECT_EQ(organ(), former);
    EXPECT_TRUE(editor().preview.organ_faults().empty());
    EXPECT_EQ(ui().dump().find("Making the plate"), std::string::npos);
}

TEST_F(PlateSwitch, IsByTheReferenceToo) {
    layout("Compare");
    ui().click("Workspace/Reference/Plate").frame();
    EXPECT_TRUE(scene().plate.use);
    EXPECT_TRUE(ui().is("Workspace/Reference/Plate", ui::Is::checked));
    ui().click("Workspace/Reference/Plate").frame();
    EXPECT_FALSE(scene().plate.use);
}

TEST_F(PlateSwitch, MovesWithTheScenesCamera) {
    editor().commands.run("view.plate");
    ui().frame();
    const Image before = picture(0);
    const glm::dvec3 by(15, -10, 20), eye = editor().preview.preview()->camera().eye;
    const auto middle = [&] {  // of the surface
        glm::vec3 sum(0);
        const auto& places = editor().preview.preview()->organ().positions;
        for (const glm::vec3& place : places) sum += place;
        return sum / static_cast<float>(places.size());
    };
    const glm::vec3 place = middle();
    editor().document.change("Eye", [&](document::Content& c) { c.scene.camera.eye += by; });
    ui().frame();
    EXPECT_TRUE(editor().preview.organ_faults().empty());
    EXPECT_LT(glm::distance(editor().preview.preview()->camera().eye, eye + by), 1e-9) << "it is seen from there";
    EXPECT_GT(glm::distance(middle(), place), 1) << "the plate is another one, before that camera";
    EXPECT_LE(differing(before, picture(0), 1), before.pixels.size() / 4 / 1000) << "the picture is what it was";
}

TEST_F(PlateSwitch, InANarrowViewUnderlayAndToolLieWhereThePlateIs) {
    start({620, 1100});
    open_sample();
    layout("Tune");
    const std::string underlay = "Workspace/View/Reference picture";
    editor().looking.underlay = true;
    ui().frame().frame();
    const ui::Rect view = ui().rect("Workspace/View/Preview");
    ASSERT_LT(view.w, view.h * 640 / 512) << "narrower than the video";
    EXPECT_NEAR(ui().rect(underlay).h, view.h, 1) << "an organ is seen at the camera's angle";
    editor().commands.run("view.plate");
    ui().frame().frame();
    const ui::Rect under = ui().rect(underlay);
    EXPECT_NEAR(under.w, view.w, 1.5) << "the plate is shown whole";
    EXPECT_NEAR(under.h, view.w * 512 / 640, 1.5);
    EXPECT_NEAR(under.y + under.h / 2, view.y + view.h / 2, 1.5);
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
    editor().looking.endoscope = false;
    editor().looking.camera.eye += glm::dvec3(20, 0, 0);
    ui().frame().frame();
    EXPECT_NEAR(ui().rect(underlay).h, view.h, 1) << "from elsewhere the plate is a surface as any other";
}

TEST_F(PlateSwitch, GoesWithTheReference) {
    editor().commands.run("view.plate");
    ui().frame();
    editor().commands.run("reference.remove");
    ui().frame();
    EXPECT_FALSE(scene().plate.use);
    EXPECT_TRUE(editor().preview.organ_faults().empty());
    EXPECT_FALSE(ui().exists("Workspace/View/Plate"));
    EXPECT_FALSE(editor().commands.enabled(editor().commands.index_of("view.plate")));
    editor().document.undo();
    ui().frame();
    EXPECT_TRUE(scene().plate.use);
    EXPECT_TRUE(organ().starts_with("frame at "));
}

TEST_F(PlateSwitch, WhatKeepsItFromBeingShownIsToldWithTheWayOut) {
    write_picture(folder() / "video.png", tissue_picture({96, 64}));
    reference().choose(folder() / "video.png");
    ui().frame().frame();
    editor().commands.run("view.plate");
    ui().frame();
    const Image shown = picture(0);
    fs::remove(folder() / "video.png");
    editor().document.change("Flat", [](document::Content& c) { c.scene.plate.depth = PlateDepth::flat; });
    ui().frame();
    ASSERT_EQ(editor().preview.organ_faults().size(), 1U);
    EXPECT_NE(editor().preview.organ_faults()[0].text().find("video.png"), std::string::npos);
    EXPECT_EQ(differing(shown, picture(0)), 0U) << "what was shown stays";
    ui().frame();
    ui().click("**/Organ fault/Show the organ").frame();
    EXPECT_FALSE(scene().plate.use);
    EXPECT_TRUE(editor().preview.organ_faults().empty());
}

}  // namespace
}  // namespace lapfx::test
