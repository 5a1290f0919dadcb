// The Measure panel, driven by the names of the widgets on the screen: the reference is measured, its qualifier, its
// baseline and what is left out are tuned over the picture.
#include <cctype>
#include <fstream>

#include "app/measure/measured_curve.h"
#include "editor/support/held_jobs.h"
#include "editor/support/measure_panel.h"
#include "match/video/measure.h"
#include "output/files.h"
#include "support/clips.h"
#include "unit/match/pictures.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using ui::Key;
using ui::Mods;

TEST_F(MeasurePanelOfKnown, TheFrameThatIsShownIsMeasured) {
    ASSERT_TRUE(bench().ready()) << ui().dump();
    EXPECT_EQ(bench().picture().size, glm::ivec2(160, 128));
    const match::FrameAmounts bloody = bench().amounts();
    EXPECT_TRUE(bloody.measurable());
    EXPECT_GT(bloody.blood.value, 0.02);
    EXPECT_LE(bloody.blood.low, bloody.blood.value);
    EXPECT_GE(bloody.blood.high, bloody.blood.value);
    EXPECT_TRUE(ui().exists(rows + "This frame"));
    go(clear_time);
    EXPECT_LT(bench().amounts().blood.value, 0.3 * bloody.blood.value);
}

TEST_F(MeasurePanelOfKnown, TheOverlaysAreSwitched) {
    const std::size_t marked = yellow_pixels();
    ASSERT_GT(marked, 500U);
    ui().click(panel + "Blood").frame().frame();
    EXPECT_LT(yellow_pixels(), marked / 10);
    ui().click(panel + "Blood").frame().frame();
    EXPECT_EQ(yellow_pixels(), marked);
    EXPECT_EQ(steps(), 0U) << "how one looks at it is no part of the document";
}

TEST_F(MeasurePanel, ItIsMeasuredToTheEnd) {
    EXPECT_TRUE(says("Not measured yet"));
    EXPECT_FALSE(ui().exists(panel + "Amounts"));
    measure_all();
    EXPECT_EQ(measuring().found()->frames.size(), 50U);
    EXPECT_GT(measuring().found()->blood.peak, 0.02);
    EXPECT_FALSE(measuring().stale());
    EXPECT_TRUE(ui().exists(panel + "Amounts")) << "the curves";
    EXPECT_FALSE(says("Not measured yet"));
    EXPECT_FALSE(says("measure again"));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(MeasurePanel, LightAndGainAreShownWhereOneAsksForThem) {
    measure_all();
    const auto seen = [&](const char* name) { return ui().is(panel + "Amounts/" + name, ui::Is::checked); };
    for (const char* const name : {"Blood", "Veil"}) EXPECT_TRUE(seen(name)) << name;
    for (const char* const name : {"Light", "Gain"}) {
        EXPECT_FALSE(seen(name)) << name;
        ui().click(panel + "Amounts/" + name).frame();
        EXPECT_TRUE(seen(name)) << name;
    }
    ui().click(panel + "Amounts", {.at = {0.5F, 0.6F}}).key('C', Mods::command).frame();
    EXPECT_NE(ui().clipboard().text.find("Gain"), std::string::npos);
    EXPECT_TRUE(ui().clipboard().text.find("Light") < ui().clipboard().text.find("Gain")) << ui().clipboard().text;
    app::MeasuredCurve gain;
    gain.set(measuring().frames(), app::gain_curve);
    ASSERT_EQ(gain.values().size(), measuring().frames().size());
    for (const match::FrameAmounts& frame : measuring().frames()) {
        if (!frame.measurable()) continue;
        EXPECT_DOUBLE_EQ(gain.values().value_at(frame.time), 100 * frame.gain.value);
    }
    measuring().start();  // anew
    ui().frame().frame();
    EXPECT_TRUE(seen("Gain")) << "what is looked at stays";
}

TEST_F(MeasurePanel, ACommandMeasuresFromAnyPanel) {
    layout("Tune");
    ui().key('M', Mods::command).frame().frame();
    EXPECT_TRUE(editor().layouts().seen("Measure"));
    EXPECT_NE(measuring().found(), nullptr);
}

TEST_F(MeasurePanel, CancelledItLeavesWhatWasFoundBefore) {
    show_with_threads();
    wait_for([&] { return measuring().found() != nullptr && !measuring().running(); });
    const match::Measurement* const before = measuring().found();
    ui().click(panel + "Measure").frame();
    ASSERT_TRUE(measuring().running()) << "anew";
    EXPECT_FALSE(ui().exists(panel + "Measure")) << "it is one at a time";
    ui().click(panel + "Cancel Measuring").frame();
    EXPECT_FALSE(measuring().running());
    editor().jobs.finish();
    ui().frame().frame();
    EXPECT_EQ(measuring().found(), before);
    EXPECT_TRUE(measuring().faults().empty());
    EXPECT_TRUE(ui().exists(panel + "Continue"));
}

TEST_F(MeasurePanel, AFrameWhoseMeasuringWasCancelledIsMeasuredWhenOneAsks) {
    show_with_threads();
    // What the measuring of the whole video finds is a reason to measure the frame anew.
    wait_for([&] { return measuring().found() != nullptr && !measuring().running(); });
    const auto cancel_at = [&](double time) {
        wait_for([&] { return bench().ready() && !bench().busy() && !bench().stale(); });
        HeldJobs held(editor().jobs);
        editor().timeline.seek(time);
        wait_for([&] { return bench().busy(); });
        for (const auto& job : editor().jobs.running()) job->cancel();  // the list of jobs does the same
        held.let_go();
        editor().jobs.finish();
        ui().frame().frame().frame();
    };
    cancel_at(2);
    EXPECT_FALSE(bench().busy()) << "it is not begun again by itself";
    EXPECT_FALSE(bench().ready()) << "the figures would be of the frame before";
    EXPECT_TRUE(says("Measuring this frame was cancelled."));
    ui().click(panel + "Measure this frame").frame();
    wait_for([&] { return bench().ready(); });
    EXPECT_EQ(bench().frame(), editor().reference().frame());
    EXPECT_FALSE(says("was cancelled"));
    cancel_at(3);
    EXPECT_TRUE(bench().given_up());
    editor().reference().step(1);  // something else is wanted
    wait_for([&] { return bench().ready(); });
    EXPECT_FALSE(bench().given_up());
    editor().reference().let_go();
    wait_for([&] { return bench().ready() && !bench().busy() && bench().frame() == editor().reference().frame(); });
    cancel_at(4);
    EXPECT_TRUE(bench().given_up());
    editor().layouts().bring_to_front("Reference");
    ui().frame().frame();
    editor().layouts().bring_to_front("Measure");
    wait_for([&] { return bench().ready(); });
    EXPECT_EQ(bench().frame(), editor().reference().frame());
}

TEST_F(MeasurePanel, WhatWasFoundIsStaleAfterAChangeUntilThatIsUndone) {
    measure_all();
    ui().click(rows + "Blood/Redness", {.clicks = 2}).type("4").key(Key::enter).frame().frame();
    EXPECT_EQ(measure().blood.redness, 4.0);
    EXPECT_TRUE(measuring().stale());
    EXPECT_TRUE(says("From before the last change: measure again."));
    undo();
    EXPECT_FALSE(measuring().stale());
    EXPECT_FALSE(says("measure again"));
    editor().document.change("Offset", [](document::Content& c) { c.scene.reference.offset += 0.2; });
    ui().frame();
    EXPECT_FALSE(measuring().stale()) << "the video and its measuring are the same";
    editor().reference().choose(write_clip(folder() / "v.avi", 30, {64, 32}, 10));
    ui().frame().frame();
    EXPECT_TRUE(measuring().stale());
    EXPECT_TRUE(says("Of operation.mp4: measure again."));
    open_sample();
    EXPECT_NE(measuring().found(), nullptr);
    editor().forget_document();
    EXPECT_EQ(measuring().found(), nullptr) << "another document";
}

TEST_F(MeasurePanel, BehindADenseVeilNoBloodIsGiven) {
    const cv::Mat clear = match::test::tissue();
    for (int i = 0; i < 8; ++i) {
        const cv::Mat veil(clear.size(), CV_32F, cv::Scalar(i < 2 ? 0.0 : 0.6));
        output::write_png(folder() / ("dense_000" + std::to_string(i) + ".png"),
                          match::test::image_of(match::test::veiled(clear, veil, match::test::light_of({}))));
    }
    editor().reference().choose(folder() / "dense_%04d.png");
    ui().frame().frame();
    editor().reference().hold(6);
    ui().frame().frame().frame();
    ASSERT_TRUE(bench().ready()) << ui().dump();
    EXPECT_EQ(bench().amounts().flags, match::told::dense);
    EXPECT_TRUE(says("too dense to see blood")) << ui().dump();
    EXPECT_TRUE(says("Here: blood is not measurable")) << ui().dump();
    editor().reference().hold(0);
    ui().frame().frame().frame();
    EXPECT_FALSE(says("too dense to see blood"));
    EXPECT_TRUE(says("s: blood 0.0 %, veil 0.0 %")) << ui().dump();
}

TEST_F(MeasurePanelOfKnown, TheQualifierIsTunedLive) {
    const double before = bench().amounts().blood.value, redness = measure().blood.redness;
    ui().click(rows + "Blood/Redness", {.clicks = 2}).type("12").key(Key::enter).frame().frame();
    EXPECT_LT(bench().amounts().blood.value, 0.7 * before);
    ASSERT_EQ(steps(), 1U);
    EXPECT_EQ(last_step(), "Blood: Redness");
    undo();
    EXPECT_EQ(measure().blood.redness, redness);
    EXPECT_NEAR(bench().amounts().blood.value, before, 1e-9);
}

TEST_F(MeasurePanel, TheBaselineIsAFrameOrSuggested) {
    EXPECT_EQ(measure().baseline, 0.0);
    EXPECT_TRUE(says("the earliest clear one"));
    const double suggested = bench().baseline();
    go(0.2);
    ui().click(rows + "Baseline/Use this frame").frame().frame();
    EXPECT_NEAR(measure().baseline, 0.641, 1e-9) << "offset of half a second; frame 4";
    EXPECT_EQ(bench().baseline(), measure().baseline);
    EXPECT_EQ(editor().reference().video()->frame_at(measure().baseline), editor().reference().frame());
    EXPECT_LT(bench().amounts().blood.value, 0.01) << "it is compared with itself";
    EXPECT_FALSE(says("the earliest clear one"));
    ui().click(rows + "Baseline/Suggest").frame().frame();
    EXPECT_EQ(measure().baseline, 0.0);
    EXPECT_EQ(bench().baseline(), suggested);
    EXPECT_EQ(steps(), 2U);
    undo();
    EXPECT_NEAR(measure().baseline, 0.641, 1e-9);
    undo();
    EXPECT_EQ(measure().baseline, 0.0);
}

TEST_F(MeasurePanel, TheBaselineIsTheFrameOfThisTimeAlsoWhereAnotherIsStillShown) {
    layout("Tune");
    editor().timeline.seek(1);
    ui().frame().frame();
    ASSERT_NE(editor().reference().shown_frame(), editor().reference().frame()) << "nobody looks at the video";
    measuring().use_frame();
    EXPECT_EQ(editor().reference().video()->frame_at(measure().baseline), editor().reference().frame());
}

TEST_F(MeasurePanel, TheFirstFrameCanBeTheBaselineToo) {
    editor().reference().hold(0);
    ui().frame().frame();
    ui().key('B', Mods::command).frame().frame();
    EXPECT_GT(measure().baseline, 0.0) << "0 would be suggested";
    EXPECT_EQ(editor().reference().video()->frame_at(measure().baseline), 0);
}

TEST_F(MeasurePanelOfKnown, TheBaselinesFrameIsDecodedOnce) {
    const int first = bench().baselines_decoded();
    const auto measured_in = [this](double width) {
        editor().document.change("Region",
                                 [=](document::Content& c) { c.scene.reference.measure.region.width = width; });
        ui().frame().frame();
        return bench().amounts();
    };
    const match::FrameAmounts narrow = measured_in(0.5), wide = measured_in(0.9), again = measured_in(0.5);
    EXPECT_NE(narrow.blood.value, wide.blood.value);
    EXPECT_EQ(narrow.blood.value, again.blood.value);
    EXPECT_EQ(bench().baselines_decoded(), first) << "another region takes no other frame";
    bench().measure_again();
    editor().document.change("Baseline", [](document::Content& c) { c.scene.reference.measure.baseline = 0.5; });
    go(bloody_time);
    EXPECT_EQ(bench().baselines_decoded(), first + 1);
    go(bloody_time + 1);
    editor().measure_bench().look.left_out = false;
    editor().document.change("Baseline", [&](document::Content& c) {
        c.scene.reference.measure.baseline = editor().reference().video()->time_of(bench().frame()) + 1e-3;
    });
    ui().frame().frame();
    EXPECT_EQ(bench().baselines_decoded(), first + 1) << "the frame that is shown has been decoded already";
    EXPECT_NEAR(bench().amounts().blood.value, 0.0, 1e-6) << "compared with itself";
}

TEST_F(MeasurePanel, ABaselineOutsideTheVideoIsToldInPlace) {
    editor().document.change("Baseline", [](document::Content& c) { c.scene.reference.measure.baseline = 500; });
    ui().frame().frame();
    ui().click(panel + "Measure").frame().frame();
    EXPECT_EQ(measuring().found(), nullptr);
    EXPECT_TRUE(says("operation.mp4: baseline: 500.00 s is outside the video")) << ui().dump();
    undo();
    measure_all();
    EXPECT_FALSE(says("is outside the video"));
}

TEST_F(MeasurePanelOfKnown, TheEyedropperTakesTheColourOfBlood) {
    ui().key('K', Mods::command | Mods::shift).frame();
    ASSERT_TRUE(holds(app::MeasureTool::pick_blood));
    EXPECT_TRUE(says("Click blood in the picture"));
    ui().key(Key::escape).frame();
    EXPECT_TRUE(holds(app::MeasureTool::none));
    ui().click(rows + "Blood/Pick blood").frame();
    ui().click(picture_path, {.at = {0.5F, 0.55F}}).frame().frame();
    EXPECT_TRUE(holds(app::MeasureTool::none)) << "it takes one";
    ASSERT_EQ(steps(), 1U);
    EXPECT_EQ(last_step(), "Pick blood");
    const BloodQualifier picked = measure().blood;
    EXPECT_NE(picked.redness, BloodQualifier{}.redness);
    EXPECT_NE(picked.brightness, BloodQualifier{}.brightness);
    undo();
    EXPECT_EQ(measure().blood.redness, BloodQualifier{}.redness);
}

TEST_F(MeasurePanelOfKnown, APartIsDrawnMovedAndTakenOut) {
    const double valid = bench().amounts().valid;
    ui().click(rows + "Left out/Draw part").frame();
    EXPECT_TRUE(holds(app::MeasureTool::draw_part));
    for (const glm::vec2 at : {glm::vec2(0.4F, 0.4F), {0.6F, 0.4F}, {0.6F, 0.6F}, {0.4F, 0.6F}})
        ui().click(picture_path + "/parts", {.at = at}).frame();
    EXPECT_EQ(bench().look.drawn.size(), 4U);
    ui().key(Key::backspace).frame();
    EXPECT_EQ(bench().look.drawn.size(), 3U);
    EXPECT_EQ(steps(), 0U) << "it is not closed yet";
    ui().key(Key::enter).frame().frame();
    EXPECT_TRUE(holds(app::MeasureTool::none));
    ASSERT_EQ(measure().parts.size(), 1U);
    ASSERT_EQ(measure().parts[0].corners.size(), 3U);
    EXPECT_EQ(last_step(), "Add part");
    EXPECT_LT(bench().amounts().valid, valid - 0.005);
    EXPECT_TRUE(says("Part 1: 3 corners"));

    const PicturePlace corner = measure().parts[0].corners[0];
    ui().drag(picture_path + "/Part 1 corner 1", {-30, -20}).frame().frame();
    EXPECT_LT(measure().parts[0].corners[0].x, corner.x - 0.02);
    EXPECT_LT(measure().parts[0].corners[0].y, corner.y - 0.02);
    EXPECT_EQ(last_step(), "Move corner");
    EXPECT_EQ(steps(), 2U) << "one step a drag";
    const double right = measure().parts[0].corners[1].x;
    ui().drag(picture_path + "/Part 1", {20, 0}).frame().frame();
    EXPECT_GT(measure().parts[0].corners[1].x, right + 0.02);
    EXPECT_EQ(last_step(), "Move part");
    undo();
    EXPECT_EQ(measure().parts[0].corners[1].x, right);

    ui().click(rows + "Left out/Remove part").frame().frame();
    EXPECT_TRUE(measure().parts.empty());
    EXPECT_NEAR(bench().amounts().valid, valid, 1e-9);
    undo();
    EXPECT_EQ(measure().parts.size(), 1U);
}

TEST_F(MeasurePanelOfKnown, DrawingEndsWithEscAndWithAnotherPanel) {
    ui().click(rows + "Left out/Draw part").frame();
    ui().click(picture_path + "/parts", {.at = {0.4F, 0.4F}}).frame();
    ui().key(Key::escape).frame();
    EXPECT_TRUE(holds(app::MeasureTool::none));
    EXPECT_TRUE(bench().look.drawn.empty());
    ui().click(rows + "Left out/Draw part").frame();
    EXPECT_TRUE(holds(app::MeasureTool::draw_part));
    editor().layouts().bring_to_front("Reference");
    ui().frame().frame();
    EXPECT_TRUE(holds(app::MeasureTool::none));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(MeasurePanelOfKnown, TheRegionIsDraggedOnThePicture) {
    const double valid = bench().amounts().valid;
    ui().drag(picture_path + "/Region lower right", {-80, -60}).frame().frame();
    EXPECT_LT(measure().region.width, 0.95);
    EXPECT_LT(measure().region.height, 0.95);
    EXPECT_EQ(last_step(), "Region");
    EXPECT_LT(bench().amounts().valid, valid);
    undo();
    EXPECT_EQ(measure().region.width, 1.0);
}

TEST_F(MeasurePanel, WhatWasFoundIsExported) {
    EXPECT_FALSE(ui().exists(rows + "Whole reference/CSV...")) << "nothing has been measured";
    measure_all();
    const auto text_of = [](const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    for (const std::string kind : {"csv", "json", "png"}) {
        std::string title = kind;
        for (char& c : title) c = static_cast<char>(std::toupper(c));
        ui().click(rows + "Whole reference/" + title + "...").frame().frame();
        ui().type("\b").key('A', Mods::command).type((folder() / ("found." + kind)).string()).key(Key::enter);
        ui().frame().frame();
        EXPECT_TRUE(fs::exists(folder() / ("found." + kind))) << ui().dump();
        EXPECT_TRUE(says("Exported found." + kind));
    }
    EXPECT_EQ(text_of(folder() / "found.csv"), match::csv_of(*measuring().found()));
    EXPECT_EQ(text_of(folder() / "found.json"), match::json_of(*measuring().found()));
    EXPECT_TRUE(text_of(folder() / "found.png").starts_with("\x89PNG"));
}

TEST_F(MeasurePanel, AClickInThePlotGoesToThatTime) {
    measure_all();
    ui().click(panel + "Amounts", {.at = {0.5F, 0.6F}}).frame();
    const double half = editor().timeline.time;
    EXPECT_GT(half, 2.0);
    EXPECT_LT(half, 5.0);
    EXPECT_FALSE(editor().reference().held());
    ui().click(panel + "Amounts", {.at = {0.12F, 0.6F}}).frame();
    EXPECT_TRUE(editor().reference().held()) << "before the scene's start";
    EXPECT_LT(editor().reference().time(), 0.5);
    ui().click(panel + "Amounts", {.at = {0.5F, 0.6F}}).frame();
    EXPECT_FALSE(editor().reference().held());
}

TEST_F(MeasurePanelOfKnown, WithoutAReferenceItSaysWhatToDo) {
    editor().reference().remove();
    ui().frame().frame();
    EXPECT_TRUE(says("There is no reference to measure"));
    EXPECT_FALSE(ui().exists(panel + "Measure"));
    ui().click(panel + "Sample reference");
    for (int i = 0; i < 10 && !bench().ready(); ++i) ui().frame();
    EXPECT_TRUE(bench().ready());
}

TEST_F(MeasurePanelOfKnown, TheReferencePanelLeadsToIt) {
    editor().layouts().bring_to_front("Reference");
    ui().frame().frame();
    ui().click("Workspace/Reference/More...").frame().click("**/Measure...").frame();
    EXPECT_TRUE(editor().layouts().seen("Measure"));
}

TEST_F(MeasurePanelOfKnown, NothingIsHeldWhileNobodyLooks) {
    const auto pictures = [&] {
        std::size_t bytes = 0;
        for (const ui::StoredImage& image : editor().images.all()) bytes += image.pixels.size();
        return bytes;
    };
    const std::size_t shown = pictures();
    editor().layouts().bring_to_front("Reference");
    ui().frame().frame();
    EXPECT_FALSE(bench().ready());
    EXPECT_LE(pictures(), shown - 160 * 128 * 4);
    editor().layouts().bring_to_front("Measure");
    ui().frame().frame();
    EXPECT_TRUE(bench().ready());
}

}  // namespace
}  // namespace lapfx::test
