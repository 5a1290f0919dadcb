// A frame of the editor does its steps, from events to pictures, in a fixed order (Editor::frame).
#include "app/base/layouts.h"
#include "editor/support/editor_test.h"

namespace lapfx::test {
namespace {

using app::FrameStep;

class FrameTest : public EditorTest {
  protected:
    std::vector<FrameStep> steps;
    /// Makes one frame; `act` is what the person does while the panels are built.
    bool frame(const std::function<void()>& act, bool visible = true) {
        steps.clear();
        return editor().frame(ui().time += 1.0 / 60, act,
                              {.visible = visible, .after = [&](FrameStep step) { steps.push_back(step); }});
    }
    void set_speed(double speed) {
        editor().document.change("Speed", [&](document::Content& c) { c.preset.bleeding.speed = speed; });
    }
};

TEST_F(FrameTest, TakesItsStepsInOrder) {
    open_sample();
    bool built = false;
    frame([&] {
        EXPECT_EQ(steps, std::vector{FrameStep::updated}) << "panels show what has been updated";
        built = true;
    });
    EXPECT_TRUE(built);
    EXPECT_EQ(steps, (std::vector{FrameStep::updated, FrameStep::built, FrameStep::followed, FrameStep::drawn}));
}

TEST_F(FrameTest, WhatIsDoneInThePanelsIsInThePictureOfTheSameFrame) {
    open_sample();
    const Image before = picture(6);
    EXPECT_FALSE(frame([] {})) << "nothing has changed";
    EXPECT_TRUE(frame([&] { set_speed(20); }));
    EXPECT_GT(differing(before, editor().preview.read()), 100U);
}

TEST_F(FrameTest, OfAWindowThatNobodySeesNothingIsDrawn) {
    open_sample();
    const Image before = picture(6);
    EXPECT_FALSE(frame([&] { set_speed(20); }, false));
    EXPECT_EQ(steps, (std::vector{FrameStep::updated, FrameStep::built}));
    EXPECT_EQ(differing(before, editor().preview.read(), 0), 0U);
    EXPECT_TRUE(frame([] {})) << "it is drawn once it is seen again";
}

TEST_F(FrameTest, AFaultIsToldAndCounted) {
    const std::uint64_t before = editor().toasts.faults();
    editor().toasts.tell(Error(Failure::runtime, Fault{"a.json", "/seed", "is broken"}));
    EXPECT_EQ(editor().toasts.faults(), before + 1);
    ASSERT_EQ(editor().toasts.log().size(), 1U);
    EXPECT_EQ(editor().toasts.log()[0].text, "a.json: /seed: is broken");
}

TEST(EditorTimeline, PlayGoesRoundInItsRangeAndStopsAtTheEnd) {
    document::Document document;
    document::Content content;
    content.scene.duration = 10;
    document.open(std::move(content), {}, {});
    app::Timeline timeline(document);
    timeline.seek(99);
    EXPECT_EQ(timeline.time, 10) << "not beyond the scene";
    timeline.has_range = true;
    timeline.range = {2, 4};
    timeline.seek(3.5);
    timeline.speed = 2;
    timeline.advance(0.5, false);
    EXPECT_DOUBLE_EQ(timeline.time, 2.5);
    timeline.loop = false;
    timeline.advance(5, false);
    EXPECT_EQ(timeline.time, 4);
    EXPECT_FALSE(timeline.playing());
    timeline.speed = 1;
    timeline.advance(8, true);
    EXPECT_EQ(timeline.time, 12) << "a tool in use goes on beyond the end";
}

}  // namespace
}  // namespace lapfx::test
