// The preview is told what a change touched. Whatever order changes come in, the picture is the one that it shows once
// everything is set anew.
#include "app/clips/clip_shelf.h"
#include "app/preview/preview_host.h"
#include "editor/support/editor_test.h"

namespace lapfx::test {
namespace {

class FollowTest : public SampleTest {
  protected:
    using Content = document::Content;
    template <typename F>
    void change(F&& with) {
        editor().document.change("Change", std::forward<F>(with));
        ui().frame();
    }
    /// Pixels that change once every value is set and every clip is opened anew.
    std::size_t left_behind() {
        const Image followed = picture(6);
        editor().preview.reload_clips();
        ui().frame();
        return differing(followed, picture(6), 0);
    }
};

TEST_F(FollowTest, EachGroupOfValuesIsSeenAtOnce) {
    const std::vector<std::pair<const char*, std::function<void(Content&)>>> changes = {
        {"a clip's weight", [](Content& c) { c.preset.smoke.clips[1].weight = 0; }},
        {"blood", [](Content& c) { c.preset.bleeding.speed = 20; }},
        {"its look", [](Content& c) { c.preset.bleeding.opacity = 0.4; }},
        {"vessels", [](Content& c) { c.preset.vessels.vessel_strength = 0.1; }},
        {"heat", [](Content& c) { c.preset.cautery.heat_rate = 800; }},
        {"plume", [](Content& c) { c.preset.smoke.plume.size = 60; }},
        {"haze", [](Content& c) { c.preset.smoke.haze.accumulation = 2.5; }},
        {"keying", [](Content& c) { c.preset.smoke.keying.luma_high = 90; }},
        {"a clip's loop", [](Content& c) { c.preset.smoke.clips[2].in = 0.4; }},
    };
    Image before = picture(6);
    for (const auto& [name, with] : changes) {
        change(with);
        const Image after = picture(6);
        EXPECT_GT(differing(before, after, 0), 10U) << name;
        before = after;
    }
    EXPECT_EQ(left_behind(), 0U);
    editor().document.go_to(0);
    ui().frame();
    EXPECT_EQ(left_behind(), 0U) << "all of them undone";
}

TEST_F(FollowTest, WhatCannotBeShownKeepsNoLaterChangeFromBeingSeen) {
    const Image before = picture(6);
    change([](Content& c) { c.preset.smoke.keying.luma_low = 0.95, c.preset.smoke.keying.luma_high = 0.2; });
    ASSERT_EQ(editor().preview.preset_faults().size(), 1U);
    EXPECT_EQ(differing(before, picture(6), 0), 0U);
    change([](Content& c) { c.preset.bleeding.speed = 20; });
    EXPECT_GT(differing(before, picture(6)), 100U);
    change([](Content& c) { c.preset.smoke.keying.luma_low = 0.1; });
    EXPECT_TRUE(editor().preview.preset_faults().empty());
    EXPECT_EQ(left_behind(), 0U) << "both values of the keying are seen, though the last change was of one";
    change([](Content& c) { c.preset.smoke.haze.accumulation = 2.5; });
    EXPECT_EQ(left_behind(), 0U);
}

TEST_F(FollowTest, AClipThatIsMissingKeepsNoValueFromBeingSeen) {
    const std::string file = editor().document.preset().smoke.clips[0].file;
    change([](Content& c) { c.preset.smoke.clips[0].file = "nowhere.mp4"; });
    ASSERT_EQ(editor().preview.preset_faults().size(), 1U);
    const Image before = picture(6);
    change([](Content& c) { c.preset.bleeding.speed = 20; });
    const Image after = picture(6);
    EXPECT_GT(differing(before, after), 100U);
    EXPECT_EQ(editor().preview.preset_faults().size(), 1U) << "and it is still told";
    change([&](Content& c) { c.preset.smoke.clips[0].file = file; });
    EXPECT_TRUE(editor().preview.preset_faults().empty());
    EXPECT_EQ(left_behind(), 0U);
}

TEST_F(FollowTest, WhileAClipSmokesAloneValuesAreFollowedToo) {
    ASSERT_GE(editor().document.preset().smoke.clips.size(), 2U);
    editor().clips().play_alone(0);
    ui().frame();
    change([](Content& c) { c.preset.smoke.clips[0].weight = 0.3, c.preset.bleeding.speed = 20; });
    EXPECT_EQ(left_behind(), 0U);
    change([](Content& c) { std::swap(c.preset.smoke.clips[0].role, c.preset.smoke.clips[1].role); });
    EXPECT_EQ(left_behind(), 0U) << "a plume alone has no haze";
    editor().clips().play_alone({});
    ui().frame();
    EXPECT_EQ(left_behind(), 0U);
}

}  // namespace
}  // namespace lapfx::test
