// Regions that are compared: drawn over both pictures, dragged, counted, and plotted over time.
#include "app/base/layouts.h"
#include "app/clips/clip_shelf.h"
#include "app/reference/reference.h"
#include "app/tuning/snapshots.h"
#include "editor/support/editor_test.h"
#include "support/endoscope.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

class Regions : public SampleTest {
  protected:
    Regions() { begins.layout = "Compare", begins.time = 4; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        ui().click("Workspace/Reference/Scopes").frame();
        ui().click("**/Scopes shown/Regions").frame();
    }
    app::Reference& reference() { return editor().reference(); }
    app::ReferenceComparison& comparison() { return reference().comparison(); }
    const app::ComparedRegions& regions() { return comparison().regions(); }
    const std::vector<ComparedRegion>& all() { return editor().document.scene().reference.regions; }
    void add() { ui().click("**/Add region").frame().frame(); }
    std::size_t samples(std::size_t side) {
        std::vector<double> frames, values;
        regions().curve(side, 0, app::RegionFigure::veil, frames, values);
        return frames.size();
    }
    static std::string over(const std::string& side, const std::string& handle) {
        return "**/Comparison/" + side + '/' + handle;
    }
    void drag(const std::string& handle, glm::vec2 way) { ui().drag(handle, way).frame(); }
};

TEST_F(Regions, AreOverBothPicturesAndCountedInBoth) {
    EXPECT_NE(ui().dump().find("No region yet"), std::string::npos);
    add();
    ASSERT_EQ(all().size(), 1U);
    for (const char* side : {"First", "Second"}) EXPECT_TRUE(ui().exists(over(side, "Region 1"))) << side;
    ASSERT_TRUE(regions().counted(0));
    ASSERT_TRUE(regions().counted(1));
    const auto &ours = regions().now(0, 0), &theirs = regions().now(1, 0);
    EXPECT_GT(ours.color.r, ours.color.b) << "tissue";
    EXPECT_GT(theirs.color.r, theirs.color.b);
    EXPECT_GT(match::distance(ours, theirs), 1.0);
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
    editor().document.undo();
    ui().frame();
    EXPECT_TRUE(all().empty());
}

TEST_F(Regions, AreMovedResizedAndRemovedByTheirHandles) {
    add();
    const ComparedRegion before = all()[0];
    const std::size_t steps = editor().document.done();
    drag(over("Second", "Region 1"), {30, 0});
    EXPECT_EQ(editor().document.done(), steps + 1) << "one gesture, one step";
    EXPECT_GT(all()[0].x, before.x + 0.01);
    EXPECT_NEAR(all()[0].y, before.y, 0.005);
    EXPECT_NEAR(all()[0].width, before.width, 1e-9);
    drag(over("First", "Region 1 lower right"), {20, 20});
    EXPECT_GT(all()[0].width, before.width + 0.01);
    EXPECT_GT(all()[0].height, before.height + 0.01);
    add();
    ASSERT_EQ(all().size(), 2U);
    EXPECT_EQ(comparison().scopes_look.region, 1U);
    ui().focus(over("First", "Region 1")).key(ui::Key::del).frame();
    EXPECT_EQ(all().size(), 1U);
    ui().click("**/Remove").frame();
    EXPECT_TRUE(all().empty());
}

TEST_F(Regions, CurvesFillWhileTheTimelineMoves) {
    add();
    for (const double time : {1.0, 2.0, 3.0}) {
        editor().timeline.seek(time);
        ui().frame().frame();
    }
    EXPECT_EQ(samples(0), 4U);
    EXPECT_EQ(samples(1), 4U);
    editor().document.change("Exposure", [](document::Content& c) { c.scene.camera.exposure *= 1.5; });
    ui().frame().frame();
    EXPECT_EQ(samples(0), 1U) << "the preview would look different";
    EXPECT_EQ(samples(1), 4U) << "the video would not";
    ui().click("Workspace/Reference/Compare/Reference").frame().frame();
    EXPECT_TRUE(ui().exists("**/Video/Region 1"));
}

TEST_F(Regions, AShorterVideoHasNoCurveOfTheOneBefore) {
    add();
    for (const double time : {2.0, 6.0}) {
        editor().timeline.seek(time);
        ui().frame().frame();
    }
    ui().click("**/Scopes shown/All").frame();
    write_picture(folder() / "video.png", tissue_picture({96, 64}));
    reference().choose(folder() / "video.png");
    ui().frame().frame();
    ui().click("**/Scopes shown/Regions").frame().frame();
    EXPECT_LE(samples(1), 1U);
}

TEST_F(Regions, AreForgottenAtOnceWhenTheVideoChanges) {
    add();
    editor().timeline.seek(2);
    ui().frame().frame();
    ASSERT_EQ(samples(0), 2U);
    ASSERT_EQ(samples(1), 2U);
    ui().click("**/Scopes shown/All").frame();
    ASSERT_EQ(samples(1), 2U) << "looked away from, they stay";
    write_picture(folder() / "video.png", tissue_picture({96, 64}));
    reference().choose(folder() / "video.png");
    ui().frame().frame();
    EXPECT_EQ(samples(0), 0U) << "its frames were the former video's";
    EXPECT_EQ(samples(1), 0U);
    EXPECT_FALSE(regions().counted(1));
}

TEST_F(Regions, OfASnapshotAreForgottenWhenAnotherIsKeptThere) {
    editor().snapshots().keep(0);
    comparison().put(1, app::side_of(0));
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed *= 2; });
    add();
    for (const double time : {1.0, 2.0}) {
        editor().timeline.seek(time);
        ui().frame().frame();
    }
    ASSERT_EQ(samples(1), 3U);
    editor().snapshots().keep(0);  // the preset as it is now
    ui().frame().frame();
    EXPECT_EQ(samples(1), 1U);
    EXPECT_EQ(samples(0), 3U) << "the preview is what it was";
}

TEST_F(Regions, OfAClipThatPlaysAloneHaveACurveOfTheirOwn) {
    add();
    for (const double time : {1.0, 2.0}) {
        editor().timeline.seek(time);
        ui().frame().frame();
    }
    ASSERT_EQ(samples(0), 3U);
    editor().clips().play_alone(0);
    ui().frame().frame();
    EXPECT_EQ(samples(0), 1U);
    EXPECT_EQ(samples(1), 3U) << "the video has no clips";
    editor().clips().play_alone({});
    ui().frame().frame();
    EXPECT_EQ(samples(0), 1U);
}

TEST_F(Regions, OfThePreviewHaveNoCurveOutsideOfTheVideo) {
    add();
    ASSERT_EQ(samples(0), 1U);
    editor().document.change("Offset", [](document::Content& c) { c.scene.reference.offset = -2; });
    editor().timeline.seek(1);
    ui().frame().frame();
    EXPECT_EQ(samples(0), 0U) << "before the video's start";
    EXPECT_TRUE(regions().counted(0)) << "the figures of now are there all the same";
    editor().timeline.seek(2);
    ui().frame().frame();
    EXPECT_EQ(samples(0), 1U) << "its first frame";
    editor().document.change("Offset", [](document::Content& c) { c.scene.reference.offset = 5; });
    editor().timeline.seek(3);
    ui().frame().frame();
    EXPECT_EQ(samples(0), 0U) << "at its end";
    editor().timeline.seek(2.9);
    ui().frame().frame();
    EXPECT_EQ(samples(0), 1U) << "its last frame";
}

TEST_F(Regions, OfTheSmallestSizeAreAllowed) {
    add();
    drag(over("First", "Region 1 lower right"), {-400, -400});
    EXPECT_NEAR(all()[0].width, 0.01, 1e-9);
    EXPECT_TRUE(editor().document.scene_faults().empty());
}

TEST_F(Regions, ComeToRest) {
    add();
    ui().settle().frame(2).settle();
    EXPECT_GT(ui().output().wake_at, ui().time + 60);
    ui().frame(1);
    EXPECT_FALSE(ui().output().changed);
}

TEST_F(Regions, OnlyEightFit) {
    for (std::size_t i = 0; i < most_compared_regions; ++i) add();
    EXPECT_EQ(all().size(), most_compared_regions);
    EXPECT_FALSE(ui().exists("**/Add region"));
}

class ProposedLook : public SampleTest {
  protected:
    ProposedLook() { begins.layout = "Compare"; }
    double vignette() { return editor().document.scene().camera.vignette; }
    /// The reference is this picture, or these as a video of 25 frames a second.
    void show(const std::vector<Image>& frames) {
        write_video(folder(), frames);
        editor().reference().choose(folder() / "frame_000.png");
        editor().document.change("Vignette", [](document::Content& c) { c.scene.camera.vignette = 0; });
        ui().frame().frame();
    }
    void propose() {
        editor().reference().look().propose();
        ui().frame().frame();
    }
    void take() {
        propose();
        editor().reference().look().take();
        ui().frame();
    }
    static Image round_view() { return behind_round_view(tissue_picture({320, 256}), {160, 128}, 120); }
};

TEST_F(ProposedLook, IsOneUndoStepAndSaysWhatItFound) {
    ui().click("Workspace/Reference/Scopes").frame();
    editor().document.change("Exposure", [](document::Content& c) { c.scene.camera.exposure = 12; });
    ui().frame().frame();
    const auto apart = [&] {
        const auto& [ours, theirs] = editor().reference().comparison().scopes();
        return std::abs(ours.mean(app::Channel::luma) - theirs.mean(app::Channel::luma));
    };
    const double before = apart();
    const std::size_t steps = editor().document.done();
    editor().commands.run("reference.propose_look");
    ui().frame().frame();
    EXPECT_EQ(editor().document.done(), steps) << "nothing changes until it is taken";
    EXPECT_EQ(editor().document.scene().camera.exposure, 12);
    EXPECT_TRUE(editor().reference().look().proposed());
    ASSERT_FALSE(editor().reference().look().notes().empty());
    EXPECT_NE(ui().dump().find(editor().reference().look().notes()[0]), std::string::npos);
    EXPECT_NE(ui().dump().find("Exposure 12 to "), std::string::npos) << ui().dump();
    ui().click("Workspace/Reference/Take look").frame().frame();
    ASSERT_EQ(editor().document.done(), steps + 1);
    EXPECT_EQ(editor().document.steps().back().name, "Propose look");
    EXPECT_FALSE(editor().reference().look().proposed());
    EXPECT_TRUE(editor().reference().look().notes().empty()) << "what is done is in the history";
    ui().frame().frame();
    EXPECT_LT(apart(), 0.5 * before) << "as bright as the video";
    editor().document.undo();
    ui().frame();
    EXPECT_EQ(editor().document.scene().camera.exposure, 12);
}

TEST_F(ProposedLook, IsLeftAndGoesWithItsReference) {
    const document::Content before = editor().document.content();
    propose();
    ASSERT_TRUE(editor().reference().look().proposed());
    ui().click("Workspace/Reference/Leave look").frame();
    EXPECT_FALSE(editor().reference().look().proposed());
    EXPECT_TRUE(editor().reference().look().notes().empty());
    EXPECT_TRUE(document::same(before, editor().document.content()));
    EXPECT_FALSE(ui().exists("Workspace/Reference/Take look"));
    propose();
    show({round_view()});
    EXPECT_FALSE(editor().reference().look().proposed());
    EXPECT_TRUE(editor().reference().look().notes().empty());
}

TEST_F(ProposedLook, IsLeftOnceWhatItWasMadeForIsAnother) {
    const auto after = [&](const char* name, const std::function<void(document::Content&)>& change) {
        propose();
        EXPECT_TRUE(editor().reference().look().proposed()) << name;
        editor().document.change(name, change);
        ui().frame().frame();
        return editor().reference().look().proposed();
    };
    EXPECT_TRUE(after("Event", [](document::Content& c) { c.scene.events.clear(); })) << "it says nothing of them";
    EXPECT_FALSE(after("Exposure", [](document::Content& c) { c.scene.camera.exposure *= 1.5; }));
    EXPECT_NE(ui().dump().find("What the look was proposed for has changed since"), std::string::npos);
    EXPECT_FALSE(ui().exists("Workspace/Reference/Take look"));
    EXPECT_FALSE(after("Blood", [](document::Content& c) { c.preset.bleeding.color_thin.r *= 0.5; }));
    EXPECT_FALSE(after("Camera", [](document::Content& c) { c.scene.camera.eye *= 1.1; }));
    EXPECT_FALSE(after("Aspect", [](document::Content& c) { c.scene.reference.aspect = 2; }));
    EXPECT_FALSE(after("Plate", [](document::Content& c) { c.scene.plate.use = true; }));
    editor().document.undo();
    ui().frame().frame();
    propose();
    const document::Content before = editor().document.content();
    editor().document.change("Plate", [](document::Content& c) { c.scene.plate.use = true; });
    editor().reference().look().take();  // in the same frame
    EXPECT_EQ(editor().document.scene().camera.exposure, before.scene.camera.exposure);
    EXPECT_EQ(editor().document.steps().back().name, "Plate");
}

TEST_F(ProposedLook, IsLeftWithAnotherSceneOfTheSameReference) {
    propose();
    ASSERT_TRUE(editor().reference().look().proposed());
    open({(shipped() / "samples/lagb.scene.json").string()});
    ui().frame().frame();
    EXPECT_FALSE(editor().reference().look().proposed());
    EXPECT_TRUE(editor().reference().look().notes().empty());
}

/// The organ fills a small part of the frame, and all around is the dark cavity.
TEST_F(ProposedLook, IsOfTheOrganAloneHoweverSmallItIs) {
    show({tissue_picture({320, 256})});
    const auto exposure_from = [&](double distance) {
        editor().document.change("Far", [&](document::Content& c) {
            SceneCamera& camera = c.scene.camera;
            camera.eye = camera.target + distance * (camera.eye - camera.target);
            c.scene.light.focus_distance = std::min(2000.0, 100 * distance);  // as bright from there
            camera.exposure = 1.9;
        });
        ui().frame().frame();
        take();
        return editor().document.scene().camera.exposure;
    };
    const double near = exposure_from(1), far = exposure_from(4);
    EXPECT_NEAR(far / near, 1, 0.5) << near << ' ' << far;
}

TEST_F(ProposedLook, IsOfTheFrameOfThisTimeAlsoWhileThePanelIsHidden) {
    show({tissue_picture({320, 256}), round_view()});
    layout("Tune");
    ASSERT_FALSE(editor().layouts().seen("Reference"));
    editor().timeline.seek(0.05);
    ui().frame();
    ASSERT_EQ(editor().reference().frame(), 1);
    ASSERT_EQ(editor().reference().shown_frame(), 0) << "nobody has looked at the other one";
    take();
    EXPECT_EQ(editor().document.steps().back().name, "Propose look");
    EXPECT_EQ(vignette(), 1) << "the second frame is round";
}

TEST_F(ProposedLook, IsOfTheShapeThatTheVideoIsShownWith) {
    const Image view = round_view();
    cv::Mat4b pixels(view.height, view.width,
                     reinterpret_cast<cv::Vec4b*>(const_cast<std::uint8_t*>(view.pixels.data()))),
        squeezed;
    cv::resize(pixels, squeezed, {180, 256}, 0, 0, cv::INTER_AREA);
    Image stored{.width = 180, .height = 256, .pixels = {}, .name = ""};
    stored.pixels.assign(squeezed.data, squeezed.data + 4 * squeezed.total());
    show({stored});
    take();
    EXPECT_EQ(vignette(), 0) << "as it is stored it is no circle";
    editor().document.change("Aspect", [](document::Content& c) { c.scene.reference.aspect = 1.25; });
    take();
    EXPECT_EQ(vignette(), 1);
}

TEST_F(ProposedLook, IsNotOfThePlateWhichIsTheVideoItself) {
    editor().commands.run("view.plate");
    ui().frame().frame();
    const std::size_t steps = editor().document.done();
    ui().click("Workspace/Reference/Propose look").frame().frame();
    EXPECT_FALSE(editor().reference().look().proposed());
    EXPECT_EQ(editor().document.done(), steps);
    EXPECT_NE(ui().dump().find("Turn Plate off"), std::string::npos) << "the reason is told" << ui().dump();
    editor().commands.run("view.plate");
    ui().frame().frame();
    propose();
    EXPECT_TRUE(editor().reference().look().proposed());
}

}  // namespace
}  // namespace lapfx::test
