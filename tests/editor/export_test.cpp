// The export dialog: what it proposes, what it refuses, what it makes.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "app/files/exports.h"
#include "app/files/files.h"
#include "app/measure/measuring.h"
#include "editor/support/editor_test.h"
#include "editor/support/held_jobs.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/video.h"
#include "support/folders.h"
#include "support/wait_until.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

class ExportTest : public SampleTest {
  protected:
    app::ExportForm& form() { return editor().exports().form; }
    void open_dialog(const char* command) {
        editor().commands.run(command);
        ui().frame().frame();
    }
    void set_file(const fs::path& path) {
        form().file() = path.string();
        ui().frame();
    }
    std::string path(const std::string& name) const { return (folder() / name).string(); }
    /// Presses Export and waits until the export has ended.
    void export_it() {
        ui().click("New export/Export");
        ASSERT_TRUE(wait_until([&] { return !editor().exports().running(); }, [&] { ui().frame(); }));
        ui().frame().frame();
    }
    /// What toasts say.
    std::string news() { return ui().dump(); }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder())) all.push_back(entry.path().filename().string());
        std::sort(all.begin(), all.end());
        return all;
    }
};

TEST_F(ExportTest, ProposesWhatIsShownBesideThePreset) {
    editor().timeline.seek(4.5);
    ui().key('E', ui::Mods::command).frame();
    ASSERT_TRUE(ui().exists("New export/What"));
    EXPECT_THAT(form().file(), HasSubstr("gastric_banding_tuned.json"));
    ui().click("New export/What/Picture").frame();
    EXPECT_THAT(ui().text("New export/Form/File"), HasSubstr("gastric_banding.png"));
    EXPECT_NEAR(ui().value("New export/Form/Time"), 4.5, 1e-9);
    ui().click("New export/What/Video").frame();
    EXPECT_EQ(ui().value("New export/Form/To"), 12);
    EXPECT_EQ(editor().exports().frames(), 300);
    ui().key(ui::Key::escape).frame();
    editor().timeline.has_range = true;
    editor().timeline.range = {.low = 2, .high = 3};
    open_dialog("export.video");
    EXPECT_EQ(ui().value("New export/Form/From"), 2);
    EXPECT_EQ(editor().exports().frames(), 25);
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
}

TEST_F(ExportTest, WhatWasOpenedIsNotReplaced) {
    guard_files(FileGuard::note);  // the program does the same
    const std::string file = path("operation.mp4");
    std::ofstream(file) << "a surgery video";
    note_read(file);
    open_dialog("export.video");
    set_file(file);
    EXPECT_EQ(editor().exports().fault_at("-o"), "is a file that was opened here; choose another name");
    set_file(path("new.mp4"));
    EXPECT_EQ(editor().exports().fault_at("-o"), "");
    form().amounts = true, form().amounts_file = file;
    ui().frame();
    EXPECT_EQ(editor().exports().fault_at("--amounts"), "is a file that was opened here; choose another name");
    guard_files(FileGuard::off);
}

TEST_F(ExportTest, TellsInPlaceWhatIsWrongAndLetsNothingBegin) {
    open_dialog("export.video");
    set_file(folder() / "out.png");
    EXPECT_EQ(editor().exports().fault_at("-o"), "a video is an .mp4, .mov, .mkv or .avi");
    EXPECT_TRUE(ui().is("New export/Export", ui::Is::disabled));
    EXPECT_THAT(ui().tip("New export/Export"), HasSubstr("Not possible yet: a video is"));
    set_file("/no such folder/out.mp4");
    EXPECT_THAT(std::string(editor().exports().fault_at("-o")), HasSubstr("there is no folder /no such folder"));
    set_file(folder() / "out.mp4");
    EXPECT_FALSE(ui().is("New export/Export", ui::Is::disabled));
    form().size = static_cast<int>(app::export_sizes.size()) - 1;
    form().width = 641;
    form().height = 480;
    ui().frame();
    EXPECT_THAT(std::string(editor().exports().fault_at("--size")), HasSubstr("must be even"));
    form().width = 640;
    form().to = form().from;
    ui().frame();
    EXPECT_THAT(std::string(editor().exports().fault_at("--to")), HasSubstr("is not after"));
    EXPECT_TRUE(ui().is("New export/Export", ui::Is::disabled));
    set_file("");
    EXPECT_EQ(editor().exports().fault_at("-o"), "choose a name for the file");
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(ExportTest, AVideoWithItsAmounts) {
    open_dialog("export.video");
    set_file(path("out.mp4"));
    form().size = 5;
    form().from = 5;
    form().to = 5.4;
    form().fps = 10;
    form().amounts = true;
    form().amounts_file = path("out.csv");
    ui().frame();
    export_it();
    EXPECT_THAT(names(), testing::ElementsAre("out.csv", "out.mp4"));
    EXPECT_THAT(news(), HasSubstr("Exported out.mp4 (4 frames), checked"));
    cv::VideoCapture video(path("out.mp4"));
    EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_WIDTH), 640);
    int frames = 0;
    while (video.grab()) ++frames;
    EXPECT_EQ(frames, 4);
    std::ifstream csv(path("out.csv"));
    std::string line;
    int lines = 0;
    while (std::getline(csv, line)) ++lines;
    EXPECT_EQ(lines, 5);
}

TEST_F(ExportTest, AVideoHasACodecAndAQuality) {
    open_dialog("export.video");
    set_file(path("out.mp4"));
    form().size = 5;
    form().to = 0.2;
    form().fps = 10;
    EXPECT_THAT(editor().exports().command(), HasSubstr(" --codec h264 --quality good "));
    form().quality = static_cast<int>(output::Quality::small);
    ui().frame();
    EXPECT_EQ(ui().text("New export/Form/Quality"), "Small");
    EXPECT_THAT(editor().exports().command(), HasSubstr(" --codec h264 --quality small "));
    form().codec = static_cast<int>(output::Codec::ffv1);
    ui().frame();
    EXPECT_EQ(editor().exports().fault_at("--codec"), "\"ffv1\" does not go into .mp4; name the file .mkv or .avi");
    EXPECT_TRUE(ui().is("New export/Export", ui::Is::disabled));
    EXPECT_FALSE(ui().exists("New export/Form/Quality")) << "it is lossless";
    set_file(path("out.mkv"));
    EXPECT_FALSE(ui().is("New export/Export", ui::Is::disabled));
    EXPECT_THAT(editor().exports().command(),
                testing::AllOf(HasSubstr(" --codec ffv1 -o "), testing::Not(HasSubstr("quality"))));
    export_it();
    EXPECT_EQ(VideoReader(path("out.mkv")).info().codec, "ffv1");
    open_dialog("export.picture");
    EXPECT_FALSE(ui().exists("New export/Form/Codec"));
}

TEST_F(ExportTest, TheEditorLivesOnAndTheExportCanBeGivenUp) {
    open_dialog("export.video");
    set_file(path("out.mp4"));
    form().size = 5;
    ui().frame();
    ui().click("New export/Export");
    for (int i = 0; i < 3; ++i) ui().frame();
    ASSERT_TRUE(editor().exports().running());
    EXPECT_TRUE(editor().wants_frame());
    EXPECT_FALSE(ui().exists("New export/What")) << "the dialog has closed";
    EXPECT_THAT(ui().text("Status bar/out.mp4"), testing::AllOf(HasSubstr("%"), testing::Not(HasSubstr("frames"))));
    const double before = editor().exports().progress();
    EXPECT_GT(before, 0);
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    ui().frame();
    EXPECT_GT(editor().exports().progress(), before);
    open_dialog("export.open");
    EXPECT_THAT(ui().text("New export/Exporting out.mp4"), HasSubstr(" of 300 frames"));
    EXPECT_TRUE(ui().exists("New export/Close")) << "which is not to give it up";
    EXPECT_TRUE(ui().is("New export/Export", ui::Is::disabled));
    EXPECT_THAT(ui().tip("New export/Export"), HasSubstr("Not possible yet: out.mp4 is being exported"));
    ui().click("New export/What/Preset").frame();
    set_file(path("meanwhile.json"));
    ui().click("New export/Export").frame().frame();
    EXPECT_EQ(load_preset(folder() / "meanwhile.json").bleeding.speed, 9) << "it waits for nothing";
    EXPECT_THAT(news(), HasSubstr("Exported meanwhile.json, checked"));
    EXPECT_TRUE(editor().exports().running());
    editor().exports().cancel();
    ui().frame().frame();
    EXPECT_FALSE(editor().exports().running());
    EXPECT_THAT(names(), testing::ElementsAre("meanwhile.json"));
    EXPECT_THAT(news(), HasSubstr("cancelled: nothing was written"));
}

TEST_F(ExportTest, WhatIsThereIsAskedFor) {
    std::ofstream(path("out.png")) << "old";
    open_dialog("export.picture");
    set_file(path("out.png"));
    form().size = 5;
    ui().frame();
    ui().click("New export/Export").frame();
    EXPECT_FALSE(editor().exports().running());
    ASSERT_TRUE(ui().exists("Replace it?/Replace")) << ui().dump();
    ui().click("Replace it?/Cancel").frame();
    EXPECT_TRUE(ui().exists("New export/What")) << "the form is there again";
    EXPECT_EQ(fs::file_size(path("out.png")), 3U);
    ui().click("New export/Export").frame();
    ui().click("Replace it?/Replace");
    EXPECT_TRUE(wait_until([&] { return !editor().exports().running(); }, [&] { ui().frame(); }));
    EXPECT_EQ(cv::imread(path("out.png")).cols, 640);
}

TEST_F(ExportTest, APresetThatCannotStandAloneBecomesABundle) {
    fs::create_directories(folder() / "clips");
    fs::copy_file(source_folder() / "samples/clips/wisps_thin.mp4", folder() / "clips/mine.mp4");
    fs::create_directories(folder() / "out");
    editor().document.change("Clip", [&](document::Content& c) {
        c.preset.folder = folder();
        c.preset.smoke.clips = {{.file = "clips/mine.mp4"}};
    });
    editor().commands.run("export.open");
    form().kind = static_cast<int>(output::OutputKind::preset);
    set_file(path("out/alone.json"));
    EXPECT_THAT(std::string(editor().exports().fault_at("clips")), HasSubstr("is outside"));
    ui().click("New export/Form/Make a bundle instead").frame();
    set_file(path("out/together"));
    ui().click("New export/Form/Copy these files").frame();  // the clip is not in the scene's folder
    export_it();
    EXPECT_THAT(news(), HasSubstr("Exported together ("));
    const Preset read = load_preset(folder() / "out/together/together.json");
    EXPECT_EQ(read.smoke.clips.at(0).file, "clips/mine.mp4");
    EXPECT_EQ(cv::imread(path("out/together/thumbnail.png")).cols, 320);
    EXPECT_TRUE(fs::exists(folder() / "out/together/organ/lagb.glb"));
}

TEST_F(ExportTest, TheTimeThatIsRenderedIsTheOneThatIsShown) {
    editor().timeline.seek(5.592273);
    editor().commands.run("export.picture");
    ui().frame();
    EXPECT_EQ(form().at, 5.592);
    form().at = 1.23456789;
    ui().frame().frame();
    EXPECT_EQ(form().at, 1.234);
}

TEST_F(ExportTest, APresetAlone) {
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9.25; });
    editor().commands.run("export.open");
    form().kind = static_cast<int>(output::OutputKind::preset);
    set_file(path("p.json"));
    export_it();
    EXPECT_EQ(load_preset(folder() / "p.json").bleeding.speed, 9.25);
    EXPECT_THAT(news(), HasSubstr("Exported p.json, checked"));
    EXPECT_TRUE(editor().document.preset_unsaved()) << "an export is no save";
}

TEST_F(ExportTest, APresetReplacesNoSceneAndASequenceNoneOfItsImagesUnasked) {
    editor().document.save_scene(folder() / "m.scene.json");
    editor().commands.run("export.open");
    form().kind = static_cast<int>(output::OutputKind::preset);
    set_file(path("m.scene.json"));
    EXPECT_EQ(editor().exports().fault_at("-o"),
              "a file of this name is there and is not a preset; choose another name");
    form().kind = static_cast<int>(output::OutputKind::sequence);
    set_file(path("f_%04d.png"));
    EXPECT_FALSE(editor().exports().replaces());
    std::ofstream(folder() / "f_0007.png") << "a texture";
    set_file(path("g_%04d.png"));
    set_file(path("f_%04d.png"));
    EXPECT_TRUE(editor().exports().replaces());
}

TEST_F(ExportTest, APresetWaitsForNoJob) {
    start({1440, 900}, false);
    const HeldJobs held(editor().jobs);
    open_sample();
    open_dialog("export.open");
    form().kind = static_cast<int>(output::OutputKind::preset);
    set_file(path("p.json"));
    EXPECT_FALSE(editor().exports().replaces());
    ui().click("New export/Export");
    EXPECT_TRUE(fs::exists(path("p.json")));
    EXPECT_THAT(news(), HasSubstr("Exported p.json, checked"));
    open_dialog("export.open");
    ui().click("New export/Export").frame();
    EXPECT_TRUE(ui().exists("Replace it?/Replace")) << "the second one is asked about";
    ui().key(ui::Key::escape).frame().key(ui::Key::escape).frame();
    editor().files().close();
    ui().frame();
    EXPECT_TRUE(editor().files().closed());
}

TEST_F(ExportTest, ClosingAsksWhileAnExportRuns) {
    std::ofstream(path("out.mp4")) << "old";
    open_dialog("export.video");
    set_file(path("out.mp4"));
    form().size = 5;
    editor().exports().start();
    ui().key(ui::Key::escape).frame().frame();
    ASSERT_TRUE(editor().exports().running());
    const auto title = [&] {
        ui().frame();
        return editor().files().question() != nullptr ? editor().files().question()->title : "";
    };
    editor().files().close();
    EXPECT_EQ(title(), "\"out.mp4\" is being exported");
    const double before = editor().exports().progress();
    ui().frame();
    EXPECT_GT(editor().exports().progress(), before) << "it goes on meanwhile";
    ui().click("**/Keep exporting").frame();
    EXPECT_FALSE(editor().files().closed());
    EXPECT_TRUE(editor().exports().running());
    // Unsaved changes are asked about first: saving may be cancelled, and then nothing may be lost.
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    editor().files().close();
    EXPECT_EQ(title(), "Save changes before closing?");
    ui().click("**/Discard").frame();
    EXPECT_EQ(title(), "\"out.mp4\" is being exported");
    EXPECT_TRUE(editor().exports().running());
    ui().click("**/Stop it and close").frame();
    EXPECT_TRUE(editor().files().closed());
    EXPECT_FALSE(editor().exports().running());
    EXPECT_THAT(names(), testing::Contains("out.mp4"));
    EXPECT_EQ(fs::file_size(path("out.mp4")), 3U) << "the old one";
}

/// An export of an organ and clips that the view has not loaded yet, because its jobs wait until `held_` is destroyed.
class LoadingExport : public ExportTest {
  protected:
    LoadingExport() { shares_measured = false; }
    void SetUp() override {
        ExportTest::SetUp();
        if (IsSkipped()) return;
        start({1440, 900}, false);
        held_ = std::make_unique<HeldJobs>(editor().jobs);
        open_sample();
        editor().timeline.speed = 0;
        open_dialog("export.picture");
        set_file(path("out.png"));
        form().size = 5;
        form().at = 6;
        ui().frame().click("New export/Export").frame().frame();
        ASSERT_TRUE(editor().exports().running());
        ASSERT_EQ(editor().preview.organ_of(editor().document.scene()), nullptr);
    }
    void TearDown() override {
        held_.reset();
        ExportTest::TearDown();
    }
    void let_go() {
        held_.reset();
        const auto busy = [&] { return editor().exports().running() || editor().jobs.busy(); };
        EXPECT_TRUE(wait_until([&] { return !busy(); }, [&] { ui().frame(); }));
        ui().frame().frame();
    }

  private:
    std::unique_ptr<HeldJobs> held_;
};

TEST_F(LoadingExport, IsToldOnceAndGoesOnWhenAllIsThere) {
    layout("Compare");  // without the view
    // As soon as the reference is there it is measured, by a thread of its own.
    ASSERT_TRUE(wait_until([&] { return editor().measuring().running(); }, [&] { ui().frame(); }));
    const auto running = editor().jobs.running();
    const auto place = [&](std::string_view name) {
        return std::ranges::find_if(running, [&](const auto& job) { return job->name() == name; });
    };
    ASSERT_NE(place("Measuring operation.mp4"), running.end());
    EXPECT_LT(place("Loading lagb.glb"), place("Measuring operation.mp4")) << "the older, though it waits";
    HeldJobs::keep_only(editor().jobs, "Loading ");
    ui().frame();
    EXPECT_TRUE(editor().exports().loading());
    EXPECT_EQ(ui().text("Status bar/out.png"), "loading");
    EXPECT_LT(editor().exports().progress(), 0) << "nobody knows yet";
    EXPECT_LT(editor().exports().seconds_left(), 0);
    EXPECT_FALSE(ui().exists("Status bar/Loading for out.png"));
    ASSERT_TRUE(ui().exists("Status bar/Loading lagb.glb")) << "which is the view's";
    EXPECT_EQ(ui().text("Status bar/Loading lagb.glb"), "") << "and no more";
    let_go();
    EXPECT_FALSE(editor().exports().running());
    EXPECT_THAT(news(), HasSubstr("Exported out.png, checked"));
    const cv::Mat loaded = cv::imread(path("out.png"));
    start();
    open_sample();
    open_dialog("export.picture");
    set_file(path("there.png"));
    form().size = 5;
    form().at = 6;
    ui().frame();
    export_it();
    const cv::Mat there = cv::imread(path("there.png"));
    ASSERT_EQ(loaded.size(), cv::Size(640, 512));
    ASSERT_EQ(there.size(), loaded.size());
    EXPECT_EQ(cv::norm(loaded, there, cv::NORM_INF), 0) << "the same as of an organ that is there";
}

TEST_F(LoadingExport, CanBeGivenUp) {
    ui().click("Status bar/Cancel out.png").frame();
    EXPECT_FALSE(editor().exports().running());
    EXPECT_THAT(news(), HasSubstr("Export of out.png cancelled: nothing was written"));
    let_go();
    EXPECT_TRUE(editor().preview.ready()) << "the view has its organ";
    EXPECT_FALSE(fs::exists(path("out.png")));
    EXPECT_FALSE(editor().exports().running());
}

TEST_F(ExportTest, TheCommandMakesTheSameAndSaysWhenItCannot) {
    open_dialog("export.picture");
    set_file(path("a b.png"));
    editor().timeline.seek(6);
    form().at = 6;
    ui().click("New export/Copy lapfx render command").frame();
    EXPECT_THAT(ui().clipboard().text, testing::ContainsRegex("samples/lagb.scene.json'? --preset "));
    EXPECT_THAT(ui().clipboard().text, HasSubstr("--size 1280x1024 --at 6 -o '" + path("a b.png") + "'"));
    ui().clipboard().text.clear();
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    ui().frame().click("New export/Copy lapfx render command").frame();
    EXPECT_EQ(ui().clipboard().text, "");
    EXPECT_THAT(news(), HasSubstr("the preset is not saved"));
}

TEST_F(ExportTest, NothingIsProposedBesideWhatCameWithTheProgram) {
    open_dialog("export.open");
    for (const std::string& file : form().files) EXPECT_EQ(fs::path(file).parent_path(), folder()) << "documents";
    ui().key(ui::Key::escape).frame();
    fs::create_directory(folder() / "own");
    fs::create_directory(folder() / "films");
    editor().document.save_preset(folder() / "own" / "a.json");
    open_dialog("export.open");
    EXPECT_EQ(form().files[0], path("own/a_tuned.json")) << "beside the user's own";
    EXPECT_EQ(form().files[4], path("own/a.mp4"));
    ui().click("New export/What/Picture").frame();
    set_file(path("films/out.png"));
    form().size = 5;
    ui().frame();
    export_it();
    editor().document.save_preset(folder() / "own" / "b.json");
    open_dialog("export.open");
    EXPECT_EQ(form().files[2], path("films/b.png")) << "where the last picture went";
    EXPECT_EQ(form().files[4], path("own/b.mp4"));
}

TEST_F(ExportTest, ABundleIsOpenedFromItsNotice) {
    open_dialog("export.bundle");
    set_file(path("together"));
    export_it();
    EXPECT_EQ(editor().document.scene_file(), shipped() / "samples" / "lagb.scene.json");
    ui().click("**/Open the bundle").frame();
    EXPECT_EQ(editor().document.scene_file(), folder() / "together" / "together.scene.json");
    EXPECT_EQ(editor().document.preset_file(), folder() / "together" / "together.json");
    open_dialog("export.bundle");
    set_file(path("alone"));
    form().with_scene = false;
    ui().frame();
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    export_it();
    ui().click("**/Open the bundle").frame();
    ASSERT_NE(editor().files().question(), nullptr);
    EXPECT_THAT(editor().files().question()->title, HasSubstr("Save changes before opening \"alone.json\"?"));
}

/// A scene's organ may be anywhere on the disk, so that a bundle could pass on files that its user never saw. They are
/// listed first, and the user has to agree.
class OutsideTest : public ExportTest {
  protected:
    void SetUp() override {
        ExportTest::SetUp();
        if (IsSkipped()) return;
        for (const char* name : {"case", "else"}) fs::create_directory(folder() / name);
        std::ofstream(folder() / "else/liver.obj") << "mtllib liver.mtl\nv 0 0 0\nv 90 0 0\nv 0 90 0\nf 1 2 3\n";
        std::ofstream(folder() / "else/liver.mtl") << "newmtl m\nKd 1 0 0\n";
        fs::copy_file(folder() / "else/liver.obj", folder() / "case/own.obj");
    }
    void open_with(const std::string& organ) {
        Scene scene;
        scene.name = "Case";
        scene.organ.file = organ;
        const fs::path file = folder() / "case" / "case.scene.json";
        save_scene(scene, file);
        open({file.string()});
        EXPECT_TRUE(wait_until([&] { return editor().preview.organ_of(editor().document.scene()) != nullptr; },
                               [&] { ui().frame(); }));
        open_dialog("export.bundle");
        set_file(path("bundle"));
    }
    std::string real(const std::string& name) const { return fs::canonical(folder() / name).string(); }
    bool lists(const std::string& name) { return ui().exists("New export/Form/Organ: " + real(name)); }
};

TEST_F(OutsideTest, WhatABundleCopiesFromElsewhereIsListedAndAgreedTo) {
    open_with("../else/liver.obj");
    EXPECT_TRUE(lists("else/liver.obj")) << ui().dump();
    EXPECT_TRUE(lists("else/liver.mtl")) << ui().dump();
    EXPECT_THAT(ui().dump(), HasSubstr("outside the folder " + (folder() / "case").string()));
    EXPECT_TRUE(ui().is("New export/Export", ui::Is::disabled));
    EXPECT_THAT(ui().tip("New export/Export"), HasSubstr("agree"));
    EXPECT_TRUE(
        ui().exists("New export/Not possible yet: agree to copying the files from elsewhere: check \"Copy "
                    "these files\""))
        << ui().dump();
    EXPECT_THAT(ui().dump(), testing::Not(HasSubstr("are copied")));
    editor().exports().start();
    EXPECT_FALSE(editor().exports().running()) << "not even from a script";
    ui().click("New export/Form/Copy these files").frame();
    EXPECT_FALSE(ui().is("New export/Export", ui::Is::disabled)) << ui().tip("New export/Export");
    export_it();
    EXPECT_TRUE(fs::exists(folder() / "bundle" / "organ" / "liver.obj"));
    open_dialog("export.bundle");
    EXPECT_FALSE(form().outside_agreed) << "each time";
}

TEST_F(OutsideTest, ALinkIsListedAsWhatItLeadsTo) {
    fs::create_symlink("../else/liver.obj", folder() / "case/mine.obj");
    open_with("mine.obj");
    EXPECT_TRUE(lists("else/liver.obj")) << ui().dump();
    EXPECT_TRUE(ui().is("New export/Export", ui::Is::disabled));
}

TEST_F(OutsideTest, AnotherListIsAnotherQuestionAndNoneIsNone) {
    open_with("../else/liver.obj");
    ui().click("New export/Form/Copy these files").frame();
    editor().document.change("Tool", [](document::Content& c) { c.scene.tool.file = "../else/liver.obj"; });
    ui().frame().frame();
    EXPECT_TRUE(ui().exists("New export/Form/Tool: " + real("else/liver.obj"))) << ui().dump();
    EXPECT_FALSE(form().outside_agreed);
    EXPECT_TRUE(ui().is("New export/Export", ui::Is::disabled));
    ui().click("New export/Form/With scene and organ").frame();
    EXPECT_FALSE(ui().exists("New export/Form/Copy these files")) << "the preset's clips are its own";
    ui().click("New export/Cancel").frame();
    open_with("own.obj");
    EXPECT_FALSE(ui().exists("New export/Form/Copy these files")) << ui().dump();
    EXPECT_FALSE(ui().is("New export/Export", ui::Is::disabled)) << ui().tip("New export/Export");
}

TEST_F(ExportTest, TheDialogKeepsItsSize) {
    open_dialog("export.open");
    const ui::Rect before = ui().rect("New export");
    form().size = static_cast<int>(app::export_sizes.size()) - 1;
    form().amounts = true;
    for (const std::string_view kind : output::output_titles()) {
        ui().click("New export/What/" + std::string(kind)).frame();
        const ui::Rect now = ui().rect("New export"), buttons = ui().rect("New export/Export");
        EXPECT_EQ(now.h, before.h) << kind;
        EXPECT_EQ(now.y, before.y) << kind;
        EXPECT_LT(buttons.y + buttons.h, now.y + now.h) << kind;
    }
}

TEST_F(ExportTest, ThePresetAsJson) {
    editor().commands.run("export.copy_json");
    EXPECT_EQ(ui().clipboard().text, write_preset(editor().document.preset()));
}

TEST_F(ExportTest, AFailureOnTheWayIsToldAndLeavesNothing) {
    fs::create_directory(folder() / "sub");
    open_dialog("export.video");
    set_file(path("sub/out.mp4"));
    form().size = 5;
    form().to = 0.2;
    editor().exports().start();
    ASSERT_TRUE(editor().exports().running()) << editor().exports().faults().front().text();
    ui().frame().frame();
    ASSERT_TRUE(editor().exports().running());
    fs::remove_all(folder() / "sub");
    EXPECT_TRUE(wait_until([&] { return !editor().exports().running(); }, [&] { ui().frame(); }));
    EXPECT_THAT(news(), HasSubstr("out.mp4: writing failed: No such file or directory"));
    EXPECT_FALSE(fs::exists(folder() / "sub"));
}

}  // namespace
}  // namespace lapfx::test
