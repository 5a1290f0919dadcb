// Exports with the reference beside each picture and the curves of both below; and how long an export will take.
#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "app/files/exports.h"
#include "app/measure/measure_bench.h"
#include "app/measure/measuring.h"
#include "app/measure/side_by_side.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "editor/support/few_frames.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int small_size = 5;  // of app::export_sizes: 640 x 512
constexpr glm::ivec2 small_px{640, 512};

class ExportBeside : public SampleTest {
  protected:
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        take_few_frames(editor());
        ui().frame().frame();
    }
    void open_few_frames() {
        open_sample();
        take_few_frames(editor());
        ui().frame().frame();
    }
    app::Exports& exports() { return editor().exports(); }
    std::string path(const std::string& name) const { return (folder() / name).string(); }
    void ask_for(const char* command, const std::string& name, bool beside) {
        editor().commands.run(command);
        ui().frame().frame();
        exports().form.file() = path(name);
        exports().form.size = small_size;
        exports().form.beside = beside;
        ui().frame();
    }
    void wait() {
        ASSERT_TRUE(wait_until([&] { return !exports().running(); }, [&] { ui().frame(); }));
        ui().frame().frame();
    }
    /// What is known of the reference is not measured again.
    void measure() {
        editor().measuring().start();
        ASSERT_TRUE(wait_until([&] { return editor().measuring().found() != nullptr; }, [&] { ui().frame(); }));
    }
    cv::Mat exported_picture(const std::string& name, bool beside) {
        ask_for("export.picture", name, beside);
        exports().form.at = 6;
        ui().frame().click("New export/Export");
        wait();
        return cv::imread(path(name));
    }
    /// Columns of a part that have a pixel near a colour.
    static int columns_with(const cv::Mat& part, ui::Color color) {
        const cv::Scalar wanted(color.b, color.g, color.r), by = cv::Scalar::all(24);
        cv::Mat near, any;
        cv::inRange(part, wanted - by, wanted + by, near);
        cv::reduce(near, any, 0, cv::REDUCE_MAX);
        return cv::countNonZero(any);
    }
};

TEST_F(ExportBeside, APictureHasBothAndTheirCurves) {
    const cv::Mat plain = exported_picture("plain.png", false), both = exported_picture("both.png", true);
    ASSERT_EQ(plain.size(), cv::Size(small_px.x, small_px.y));
    const glm::ivec2 written = exports().written_px();
    ASSERT_EQ(both.size(), cv::Size(written.x, written.y));
    EXPECT_EQ(written.x, 640 + 4 + 640) << "the reference is 5:4";
    EXPECT_EQ(written % 2, glm::ivec2(0));
    EXPECT_EQ(cv::norm(both(cv::Rect(0, 0, 640, 512)), plain, cv::NORM_INF), 0) << "the preview, to the byte";
    // The reference at 6.5 s, as it is half a second on.
    VideoReader video(editor().reference().file());
    Image frame;
    ASSERT_TRUE(video.read(video.frame_at(6.5005), frame));
    cv::Mat wanted;
    cv::resize(cv::Mat(frame.height, frame.width, CV_8UC4, frame.pixels.data()), wanted, {640, 512}, 0, 0,
               cv::INTER_LINEAR);
    cv::cvtColor(wanted, wanted, cv::COLOR_RGBA2BGR);
    EXPECT_EQ(cv::norm(both(cv::Rect(644, 0, 640, 512)), wanted, cv::NORM_INF), 0);
    EXPECT_EQ(cv::countNonZero(cv::Mat(both(cv::Rect(640, 0, 4, 512))).reshape(1)), 0) << "black between them";
    const cv::Mat strip = both(cv::Rect(0, 512, written.x, written.y - 512));
    const ui::Theme& theme = ui::dark_theme();
    const cv::Mat blood = strip(cv::Rect(0, 0, strip.cols / 2, strip.rows)),
                  veil = strip(cv::Rect(strip.cols / 2, 0, strip.cols / 2, strip.rows));
    // Both curves span what the video has of the scene, 7.5 s of 12; the legend alone has some ten columns.
    EXPECT_GT(columns_with(blood, theme.series[app::blood_series]), 200);
    EXPECT_GT(columns_with(blood, theme.series[1]), 200) << "the reference's";
    EXPECT_GT(columns_with(veil, theme.series[app::smoke_series]), 200);
    EXPECT_GT(columns_with(veil, theme.series[1]), 200);
}

TEST_F(ExportBeside, TheReferenceLiesAsItIsPlaced) {
    editor().document.change("Place", [](document::Content& c) {
        c.scene.reference.aspect = 2;
        c.scene.reference.placement.scale = 0.5;
    });
    ui().frame();
    measure();
    const cv::Mat both = exported_picture("placed.png", true);
    ASSERT_EQ(both.cols, 640 + 4 + 1024) << "twice as wide as high";
    const cv::Mat right = both(cv::Rect(644, 0, 1024, 512));
    EXPECT_EQ(cv::norm(right(cv::Rect(0, 0, 1024, 124)), cv::NORM_INF), 0) << "black above";
    EXPECT_EQ(cv::norm(right(cv::Rect(0, 0, 252, 512)), cv::NORM_INF), 0) << "and beside";
    EXPECT_GT(cv::mean(right(cv::Rect(300, 150, 400, 200)))[2], 30);
}

TEST_F(ExportBeside, WithoutAReferenceItIsRefusedInPlace) {
    editor().reference().remove();
    ui().frame().frame();
    ask_for("export.picture", "out.png", true);
    EXPECT_EQ(exports().fault_at("--beside"), "there is no reference: open a surgery video first");
    EXPECT_TRUE(ui().is("New export/Export", ui::Is::disabled));
    ui().click("New export/Form/Beside the reference, with curves").frame();
    EXPECT_FALSE(ui().is("New export/Export", ui::Is::disabled));
}

TEST_F(ExportBeside, WhatCannotBeMeasuredIsSaidOnThePage) {
    app::Compared compared{.frame = {64, 64}, .duration = 1};
    cv::imwrite(path("black_0.png"), cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(0)));
    cv::imwrite(path("black_1.png"), cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(0)));
    VideoReader video(path("black_%d.png"));
    const Scene& scene = editor().document.scene();
    match::PreviewCurve curve(editor().preview.organ_of(scene), {}, {});
    const app::BothWanted wanted{.scene = scene,
                                 .preset = editor().document.preset(),
                                 .video = video,
                                 .options = {},
                                 .found = nullptr,
                                 .curve = curve};
    EXPECT_TRUE(measure_both(compared, wanted, {}));
    EXPECT_THAT(compared.words, testing::StartsWith("The reference is not measured: "));
    EXPECT_TRUE(compared.of_preview.empty());
    EXPECT_FALSE(measure_both(compared, wanted, [](double) { return false; })) << "it was stopped";
}

TEST_F(ExportBeside, BothAreMeasuredAtTheTimesOfTheScene) {
    const Scene& scene = editor().document.scene();
    app::Compared compared{.frame = {64, 64}, .duration = scene.duration};
    compared.reference.offset = 0.5;
    match::Measurement found;  // 0.5 to 2.5 s of the video are 0 to 2 s of the scene
    for (int i = 0; i <= 10; ++i) {
        match::FrameAmounts& frame = found.frames.emplace_back();
        frame.time = 0.5 + 0.2 * i;
        frame.blood = frame.veil = {.value = 0.1, .low = 0.05, .high = 0.15};
    }
    VideoReader video(editor().reference().file());
    match::PreviewCurve curve(editor().preview.organ_of(scene),
                              {.clip_folders = editor().options().clip_folders, .wait_for_clips = true},
                              {.size = match::preview_size({5, 4}, 0.0, 96)});
    const app::BothWanted wanted{.scene = scene,
                                 .preset = editor().document.preset(),
                                 .video = video,
                                 .options = {},
                                 .found = &found,
                                 .curve = curve};
    ASSERT_TRUE(measure_both(compared, wanted, {}));
    ASSERT_FALSE(compared.of_preview.empty()) << compared.words;
    EXPECT_NEAR(compared.of_preview.front().time, 0.0, 1e-9);
    EXPECT_NEAR(compared.of_preview.back().time, 2.0, 0.11);
}

TEST_F(ExportBeside, ItIsComparedBesideTheUiAndCanBeGivenUp) {
    start({1440, 900}, false);
    open_few_frames();
    const auto there = [&] {
        return editor().reference().video() != nullptr && editor().preview.organ_of(editor().document.scene());
    };
    ASSERT_TRUE(wait_until(there, [&] { ui().frame(); }));
    measure();
    ask_for("export.picture", "both.png", true);
    exports().form.at = 6;
    ui().frame().click("New export/Export").frame().frame();
    ASSERT_TRUE(wait_until([&] { return exports().progress_text() == "comparing"; }, [&] { ui().frame(); }));
    EXPECT_TRUE(exports().loading());
    ASSERT_NE(exports().job(), nullptr);
    exports().cancel();
    ui().frame().frame();
    EXPECT_FALSE(exports().running());
    EXPECT_TRUE(fs::is_empty(folder()));
    EXPECT_THAT(ui().dump(), HasSubstr("cancelled: nothing was written"));
    ask_for("export.picture", "both.png", true);
    exports().form.at = 6;
    ui().frame().click("New export/Export").frame();
    wait();
    EXPECT_THAT(ui().dump(), HasSubstr("Exported both.png, checked"));
    EXPECT_EQ(cv::imread(path("both.png")).cols, exports().written_px().x);
}

TEST_F(ExportBeside, HowLongItTakesIsTriedBeforeItBegins) {
    start({1440, 900}, false);
    open_few_frames();
    ASSERT_TRUE(wait_until([&] { return editor().preview.organ_of(editor().document.scene()) != nullptr; },
                           [&] { ui().frame(); }));
    ask_for("export.video", "out.mp4", false);
    EXPECT_LT(exports().seconds_expected(), 0);
    ASSERT_TRUE(wait_until([&] { return exports().seconds_expected() > 0; }, [&] { ui().frame(); }));
    ui().frame();
    EXPECT_THAT(ui().dump(), HasSubstr("300 frames of 640 x 512 pixels, 12.00 s. Takes about "));
    const double all = exports().seconds_expected();
    exports().form.to = 6;
    EXPECT_LT(exports().seconds_expected(), all) << "of half as many frames";
    EXPECT_GT(exports().seconds_expected(), 0.4 * all);
    exports().form.to = 12;
    exports().form.size = 0;
    ui().frame().frame();
    EXPECT_LT(exports().seconds_expected(), 0) << "of another size it is tried again";
    EXPECT_TRUE(fs::is_empty(folder()));
}

TEST_F(ExportBeside, TheCommandHasTheReference) {
    ask_for("export.picture", "both.png", true);
    EXPECT_THAT(exports().command(), HasSubstr(" --beside " + editor().reference().file().lexically_normal().string()));
    exports().form.beside = false;
    EXPECT_THAT(exports().command(), testing::Not(HasSubstr("--beside")));
}

}  // namespace
}  // namespace lapfx::test
