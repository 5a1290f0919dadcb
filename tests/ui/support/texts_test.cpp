// Tests of the finder of overlapping texts, on texts that it has to find.
#include "ui/support/texts.h"

#include <gmock/gmock.h>

#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

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

}  // namespace
}  // namespace lapfx::ui
