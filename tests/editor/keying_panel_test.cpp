// The keying bench, driven by the names of the widgets on the screen.
#include <cmath>
#include <fstream>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "app/clips/keying_bench.h"
#include "editor/support/editor_test.h"
#include "support/folders.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using app::BenchView;

class KeyingPanel : public SampleTest {
  protected:
    KeyingPanel() { begins.layout = "Key"; }
    glm::vec4 pixel(BenchView view, glm::ivec2 at) {
        const ui::Picture picture = editor().keying().picture(view);
        EXPECT_NE(picture.pixels, nullptr);
        return picture.pixels->pixel(at);
    }
    /// Mean of red over the whole picture.
    double mean(BenchView view) {
        const ui::Picture picture = editor().keying().picture(view);
        double sum = 0;
        for (int y = 0; y < picture.size.y; ++y)
            for (int x = 0; x < picture.size.x; ++x) sum += picture.pixels->pixel({x, y}).r;
        return sum / picture.size.x / picture.size.y;
    }
    const KeyingParameters& keying() { return editor().document.preset().smoke.keying; }
    std::size_t steps() { return editor().document.done(); }

    /// Frames of green with a grey square, as a video without loss.
    fs::path green_clip() {
        const fs::path path = folder() / "green.avi";
        cv::VideoWriter writer(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10,
                               cv::Size(160, 96));
        for (int i = 0; i < 10; ++i) {
            cv::Mat image(96, 160, CV_8UC3, cv::Scalar(40, 170, 30));
            image(cv::Rect(60, 30, 40, 40)) = cv::Scalar(180, 180, 180);
            writer.write(image);
        }
        writer.release();
        return path;
    }
    /// Makes the clip the preset's only one that is not haze.
    void put_clip(const fs::path& file) {
        editor().document.change("Clip", [&](document::Content& c) {
            auto& clips = c.preset.smoke.clips;
            std::erase_if(clips, [](const SmokeClip& clip) { return clip.role == ClipRole::plume; });
            clips.insert(clips.begin(), {.file = file.string()});
            editor().document.gather_clips(c.preset);
        });
        ui().frame().frame();
    }
    /// The same, and the history is forgotten.
    void open_clip(const fs::path& clip) {
        put_clip(clip);
        document::Document& document = editor().document;
        document.open(document::Content(document.content()), fs::path(document.scene_file()),
                      fs::path(document.preset_file()));
        ui().frame().frame();
    }
    const std::string panel = "Workspace/Keying/";
};

TEST_F(KeyingPanel, ShowsTheSelectedClipOnItsWayToSmoke) {
    const app::KeyingBench& bench = editor().keying();
    ASSERT_TRUE(bench.ready());
    EXPECT_EQ(bench.picture(BenchView::source).size, glm::ivec2(180, 120));
    EXPECT_EQ(bench.frames(), 150);
    const double before = mean(BenchView::source);
    editor().clips().selected = 2;
    ui().frame().frame();
    EXPECT_GT(std::abs(mean(BenchView::source) - before), 10.0) << "another clip";
    for (int y = 25; y < 120; y += 25) {
        const glm::vec4 source = pixel(BenchView::source, {75, y}), matte = pixel(BenchView::matte, {75, y});
        const double luma = 0.299 * source.r + 0.587 * source.g + 0.114 * source.b;
        const double expected =
            255 * std::clamp((luma - keying().luma_low) / (keying().luma_high - keying().luma_low), 0.0, 1.0);
        EXPECT_NEAR(matte.r, expected, 3.0) << y;
    }
}

TEST_F(KeyingPanel, TheLowHandleChangesMatteAndPreviewInOneStep) {
    const Image preview = picture(6);
    const double before = mean(BenchView::matte), low = keying().luma_low;
    ui().drag(panel + "Bench/Luma/Low", {60, 0});
    ui().frame();
    EXPECT_GT(keying().luma_low, low + 20);
    EXPECT_LT(mean(BenchView::matte), before - 1.0);
    EXPECT_GT(differing(preview, picture(6)), 100U);
    ASSERT_EQ(steps(), 1U);
    EXPECT_EQ(editor().document.steps()[0].name, "Luma low");
    editor().document.undo();
    ui().frame().frame();
    EXPECT_EQ(keying().luma_low, low);
    EXPECT_NEAR(mean(BenchView::matte), before, 1e-9);
}

TEST_F(KeyingPanel, TheEyedropperTakesTheSourcesColour) {
    open_clip(green_clip());
    editor().keying().look.sample_box = 1;
    ui().key('K');
    EXPECT_TRUE(editor().keying().look.eyedropper);
    ui().frame();
    ui().click(panel + "Bench/Source", {.at = {0.35F, 0.2F}});
    ASSERT_EQ(steps(), 1U);
    EXPECT_EQ(editor().document.steps()[0].name, "Key colour");
    const glm::vec4 value = pixel(BenchView::source, {10, 10});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(255 * keying().key_color[c], value[c], 1.01) << c;
    EXPECT_GT(keying().key_color.g, 0.5);
    EXPECT_FALSE(editor().keying().look.eyedropper) << "it takes one";
    ui().click(panel + "Bench/Keyed", {.at = {0.5F, 0.5F}});
    EXPECT_EQ(steps(), 1U) << "never from what is keyed already";
}

TEST_F(KeyingPanel, ChromaCirclesAreDragged) {
    open_clip(green_clip());
    editor().document.change("Key colour", [](document::Content& c) {
        c.preset.smoke.keying.key_color = {0.12, 0.67, 0.16};
        c.preset.smoke.keying.chroma_low = 10, c.preset.smoke.keying.chroma_high = 30;
    });
    ui().frame().frame();
    EXPECT_LT(pixel(BenchView::matte, {10, 10}).r, 4);
    EXPECT_GT(pixel(BenchView::matte, {80, 50}).r, 120);
    ui().drag(panel + "Bench/Chroma/Chroma high", {12, 0});
    EXPECT_NE(keying().chroma_high, 30.0);
    EXPECT_EQ(steps(), 2U);
    EXPECT_EQ(editor().document.steps()[1].name, "Chroma high");
}

TEST_F(KeyingPanel, SuggestFillsTheThresholds) {
    open_clip(green_clip());
    const KeyingParameters shared = keying();
    ui().click(panel + "Bench/Thresholds/Suggest keying").frame().frame();
    ASSERT_EQ(steps(), 1U);
    EXPECT_EQ(editor().document.steps()[0].name, "Suggest keying");
    const KeyingParameters& own = editor().keying().keying();
    EXPECT_GT(own.chroma_high, 20.0);
    EXPECT_GT(own.key_color.g, own.key_color.r + 0.3);
    EXPECT_EQ(keying().chroma_high, shared.chroma_high) << "the other clips keep theirs";
    ASSERT_TRUE(editor().keying().suggestion());
    const std::string told = ui().dump();
    EXPECT_NE(told.find("% sure"), std::string::npos) << "told in place";
    EXPECT_NE(told.find("the background is green ("), std::string::npos);
    EXPECT_NE(told.find(" levels; smoke is found by its colour"), std::string::npos) << "with its unit";
    EXPECT_NE(told.find("Chroma high from 0 to "), std::string::npos) << editor().keying().suggestion_changes();
    EXPECT_EQ(told.find("code values"), std::string::npos) << "one word for it everywhere";
    EXPECT_TRUE(editor().keying().suggestion_changes().starts_with("For this clip only (")) << "and says so";
    ui().click(panel + "Bench/Thresholds/Use for all").frame();
    EXPECT_GT(keying().chroma_high, 20.0) << "for all is a second choice";
    EXPECT_FALSE(editor().keying().clip()->own_keying);
    EXPECT_TRUE(editor().keying().suggestion_changes().starts_with("For all clips ("));
    ASSERT_EQ(steps(), 2U);
    ui().click(panel + "Bench/Thresholds/Dismiss");
    EXPECT_FALSE(editor().keying().suggestion());
    editor().document.undo();
    editor().document.undo();
    EXPECT_EQ(keying().chroma_high, 0.0);
    EXPECT_FALSE(editor().keying().clip()->own_keying);
}

/// Handles do the same as the rows next to them (the sheet of keys says so).
TEST_F(KeyingPanel, BackspaceOnHandlesIsTheSavedValueWithShiftTheDefault) {
    editor().document.change("Kept", [](document::Content& c) { c.preset.smoke.keying.luma_low = 40; });
    editor().document.save_preset(folder() / "kept.json");
    const KeyingParameters standard;
    ASSERT_NE(standard.luma_low, 40);
    editor().document.change("Edited", [](document::Content& c) {
        c.preset.smoke.keying.luma_low = 77, c.preset.smoke.keying.chroma_low = 33;
        c.preset.smoke.keying.chroma_high = 99;
    });
    ui().frame().focus(panel + "Bench/Luma/Low").key(ui::Key::backspace);
    EXPECT_EQ(keying().luma_low, 40);
    ui().key(ui::Key::backspace, ui::Mods::shift);
    EXPECT_EQ(keying().luma_low, standard.luma_low);
    ui().focus(panel + "Bench/Chroma/Chroma low").key(ui::Key::backspace, ui::Mods::shift);
    EXPECT_EQ(keying().chroma_low, standard.chroma_low);
}

TEST_F(KeyingPanel, SourceCropAndMasksAreHandlesOnTheSourcePicture) {
    const std::string source = panel + "Bench/Source/";
    const auto clip = [&] { return editor().document.preset().smoke.clips[editor().clips().selected]; };
    const SmokeClip before = clip();
    ui().drag(source + "Source", {-30, -20});
    EXPECT_LT(clip().source_x, before.source_x);
    EXPECT_LT(clip().source_y, before.source_y);
    ASSERT_EQ(steps(), 1U);
    EXPECT_EQ(editor().document.steps()[0].name, "Source");
    ui().drag(source + "Crop top", {0, 25});
    EXPECT_GT(clip().crop.top, 0.02);
    EXPECT_EQ(clip().crop.bottom, 0.0);
    ASSERT_EQ(steps(), 2U);
    ui().click(panel + "Bench/Thresholds/Frame/Add mask").frame();
    ASSERT_EQ(clip().masks.size(), 1U);
    ui().drag(source + "Mask 1", {20, 10});
    EXPECT_GT(clip().masks[0].x, 0.4);
    EXPECT_NEAR(clip().masks[0].width, 0.2, 1e-9) << "moved whole";
    const double wide = clip().masks[0].width;
    ui().drag(source + "Mask 1 lower right", {15, 0});
    EXPECT_GT(clip().masks[0].width, wide);
    editor().document.undo();
    EXPECT_NEAR(clip().masks[0].width, wide, 1e-9);
    ui().frame().key(ui::Key::del);
    ui().frame();
    EXPECT_TRUE(clip().masks.empty()) << "Delete takes it out";
}

TEST_F(KeyingPanel, AMaskIsDrawnByADragAndEscapeOrAnotherClipEndsIt) {
    const std::string draw = panel + "Bench/Thresholds/Frame/Draw mask", source = panel + "Bench/Source";
    const auto masks = [&] { return editor().document.preset().smoke.clips[0].masks; };
    const auto draws = [&] { return editor().keying().look.draws_mask; };
    ui().click(draw).frame();
    ASSERT_TRUE(draws());
    ui().press(source, {0.4F, 0.4F}).drag_by(0.2F * ui().rect(source).size()).release().frame();
    ASSERT_EQ(masks().size(), 1U);
    EXPECT_EQ(editor().document.steps().back().name, "Add mask");
    EXPECT_FALSE(draws()) << "it takes one";
    const ClipMask mask = masks()[0];
    EXPECT_NEAR(mask.x + 0.5 * mask.width, 0.5, 0.02) << "around the middle, where it was drawn";
    EXPECT_NEAR(mask.y + 0.5 * mask.height, 0.5, 0.02);
    EXPECT_GT(mask.width, 0.15);
    ui().click(draw).frame();
    ASSERT_TRUE(draws());
    ui().key(ui::Key::escape).frame();
    EXPECT_FALSE(draws()) << "Esc without a drag";
    ui().click(draw).frame();
    ui().press(source, {0.2F, 0.2F}).drag_by({30, 30}).key(ui::Key::escape).release().frame();
    EXPECT_FALSE(draws()) << "Esc in the middle of one";
    EXPECT_EQ(masks().size(), 1U);
    ui().click(draw).frame();
    ASSERT_TRUE(draws());
    editor().clips().selected = 1;
    ui().frame().frame();
    EXPECT_FALSE(draws()) << "it was for the other clip";
}

TEST_F(KeyingPanel, WithAllMasksThatAreAllowedDrawingCanStillBeSwitchedOff) {
    const std::string draw = panel + "Bench/Thresholds/Frame/Draw mask";
    ui().click(draw).frame();
    editor().document.change("Masks", [](document::Content& c) {
        c.preset.smoke.clips[0].masks.assign(most_masks, {.x = 0.4, .y = 0.4, .width = 0.2, .height = 0.2});
    });
    ui().frame();
    ASSERT_TRUE(editor().keying().look.draws_mask);
    ASSERT_FALSE(ui().is(draw, ui::Is::disabled));
    ui().click(draw).frame();
    EXPECT_FALSE(editor().keying().look.draws_mask);
    EXPECT_TRUE(ui().is(draw, ui::Is::disabled)) << "there is no room for another one";
    EXPECT_TRUE(ui().is(panel + "Bench/Thresholds/Frame/Add mask", ui::Is::disabled));
}

TEST_F(KeyingPanel, TheSourceIsFoundInOneStep) {
    editor().document.change("Source", [](document::Content& c) {
        c.preset.smoke.clips[0].source_x = 0.05, c.preset.smoke.clips[0].source_y = 0.05;
    });
    ui().frame();
    const SourceSuggestion found = suggest_source(editor().clips().of(0).path);
    ASSERT_TRUE(found.found);
    ui().click(panel + "Bench/Thresholds/Frame/Find the smoke's source").frame().frame();
    const SmokeClip& clip = editor().document.preset().smoke.clips[0];
    EXPECT_NEAR(clip.source_x, found.place.x, 0.0025 + 1e-9);
    EXPECT_NEAR(clip.source_y, found.place.y, 0.0025 + 1e-9);
    ASSERT_EQ(steps(), 2U);
    EXPECT_EQ(editor().document.steps()[1].name, "Source");
    EXPECT_NE(editor().toasts.log().back().text.find("plume_thick.mp4"), std::string::npos);
}

TEST_F(KeyingPanel, SuggestLeavesOtherClipsAloneWhereTheClipHasItsOwn) {
    open_clip(green_clip());
    const KeyingParameters shared = keying();
    ui().click(panel + "Bench/Thresholds/Thresholds for/This clip").frame();
    ui().click(panel + "Bench/Thresholds/Suggest keying").frame().frame();
    ASSERT_EQ(steps(), 2U) << "the clip's own keying, then one step for all that was suggested";
    EXPECT_EQ(keying().chroma_high, shared.chroma_high);
    EXPECT_EQ(keying().luma_high, shared.luma_high);
    EXPECT_EQ(keying().key_color, shared.key_color);
    EXPECT_GT(editor().keying().keying().chroma_high, 20.0);
    EXPECT_TRUE(editor().keying().suggestion_changes().starts_with("For this clip only: ")) << "and says so";
    ui().click(panel + "Bench/Thresholds/Suggest keying").frame().frame();
    EXPECT_EQ(editor().keying().suggestion_changes(), "Nothing changed: these thresholds were set already");
    EXPECT_EQ(steps(), 2U);
}

TEST_F(KeyingPanel, ASuggestionThatEndsWhileAnotherClipIsSelectedIsForItsOwn) {
    open_clip(green_clip());
    document::Document& document = editor().document;
    const std::size_t number = editor().clips().selected;
    document.change("Own keying", [&](document::Content& c) {
        c.preset.smoke.clips[number].own_keying = true;
        c.preset.smoke.clips[number].keying.spill = 0.25;
    });
    document.change("Add clip", [&](document::Content& c) {
        c.preset.smoke.clips.push_back(c.preset.smoke.clips[number]);
        c.preset.smoke.clips.back().own_keying = false;
    });
    const KeyingParameters shared = keying();
    ui().frame();
    editor().keying().suggest();
    editor().clips().selected = document.preset().smoke.clips.size() - 1;
    ui().frame().frame();
    EXPECT_EQ(document.steps().back().name, "Suggest keying");
    EXPECT_GT(document.preset().smoke.clips[number].keying.chroma_high, 20.0);
    EXPECT_EQ(keying().chroma_high, shared.chroma_high);
    EXPECT_FALSE(editor().keying().suggestion()) << "it is not of the clip that is seen";
    const std::string told = ui().dump();
    EXPECT_NE(told.find("Keying for green.avi, "), std::string::npos) << "but told";
    EXPECT_NE(told.find("For this clip only: "), std::string::npos) << "of the clip that it is for";
    EXPECT_NE(told.find("Spill from 0.25 to 1"), std::string::npos) << "with its values";
}

TEST_F(KeyingPanel, ASuggestionThatEndsAsTheSelectedClipGoesIsForItsOwn) {
    open_clip(green_clip());
    document::Document& document = editor().document;
    document.change("One clip", [&](document::Content& c) {
        auto& clips = c.preset.smoke.clips;
        clips = {clips[editor().clips().selected]};
    });
    editor().clips().selected = 0;
    ui().frame().frame();
    editor().keying().suggest();
    document.change("Add clip",
                    [&](document::Content& c) { c.preset.smoke.clips.push_back(c.preset.smoke.clips.front()); });
    editor().clips().selected = 1;
    document.undo();
    ui().frame().frame();
    EXPECT_EQ(editor().clips().selected, 0U);
    EXPECT_GT(keying().chroma_high, 20.0);
    EXPECT_TRUE(editor().keying().suggestion()) << "its clip is seen again: told in place";
    EXPECT_EQ(ui().dump().find("Keying for green.avi"), std::string::npos);
}

TEST_F(KeyingPanel, WhatASuggestionChangedIsSaidAsLongAsItIsSo) {
    open_clip(green_clip());
    editor().document.change("Spill", [](document::Content& c) { c.preset.smoke.keying.spill = 0.25; });
    ui::CommandTable& commands = editor().commands;
    commands.bind(commands.index_of("edit.undo"), {ui::key_of('U'), ui::Mods::command});
    ui().click(panel + "Bench/Thresholds/Suggest keying").frame().frame();
    EXPECT_NE(ui().dump().find("Ctrl+U undoes it."), std::string::npos);
    EXPECT_NE(ui().dump().find("Spill from 0.25 to 1"), std::string::npos) << editor().keying().suggestion_changes();
    editor().document.undo();
    ui().frame().frame();
    EXPECT_EQ(ui().dump().find("Spill from 0.25 to 1"), std::string::npos) << "it is taken back";
    EXPECT_EQ(ui().dump().find("Ctrl+U takes it back"), std::string::npos);
    EXPECT_NE(ui().dump().find("% sure"), std::string::npos) << "the clip is as it was";
    editor().document.redo();
    ui().click(panel + "Bench/Thresholds/Suggest keying").frame().frame();
    EXPECT_NE(ui().dump().find("Nothing changed: these thresholds were set already."), std::string::npos);
    EXPECT_EQ(ui().dump().find("Ctrl+U takes it back"), std::string::npos) << "undo would take back something else";
}

TEST_F(KeyingPanel, ThePixelSaysWhatThresholdsGoBy) {
    open_clip(green_clip());
    ui().move_to(panel + "Bench/Source").frame();
    EXPECT_NE(ui().text(panel + "Bench/Source").find("Luma 1"), std::string::npos) << ui().text(panel + "Bench/Source");
    ui().move_to(panel + "Bench/Matte").frame();
    EXPECT_NE(ui().text(panel + "Bench/Matte").find("Opacity "), std::string::npos);
    ui().click(panel + "Bench/Scope/Waveform").frame();
    EXPECT_TRUE(ui().exists(panel + "Bench/Luma waveform"));
    ui().click(panel + "Bench/Scope/Colours").frame();
    EXPECT_TRUE(ui().exists(panel + "Bench/Chroma"));
}

TEST_F(KeyingPanel, ThresholdsAreForAllClipsOrForThisOne) {
    const double low = keying().luma_low;
    ui().click(panel + "Bench/Thresholds/Thresholds for/This clip").frame();
    ui().drag(panel + "Bench/Luma/Low", {60, 0});
    EXPECT_EQ(keying().luma_low, low) << "the preset's stay";
    const SmokeClip& clip = editor().document.preset().smoke.clips[0];
    EXPECT_TRUE(clip.own_keying);
    EXPECT_GT(clip.keying.luma_low, low + 20);
    EXPECT_EQ(clip.keying.luma_high, keying().luma_high) << "they go on from the preset's";
    EXPECT_EQ(steps(), 2U);
    ui().click(panel + "Bench/Thresholds/Thresholds for/All clips").frame();
    EXPECT_FALSE(editor().document.preset().smoke.clips[0].own_keying);
}

/// Uses an editor that does not wait: jobs decode the frames.
TEST_F(KeyingPanel, BesideTheWindowPicturesFollowWithoutWaiting) {
    ui::ImageStore images;
    app::EditorOptions options = editor().options();
    options.exact = false;
    app::Editor live(images, options);
    live.document.open(editor().document.content());
    app::KeyingBench& bench = live.keying();
    double now = 1;
    const auto frame = [&] { live.frame(now += 1.0 / 60, [&] { bench.show(); }, {.visible = false}); };
    const auto until = [&](const std::function<bool()>& met) { return wait_until(met, frame); };
    const auto matte = [&] { return bench.picture(BenchView::matte).pixels->pixel({90, 95}).r; };
    frame();
    EXPECT_FALSE(bench.ready()) << "nothing was waited for";
    ASSERT_TRUE(until([&] { return bench.ready() && !live.jobs.busy(); }));
    EXPECT_FALSE(bench.stale());
    const float before = matte();
    EXPECT_GT(before, 40);
    live.document.change("Luma low", [](document::Content& c) { c.preset.smoke.keying.luma_low = 150; });
    EXPECT_TRUE(bench.stale());
    frame();
    EXPECT_LT(matte(), before) << "seen in the next frame";
    // The newest request is fulfilled, whatever was requested before.
    for (const double time : {0.5, 1.0, 1.5, 3.0}) {
        bench.look.time = time;
        live.document.change("Choke", [&](document::Content& c) { c.preset.smoke.keying.choke = time; });
        frame();
    }
    ASSERT_TRUE(until([&] { return !bench.stale() && !live.jobs.busy(); }));
    EXPECT_EQ(bench.frame(), 90);
    bench.suggest();
    ASSERT_TRUE(bench.suggesting());
    EXPECT_TRUE(until([&] { return !bench.suggesting(); }));
    EXPECT_EQ(live.document.steps().back().name, "Suggest keying");
}

TEST_F(KeyingPanel, ViewsShareOneLook) {
    const ui::ViewState before = editor().keying().look.state;
    ui().wheel(panel + "Bench/Source", {0, 2});
    EXPECT_NE(editor().keying().look.state, before);
    ui().click(panel + "Fit");
    EXPECT_TRUE(editor().keying().look.state.fitted);
    ui().click(panel + "Views/Matte").frame();
    EXPECT_TRUE(ui().exists(panel + "Bench/Matte"));
    EXPECT_FALSE(ui().exists(panel + "Bench/Keyed"));
    EXPECT_FALSE(editor().keying().look.grid);
}

TEST_F(KeyingPanel, ScrubsByTimeAndByFrame) {
    const int before = editor().keying().frame();
    EXPECT_EQ(before, 60);
    ui().click(panel + "Bench/Next frame").frame();
    EXPECT_EQ(editor().keying().frame(), before + 1);
    ui().click(panel + "Bench/Previous frame").click(panel + "Bench/Previous frame").frame();
    EXPECT_EQ(editor().keying().frame(), before - 1);
    ui().click(panel + "Bench/Follow");
    editor().timeline.seek(1.0);
    ui().frame().frame();
    EXPECT_EQ(editor().keying().frame(), 30);
    EXPECT_EQ(steps(), 0U) << "no part of the document";
}

TEST_F(KeyingPanel, BehindTheSmokeThereIsWhatWasChosen) {
    const glm::ivec2 corner(5, 5);
    EXPECT_GT(pixel(BenchView::composite, corner).r, pixel(BenchView::composite, corner).g + 40) << "tissue";
    ui().click(panel + "Behind/Grey").frame();
    EXPECT_EQ(pixel(BenchView::composite, corner), glm::vec4(118, 118, 118, 255));
    ui().click(panel + "Behind/Preview").frame().frame().frame();
    const Image preview = editor().preview.read();
    const glm::vec4 middle = pixel(BenchView::composite, {25, 60});
    const double step = std::min(preview.width / 180.0, preview.height / 120.0);
    const int x = static_cast<int>(0.5 * (preview.width - 180 * step) + 25.5 * step);
    const int y = static_cast<int>(0.5 * (preview.height - 120 * step) + 60.5 * step);
    EXPECT_EQ(middle.r, preview.pixels[4 * static_cast<std::size_t>(y * preview.width + x)]);
}

TEST_F(KeyingPanel, BehindTheSmokeThePreviewIsWhole) {
    int asked = 0;
    clock = [&] { return 0.5 * ++asked; };  // a scene this slow is drawn with fewer pixels while a person works
    start({1440, 900}, false);
    open_sample();
    editor().jobs.finish();
    ui().frame().frame();
    editor().jobs.finish();
    layout("Key");
    editor().timeline.speed = 0;
    // The scene has no smoke, because a streamed clip may show another frame by then.
    editor().document.change(
        "No smoke", [](document::Content& c) { c.preset.smoke.plume.density = c.preset.smoke.haze.accumulation = 0; });
    const auto rest = [&] {
        for (int i = 0; i < 4; ++i) {
            ui().frame(1).frame();
            editor().jobs.finish();
        }
    };
    const auto seen = [&] {
        std::vector<glm::vec4> pixels;
        for (int y = 4; y < 480; y += 8)
            for (int x = 4; x < 720; x += 8) pixels.push_back(pixel(BenchView::composite, {x, y}));
        return pixels;
    };
    rest();
    ui().click(panel + "Behind/Preview");
    for (int i = 0; i < 150; ++i) {  // the first frames may still have all pixels
        editor().timeline.seek(0.02 * i);
        editor().touch(ui().time + 1.0 / 60);
        ui().frame();
    }
    editor().timeline.seek(3);
    ASSERT_LT(editor().whole_at(), 1e9) << "what is seen meanwhile has fewer pixels";
    ui().frame().frame();
    editor().jobs.finish();
    rest();
    ASSERT_GT(editor().whole_at(), 1e9);
    const auto shown = seen();
    editor().keying().take_backdrop();
    rest();
    EXPECT_TRUE(shown == seen());
}

TEST_F(KeyingPanel, ASourceThatIsFoundIsNotOfTheNextDocument) {
    open_clip(source_folder() / "samples/clips/plume_thick.mp4");
    editor().keying().find_source();
    ASSERT_TRUE(editor().keying().finding_source());
    editor().forget_document(false);
    EXPECT_FALSE(editor().keying().finding_source());
    editor().jobs.finish();
    EXPECT_EQ(steps(), 0U);
    EXPECT_EQ(editor().toasts.size(), 0U) << "nothing is said of it";
}

TEST_F(KeyingPanel, AMissingFileIsToldInPlace) {
    editor().document.change("Clip", [](document::Content& c) { c.preset.smoke.clips[0].file = "gone.mp4"; });
    ui().frame().frame();
    EXPECT_FALSE(editor().keying().ready());
    EXPECT_NE(ui().dump().find("gone.mp4: no such clip"), std::string::npos);
    EXPECT_TRUE(ui().exists(panel + "Replace file..."));
    editor().document.undo();
    ui().frame().frame();
    EXPECT_TRUE(editor().keying().ready());
}

TEST_F(KeyingPanel, AClipWithItsOwnOpacityHasNoThresholds) {
    cv::Mat image(64, 96, CV_8UC4, cv::Scalar(200, 200, 200, 0));
    image(cv::Rect(20, 20, 30, 30)) = cv::Scalar(200, 200, 200, 160);
    const fs::path path = folder() / "own.png";
    ASSERT_TRUE(cv::imwrite(path.string(), image));
    put_clip(path);
    ASSERT_TRUE(editor().keying().ready());
    EXPECT_NEAR(pixel(BenchView::matte, {30, 30}).r, 160, 1);
    EXPECT_EQ(pixel(BenchView::matte, {80, 50}).r, 0);
    EXPECT_FALSE(ui().exists(panel + "Bench/Luma/Low"));
    EXPECT_TRUE(ui().is(panel + "Bench/Thresholds/Luma low", ui::Is::disabled));
    EXPECT_FALSE(ui().is(panel + "Bench/Thresholds/Choke", ui::Is::disabled)) << "edges are drawn in all the same";
    EXPECT_NE(ui().dump().find("has its own opacity"), std::string::npos) << "told why";
}

TEST_F(KeyingPanel, WithoutAClipOneCanBeAdded) {
    editor().document.change("Clips", [](document::Content& c) { c.preset.smoke.clips.clear(); });
    ui().frame().frame();
    EXPECT_TRUE(ui().exists(panel + "Add clip..."));
    EXPECT_FALSE(editor().commands.enabled(editor().commands.index_of("clip.suggest")));
}

TEST_F(KeyingPanel, AClipThatBreaksWhileItIsOpenDoesNoHarm) {
    const fs::path path = green_clip();
    put_clip(path);
    ASSERT_TRUE(editor().keying().ready());
    std::ofstream(path, std::ios::trunc) << "no video any more";
    editor().keying().look.time = 0.75;
    ui().frame().frame();
    editor().clips().look_again();
    ui().frame().frame();
    EXPECT_NE(ui().dump().find("is not a video that can be decoded"), std::string::npos);
}

}  // namespace
}  // namespace lapfx::test
