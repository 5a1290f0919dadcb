// The finder of overlapping and cut texts is itself tried, on what it has to find.
#include "ui/support/texts.h"

#include <gmock/gmock.h>

#include "ui/support/harness.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/scroll.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

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

TEST(Texts, ALabelOfAButtonIsNotToBeElidedAValueMay) {
    float width = 60;
    Harness ui([&](Ui& u) {
        const Column column(u, {.width = px(200)});
        button(u, "Use for all clips", {.width = px(width)});
        label(u, "a value that is too long for its place in this column");
    });
    EXPECT_THAT(cut(ui), ElementsAre(HasSubstr("Use for all clips")));
    width = 200;
    ui.frame();
    EXPECT_THAT(cut(ui), IsEmpty());
}

TEST(Texts, AClipThatTakesPartOfALineIsFoundWhereNobodyScrolls) {
    bool scrolls = false;
    Harness ui([&](Ui& u) {
        const auto lines = [&] {
            for (const char* line : {"one line", "two lines", "three lines"}) label(u, line);
        };
        if (scrolls) {
            const Column column(u, {.width = px(200), .height = px(42)});
            const ScrollArea area(u, "Lines");
            return lines();
        }
        Node& box = u.open(Role::group, "Lines", Axis::y);
        box.size[0] = px(200), box.size[1] = px(42);
        box.clips = true;
        lines();
        u.close();
    });
    EXPECT_THAT(cut(ui), SizeIs(1));
    scrolls = true;
    ui.frame().frame();
    EXPECT_THAT(cut(ui), IsEmpty());
}

}  // namespace
}  // namespace lapfx::ui
