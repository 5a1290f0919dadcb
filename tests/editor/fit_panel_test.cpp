// The Fit panel: what may change is found beside the UI, shown, and taken as one undo step.
#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "app/base/layouts.h"
#include "app/clips/clip_shelf.h"
#include "app/measure/fit_reporting.h"
#include "app/measure/fitting.h"
#include "app/measure/measuring.h"
#include "app/reference/reference.h"
#include "app/tuning/key_titles.h"
#include "app/tuning/parameters.h"
#include "app/tuning/tuning.h"
#include "document/document.h"
#include "editor/support/editor_test.h"
#include "editor/support/few_frames.h"
#include "lapfx/authoring/preview.h"
#include "match/fit/worse.h"
#include "match/report/report.h"
#include "output/files.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string panel = "Workspace/Fit/";

class FitPanel : public SampleTest {
  protected:
    FitPanel() { begins.layout = "Compare"; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        take_few_frames(editor());
        editor().document.change("Short", [](document::Content& c) { c.scene.duration = 3; });
        editor().layouts().bring_to_front("Fit");
        ui().frame().frame();
    }
    app::Fitting& fitting() { return editor().fitting(); }
    void press(const std::string& button) { ui().click(panel + button).frame().frame().frame(); }
    bool says(const std::string& text) { return ui().dump().find(text) != std::string::npos; }
    std::size_t steps() { return editor().document.done(); }
};

TEST_F(FitPanel, TheProposalIsTakenAsOneStep) {
    const document::Content before = editor().document.content();
    const std::size_t steps_before = steps();
    press("Propose");
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    EXPECT_NE(editor().measuring().found(), nullptr) << "the reference is measured before";
    EXPECT_FALSE(fitting().found()->result) << "nothing is drawn";
    EXPECT_TRUE(document::same(before, editor().document.content())) << "nothing changes until it is taken";
    ASSERT_FALSE(fitting().found()->lines.empty());
    EXPECT_TRUE(says(app::with_titles(fitting().found()->lines.front())));
    EXPECT_FALSE(says("(null)")) << "a parameter without a unit";
    char change[64];
    std::snprintf(change, sizeof change, "%.3g \u2192 %.3g 1/s", before.preset.smoke.haze.accumulation,
                  fitting().found()->tuned.preset.smoke.haze.accumulation);
    EXPECT_TRUE(says(change)) << change << " is no interval\n" << ui().dump();
    const document::Content found = fitting().found()->tuned;
    press("Take");
    EXPECT_EQ(steps(), steps_before + 1);
    EXPECT_EQ(editor().document.steps().back().name, "Take proposal");
    EXPECT_TRUE(document::same({found.scene, found.preset}, editor().document.content()));
    EXPECT_FALSE(document::same(before, editor().document.content()));
    EXPECT_TRUE(fitting().taken());
    EXPECT_TRUE(says("Taken")) << "what was found can still be read";
    editor().document.undo();
    EXPECT_TRUE(document::same(before, editor().document.content()));
}

TEST_F(FitPanel, AFitComesNearerAndIsTakenAsOneStep) {
    fitting().look.keys = {"smoke.haze.accumulation"};
    fitting().look.tools = false;
    editor().document.change("Thin", [](document::Content& c) { c.preset.smoke.haze.accumulation *= 0.3; });
    const document::Content before = editor().document.content();
    press("Fit");
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    ASSERT_TRUE(fitting().found()->result);
    const match::FitResult result = *fitting().found()->result;
    ASSERT_TRUE(result.veil_before && result.veil_after);
    EXPECT_LT(*result.veil_after, 0.7 * *result.veil_before);
    ASSERT_EQ(result.parameters.size(), 1U);
    EXPECT_GT(result.parameters[0].after, 1.5 * before.preset.smoke.haze.accumulation);
    EXPECT_EQ(fitting().frames().size(), result.after.size()) << "its curve is plotted";
    press("Take");
    EXPECT_EQ(editor().document.preset().smoke.haze.accumulation, result.parameters[0].after);
    EXPECT_EQ(editor().document.steps().back().name, "Fit");
    EXPECT_TRUE(fitting().frames().empty()) << "the preview's own curve shows it now";
    editor().document.undo();
    EXPECT_TRUE(document::same(before, editor().document.content()));
}

TEST_F(FitPanel, WhenToolsWorkIsTold) {
    fitting().look.keys = {"smoke.haze.accumulation"};
    editor().document.change("Late", [](document::Content& c) {
        c.scene.events.resize(1);
        c.scene.events[0].time = 2.2;
    });
    press("Fit");
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    int told = 0;
    for (const match::FittedParameter& p : fitting().found()->result->parameters) {
        if (!p.parameter.of_scene) continue;
        const std::size_t event = static_cast<std::size_t>(p.parameter.key.at(std::string("events.").size()) - '0');
        EXPECT_TRUE(says("Event " + std::to_string(event + 1) + ", " + std::string(p.parameter.row->key)))
            << p.parameter.key << '\n'
            << ui().dump();
        EXPECT_TRUE(p.determined || says("Not determined: " + app::with_titles(p.why))) << p.why;
        ++told;
    }
    EXPECT_GE(told, 1);
}

TEST_F(FitPanel, WhatIsLockedStays) {
    editor().tuning().lock(app::parameters().find("smoke.haze.accumulation"), true);
    ui().frame();
    EXPECT_TRUE(says("locked"));
    press("Propose");
    ASSERT_NE(fitting().found(), nullptr);
    EXPECT_EQ(fitting().found()->tuned.preset.smoke.haze.accumulation,
              editor().document.preset().smoke.haze.accumulation);
    for (const match::FreeParameter& p : fitting().found()->parameters) EXPECT_NE(p.key, "smoke.haze.accumulation");
}

TEST_F(FitPanel, WhatIsLockedMeanwhileStays) {
    press("Propose");
    ASSERT_NE(fitting().found(), nullptr);
    const Preset before = editor().document.preset(), found = fitting().found()->tuned.preset;
    ASSERT_NE(found.smoke.haze.accumulation, before.smoke.haze.accumulation);
    editor().tuning().lock(app::parameters().find("smoke.haze.accumulation"), true);
    press("Take");
    EXPECT_EQ(editor().document.preset().smoke.haze.accumulation, before.smoke.haze.accumulation);
    EXPECT_TRUE(says("What has been locked since stays as it is"));
}

TEST_F(FitPanel, ToolsStayWhereTheyMayNotChange) {
    const auto events = editor().document.scene().events;
    ui().click("**/Tools may change").frame();
    press("Propose");
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    press("Take");
    ASSERT_EQ(editor().document.scene().events.size(), events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
        EXPECT_EQ(editor().document.scene().events[i].time, events[i].time);
        EXPECT_EQ(editor().document.scene().events[i].power, events[i].power);
    }
}

TEST_F(FitPanel, BeginsThoughNothingElseBringsAFrame) {
    ui().frame().frame();
    ASSERT_GT(fitting().due(), ui().time);
    fitting().start();
    EXPECT_LE(fitting().due(), ui().time);
    fitting().cancel();
    ui().frame();
    EXPECT_GT(fitting().due(), ui().time);
}

TEST_F(FitPanel, WhatIsTakenAndUndoneCanBeTakenAgain) {
    press("Propose");
    ASSERT_NE(fitting().found(), nullptr);
    press("Take");
    ASSERT_TRUE(fitting().taken());
    editor().document.undo();
    ui().frame().frame();
    EXPECT_FALSE(fitting().taken());
    EXPECT_FALSE(says("Taken"));
    EXPECT_FALSE(fitting().stale()) << "all is as it was when it was found";
    editor().document.redo();
    ui().frame().frame();
    EXPECT_TRUE(fitting().taken());
    editor().document.undo();
    ui().frame().frame();
    press("Take");
    EXPECT_TRUE(fitting().taken());
    EXPECT_EQ(editor().document.steps().back().name, "Take proposal");
}

TEST_F(FitPanel, WhatWasFoundStaysUntilSomethingElseIsFound) {
    press("Propose");
    ASSERT_NE(fitting().found(), nullptr);
    const std::vector<std::string> lines = fitting().found()->lines;
    const auto keys = std::exchange(fitting().look.keys, {});
    press("Fit");
    EXPECT_FALSE(fitting().faults().empty());
    ASSERT_NE(fitting().found(), nullptr) << "what is begun again may fail";
    EXPECT_EQ(fitting().found()->lines, lines);
    fitting().look.keys = keys;
    press("Take");
    ASSERT_TRUE(fitting().taken());
    fitting().propose();
    ui().frame().frame();
    ASSERT_NE(fitting().found(), nullptr);
    EXPECT_FALSE(fitting().taken()) << "another one";
    EXPECT_FALSE(fitting().stale());
}

TEST_F(FitPanel, WhatWasFoundGoesWithItsReference) {
    press("Propose");
    press("Take");
    ASSERT_TRUE(fitting().taken());
    fs::copy_file(editor().reference().file(), folder() / "other.mp4");
    editor().reference().choose(folder() / "other.mp4");
    ui().frame().frame();
    EXPECT_EQ(fitting().found(), nullptr);
    EXPECT_FALSE(says("Taken"));
}

TEST_F(FitPanel, KeysAreNamedAsTheWindowNamesThem) {
    press("Propose");
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    bool named = false;
    for (const std::string& line : fitting().found()->lines) named = named || line.find("smoke.haze.") != line.npos;
    ASSERT_TRUE(named) << "files and commands name keys";
    EXPECT_TRUE(says("Haze: "));
    EXPECT_EQ(ui().dump().find(" smoke.haze.ventilation: "), std::string::npos) << ui().dump();
    EXPECT_EQ(ui().dump().find("\"smoke.haze."), std::string::npos) << ui().dump();
}

TEST_F(FitPanel, AClipThatIsGoneIsToldBeforeMeasuringWithTheWayOut) {
    editor().document.change("Gone", [](document::Content& c) {
        ASSERT_GE(c.preset.smoke.clips.size(), 2U);
        c.preset.smoke.clips[1].file = "gone.mp4";
    });
    ui().frame().frame();
    press("Fit");
    EXPECT_FALSE(fitting().busy());
    EXPECT_EQ(editor().measuring().found(), nullptr) << "nothing was measured for it";
    EXPECT_EQ(fitting().lost_clip(), std::optional<std::size_t>(1));
    EXPECT_TRUE(says("gone.mp4: no such clip")) << ui().dump();
    editor().clips().selected = 0;
    ui().click(panel + "Choose file...").frame();
    EXPECT_EQ(editor().clips().selected, 1U);
    EXPECT_TRUE(says("Another file for this clip")) << ui().dump();
    ui().key(ui::Key::escape).frame();
    editor().document.undo();
    ui().frame().frame();
    EXPECT_FALSE(fitting().lost_clip());
    EXPECT_TRUE(fitting().faults().empty()) << "it is there again";
    EXPECT_FALSE(ui().exists(panel + "Choose file..."));
}

TEST_F(FitPanel, TheProgressOfACurveNeverGoesBack) {
    const Scene& scene = editor().document.scene();
    match::PreviewCurve curve(editor().preview.organ_of(scene),
                              {.clip_folders = editor().options().clip_folders, .wait_for_clips = true},
                              {.size = {64, 48}});
    std::vector<double> times, told;
    for (int i = 0; i < 20; ++i) times.push_back(0.1 * i);
    const auto frames = curve.measure(scene, editor().document.preset(), times, {.progress = [&](double share) {
                                          told.push_back(share);
                                          return true;
                                      }});
    ASSERT_TRUE(frames);
    EXPECT_GT(told.size(), times.size());
    EXPECT_TRUE(std::ranges::is_sorted(told)) << testing::PrintToString(told);
    EXPECT_LE(told.back(), 1.0);
}

TEST_F(FitPanel, NothingFreeIsTold) {
    fitting().look.keys.clear();
    ui().frame();
    EXPECT_TRUE(says("Nothing: all parameters stay as they are."));
    press("Fit");
    EXPECT_EQ(fitting().found(), nullptr);
    EXPECT_FALSE(fitting().busy());
    EXPECT_TRUE(says("names no parameter: nothing is free")) << ui().dump();
}

TEST_F(FitPanel, ParametersAreTakenAwayAndAdded) {
    ASSERT_EQ(fitting().look.keys.size(), match::usual_parameters.size());
    fitting().look.keys = {"bleeding.speed", "smoke.haze.accumulation"};
    ui().frame();
    ui().click("**/Keep Bleeding: Speed").frame();
    EXPECT_THAT(fitting().look.keys, ElementsAre("smoke.haze.accumulation"));
    ui().click("**/Add parameter").frame().type("Ventilation").frame().key(ui::Key::enter).frame().frame();
    EXPECT_THAT(fitting().look.keys, ElementsAre("smoke.haze.accumulation", "smoke.haze.ventilation"));
}

TEST_F(FitPanel, ToolsThatChangedMeanwhileStay) {
    press("Propose");
    ASSERT_NE(fitting().found(), nullptr);
    const double found = fitting().found()->tuned.preset.smoke.haze.accumulation;
    ASSERT_NE(found, editor().document.preset().smoke.haze.accumulation);
    editor().document.change("Move", [](document::Content& c) { c.scene.events.front().time += 0.25; });
    const auto events = editor().document.scene().events;
    ui().frame();
    EXPECT_TRUE(fitting().stale());
    press("Take");
    EXPECT_EQ(editor().document.preset().smoke.haze.accumulation, found);
    ASSERT_EQ(editor().document.scene().events.size(), events.size());
    for (std::size_t i = 0; i < events.size(); ++i) EXPECT_EQ(editor().document.scene().events[i].time, events[i].time);
    EXPECT_TRUE(says("its tools stay as they are"));
}

TEST_F(FitPanel, WithoutAReferenceThereIsNothingToFitTo) {
    editor().document.change("Without", [](document::Content& c) { c.scene.reference.file.clear(); });
    ui().frame().frame();
    EXPECT_TRUE(says("There is no reference to fit to"));
    fitting().start();
    ui().frame().frame();
    EXPECT_FALSE(fitting().busy());
    ASSERT_FALSE(fitting().faults().empty());
    EXPECT_EQ(fitting().faults().front().reason, "there is no reference to fit to");
}

// --- colours ---------------------------------------------------------------------------------------------------------

/// The reference is the scene itself, with another blood and another haze.
class FitColors : public FitPanel {
  protected:
    void SetUp() override {
        FitPanel::SetUp();
        if (IsSkipped()) return;
        editor().document.change("Bleeds", [](document::Content& c) {
            c.preset.bleeding.speed = 12, c.preset.bleeding.max_extent = 30;
            c.preset.smoke.haze.accumulation = 0.06;
            c.scene.duration = 4;  // there is enough of both by then
        });
        start_ = hidden_ = editor().document.content();
        hidden_.preset.bleeding.color_thin = {0.75, 0.25, 0.125},
        hidden_.preset.bleeding.color_deep = {0.5, 0.125, 0.06};
        hidden_.preset.smoke.haze.color = {0.376, 0.416, 0.565}, hidden_.preset.smoke.plume.color = {0.5, 0.565, 0.753};
        hidden_.scene.camera.exposure *= 1.3;
        static const HiddenVideo video(*this);
        editor().document.change("Reference", [](document::Content& c) {
            c.scene.reference = {};
            c.scene.reference.file = video.file.string();
        });
        ui().frame().frame();
        fitting().look.keys = {"smoke.haze.accumulation"};
        fitting().look.tools = false;
    }
    /// The same for all tests, which are then told what was measured of it, too.
    struct HiddenVideo {
        explicit HiddenVideo(FitColors& test) {
            std::string pattern = (fs::temp_directory_path() / "lapfx-hidden-XXXXXX").string();
            folder = ::mkdtemp(pattern.data());
            file = folder / "hidden.mp4";
            Preview preview(test.hidden_.scene, test.hidden_.preset,
                            {.clip_folders = test.editor().options().clip_folders, .wait_for_clips = true});
            output::VideoFile video(file, 5, {hidden_size.x, hidden_size.y});
            for (int i = 0; i < 20; ++i) video.add(preview.image(0.2 * i, hidden_size));
            video.finish();
        }
        ~HiddenVideo() {
            std::error_code error;
            fs::remove_all(folder, error);
        }
        fs::path folder, file;
    };
    static constexpr glm::ivec2 hidden_size{128, 104};
    std::vector<match::FrameAmounts> curve_of_found() {
        const app::FitFound& found = *fitting().found();
        match::PreviewCurve curve(found.fit.organ,
                                  {.clip_folders = editor().options().clip_folders, .wait_for_clips = true},
                                  {.size = match::preview_size(hidden_size, 0.0, measured_side)});
        std::vector<double> times;
        for (const match::TargetPoint& aim : found.target) times.push_back(aim.time);
        return curve.measure(found.tuned.scene, found.tuned.preset, times).value();
    }
    static double apart(const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b); }
    /// "blood: Delta E 12.1 before, 1.3 after"
    std::pair<double, double> told(const std::string& name) {
        for (const std::string& line : fitting().found()->colors) {
            double before = -1, after = -1;
            if (std::sscanf(line.c_str(), (name + ": Delta E %lf before, %lf after").c_str(), &before, &after) == 2)
                return {before, after};
        }
        ADD_FAILURE() << name << " is not told";
        return {};
    }

    document::Content start_, hidden_;
};

TEST_F(FitColors, HiddenOnesAreFoundAndTakenInTheOneStep) {
    EXPECT_FALSE(fitting().look.colors);
    ui().click("**/Colours").frame();
    EXPECT_TRUE(fitting().look.colors);
    const document::Content before = editor().document.content();
    press("Fit");
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    for (const char* const name : {"blood", "smoke", "tissue"}) {
        const auto [far, near] = told(name);
        EXPECT_GT(far, 3) << name;
        EXPECT_LT(near, std::max(3.0, 0.4 * far)) << name;
    }
    for (const std::string& line : fitting().found()->colors) EXPECT_TRUE(says(app::with_titles(line))) << line;
    const match::FitResult& result = *fitting().found()->result;
    const std::vector<match::FrameAmounts> drawn = curve_of_found();
    ASSERT_EQ(result.after.size(), drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        EXPECT_NEAR(result.after[i].veil.value, drawn[i].veil.value, 1e-6) << "the curves are those of what is taken";
        EXPECT_NEAR(result.after[i].blood.value, drawn[i].blood.value, 1e-6) << i;
    }
    const std::size_t done = steps();
    press("Take");
    EXPECT_EQ(steps(), done + 1);
    const document::Content& now = editor().document.content();
    EXPECT_EQ(now.preset.bleeding.color_thin, fitting().found()->tuned.preset.bleeding.color_thin);
    EXPECT_LT(apart(now.preset.bleeding.color_thin, hidden_.preset.bleeding.color_thin),
              0.6 * apart(start_.preset.bleeding.color_thin, hidden_.preset.bleeding.color_thin));
    EXPECT_LT(apart(now.preset.smoke.haze.color, hidden_.preset.smoke.haze.color),
              0.6 * apart(start_.preset.smoke.haze.color, hidden_.preset.smoke.haze.color));
    EXPECT_NEAR(now.scene.camera.exposure, hidden_.scene.camera.exposure, 0.15 * hidden_.scene.camera.exposure);
    EXPECT_EQ(now.scene.organ.color, fitting().found()->tuned.scene.organ.color);
    EXPECT_LT(apart(now.scene.organ.color, hidden_.scene.organ.color), 0.1) << "the same organ under the same lamp";
    editor().document.undo();
    EXPECT_TRUE(document::same(before, editor().document.content()));
}

TEST_F(FitColors, WhatIsLockedStaysAndWhatGetsWorseIsToldBeforeItIsTaken) {
    // Blood that looks right as long as the exposure is wrong: that is matched by the tissue, and the blood is locked.
    fitting().look.colors = true;
    editor().document.change("Bright blood", [this](document::Content& c) {
        c.preset.bleeding.color_thin = 1.3 * hidden_.preset.bleeding.color_thin;
        c.preset.bleeding.color_deep = 1.3 * hidden_.preset.bleeding.color_deep;
    });
    for (const char* const key : {"bleeding.color_thin", "bleeding.color_deep"})
        editor().tuning().lock(app::parameters().find(key), true);
    const Preset before = editor().document.preset();
    press("Fit");
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    const std::vector<std::string> worse = match::what_is_worse(*fitting().found()->result);
    ASSERT_FALSE(worse.empty());
    EXPECT_TRUE(worse.front().starts_with("colour of blood: Delta E ")) << worse.front();
    EXPECT_TRUE(says("Farther from the reference than before:"));
    for (const std::string& line : worse) EXPECT_TRUE(says(line)) << line;

    const Preset found = fitting().found()->tuned.preset;
    EXPECT_EQ(found.bleeding.color_thin, before.bleeding.color_thin);
    ASSERT_NE(found.smoke.haze.color, before.smoke.haze.color);
    ASSERT_NE(found.smoke.plume.color, before.smoke.plume.color);
    editor().tuning().lock(app::parameters().find("smoke.haze.color"), true);  // meanwhile
    press("Take");
    EXPECT_EQ(editor().document.preset().smoke.haze.color, before.smoke.haze.color);
    EXPECT_EQ(editor().document.preset().smoke.plume.color, found.smoke.plume.color);
    EXPECT_TRUE(says("What has been locked since stays as it is"));
}

// --- its report ------------------------------------------------------------------------------------------------------

class FitReport : public FitPanel {
  protected:
    void fit() {
        fitting().look.keys = {"smoke.haze.accumulation"};
        fitting().look.tools = false;
        press("Fit");
        ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    }
    void export_to(const fs::path& file) {
        ui().click("**/Export report...").frame().frame();
        ui().type("\b").key('A', ui::Mods::command).type(file.string()).key(ui::Key::enter);
        ui().frame().frame();
    }
};

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST_F(FitReport, HasCurvesParametersAndPictures) {
    press("Propose");
    EXPECT_FALSE(ui().exists("**/Export report...")) << "a proposal has drawn nothing";
    fit();
    press("Take");
    editor().document.change("Without", [](document::Content& c) { c.scene.reference.offset = 1; });
    const fs::path file = folder() / "report.html";
    export_to(file);
    EXPECT_TRUE(says("Exported report.html")) << ui().dump();
    const std::string page = text_of(file);
    EXPECT_EQ(count(page, "<svg"), 2);
    const std::vector<match::ReportMoment> moments = match::report_moments(fitting().found()->target);
    EXPECT_EQ(count(page, "src=\"data:image/jpeg;base64,"), 3 * static_cast<int>(moments.size()));
    EXPECT_EQ(count(page, "src="), 3 * static_cast<int>(moments.size())) << "nothing from elsewhere";
    EXPECT_EQ(count(page, "<script"), 0);
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    EXPECT_THAT(page, HasSubstr("smoke.haze.accumulation"));
    EXPECT_THAT(page, HasSubstr("lagb.scene.json"));
    EXPECT_THAT(page, HasSubstr(editor().reference().file().filename().string()));
    EXPECT_THAT(page, HasSubstr("<dt>Offset</dt><dd>0.5 s")) << "as it was fitted, whatever has changed since";
    EXPECT_THAT(page, Not(HasSubstr("Preset after"))) << "no file was written";
    fs::create_symlink(folder() / "elsewhere.html", folder() / "link.html");
    editor().fit_reporting().write(*fitting().found(), folder() / "link.html");
    ui().frame().frame();
    EXPECT_TRUE(says("link.html: not written: it is a symbolic link")) << ui().dump();
    EXPECT_FALSE(fs::exists(folder() / "elsewhere.html"));
}

/// Beside the UI, as in the window.
class FitBeside : public FitPanel {
  protected:
    FitBeside() { begins.exact = false; }
    bool wait_for(const std::function<bool()>& so) {
        return wait_until(so, [&] { ui().frame(0.02); });
    }
};

TEST_F(FitBeside, ACancelledFitGivesTheNearestSoFar) {
    fitting().look.keys = {"smoke.haze.accumulation", "smoke.haze.ventilation"};
    fitting().look.tools = false;
    const document::Content before = editor().document.content();
    fitting().start();
    ASSERT_TRUE(wait_for([&] { return !fitting().busy() || !fitting().frames().empty(); }));
    ASSERT_TRUE(fitting().busy()) << ui().dump();
    EXPECT_GT(fitting().progress(), 0.0);
    fitting().cancel();
    ASSERT_TRUE(wait_for([&] { return !fitting().busy(); }));
    ASSERT_NE(fitting().found(), nullptr);
    EXPECT_TRUE(fitting().found()->result->ended_early);
    EXPECT_FALSE(fitting().found()->result->colors_after.tissue) << "it ends at once, nothing else is drawn";
    ui().frame();
    EXPECT_TRUE(says("the nearest so far")) << ui().dump();
    EXPECT_TRUE(document::same(before, editor().document.content()));
}

TEST_F(FitBeside, WhileItFitsWhatWasFoundBeforeIsReadButNotTaken) {
    fitting().propose();
    ASSERT_TRUE(wait_for([&] { return !fitting().busy(); }));
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    const std::vector<std::string> lines = fitting().found()->lines;
    fitting().start();
    ui().frame();
    ASSERT_TRUE(fitting().busy());
    ASSERT_NE(fitting().found(), nullptr);
    EXPECT_TRUE(says("Found before")) << ui().dump();
    EXPECT_FALSE(editor().commands.enabled(editor().commands.index_of("fit.take")));
    ASSERT_TRUE(wait_for([&] { return !fitting().busy() || !fitting().frames().empty(); }));
    ASSERT_TRUE(fitting().busy());
    fitting().cancel();
    ASSERT_TRUE(wait_for([&] { return !fitting().busy(); }));
    EXPECT_TRUE(fitting().found()->result) << "that of the fit, as far as it came";
    EXPECT_FALSE(says("Found before"));
}

TEST_F(FitBeside, TheReportIsWrittenOrCancelled) {
    fitting().look.keys = {"smoke.haze.accumulation"};
    fitting().look.tools = false;
    fitting().start();
    ASSERT_TRUE(wait_for([&] { return !fitting().busy(); }));
    ASSERT_NE(fitting().found(), nullptr) << ui().dump();
    app::FitReporting& reporting = editor().fit_reporting();
    const fs::path cancelled = folder() / "cancelled.html", written = folder() / "written.html";
    reporting.write(*fitting().found(), cancelled);
    ASSERT_TRUE(reporting.busy());
    ui().frame();
    EXPECT_TRUE(says("Writing the report")) << ui().dump();
    reporting.cancel();
    ASSERT_TRUE(wait_for([&] { return !reporting.busy(); }));
    EXPECT_FALSE(fs::exists(cancelled));
    reporting.write(*fitting().found(), written);
    editor().document.change("Meanwhile", [](document::Content& c) { c.scene.events.clear(); });
    ASSERT_TRUE(wait_for([&] { return !reporting.busy(); }));
    ui().frame();
    EXPECT_TRUE(says("Exported written.html")) << ui().dump();
    EXPECT_THAT(text_of(written), HasSubstr("After at "));
    std::vector<fs::path> others;
    for (const auto& entry : fs::directory_iterator(folder()))
        if (entry.path().filename().string().starts_with(".lapfx-part-")) others.push_back(entry.path());
    EXPECT_THAT(others, testing::IsEmpty());
}

TEST_F(FitBeside, AnotherDocumentEndsIt) {
    fitting().start();
    ASSERT_TRUE(wait_for([&] { return !fitting().busy() || fitting().progress() > 0.0; }));
    ASSERT_TRUE(fitting().busy());
    editor().forget_document();
    EXPECT_FALSE(fitting().busy());
    EXPECT_EQ(fitting().found(), nullptr);
    ui().frame().frame();
}

}  // namespace
}  // namespace lapfx::test
