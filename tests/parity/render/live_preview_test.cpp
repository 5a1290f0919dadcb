// Changes that a preview accepts: another scene, prepared organs, shaders and clips that change on disk.
#include <gmock/gmock.h>

#include <opencv2/videoio.hpp>

#include "gl/shader_source.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/prepared_scene.h"
#include "lapfx/clip_cache.h"
#include "parity/render/scene_fixture.h"
#include "support/wait_until.h"

namespace lapfx {
namespace {

namespace fs = std::filesystem;

class LivePreview : public test::SceneTest {
  protected:
    LivePreview() { fs::create_directory(shaders); }

    Preview preview_with(std::shared_ptr<ClipCache> clips) const {
        return Preview(scene, preset, {.clip_folders = {}, .wait_for_clips = true, .clip_cache = std::move(clips)});
    }
    /// Replaces clip.avi by a clip of one grey level, written next to it and renamed.
    void replace_clip(int level) {
        const cv::Size extent(64, 48);
        cv::VideoWriter writer((folder / "new.avi").string(), cv::CAP_FFMPEG,
                               cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20.0, extent);
        for (int i = 0; i < 12; ++i) writer.write(cv::Mat(extent, CV_8UC3, cv::Scalar::all(level)));
        writer.release();
        fs::rename(folder / "new.avi", folder / "clip.avi");
    }
    /// Post-processing that keeps only red, or one with a mistake.
    void write_post(const std::string& last_line) const {
        std::string text = gl::shader_source("post.frag").text;
        text.insert(text.rfind('}'), last_line + "\n");
        std::ofstream(shaders / "post.frag") << text;
    }

    fs::path shaders = folder / "shaders";
};

TEST_F(LivePreview, APreparedOrganGivesTheSamePictures) {
    const auto made = prepare_organ(scene, preset.vessels);
    Preview direct = preview(), first(scene, preset, made, {.clip_folders = {}, .wait_for_clips = true}),
            second(scene, preset, made, {.clip_folders = {}, .wait_for_clips = true});
    for (const double time : {0.0, 2.5, 4.0}) {
        const Image expected = direct.image(time, size);
        EXPECT_TRUE(first.image(time, size).pixels == expected.pixels) << time;
        EXPECT_TRUE(second.image(time, size).pixels == expected.pixels) << time << ", shared";
    }
    EXPECT_GT(first.memory(), made->memory());
    scene.organ.scale = 2.0;
    EXPECT_THROW(Preview(scene, preset, made, PreviewOptions{}), Error) << "it is of another scene";
}

TEST_F(LivePreview, AnotherSceneIsThatOfANewPreview) {
    Preview live = preview();
    live.image(3.0, size);
    const Image before = live.image(2.5, size);
    const std::vector<std::function<void()>> changes{
        [&] { scene.seed = 77; },
        [&] {
            scene.gravity = {0.6, -0.5, 0.2};
        },
        [&] { scene.light.intensity = 0.5; },
        [&] { scene.light.beam_angle = 30.0; },
        [&] {
            scene.camera.eye = {10.0, 50.0, 12.0};
        },
        [&] { scene.camera.exposure = 1.4; },
        [&] { scene.events.pop_back(); },
        [&] { scene.events[0].position.x = scene.events[0].to.x = 6.0; },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        changes[i]();
        live.set_scene(scene);
        const Image expected = preview().image(2.5, size);
        EXPECT_TRUE(live.image(2.5, size).pixels == expected.pixels) << i;
        EXPECT_FALSE(expected.pixels == before.pixels) << i;
    }
}

TEST_F(LivePreview, AnotherOrganIsRefusedAndChangesNothing) {
    Preview live = preview();
    const Image before = live.image(2.5, size);
    Scene other = scene;
    other.organ.rotation.x = 10.0;
    other.light.intensity = 0.1;
    EXPECT_FALSE(live.takes(other));
    EXPECT_THROW(live.set_scene(other), Error);
    other = scene;
    other.gravity = {};
    other.light.intensity = 0.1;
    EXPECT_THROW(live.set_scene(other), Error);
    EXPECT_TRUE(live.image(2.5, size).pixels == before.pixels);
}

TEST_F(LivePreview, ABrokenShaderKeepsThePictureAndAMendedOneChangesIt) {
    Preview live = preview();
    const Image before = live.image(2.5, size);
    write_post("wrong = 1.0;");
    try {
        live.reload_shaders(shaders);
        FAIL() << "it cannot compile";
    } catch (const Error& error) {
        EXPECT_EQ(error.faults().front().file, "post.frag");
        ASSERT_GT(error.faults().size(), 1U);
        EXPECT_THAT(error.faults()[1].text(), testing::HasSubstr("post.frag:")) << "with its line";
    }
    EXPECT_TRUE(live.image(2.5, size).pixels == before.pixels);
    EXPECT_TRUE(preview().image(2.5, size).pixels == before.pixels) << "nor is it used by a new one";
    write_post("o_color.r = 1.0;");
    live.reload_shaders(shaders);
    const Image after = live.image(2.5, size);
    EXPECT_EQ(after.pixels[0], 255);
    EXPECT_GT(test::differing(before, after), 1000);
    EXPECT_TRUE(preview().image(2.5, size).pixels == after.pixels) << "a new one is of the same shaders";
    fs::remove(shaders / "post.frag");
    live.reload_shaders(shaders);
    EXPECT_TRUE(live.image(2.5, size).pixels == before.pixels) << "the built-in one again";
}

TEST_F(LivePreview, AClipThatIsReplacedOnDiskIsOpenedAnew) {
    const auto clips = std::make_shared<ClipCache>();
    Preview live = preview_with(clips);
    const Image before = live.image(2.5, size);
    live.set_preset(preset);
    EXPECT_TRUE(live.image(2.5, size).pixels == before.pixels);
    replace_clip(240);
    live.set_preset(preset);
    const Image after = live.image(2.5, size);
    EXPECT_GT(test::differing(before, after), 100);
    EXPECT_TRUE(preview().image(2.5, size).pixels == after.pixels);
}

TEST_F(LivePreview, WithoutItsClipsAllElseIsLive) {
    Preview live = preview();
    live.image(2.5, size);
    preset.bleeding.speed = 12.0;
    const Image expected = preview().image(2.5, size);
    fs::remove(folder / "clip.avi");
    EXPECT_THROW(live.set_preset(preset), Error);
    live.set_parameters(preset);
    EXPECT_TRUE(live.image(2.5, size).pixels == expected.pixels);
    preset.smoke.clips.clear();
    live.set_parameters(preset);
    EXPECT_TRUE(live.image(2.5, size).pixels == expected.pixels) << "clips that play go on";
}

/// A row of each kind of work that a change may cause, one after the other.
TEST_F(LivePreview, WhoSaysWhatHasChangedSeesTheSame) {
    Preview told = preview(), asked = preview();
    Image last = told.image(2.5, size);
    int seen = 0;
    for (const auto& [key, value] : std::initializer_list<std::pair<const char*, const char*>>{
             {"bleeding.speed", "9"},          {"bleeding.gravity_bias", "0.1"},   {"bleeding.threshold", "0.9"},
             {"bleeding.deep_at", "2"},        {"bleeding.color_thin", "#20ff20"}, {"bleeding.suction_radius", "3"},
             {"bleeding.noise_strength", "1"}, {"vessels.vessel_strength", "0.2"}, {"cautery.heat_rate", "600"},
             {"cautery.tip_radius", "2.5"},    {"cautery.clip_length", "5"},       {"cautery.clip_reach", "1"},
             {"cautery.model", "bioheat"},     {"smoke.plume.fat_gain", "2"},      {"smoke.plume.density", "0.9"},
             {"smoke.haze.accumulation", "1"}, {"smoke.haze.color", "#4040ff"},    {"smoke.keying.luma_low", "90"},
             {"smoke.particles.rate", "40"},   {"smoke.clips.0.weight", "0.4"}}) {
        const Preset before = preset;
        set_parameter(preset_table(), &preset, key, value);
        const unsigned changed = difference(preset_table(), &before, &preset);
        ASSERT_NE(changed, 0U) << key;
        told.set_parameters(preset, changed);
        asked.set_parameters(preset);
        const Image picture = told.image(2.5, size);
        EXPECT_TRUE(picture.pixels == asked.image(2.5, size).pixels) << key;
        EXPECT_EQ(told.amounts().blood_area, asked.amounts().blood_area) << key;
        EXPECT_EQ(told.amounts().burnt_area, asked.amounts().burnt_area) << key;
        EXPECT_EQ(told.amounts().haze, asked.amounts().haze) << key;
        seen += picture.pixels != last.pixels;
        last = picture;
    }
    EXPECT_GT(seen, 5) << "or the test would not see what is left out";
    EXPECT_TRUE(preview().image(2.5, size).pixels == last.pixels) << "as if it had been so from the start";
}

TEST_F(LivePreview, TheCacheLooksThroughFilesOnceAndKnowsBrokenOnes) {
    ClipCache clips;
    EXPECT_FALSE(clips.knows(preset, {}));
    EXPECT_FALSE(clips.look_through(preset, {}, [](double) { return false; }));
    EXPECT_FALSE(clips.knows(preset, {}));
    double last = -1;
    EXPECT_TRUE(clips.look_through(preset, {}, [&](double share) { return std::exchange(last, share) <= share; }));
    EXPECT_EQ(last, 1.0);
    EXPECT_TRUE(clips.knows(preset, {}));
    clips.forget(folder / "clip.avi");
    EXPECT_FALSE(clips.knows(preset, {}));

    folder.write("broken.avi", std::string(700, '\1'));
    preset.smoke.clips.push_back({.file = "broken.avi"});
    const auto shared = std::make_shared<ClipCache>();
    EXPECT_TRUE(shared->look_through(preset, {}));
    EXPECT_TRUE(shared->knows(preset, {}));
    EXPECT_THROW(preview_with(shared), Error);
    preset.smoke.clips.back().file = "nowhere.avi";
    EXPECT_TRUE(shared->knows(preset, {})) << "there is nothing to be looked through";
}

TEST_F(LivePreview, AFrameThatIsLateIsToldUntilItIsThere) {
    Preview live(scene, preset, {});
    live.image(2.5, size);
    bool was_late = live.late();
    EXPECT_TRUE(test::wait_until([&] { return !live.late(); }, [&] { live.image(2.5, size); }));
    EXPECT_TRUE(was_late) << "at first nothing is decoded";
    EXPECT_TRUE(live.image(2.5, size).pixels == preview().image(2.5, size).pixels);
}

}  // namespace
}  // namespace lapfx
