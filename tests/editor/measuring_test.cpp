// The reference is measured as it is looked at, beside the UI: what has been measured so far is seen, what was stopped
// goes on, what is known stays known, and what was counted is drawn over the reference.
#include "app/measure/measuring.h"

#include "app/base/layouts.h"
#include "app/measure/amounts.h"
#include "app/measure/proposed_marks.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "editor/support/few_frames.h"
#include "match/frame/counted.h"
#include "match/use/measure_video.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

const std::string panel = "Workspace/Measure/", rows = panel + "Measure settings/";

class MeasuringTest : public SampleTest {
  protected:
    MeasuringTest() { begins.exact = false, begins.layout = "Compare"; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        editor().amounts().look.of = app::AmountsLook::on_organ;  // the others would begin it
        take_few_frames(editor());
        wait_for(
            [&] { return editor().reference().file() == few_frames() && editor().reference().video() != nullptr; });
    }
    void wait_for(const std::function<bool()>& so) {
        ASSERT_TRUE(wait_until(so, [&] { ui().frame().frame(); }));
    }
    void show_panel() {
        editor().layouts().bring_to_front("Measure");
        ui().frame().frame();
    }
    app::Measuring& measuring() { return editor().measuring(); }
    bool says(const std::string& text) { return ui().dump().find(text) != std::string::npos; }
    void set_redness(double value) {
        editor().document.change("Redness",
                                 [&](document::Content& c) { c.scene.reference.measure.blood.redness = value; });
    }
};

/// Nothing is known before.
class MeasuringAnew : public MeasuringTest {
  protected:
    MeasuringAnew() { shares_measured = false; }
};

TEST_F(MeasuringAnew, ItBeginsByItselfWhereItIsLookedAtAndComesToRest) {
    for (int i = 0; i < 80; ++i) ui().frame();
    EXPECT_FALSE(measuring().running()) << "nobody looks";
    EXPECT_EQ(measuring().found(), nullptr);
    show_panel();
    wait_for([&] { return measuring().found() != nullptr; });
    EXPECT_FALSE(measuring().stale());
    EXPECT_EQ(measuring().frames().size(), measuring().found()->frames.size());
    EXPECT_EQ(measuring().due(), std::numeric_limits<double>::infinity()) << "nothing is asked for any more";
    const std::uint64_t version = measuring().version();
    for (int i = 0; i < 80; ++i) ui().frame();
    EXPECT_EQ(measuring().version(), version) << "and it does not begin again";
}

TEST_F(MeasuringAnew, WhatWasStoppedGoesOnToTheSameEnd) {
    show_panel();
    wait_for([&] { return measuring().frames().size() >= 10; });
    ASSERT_TRUE(measuring().running());
    EXPECT_TRUE(ui().exists(panel + "Amounts")) << "the curves so far";
    ui().click(panel + "Cancel Measuring").frame();
    EXPECT_FALSE(measuring().running());
    editor().jobs.finish();  // the frame that was being measured
    ui().frame();
    ASSERT_EQ(measuring().found(), nullptr) << "this video is too short to be stopped in time";
    const std::size_t so_far = measuring().frames().size();
    EXPECT_GE(so_far, 10U);
    for (int i = 0; i < 80; ++i) ui().frame();
    EXPECT_FALSE(measuring().running()) << "it was stopped";
    EXPECT_EQ(measuring().frames().size(), so_far);
    EXPECT_TRUE(says("Measured in part: press Continue.")) << ui().dump();
    ui().click(panel + "Continue").frame();
    ASSERT_TRUE(measuring().running());
    EXPECT_GE(measuring().frames().size(), so_far) << "it does not start anew";
    wait_for([&] { return measuring().found() != nullptr; });
    VideoReader video(editor().reference().file());
    EXPECT_EQ(
        match::csv_of(*measuring().found()),
        match::csv_of(match::measure(video, match::measure_options(editor().document.scene().reference.measure))));
}

TEST_F(MeasuringAnew, AChangeThatDoesNotConcernItStopsNothing) {
    show_panel();
    wait_for([&] { return measuring().frames().size() >= 5; });
    const auto job = measuring().running();
    editor().document.change("Offset", [](document::Content& c) { c.scene.reference.offset += 1; });
    ui().frame().frame();
    EXPECT_TRUE(measuring().found() != nullptr || measuring().running() == job);
}

TEST_F(MeasuringTest, WhatIsKnownOfAnEarlierStateIsNotMeasuredAgain) {
    show_panel();
    wait_for([&] { return measuring().found() != nullptr; });
    const std::string before = match::csv_of(*measuring().found());
    set_redness(9);
    ui().frame().frame();
    EXPECT_TRUE(measuring().stale());
    EXPECT_TRUE(says("From before the last change")) << ui().dump();
    wait_for([&] { return !measuring().stale(); });
    EXPECT_NE(match::csv_of(*measuring().found()), before);
    editor().document.undo();
    ui().frame().frame();
    EXPECT_FALSE(measuring().stale()) << "it is known";
    EXPECT_FALSE(measuring().running());
    EXPECT_EQ(match::csv_of(*measuring().found()), before);
}

TEST_F(MeasuringAnew, WhatWasUnderWayForAnEarlierStateGoesOnWhenThatComesBack) {
    show_panel();
    wait_for([&] { return measuring().frames().size() >= 10; });
    set_redness(9);
    ui().frame();
    EXPECT_FALSE(measuring().running());
    editor().jobs.finish();
    editor().document.undo();
    ui().frame();
    EXPECT_GE(measuring().frames().size(), 10U);
    wait_for([&] { return measuring().found() != nullptr && !measuring().stale(); });
}

TEST_F(MeasuringAnew, WhatIsKnownOfAFileIsKnownToEveryDocument) {
    const auto open_copy = [&] {
        open_sample();
        editor().reference().choose(folder() / "copy.mp4");
        layout("Compare");
        show_panel();
    };
    std::filesystem::copy_file(editor().reference().file(), folder() / "copy.mp4");
    open_copy();
    wait_for([&] { return measuring().found() != nullptr && !measuring().stale(); });
    const match::Measurement* const found = measuring().found();
    const std::size_t memory = measuring().memory();
    EXPECT_GT(memory, 0U);
    editor().forget_document();
    EXPECT_EQ(measuring().found(), nullptr);
    EXPECT_EQ(measuring().memory(), memory) << "it is still held";
    open_copy();
    wait_for([&] {
        EXPECT_FALSE(measuring().running());
        return measuring().found() != nullptr;
    });
    EXPECT_EQ(measuring().found(), found);
    EXPECT_EQ(measuring().memory(), memory);
    wait_for([&] { return editor().reference().shown_frame() == editor().reference().frame(); });
    EXPECT_NE(measuring().counted(editor().reference().video()->time_of(25)), 0U) << "what was counted in it, too";
    ui().click(panel + "Measure").frame();
    EXPECT_TRUE(measuring().running()) << "anew where one asks for it";
    measuring().cancel();
    editor().forget_document();
    std::filesystem::last_write_time(folder() / "copy.mp4",
                                     std::filesystem::last_write_time(folder() / "copy.mp4") + std::chrono::seconds(1));
    open_copy();
    wait_for([&] { return measuring().running() != nullptr; });
    EXPECT_EQ(measuring().found(), nullptr) << "somebody has written to it";
}

TEST_F(MeasuringAnew, WhatWasCountedIsDrawnOverTheReferenceWhereItIsMeasured) {
    const auto shown = [&] {
        const ui::StoredImage* const image = editor().images.find(editor().reference().shown().whole().image);
        return image != nullptr ? image->pixels : std::vector<std::uint8_t>();
    };
    wait_for([&] { return editor().reference().shown_frame() >= 0; });
    editor().timeline.seek(5.5);
    wait_for([&] { return editor().reference().shown_frame() == editor().reference().frame(); });
    const std::vector<std::uint8_t> plain = shown();
    EXPECT_EQ(plain, editor().reference().image().pixels);
    ui().click("Workspace/Reference/Counted").frame();
    EXPECT_TRUE(editor().reference().shown().shows_counted);
    EXPECT_TRUE(says("Not measured yet")) << ui().dump();
    wait_for([&] { return measuring().found() != nullptr; });
    ui().frame();
    EXPECT_TRUE(editor().reference().shown().counted_shown());
    EXPECT_FALSE(says("Not measured yet"));
    const std::vector<std::uint8_t> counted = shown();
    EXPECT_NE(counted, plain);
    EXPECT_EQ(editor().reference().image().pixels, plain) << "colours are read of the frame as it is";
    // The same as the library draws over that frame.
    VideoReader video(editor().reference().file());
    Image drawn;
    const double wanted = video.time_of(editor().reference().shown_frame());
    match::MeasureOptions options = match::measure_options(editor().document.scene().reference.measure);
    options.measured = [&](const Image& frame, const match::Estimator* estimator, const match::FrameAmounts& amounts) {
        if (amounts.time != wanted) return;
        drawn = frame;
        if (estimator != nullptr) match::draw_counted(drawn, *estimator, amounts);
    };
    match::measure(video, options);
    ASSERT_EQ(drawn.pixels.size(), counted.size());
    std::size_t off = 0;
    for (std::size_t i = 0; i < counted.size(); ++i) off += std::abs(counted[i] - drawn.pixels[i]) > 12 ? 1 : 0;
    EXPECT_LT(off, counted.size() / 50) << "its veil has fewer pixels";
    editor().timeline.seek(2);
    wait_for([&] { return editor().reference().shown_frame() == editor().reference().frame(); });
    EXPECT_TRUE(editor().reference().shown().counted_shown()) << "also of other frames";
    set_redness(9);
    ui().frame().frame();
    EXPECT_FALSE(editor().reference().shown().counted_shown()) << "nothing was counted like that";
    ui().click("Workspace/Reference/Counted").frame();
    EXPECT_EQ(shown(), editor().reference().image().pixels);
}

TEST_F(MeasuringTest, MarksAreProposedAndTaken) {
    const auto marks = [&]() -> const ReferenceMarks& { return editor().document.scene().reference.marks; };
    editor().document.change("Blood", [](document::Content& c) { c.scene.reference.marks.blood_starts = 1; });
    show_panel();
    wait_for([&] { return measuring().found() != nullptr; });
    ui().frame().frame();
    const match::Episode veil = measuring().found()->veil;
    ASSERT_TRUE(veil.onset && veil.peak_at) << "the sample has smoke";
    const ReferenceMarks proposed = app::marks_of(*measuring().found());
    EXPECT_NEAR(proposed.smoke_starts, *veil.onset, 1e-4);
    EXPECT_NEAR(proposed.smoke_peaks, *veil.peak_at, 1e-4);
    EXPECT_FALSE(ui().exists("**/Blood starts?")) << "it is marked already";
    ASSERT_TRUE(ui().exists("**/Smoke starts?")) << ui().dump();
    const std::size_t steps = editor().document.done();
    const ui::Rect ghost = ui().rect("**/Smoke starts?");
    ui().click("**/Smoke starts?").frame();
    EXPECT_EQ(marks().smoke_starts, proposed.smoke_starts);
    EXPECT_EQ(marks().smoke_peaks, -1) << "one at a time";
    EXPECT_EQ(editor().document.done(), steps + 1);
    EXPECT_FALSE(ui().exists("**/Smoke starts?"));
    EXPECT_NEAR(ui().rect("**/Smoke starts").center().x, ghost.center().x, 1);
    ui().drag("**/Smoke starts", {40, 0}).frame();
    EXPECT_GT(marks().smoke_starts, proposed.smoke_starts + 0.1) << "and moved as any other";
    EXPECT_EQ(marks().smoke_peaks, -1);
    editor().document.undo();
    editor().document.undo();
    ui().frame().frame();
    EXPECT_TRUE(ui().exists("**/Smoke starts?"));
    ui().click(rows + "Whole reference/Take proposed marks").frame();
    EXPECT_EQ(marks().smoke_starts, proposed.smoke_starts);
    EXPECT_EQ(marks().smoke_peaks, proposed.smoke_peaks);
    EXPECT_EQ(marks().smoke_clears, proposed.smoke_clears);
    EXPECT_EQ(marks().blood_starts, 1) << "what is marked stays";
    EXPECT_EQ(editor().document.done(), steps + 1) << "one step";
    ui().frame();
    EXPECT_FALSE(ui().exists("**/Smoke peaks?"));
}

TEST(MeasuredVideos, TheLastThatWereUsedAreKeptUnderAllThatTheyDependOn) {
    app::MeasuredVideos videos;
    const auto key = [](const std::string& file, int written = 1, double redness = 2) {
        app::MeasuredVideos::Key made{.file = file, .written = {}, .measure = {}};
        made.written += std::chrono::seconds(written);
        made.measure.blood.redness = redness;
        return made;
    };
    std::vector<std::shared_ptr<const app::MeasuredVideo>> all;
    for (const char* file : {"a", "b", "c", "d"}) {
        all.push_back(std::make_shared<const app::MeasuredVideo>());
        videos.keep(key(file), all.back());
    }
    EXPECT_EQ(videos.find(key("a", 2)), nullptr) << "written since";
    EXPECT_EQ(videos.find(key("a", 1, 3)), nullptr) << "measured otherwise";
    EXPECT_EQ(videos.find(key("a")), all[0]);
    const auto anew = std::make_shared<const app::MeasuredVideo>();
    videos.keep(key("c"), anew);
    EXPECT_EQ(videos.find(key("c")), anew);
    EXPECT_FALSE(videos.holds(*all[2])) << "it is another's place";
    videos.keep(key("e"), std::make_shared<const app::MeasuredVideo>());
    EXPECT_EQ(videos.find(key("b")), nullptr) << "it was unused for longest";
    EXPECT_EQ(videos.find(key("a")), all[0]);
    EXPECT_TRUE(videos.holds(*all[3]));
}

}  // namespace
}  // namespace lapfx::test
