// Tests of the finder of overlapping texts, on texts that it has to find.
#include "ui/support/texts.h"

#include <gmock/gmock.h>

#include <cmath>

#include "ui/support/harness.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/param.h"
#include "ui/widgets/tabs.h"
#include "ui/widgets/text_field.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<TextSeen> seen(Harness& ui) {
    texts_seen(*ui.output().list, Harness::fonts(), ui.ui().em(1));  // its ellipses may move letters in the atlas
    ui.frame();
    return texts_seen(*ui.output().list, Harness::fonts(), ui.ui().em(1));
}
std::vector<std::string> over(Harness& ui) {
    return texts_over_texts(ui.ui().tree(), seen(ui), ui.ui().em(1));
}
std::vector<std::string> cut(Harness& ui) {
    return cut_texts(ui.ui().tree(), seen(ui), ui.ui().em(1));
}

TEST(Texts, TwoOverEachOtherAreFoundUnlessSomethingOpaqueIsBetween) {
    float shift = 4;
    bool opaque = false;
    Harness ui([&](Ui& u) {
        button(u, "First one", {.width = px(120)});
        if (opaque) {
            button(u, "Second one", {.width = px(120)});
            u.last().placed = true;
            u.last().placement = u.arena().make(Placement{.offset = {shift, 0}});
            return;
        }
        label(u, "Second one");
        u.last().placed = true;
        u.last().placement = u.arena().make(Placement{.offset = {shift, 0}});
    });
    EXPECT_THAT(over(ui), ElementsAre(HasSubstr("Second one")));
    shift = 200;
    ui.frame();
    EXPECT_THAT(over(ui), IsEmpty());
    shift = 0, opaque = true;
    ui.frame();
    EXPECT_THAT(over(ui), IsEmpty()) << "what is covered is not seen";
    EXPECT_THAT(cut(ui), IsEmpty());
}

TEST(Texts, NumbersPathsAndNamesWithoutTheirEndAreFound) {
    std::string path = "/a/folder/of/some/depth/organ.glb";
    bool keeps_end = false;
    float width = 120;
    double eye = -7345678.25;
    Harness ui([&](Ui& u) {
        label(u, path, {.path = keeps_end, .width = px(width)});
        text_field(u, "File", path, {.width = px(width), .read_only = true, .path = keeps_end});
        number_field(u, "X", eye, {.minimum = -1e8, .maximum = 1e8, .width = px(keeps_end ? 160.0F : 60.0F)});
    });
    EXPECT_THAT(cut(ui), ElementsAre(HasSubstr("organ.glb"), HasSubstr("File"), HasSubstr("X (slider")));
    keeps_end = true, width = 160;
    ui.frame();
    EXPECT_THAT(cut(ui), IsEmpty()) << "the end of a path is seen: its beginning has given way";
}

TEST(Texts, AnEllipsisAloneIsFound) {
    float width = 200;
    Harness ui([&](Ui& u) {
        label(u, "Wwwwwww", {.width = px(width)});
        label(u, "/a/path/of/wwwwwww", {.path = true, .width = px(width)});
        button(u, "Wwwwwww", {.width = px(width + std::ceil(1.4F * u.em(1)))});
    });
    EXPECT_THAT(cut(ui), IsEmpty());
    width = ui.ui().text_width("\u2026") + 2;
    ui.frame();
    const auto texts = seen(ui);
    ASSERT_EQ(texts.size(), 3U);
    for (const TextSeen& text : texts) EXPECT_EQ(text.glyphs.size(), 1U);
    EXPECT_THAT(cut(ui), testing::Contains(HasSubstr("nothing of it is left")).Times(3));
}

TEST(Texts, APathBeginsWithAWholeFolderWhereThereIsRoom) {
    const std::string path = "/home/someone/videos/plume.mp4";
    float width = 1000;
    Harness ui([&](Ui& u) { label(u, path, {.path = true, .width = px(width)}); });
    EXPECT_EQ(seen(ui).front().glyphs.size(), path.size());
    width = ui.ui().text_width("\u2026ne/videos/plume.mp4") + 2;
    ui.frame();
    EXPECT_EQ(seen(ui).front().glyphs.size(), 1 + std::string("/videos/plume.mp4").size());
    width = ui.ui().text_width("\u2026ume.mp4") + 1;
    ui.frame();
    EXPECT_EQ(seen(ui).front().glyphs.size(), 1 + std::string("ume.mp4").size());
}

TEST(Texts, HalfATabIsFound) {
    constexpr std::string_view names[] = {"Timeline", "Amounts", "Curves", "Presets", "Snapshots"};
    float width = 400;
    Harness ui([&](Ui& u) { tab_strip(u, "Panels", 0, names, {.width = px(width)}); }, {640, 200});
    for (width = 400; width > 100; width -= 7) {
        ui.frame().frame();
        EXPECT_THAT(cut(ui), IsEmpty()) << width << ": names are seen whole or not at all";
        EXPECT_GE(seen(ui).size(), 1U) << width;
    }
}

}  // namespace
}  // namespace lapfx::ui
