// The Measure panel with the sample scene and its reference.
//
//     TEST_F(MeasurePanelOfKnown, ABloodyFrame) { EXPECT_GT(bench().amounts().blood.value, 0.02); }
//
#pragma once

#include "app/base/layouts.h"
#include "app/measure/measure_bench.h"
#include "app/measure/measuring.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "editor/support/few_frames.h"
#include "support/wait_until.h"

namespace lapfx::test {

inline constexpr double clear_time = 0.0, bloody_time = 5.5;  // s of the scene, in the sample reference

class MeasurePanel : public SampleTest {
  protected:
    MeasurePanel() { begins.layout = "Compare"; }
    void SetUp() override {
        SampleTest::SetUp();
        if (!IsSkipped()) show();
    }
    void show() {
        take_few_frames(editor());
        ui().frame().frame();
        if (known) {
            measuring().start();
            ui().frame().frame();
        }
        editor().layouts().bring_to_front("Measure");
        go(bloody_time);
    }
    void go(double time) {
        editor().timeline.seek(time);
        ui().frame().frame().frame();
    }
    /// Frames until it is so: videos and jobs have threads of their own.
    void wait_for(const std::function<bool()>& so) {
        ASSERT_TRUE(wait_until(so, [&] { ui().frame().frame(); }));
    }
    void show_with_threads() {
        start({1440, 900}, false);
        open_sample();
        layout("Compare");
        show();
        wait_for([&] { return bench().ready(); });
    }
    app::Measuring& measuring() { return editor().measuring(); }
    app::MeasureBench& bench() { return editor().measure_bench(); }
    bool holds(app::MeasureTool tool) { return bench().look.tool == tool; }
    const ReferenceMeasure& measure() { return editor().document.scene().reference.measure; }
    std::size_t steps() { return editor().document.done(); }
    std::string last_step() { return editor().document.steps()[editor().document.done() - 1].name; }
    bool says(const std::string& text) { return ui().dump().find(text) != std::string::npos; }
    void undo() {
        editor().document.undo();
        ui().frame().frame();
    }
    void measure_all() {
        ui().click(panel + "Measure").frame().frame();
        ASSERT_NE(measuring().found(), nullptr);
    }
    /// How many pixels of the picture are marked as blood.
    std::size_t yellow_pixels() {
        const ui::StoredImage* shown = editor().images.find(bench().picture().image);
        if (shown == nullptr) return 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i + 3 < shown->pixels.size(); i += 4)
            count += shown->pixels[i + 1] > 140 && shown->pixels[i + 2] < 110 ? 1 : 0;
        return count;
    }
    const std::string panel = "Workspace/Measure/", rows = panel + "Measure settings/",
                      picture_path = panel + "Measured";
    bool known = false;  ///< the reference has been measured before, so that its frames are soon told
};

class MeasurePanelOfKnown : public MeasurePanel {
  protected:
    MeasurePanelOfKnown() { known = true; }
};

}  // namespace lapfx::test
