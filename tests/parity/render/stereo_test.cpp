// Two views of one update: a stereo laparoscope, or an assistant's second monitor.
#include <thread>

#include "lapfx/effects.h"
#include "lapfx/frame.h"
#include "parity/allocations.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "support/wait_until.h"

namespace lapfx {
namespace {

class StereoTest : public test::FrameTest {
  protected:
    Effects made(bool wait = true) const {
        Effects effects(load_organ(folder / "sheet.obj"), preset, {.gravity = scene.gravity, .wait_for_clips = wait});
        effects.set_contacts(scene.events);
        return effects;
    }
    /// From 4 mm left or right of the scene's camera.
    View eye(double side) const {
        SceneCamera camera = scene.camera;
        camera.eye.x += 4.0 * side;
        return render::view_of(camera, SceneLight{}, size);
    }
    void draw(Effects& effects, double side, Picture& picture) { FrameTest::draw(effects, eye(side), picture); }
    Picture alone(double side) {
        Effects effects = made();
        effects.seek(time);
        Picture picture = blank();
        draw(effects, side, picture);
        return picture;
    }
};

TEST_F(StereoTest, EachEyeSeesWhatItSeesAlone) {
    Effects effects = made();
    effects.seek(time);
    Picture left = blank(), right = blank();
    draw(effects, -1.0, left);
    draw(effects, 1.0, right);
    EXPECT_NE(left, right);
    EXPECT_EQ(left, alone(-1.0));
    EXPECT_EQ(right, alone(1.0));
}

TEST_F(StereoTest, TheSecondEyeCostsNoUpdate) {
    Effects effects = made();
    Picture left = blank(), right = blank();
    const std::uint64_t none_yet = effects.streaming_times().uploaded;
    std::uint64_t first = 0;
    for (const double at : {time, time + 0.1, time + 0.5, time + 0.9}) {  // the first one makes what is kept
        effects.seek(at);
        const std::size_t bytes = effects.uploaded();
        draw(effects, -1.0, left);
        const StreamingTimes after_left = effects.streaming_times();
        if (at == time) first = after_left.uploaded;
        EXPECT_GT(bytes, 0u);
        const std::size_t allocations = test::allocations;
        draw(effects, 1.0, right);
        EXPECT_EQ(test::allocations, allocations);
        EXPECT_EQ(effects.uploaded(), bytes);
        EXPECT_EQ(effects.streaming_times().uploaded_bytes, after_left.uploaded_bytes);
        EXPECT_EQ(effects.streaming_times().uploaded, after_left.uploaded);
        EXPECT_EQ(effects.streaming_times().wait, after_left.wait);
    }
    EXPECT_GT(first, none_yet);
    EXPECT_GT(effects.streaming_times().uploaded, first) << "no clip went on";
}

TEST_F(StereoTest, BothEyesSeeTheSameFrameOfALateClip) {
    Effects effects = made(false);
    Picture left = blank(), right = blank();
    int late = 0;
    for (int i = 0; i < 20; ++i) {
        effects.seek(time + 0.37 * i);  // a jump
        draw(effects, 0.0, left);
        late += effects.late() ? 1 : 0;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));  // the frame that was late is there now
        draw(effects, 0.0, right);
        EXPECT_EQ(left, right) << "jump " << i;
    }
    if (late == 0) GTEST_SKIP() << "every frame came in time";
}

/// A host that draws the same moment again after a change: late() says when to seek it once more.
TEST_F(StereoTest, AClipThatCameWithAPresetAndIsNotThereYetIsLate) {
    test::write_clip(folder / "later.avi", 12, {1920, 1080});
    Effects effects = made(false);
    effects.seek(time);
    Picture picture = blank();
    draw(effects, 0.0, picture);
    preset.smoke.clips = {{.file = "later.avi", .role = ClipRole::haze}};
    effects.set_preset(preset);
    draw(effects, 0.0, picture);
    EXPECT_TRUE(test::wait_until([&] { return !effects.late(); },
                                 [&] {
                                     effects.seek(time);
                                     draw(effects, 0.0, picture);
                                 }));
    EXPECT_EQ(picture, alone(0.0));
}

}  // namespace
}  // namespace lapfx
