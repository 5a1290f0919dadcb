// The amounts panel, where it shows what is in the view: reference and preview, measured alike, over each other on the
// scene's time.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>

#include "app/base/layouts.h"
#include "app/measure/amounts.h"
#include "app/measure/measuring.h"
#include "app/measure/preview_measuring.h"
#include "app/reference/reference.h"
#include "app/tuning/parameters.h"
#include "app/tuning/tuning.h"
#include "editor/support/editor_test.h"
#include "editor/support/few_frames.h"
#include "lapfx/authoring/video.h"
#include "match/compare/color_likeness.h"
#include "match/compare/likeness_words.h"
#include "match/use/measure_video.h"
#include "match/video/measure.h"
#include "support/clips.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double settled = 1;  // s: longer than a change takes to be followed
const std::string bar = "Workspace/Amounts/Plots/", plots = "**/Measured plots/";

/// What a plot gives as CSV: a column for each series, nothing where it has no value.
struct Table {
    std::vector<std::string> names;
    std::vector<std::vector<std::optional<double>>> rows;

    /// Times and values of the series whose name begins so.
    std::vector<std::pair<double, double>> of(const std::string& name) const {
        std::vector<std::pair<double, double>> points;
        for (std::size_t c = 1; c < names.size(); ++c) {
            if (!names[c].starts_with(name)) continue;
            for (const auto& row : rows)
                if (row[c]) points.emplace_back(*row[0], *row[c]);
        }
        return points;
    }
};

Table read_table(const std::string& csv) {
    Table table;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells;
        std::size_t from = 0;
        for (std::size_t comma = 0; comma != std::string::npos; from = comma + 1)
            comma = line.find(',', from), cells.push_back(line.substr(from, comma - from));
        if (table.names.empty()) {
            table.names = cells;
            continue;
        }
        auto& row = table.rows.emplace_back();
        for (const std::string& cell : cells)
            row.push_back(cell.empty() ? std::nullopt : std::optional(std::stod(cell)));
    }
    return table;
}

class MeasuredAmounts : public SampleTest {
  protected:
    MeasuredAmounts() {
        begins.window = {1000, 700};
        measures_preview = true;
    }
    void SetUp() override {
        SampleTest::SetUp();
        if (!IsSkipped()) shorten();
    }
    void shorten() {
        take_few_frames(editor());
        editor().document.change("Short", [&](document::Content& c) { c.scene.duration = lasts; });
        layout("Compare");
    }
    void settle() { ui().frame(settled).frame().frame(settled).frame().settle(); }
    double lasts = 5;  ///< s: of the scene, each 0.2 s of which are drawn and measured
    app::Measuring& measuring() { return editor().measuring(); }
    app::PreviewMeasuring& preview() { return editor().preview_measuring(); }
    Table table(const std::string& plot) {
        ui().click(plots + plot, {.at = {0.5F, 0.6F}}).key('C', ui::Mods::command).frame();
        return read_table(ui().clipboard().text);
    }
    bool says(const std::string& text) { return ui().dump().find(text) != std::string::npos; }
    void wait_for(const std::function<bool()>& so) {
        ASSERT_TRUE(wait_until(so, [&] { ui().frame().frame(); }));
    }
};

/// A short curve tells when one is measured, and when not.
class BriefAmounts : public MeasuredAmounts {
  protected:
    BriefAmounts() { lasts = 2; }
};

TEST_F(MeasuredAmounts, BothAreDrawnOnTheScenesTime) {
    settle();
    EXPECT_TRUE(says("The reference is not measured yet"));
    EXPECT_TRUE(table("Veil").of("Ref").empty());
    ui().click(bar + "Measure").frame().frame();
    ASSERT_NE(measuring().found(), nullptr);
    settle();
    const Scene& scene = editor().document.scene();
    const match::Likeness likeness =
        match::likeness_of(preview().frames(), measuring().found()->frames, scene.reference.offset);
    for (const match::Clause& clause : match::clauses(likeness, scene.events))
        EXPECT_TRUE(says(clause.sentence())) << ui().dump();
    const double offset = editor().document.scene().reference.offset, length = editor().timeline.duration();
    ASSERT_EQ(offset, 0.5);
    for (const bool blood : {true, false}) {
        const Table shown = table(blood ? "Blood" : "Veil");
        std::vector<std::pair<double, double>> theirs, ours;
        for (const match::FrameAmounts& f : measuring().found()->frames)
            if (f.time - offset >= 0 && f.time - offset <= length && (blood ? f.blood_measurable() : f.measurable()))
                theirs.emplace_back(f.time - offset, 100 * (blood ? f.blood.value : f.veil.value));
        for (const match::FrameAmounts& f : preview().frames())
            if (blood ? f.blood_measurable() : f.measurable())
                ours.emplace_back(f.time, 100 * (blood ? f.blood.value : f.veil.value));
        EXPECT_GT(theirs.size(), 25U);
        EXPECT_GT(ours.size(), 20U);
        EXPECT_THAT(shown.of("Ref"), testing::Pointwise(testing::Eq(), theirs));
        EXPECT_THAT(shown.of("Pre"), testing::Pointwise(testing::Eq(), ours));
    }
    editor().document.change("Offset", [](document::Content& c) { c.scene.reference.offset = 1.5; });
    const std::uint64_t before = preview().version();
    settle();
    const auto moved = table("Veil").of("Ref");
    ASSERT_FALSE(moved.empty());
    const auto& first = *std::find_if(measuring().found()->frames.begin(), measuring().found()->frames.end(),
                                      [](const match::FrameAmounts& f) { return f.time >= 1.5 && f.measurable(); });
    EXPECT_NEAR(moved.front().first, first.time - 1.5, 1e-9);
    EXPECT_EQ(moved.front().second, 100 * first.veil.value);
    EXPECT_EQ(preview().version(), before) << "the preview is the same";
}

/// "blood 12.3": of the line of colours.
std::string shown_color(const std::string& name, const std::optional<double>& apart) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %.1f", name.c_str(), apart.value_or(-1));
    return apart ? text : name + " unknown";
}

/// The colours of smoke are told of pictures of full size.
class MeasuredColours : public MeasuredAmounts {
  protected:
    MeasuredColours() { measured_side = 256; }
};

TEST_F(MeasuredColours, HowNearColoursAreIsToldAndLeadsToWhatMendsIt) {
    editor().document.change("Bleeds", [](document::Content& c) {
        c.preset.bleeding.speed = 12, c.preset.bleeding.max_extent = 30;
        c.preset.smoke.haze.accumulation = 0.2;
    });
    settle();
    EXPECT_FALSE(says("Delta E")) << "the reference is not measured";
    ui().click(bar + "Measure").frame().frame();
    settle();
    EXPECT_FALSE(says("Delta E")) << "the plots need the room";
    ui().size = {1000, 780};
    ui().frame().frame();
    const auto apart = [&] {  // the scene's 5 s, from 0.5 s of the reference on
        return match::likeness_of(preview().colors()->at_peak(0, 5).colors,
                                  measuring().colors()->at_peak(0.5, 5.5).colors);
    };
    match::ColorLikeness likeness = apart();
    ASSERT_TRUE(likeness.smoke && likeness.tissue);
    EXPECT_TRUE(says(shown_color("blood", likeness.blood) + ",")) << ui().dump();
    EXPECT_TRUE(says(shown_color("smoke", likeness.smoke) + ",")) << ui().dump();
    EXPECT_TRUE(says(shown_color("tissue", likeness.tissue))) << ui().dump();
    const double before = *likeness.smoke;
    editor().document.change("Other", [](document::Content& c) {
        c.preset.smoke.haze.color = c.preset.smoke.plume.color = {0.05, 0.1, 0.05};
    });
    settle();
    likeness = apart();
    ASSERT_TRUE(likeness.smoke);
    EXPECT_GT(std::abs(*likeness.smoke - before), 3);
    EXPECT_TRUE(says(shown_color("smoke", likeness.smoke))) << ui().dump();
    ui().click("**/Colours/" + shown_color("smoke", likeness.smoke) + ",").frame().frame();
    EXPECT_EQ(editor().tuning().current, app::parameters().find("smoke.haze.color"));
    ui().click("**/Colours/" + shown_color("tissue", likeness.tissue)).frame().frame();
    EXPECT_THAT(ui().focused(), HasSubstr("Exposure"));
    EXPECT_TRUE(editor().layouts().seen("Scene"));
}

TEST_F(MeasuredAmounts, ColoursAreThoseThatMeasuringTheVideoFinds) {
    settle();
    ui().click(bar + "Measure").frame().frame();
    settle();
    ASSERT_NE(measuring().colors(), nullptr);
    VideoReader video(editor().reference().file());
    match::MeasureOptions options = match::measure_options(editor().document.scene().reference.measure);
    match::PeakColors peaks(0.5, 5.37);  // to the end of a step
    options.measured = [&](const Image& frame, const match::Estimator* estimator, const match::FrameAmounts& amounts) {
        peaks.add(frame, estimator, amounts);
    };
    match::measure(video, options);
    const match::ColorsAtPeak found = measuring().colors()->at_peak(0.5, 5.37);
    ASSERT_TRUE(found.colors.smoke && found.colors.tissue);
    ASSERT_TRUE(found.colors.blood && peaks.found().blood);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR((*found.colors.blood)[c], (*peaks.found().blood)[c], 1e-12) << "a sum in another order";
    EXPECT_EQ(found.colors.smoke, peaks.found().smoke);
    EXPECT_EQ(found.colors.tissue, peaks.found().tissue);
    EXPECT_EQ(found.veil.value, peaks.at_peak().veil.value);
}

TEST_F(MeasuredAmounts, WhatDiffersLeadsToWhatMendsIt) {
    editor().document.change("Dense", [](document::Content& c) { c.preset.smoke.haze.accumulation *= 15; });
    settle();
    ui().click(bar + "Measure").frame().frame();
    settle();
    std::size_t parameters = 0, events = 0;
    for (const double factor : {1.0, 0.01}) {
        editor().document.change("Thin", [&](document::Content& c) { c.preset.smoke.haze.accumulation *= factor; });
        settle();
        const Scene& scene = editor().document.scene();
        for (const match::Clause& clause :
             match::clauses(match::likeness_of(preview().frames(), measuring().found()->frames, scene.reference.offset),
                            scene.events)) {
            if (clause.key.empty()) continue;
            editor().selected.clear();
            ui().click("**/" + clause.sentence()).frame().frame();
            if (editor().selected.empty()) {
                EXPECT_EQ(editor().tuning().current, app::parameters().find(clause.key)) << clause.key;
                ++parameters;
            } else {
                EXPECT_THAT(clause.key, StartsWith("events." + std::to_string(editor().selected.front()) + "."));
                ++events;
            }
        }
    }
    EXPECT_GT(parameters, 0U) << ui().dump();
    EXPECT_GT(events, 0U);
}

TEST_F(MeasuredAmounts, ThePreviewIsMeasuredNearTheTruthThatIsAskedFor) {
    settle();
    ASSERT_FALSE(preview().frames().empty());
    EXPECT_TRUE(preview().truths().empty());
    EXPECT_TRUE(table("Veil").of("Tru").empty());
    ui().click(bar + "Truth");
    settle();
    const auto& measured = preview().frames();
    const auto& truth = preview().truths();
    ASSERT_EQ(truth.size(), measured.size());
    EXPECT_EQ(table("Veil").of("Tru").size(), truth.size());
    double most = 0, veil_off = 0, blood_off = 0, count = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        EXPECT_EQ(truth[i].time, measured[i].time);
        most = std::max(most, truth[i].veil);
        if (!measured[i].blood_measurable()) continue;
        veil_off += std::abs(measured[i].veil.value - truth[i].veil);
        blood_off += std::abs(measured[i].blood.value - truth[i].blood);
        ++count;
    }
    EXPECT_GT(most, 0.1) << "there is smoke to be measured";
    EXPECT_LT(veil_off / count, 0.05);
    EXPECT_LT(blood_off / count, 0.05);
    const std::uint64_t version = preview().version();
    ui().click(bar + "Truth");
    settle();
    EXPECT_FALSE(preview().stale()) << "less costs nothing";
    EXPECT_EQ(preview().version(), version);
}

TEST_F(BriefAmounts, TheSameSceneIsMeasuredTheSame) {
    settle();
    const std::vector<match::FrameAmounts> first = preview().frames();
    ASSERT_GT(first.size(), 9U);
    EXPECT_EQ(first.front().time, 0.0);
    EXPECT_EQ(first.back().time, editor().timeline.duration());
    editor().document.change("Exposure", [](document::Content& c) { c.scene.camera.exposure *= 0.7; });
    settle();
    EXPECT_NE(preview().frames()[first.size() / 2].veil.value, first[first.size() / 2].veil.value);
    start({1000, 700});
    open_sample();
    shorten();
    settle();
    ASSERT_EQ(preview().frames().size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(preview().frames()[i].blood.value, first[i].blood.value) << i;
        EXPECT_EQ(preview().frames()[i].veil.value, first[i].veil.value) << i;
        EXPECT_EQ(preview().frames()[i].flags, first[i].flags) << i;
    }
}

TEST_F(BriefAmounts, NothingIsMeasuredWhileNobodyLooksOrChangesSettle) {
    layout("Tune");
    ui().frame(settled).frame().frame(settled).settle();
    EXPECT_TRUE(preview().frames().empty());
    layout("Compare");
    settle();
    EXPECT_FALSE(preview().frames().empty());
    ui().click("**/Amounts/On organ");
    editor().document.change("Exposure", [](document::Content& c) { c.scene.camera.exposure *= 0.7; });
    const std::uint64_t version = preview().version();
    settle();
    EXPECT_EQ(preview().version(), version) << "what the organ has is looked at";
    ui().click("**/Amounts/In view").frame();
    EXPECT_TRUE(says("The preview's curve is from before the last change")) << ui().dump();
    settle();
    EXPECT_NE(preview().version(), version);
    EXPECT_FALSE(says("from before the last change"));
}

TEST_F(BriefAmounts, NoCurveStaysBesideAnotherReferenceOrScene) {
    settle();
    ASSERT_FALSE(table("Veil").of("Pre").empty());
    editor().reference().choose(write_clip(folder() / "v.avi", 30, {64, 32}, 10));
    ui().frame().frame();
    ASSERT_EQ(editor().reference().file().filename(), "v.avi");
    EXPECT_TRUE(preview().frames().empty()) << "it was measured in the shape of the other one";
    EXPECT_FALSE(says("The preview's curve is from before the last change")) << ui().dump();
    settle();
    EXPECT_FALSE(preview().frames().empty());
    open_sample();
    ui().frame().frame();
    EXPECT_TRUE(preview().frames().empty()) << "another document";
    shorten();
    settle();
    EXPECT_FALSE(table("Veil").of("Pre").empty());
}

/// The layout Compare as a usual screen has it, with pictures and colours beside the curves.
class CurvesBesidePictures : public MeasuredColours {
  protected:
    CurvesBesidePictures() { begins.window = {1440, 900}; }
};

TEST_F(CurvesBesidePictures, CurvesAreHighEnoughToBeRead) {
    settle();
    ui().click(bar + "Measure").frame().frame();
    settle();
    ASSERT_TRUE(says("Delta E")) << ui().dump();
    constexpr float around = 46, least = 90;  // px: of names and numbers above and below a curve, and of the curve
    const ui::Rect area = ui().rect("**/Measured plots");
    for (const char* const plot : {"Blood", "Veil"}) {
        const ui::Rect rect = ui().rect(plots + plot);
        EXPECT_GE(rect.h, around + least) << plot;
        EXPECT_LE(rect.bottom(), area.bottom() + 0.5F) << plot << " is seen without scrolling";
    }
}

TEST_F(BriefAmounts, AClickGoesToThatTime) {
    settle();
    ui().click(plots + "Blood", {.at = {0.5F, 0.6F}}).frame();
    EXPECT_GT(editor().timeline.time, 0.3 * editor().timeline.duration());
    EXPECT_LT(editor().timeline.time, 0.8 * editor().timeline.duration());
}

TEST_F(BriefAmounts, WhatIsWrongIsToldInPlace) {
    settle();
    editor().document.change("Organ", [](document::Content& c) { c.scene.organ.file = "gone.glb"; });
    settle();
    EXPECT_TRUE(preview().frames().empty());
    EXPECT_TRUE(says("gone.glb"));
    editor().document.undo();
    settle();
    EXPECT_FALSE(preview().frames().empty());
    EXPECT_FALSE(says("gone.glb"));
}

TEST_F(MeasuredAmounts, BesideTheUiItIsStoppedAndBegunAgain) {
    start({1440, 900}, false);
    open_sample();
    shorten();
    wait_for([&] { return !preview().frames().empty() && preview().busy(); });
    EXPECT_TRUE(says("Measuring: "));
    ui().click(bar + "Stop measuring").frame();
    EXPECT_FALSE(preview().busy());
    EXPECT_TRUE(preview().frames().empty()) << "a part of a curve";
    for (int i = 0; i < 60; ++i) ui().frame();
    EXPECT_FALSE(preview().busy());
    EXPECT_FALSE(measuring().running());
    EXPECT_TRUE(says("Measuring the preview was stopped")) << ui().dump();
    ui().click(bar + "Again");
    wait_for([&] { return !preview().stale() && !preview().busy(); });
    const std::vector<match::FrameAmounts> alone = preview().frames();
    editor().document.change("Exposure", [](document::Content& c) { c.scene.camera.exposure *= 0.7; });
    wait_for([&] { return preview().busy(); });
    EXPECT_EQ(preview().frames().size(), alone.size()) << "what is known stays until it can be replaced";
    EXPECT_TRUE(preview().stale());
    editor().document.undo();
    ui().frame();
    EXPECT_FALSE(preview().busy()) << "a change cancels it";
    EXPECT_FALSE(preview().stale()) << "this is known";
    editor().document.redo();
    wait_for([&] { return preview().busy(); });
    ui().click(bar + "Stop measuring").frame();
    EXPECT_TRUE(says("Measuring the preview was stopped")) << "no words about the scene before";
}

}  // namespace
}  // namespace lapfx::test
