// The view panel: looking around, working with tools, overlays and the parameters that they belong to.
#include <opencv2/imgcodecs.hpp>

#include "app/base/layouts.h"
#include "app/files/exports.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

constexpr const char* preview = "Workspace/View/Preview";

class ViewPanelTest : public SampleTest {
  protected:
    ViewPanelTest() { begins.window = {1000, 640}; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        ASSERT_TRUE(editor().preview.ready());
    }
    /// The place on the organ at a fraction of the view.
    glm::dvec3 place_at(glm::vec2 fraction) {
        const glm::ivec2 size = editor().preview.size();
        const auto hit = editor().preview.preview()->pick(glm::dvec2(fraction) * glm::dvec2(size), size);
        if (!hit) throw std::runtime_error("no organ there");
        return hit->position;
    }
    const std::vector<ToolContact>& events() { return editor().document.scene().events; }
    void hold(int frames) {
        for (int i = 0; i < frames; ++i) ui().frame();
    }
};

/// With the whole organ: a camera that stands farther away sees what the scene's own does not.
class WholeViewTest : public ViewPanelTest {
  protected:
    WholeViewTest() { whole_sample = true; }
};

TEST_F(ViewPanelTest, DraggingTurnsPansAndZooms) {
    editor().commands.run("view.endoscope");
    ui().frame();
    const SceneCamera before = editor().looking.camera;
    ui().drag(preview, {60, 0});
    SceneCamera turned = editor().looking.camera;
    EXPECT_EQ(turned.target, before.target);
    EXPECT_NEAR(glm::distance(turned.eye, turned.target), glm::distance(before.eye, before.target), 1e-6);
    EXPECT_GT(glm::distance(turned.eye, before.eye), 5.0);
    ui().drag(preview, {60, 0}, ui::Mods::shift);
    EXPECT_GT(glm::distance(editor().looking.camera.target, turned.target), 1.0) << "Shift pans";
    const SceneCamera panned = editor().looking.camera;
    ui().wheel(preview, {0, 2});
    EXPECT_LT(glm::distance(editor().looking.camera.eye, editor().looking.camera.target),
              0.9 * glm::distance(panned.eye, panned.target));
    EXPECT_FALSE(editor().document.can_undo()) << "looking is no edit";
}

TEST_F(ViewPanelTest, LookingAroundBeginsWithWhatTheEndoscopeSees) {
    const SceneCamera scene = editor().document.scene().camera;
    editor().looking.camera.eye = {500, 0, 0};  // of an earlier look
    ui().press(preview).drag_by({60, 20});
    EXPECT_FALSE(editor().looking.endoscope);
    const SceneCamera& free = editor().looking.camera;
    EXPECT_EQ(free.target, scene.target);
    EXPECT_NEAR(glm::distance(free.eye, free.target), glm::distance(scene.eye, scene.target), 1e-6);
    EXPECT_GT(glm::distance(free.eye, scene.eye), 5.0) << "it turns at once";
    const std::string told = "Workspace/View/Beside the pointer";
    EXPECT_EQ(ui().text(told), "You look around freely. Key E goes back to the endoscope");
    const ui::Rect line = ui().rect(told);
    EXPECT_LT(std::abs(line.center().y - ui().ui().pointer().y), 50.0F) << "not in a far corner";
    EXPECT_LT(line.x, ui().ui().pointer().x + 50);
    EXPECT_GT(line.right(), ui().ui().pointer().x);
    ui().release().key('E');
    EXPECT_TRUE(editor().looking.endoscope);
    EXPECT_EQ(editor().shot().camera.eye, scene.eye) << "the endoscope has not moved";
    EXPECT_EQ(editor().toasts.size(), 0U);
    ui().frame(10).frame();
    EXPECT_FALSE(ui().exists(told));
    ui().wheel(preview, {0, 2});
    EXPECT_FALSE(editor().looking.endoscope) << "the wheel looks around, too";
}

TEST_F(ViewPanelTest, WithAToolInTheHandTheEndoscopeStaysAndSaysHowToLookAround) {
    ui().key('1').wheel(preview, {0, 2});
    EXPECT_TRUE(editor().looking.endoscope);
    EXPECT_EQ(ui().text("Workspace/View/Beside the pointer"),
              "The tool works in the endoscope's view. Key 0 looks around");
    ui().key('0').drag(preview, {60, 0});
    EXPECT_FALSE(editor().looking.endoscope);
}

TEST_F(ViewPanelTest, TheKeyboardLooksAround) {
    ui().focus(preview);
    ui().key('E');
    ASSERT_FALSE(editor().looking.endoscope);
    const SceneCamera before = editor().looking.camera;
    ui().key(ui::Key::left);
    EXPECT_GT(glm::distance(editor().looking.camera.eye, before.eye), 1.0);
    ui().key(ui::Key::home);
    const SceneCamera framed = editor().looking.camera;
    EXPECT_NE(framed.target, before.target);
    ui().key(ui::key_of('='));
    EXPECT_LT(glm::distance(editor().looking.camera.eye, framed.target), glm::distance(framed.eye, framed.target));
    ui().key(ui::Key::space);
    EXPECT_TRUE(editor().timeline.playing());
}

TEST_F(ViewPanelTest, AToolHeldOnTheOrganBecomesAnEvent) {
    const Image clean = picture(10);
    const std::size_t before = events().size();
    const glm::dvec3 place = place_at({0.6F, 0.45F});
    ui().key('2');
    ASSERT_EQ(editor().tool.action, ToolAction::cut);
    ui().press(preview, {0.6F, 0.45F});
    EXPECT_TRUE(editor().hold.on());
    EXPECT_TRUE(editor().timeline.playing());
    hold(30);
    EXPECT_EQ(events().size(), before) << "nothing is recorded yet";
    ui().release();
    EXPECT_FALSE(editor().timeline.playing()) << "it stood before";
    ASSERT_EQ(events().size(), before + 1);
    const ToolContact event = events().back();
    EXPECT_EQ(event.action, ToolAction::cut);
    EXPECT_NEAR(event.time, 10, 1e-3);
    EXPECT_NEAR(event.duration, 0.5, 0.06);
    EXPECT_LT(glm::distance(event.position, place), 0.5);
    EXPECT_EQ(editor().document.steps().back().name, "Cut");
    EXPECT_GT(differing(clean, picture(11.5)), 50U);
    editor().document.undo();
    EXPECT_EQ(events().size(), before);
    EXPECT_EQ(differing(clean, picture(10), 0), 0U) << "undone to the pixel";
}

TEST_F(ViewPanelTest, AClipIsSetWhereTheToolIsPressedAndUndone) {
    const Image clean = picture(10);
    const std::size_t before = events().size();
    const glm::dvec3 place = place_at({0.6F, 0.45F});
    ui().key('7');
    ASSERT_EQ(editor().tool.action, ToolAction::clip);
    EXPECT_EQ(ui().value("**/View/Tool"), static_cast<double>(tool_action_count)) << "the last in the list of tools";
    EXPECT_FALSE(ui().exists("**/Power")) << "it has none";
    ui().press(preview, {0.6F, 0.45F});
    hold(8);
    ui().release();
    ASSERT_EQ(events().size(), before + 1);
    EXPECT_EQ(events().back().action, ToolAction::clip);
    EXPECT_LT(glm::distance(events().back().position, place), 0.5);
    EXPECT_EQ(editor().document.steps().back().name, "Clip");
    ui().frame();
    EXPECT_TRUE(ui().exists("**/Clip 1")) << "on the timeline";
    EXPECT_GT(differing(clean, picture(10)), 20U);
    editor().document.undo();
    EXPECT_EQ(events().size(), before);
    EXPECT_EQ(differing(clean, picture(10), 0), 0U) << "undone to the pixel";
}

TEST_F(ViewPanelTest, ATrailFollowsThePointerAndTheSceneGetsLonger) {
    editor().timeline.seek(11.9);
    ui().frame();
    ui().key('1');
    const std::size_t before = events().size();
    ui().press(preview, {0.5F, 0.5F});
    for (int i = 0; i < 8; ++i) ui().drag_by({5, 0});
    ui().release();
    ASSERT_GT(events().size(), before);
    EXPECT_GT(glm::distance(events()[before].position, events().back().to), 2.0);
    EXPECT_GT(editor().timeline.duration(), 12.0);
    EXPECT_GE(editor().timeline.duration(), events().back().end());
    editor().document.undo();
    EXPECT_EQ(events().size(), before);
    EXPECT_EQ(editor().timeline.duration(), 12.0) << "one step";
}

TEST_F(ViewPanelTest, EscWhileHeldGivesEverythingBack) {
    const Image before = picture(5);
    ui().key('2');
    const std::size_t count = events().size();
    ui().press(preview, {0.6F, 0.45F});
    hold(20);
    ui().key(ui::Key::escape);
    ui().release();
    EXPECT_FALSE(editor().hold.on());
    EXPECT_EQ(events().size(), count);
    EXPECT_FALSE(editor().document.can_undo());
    EXPECT_EQ(editor().timeline.time, 5);
    EXPECT_EQ(differing(before, picture(5), 0), 0U);
}

TEST_F(ViewPanelTest, EnterWorksInTheMiddleForHalfASecond) {
    editor().timeline.seek(5);
    ui().focus(preview);
    ui().key('2');
    const std::size_t count = events().size();
    const glm::dvec3 middle = place_at({0.5F, 0.5F});
    ui().key(ui::Key::enter);
    hold(40);
    ASSERT_EQ(events().size(), count + 1);
    EXPECT_NEAR(events().back().duration, 0.5, 0.02);
    EXPECT_LT(glm::distance(events().back().position, middle), 0.5);
    EXPECT_FALSE(editor().timeline.playing());
}

TEST_F(ViewPanelTest, TheBandOfVesselsIsTunedOverItsOverlay) {
    ui().key('V');
    EXPECT_EQ(editor().looking.overlay, Overlay::vessels);
    ui().frame().frame();
    const Image before = picture(0);
    const double low = editor().document.preset().vessels.vessel_low;
    ui().drag("**/Vessel low", {-40, 0});
    EXPECT_LT(editor().document.preset().vessels.vessel_low, low);
    EXPECT_EQ(editor().document.steps().size(), 1U);
    EXPECT_GT(differing(before, picture(0)), 100U) << "more counts as vessel";
    editor().document.undo();
    EXPECT_EQ(editor().document.preset().vessels.vessel_low, low);
    ui().key('T');
    ui().frame();
    EXPECT_TRUE(ui().exists("**/Fat low"));
    ui().key('T');
    ui().frame();
    EXPECT_FALSE(ui().exists("**/View/Fat low"));
}

TEST_F(ViewPanelTest, ThisViewBecomesTheEndoscope) {
    ui().key('E');
    ui().drag(preview, {80, 0});
    const SceneCamera free = editor().looking.camera;
    const double vignette = editor().document.scene().camera.vignette;
    EXPECT_TRUE(editor().commands.run("view.use_view"));
    EXPECT_EQ(editor().document.scene().camera.eye, free.eye);
    EXPECT_EQ(editor().document.scene().camera.vignette, vignette);
    EXPECT_TRUE(editor().looking.endoscope);
    EXPECT_EQ(editor().document.steps().size(), 1U);
}

double mean_luma(const Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
        sum += 0.2126 * image.pixels[i] + 0.7152 * image.pixels[i + 1] + 0.0722 * image.pixels[i + 2];
    return sum / static_cast<double>(image.pixels.size() / 4);
}

TEST_F(WholeViewTest, TheLampComesAlongWithTheEndoscope) {
    editor().document.change("No round picture", [](document::Content& c) { c.scene.camera.vignette = 0; });
    const double focus = editor().document.scene().light.focus_distance;
    for (const double nearer : {0.3, 0.6, 1.5}) {
        editor().looking.camera = editor().document.scene().camera;
        SceneCamera& free = editor().looking.camera;
        free.eye = free.target + nearer * (free.eye - free.target);
        editor().looking.endoscope = false;
        const double seen = mean_luma(picture(0));
        editor().commands.run("view.use_view");
        EXPECT_NEAR(editor().document.scene().light.focus_distance, nearer * focus, 1e-9);
        EXPECT_NEAR(mean_luma(picture(0)), seen, 0.08 * seen) << nearer << ", but for what the lamp does not light";
        editor().document.undo();
        EXPECT_EQ(editor().document.scene().light.focus_distance, focus) << "in the same step";
    }
}

TEST_F(ViewPanelTest, PanelsGoOnWhileTheSceneIsSlow) {
    int asked = 0;
    clock = [&] { return 0.5 * ++asked; };  // every picture of the scene takes half a second
    start({1440, 900}, false);
    open_sample();
    editor().jobs.finish();
    ui().frame().frame();
    editor().jobs.finish();
    ui().frame().frame();
    editor().timeline.speed = 1;
    ui().press("**/Bleeding/Speed");
    const int before = asked;
    double last = editor().document.preset().bleeding.speed;
    int shown = 0;
    for (int i = 0; i < 30; ++i) {
        ui().drag_by({4, 0});
        const double now = editor().document.preset().bleeding.speed;
        EXPECT_EQ(ui().value("**/Bleeding/Speed"), now) << "the row shows what was just dragged";
        shown += now != last ? 1 : 0;
        last = now;
    }
    EXPECT_GE(shown, 25);
    EXPECT_LE(asked - before, 2 * 4) << "of 120 frames the scene had a turn every second";
    EXPECT_LT(editor().whole_at(), 1e9) << "what is seen meanwhile has fewer pixels";
    ui().release();
    editor().timeline.speed = 0;
    editor().timeline.seek(6);
    ui().frame().frame(1).frame(1);
    // Frames of its clips are being decoded.
    EXPECT_TRUE(wait_until([&] { return !editor().preview.late(); }, [&] { ui().frame(); }));
    EXPECT_GT(editor().whole_at(), 1e9);
    const Image whole = editor().preview.read();
    EXPECT_EQ(differing(whole, picture(6), 0), 0U);
    EXPECT_EQ(glm::ivec2(whole.width, whole.height), editor().preview.size()) << "of the view's own size";
    clock = {};
}

TEST_F(ViewPanelTest, AnOrganThatIsGoneIsToldInPlaceWithTheWayOut) {
    editor().document.change("Organ", [](document::Content& c) { c.scene.organ.file = "gone.glb"; });
    ui().frame().frame();
    ASSERT_TRUE(ui().exists("**/Organ fault"));
    EXPECT_TRUE(ui().exists("**/Choose another..."));
    ui().click("**/Organ fault/Undo");
    ui().frame().frame();
    EXPECT_FALSE(ui().exists("**/Organ fault"));
    EXPECT_EQ(editor().document.scene().organ.file, "lagb.glb");
}

TEST_F(ViewPanelTest, HalfResolutionIsAQuarterOfThePixelsStretchedSmoothly) {
    const Image whole = picture(6);
    const ui::Rect place = ui().rect(preview);
    ASSERT_EQ(glm::vec2(whole.width, whole.height), glm::vec2(place.w, place.h)) << "pixel for pixel";
    const auto exported = [&](const char* name) {
        const std::filesystem::path file = folder() / name;
        editor().commands.run("export.picture");
        ui().frame().frame();
        editor().exports().form.file() = file.string();
        editor().exports().form.size = 5;
        ui().frame();
        ui().click("New export/Export");
        EXPECT_TRUE(wait_until([&] { return !editor().exports().running(); }, [&] { ui().frame(); }));
        ui().frame().frame();
        return cv::imread(file.string());
    };
    const cv::Mat before = exported("whole.png");
    editor().commands.run("view.half_resolution");
    const Image half = picture(6);
    EXPECT_EQ(half.width, (whole.width + 1) / 2);
    EXPECT_EQ(half.height, (whole.height + 1) / 2);
    const ui::Rect now = ui().rect(preview);
    EXPECT_EQ(glm::vec2(now.w, now.h), glm::vec2(place.w, place.h));
    // The draw list has the picture over the whole place, linearly filtered.
    const ui::DrawList& list = *ui().output().list;
    int found = 0;
    for (const ui::Batch& batch : list.batches)
        for (std::uint32_t n = batch.first; n < batch.first + batch.count; ++n) {
            const ui::Instance& i = list.instances[n];
            if (batch.images[0] != editor().preview.picture() || i.kind != ui::InstanceKind::image) continue;
            EXPECT_EQ(glm::vec4(i.x, i.y, i.w, i.h), glm::vec4(now.x, now.y, now.w, now.h));
            EXPECT_EQ(i.border, 0) << "not by nearest pixels";
            ++found;
        }
    EXPECT_EQ(found, 1);
    // It is the same picture: the mean of four pixels is about equal to the one that replaces them.
    double sum = 0, mirrored = 0;
    for (int y = 0; y < whole.height / 2; ++y)
        for (int x = 0; x < whole.width / 2; ++x) {
            const auto at = [&](const Image& image, int u, int v) {
                const std::uint8_t* p = image.pixels.data() + 4 * (v * image.width + u);
                return glm::dvec3(p[0], p[1], p[2]);
            };
            const glm::dvec3 mean = (at(whole, 2 * x, 2 * y) + at(whole, 2 * x + 1, 2 * y) +
                                     at(whole, 2 * x, 2 * y + 1) + at(whole, 2 * x + 1, 2 * y + 1)) /
                                    4.0;
            sum += glm::distance(mean, at(half, x, y));
            mirrored += glm::distance(mean, at(half, half.width - 1 - x, y));
        }
    EXPECT_LT(sum, 0.3 * mirrored);
    const cv::Mat after = exported("half.png");
    ASSERT_FALSE(before.empty());
    ASSERT_EQ(before.size(), after.size());
    EXPECT_EQ(cv::norm(before, after, cv::NORM_INF), 0) << "what is exported does not change";
}

TEST_F(ViewPanelTest, TheOrganIsColouredLive) {
    layout("Stage");
    const Image white = picture(0);
    const auto share = [](const Image& image) {
        double red = 1, green = 1;
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) red += image.pixels[i], green += image.pixels[i + 1];
        return red / green;
    };
    const std::uint64_t organ = editor().preview.organ_version();
    ui().click("**/Organ/Colour/Colour").frame();
    ui().click("**/Hex", {.clicks = 2}).key('A', ui::Mods::command).type("#c03030").key(ui::Key::enter).frame();
    EXPECT_NEAR(editor().document.scene().organ.color.x, 0xc0 / 255.0, 1e-9);
    EXPECT_EQ(editor().document.steps().back().name, "Organ: Colour");
    EXPECT_GT(share(picture(0)), 1.5 * share(white));
    EXPECT_EQ(editor().preview.organ_version(), organ) << "nothing is loaded for it";
    editor().document.undo();
    EXPECT_EQ(differing(white, picture(0), 0), 0U);
}

TEST_F(ViewPanelTest, HomeActsOnThePictureThatIsLookedAt) {
    layout("Compare");
    editor().reference().choose_sample();
    ui().frame().frame();
    ASSERT_FALSE(editor().layouts().seen("View"));
    editor().reference().comparison().state.view.fitted = false;
    editor().reference().comparison().state.view.zoom = 3;
    ui().key(ui::Key::home).frame();
    EXPECT_TRUE(editor().looking.endoscope) << "the view that nobody sees stays as it is";
    EXPECT_TRUE(editor().reference().comparison().state.view.fitted);
    layout("Tune");
    ui().key(ui::Key::home).frame();
    EXPECT_FALSE(editor().looking.endoscope);
}

/// The part of the view's width and height that the organ takes up.
glm::dvec2 filled(app::Editor& editor) {
    const Preview& shown = *editor.preview.preview();
    const SceneCamera& camera = editor.looking.camera;
    const glm::dvec2 size(editor.preview.size());
    const double half = std::tan(glm::radians(camera.field_of_view) / 2);
    glm::dvec2 most(0);
    for (const glm::vec3& p : shown.organ().positions) {
        const glm::dvec3 off = glm::dvec3(p) - camera.eye;  // it looks along -z
        most = glm::max(most, glm::abs(glm::dvec2(off)) / (-off.z * half * glm::dvec2(size.x / size.y, 1)));
    }
    return most;
}

TEST_F(ViewPanelTest, HomeFitsTheOrganToTheView) {
    ui().key(ui::Key::home).frame();
    const glm::dvec2 wide = filled(editor());
    EXPECT_NEAR(std::max(wide.x, wide.y), 0.94, 1e-3) << wide.x << ", " << wide.y;
    layout("Key");  // a view of another shape
    ui().frame().key(ui::Key::home).frame();
    const glm::dvec2 high = filled(editor());
    EXPECT_NEAR(std::max(high.x, high.y), 0.94, 1e-3) << high.x << ", " << high.y;
}

TEST_F(ViewPanelTest, AFreeLookIsWithoutHaze) {
    editor().document.change("Haze", [](document::Content& c) { c.preset.smoke.haze.accumulation = 0.6; });
    const auto without = [&] {
        editor().document.change("Haze", [](document::Content& c) { c.preset.smoke.haze.accumulation = 0; });
        const Image clear = picture(6);
        editor().document.undo();
        return clear;
    };
    const Image endoscope = picture(6);
    EXPECT_GT(differing(endoscope, without()), 1000U) << "what is exported has its haze";
    ui().key(ui::Key::home).frame();
    const Image free = picture(6);
    EXPECT_EQ(differing(free, without(), 0), 0U) << "from far away it would be fog";
    ui().click("**/Haze/header");
    ui().click("**/Haze/Only in the endoscope view").frame();
    EXPECT_TRUE(editor().looking.endoscope);
    EXPECT_EQ(differing(picture(6), endoscope, 0), 0U);
    EXPECT_FALSE(ui().exists("**/Haze/Only in the endoscope view"));
}

TEST_F(ViewPanelTest, ToolsStaySideBySideWhenOneIsChosen) {
    start({1440, 900});
    open_sample();
    ASSERT_TRUE(ui().exists("**/Tool/Cut")) << ui().dump();
    for (const char* const tool : {"Cut", "Coagulate", "Cauterise", "Look around"}) {
        ui().click("**/Tool/" + std::string(tool)).frame().frame();
        EXPECT_TRUE(ui().exists("**/Tool/Look around")) << tool << " folds the tools up just when one changes them";
    }
}

TEST_F(ViewPanelTest, HomeFitsAReferenceWhereThereIsNoOrgan) {
    start();
    layout("Compare");
    editor().reference().choose_sample();
    ui().frame().frame();
    ASSERT_FALSE(editor().preview.ready());
    ASSERT_NE(editor().reference().video(), nullptr);
    editor().reference().comparison().state.view.fitted = false;
    ui().key(ui::Key::home).frame();
    EXPECT_TRUE(editor().reference().comparison().state.view.fitted);
}

}  // namespace
}  // namespace lapfx::test
