// What the parameters of a plume do to whole pictures while the tool is on.
#include "parity/render/scene_fixture.h"

namespace lapfx {
namespace {

class PlumePicture : public test::SceneTest {
  protected:
    PlumePicture() {
        scene.gravity = {0.0, 0.0, 1.0};  // up in the view
        scene.events.erase(scene.events.begin());
        scene.events[0].time = 0.0;  // burns for 3 s
        preset.smoke.clips = {{.file = "clip.avi", .role = ClipRole::plume}};
        preset.smoke.keying = {.luma_low = 0.0, .luma_high = 140.0, .noise_strength = 0.0};
        preset.smoke.plume.size = 30.0;
        preset.smoke.plume.density = 1.0;
        preset.smoke.haze.accumulation = 0.0;
    }
    Image at(double time) const { return preview().image(time, size); }
};

TEST_F(PlumePicture, RiseAndGrowthActWhileTheToolIsOn) {
    for (const double time : {1.0, 2.9}) {
        const Image before = at(time);
        preset.smoke.plume.rise = 60.0;
        EXPECT_GT(test::differing(before, at(time)), 100) << "rise, " << time;
        preset.smoke.plume.rise = 6.0;
        preset.smoke.plume.growth = 3.0;
        EXPECT_GT(test::differing(before, at(time)), 100) << "growth, " << time;
        preset.smoke.plume.growth = 0.25;
    }
}

TEST_F(PlumePicture, LeanActsUpToItsEnd) {
    preset.smoke.plume.size = 110.0;  // to the lens, 60 mm away
    Image before = at(2.0);
    for (const double lean : {0.8, 0.9, 1.0, 1.2, 1.5}) {
        preset.smoke.plume.lean = lean;
        const Image now = at(2.0);
        EXPECT_GT(test::differing(before, now, 0), 20) << lean;
        before = now;
    }
}

// Two clips that are the same show what one of them shows alone, whatever their weights, of plumes as of haze.
TEST_F(PlumePicture, WeightsShareTheSmokeOfTheirRole) {
    for (const ClipRole role : {ClipRole::plume, ClipRole::haze}) {
        SmokeClip clip{.file = "clip.avi", .role = role, .start = ClipStart::beginning, .mirror = ClipMirror::off};
        preset.smoke.haze.accumulation = 0.3;
        preset.smoke.clips = {};
        const Image none = at(2.0);
        preset.smoke.clips = {clip};
        const Image alone = at(2.0);
        EXPECT_GT(test::differing(alone, none, 0), 100) << "there is smoke";
        preset.smoke.clips[0].weight = 4.0;
        EXPECT_EQ(test::differing(alone, at(2.0), 0), 0) << "alone it is all, whatever it weighs";
        preset.smoke.clips = {clip, clip};
        preset.smoke.clips[0].weight = 0.5;
        preset.smoke.clips[1].weight = 3.0;
        EXPECT_EQ(test::differing(alone, at(2.0), 1), 0) << "both together";
    }
}

}  // namespace
}  // namespace lapfx
