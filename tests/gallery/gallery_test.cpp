// Every page at several scales: its widgets have names, can be reached and are not hidden by mistake, and it comes to
// rest when nothing happens.
#include "gallery/gallery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/tabs.h"

namespace lapfx::gallery {
namespace {

using ui::Harness;
using ui::has;
using ui::Is;
using ui::Key;
using ui::Mods;
using ui::Node;
using ui::Sense;

constexpr float scales[] = {0.75F, 1.0F, 2.0F, 3.0F};

struct Shown {
    explicit Shown(int page, float scale = 1, glm::ivec2 size = {1280, 800})
        : ui(build(page), size, scale, &state.commands) {}
    std::function<void(ui::Ui&)> build(int page) {
        state.page = page;
        return [this](ui::Ui& u) { gallery::build(u, state); };
    }
    ui::ImageStore images;
    State state{images};
    Harness ui;
};

class EveryPage : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Gallery, EveryPage, testing::Range(0, static_cast<int>(pages().size())), [](const auto& each) {
    std::string name(pages()[static_cast<std::size_t>(each.param)].name);
    std::erase(name, ' ');
    return name;
});

TEST_P(EveryPage, HasNamesForAllThatTakesTheKeyboardAndNoneTwice) {
    for (const float scale : scales) {
        for (const glm::ivec2 size : {glm::ivec2(1280, 800), glm::ivec2(300, 200)}) {
            Shown shown(GetParam(), scale, size);
            EXPECT_THAT(ui::faults_of(shown.ui.ui().tree()), testing::IsEmpty()) << "scale " << scale;
            EXPECT_EQ(shown.ui.ui().duplicates(), 0U);
        }
    }
}

std::set<ui::Id> all_focusable(Harness& harness) {
    std::set<ui::Id> found;
    for (const Node& node : harness.ui().tree()) {
        if (has(node.sense, Sense::focus) && node.layer == 0) found.insert(node.id);
    }
    return found;
}

TEST_P(EveryPage, IsWalkedThroughByTabAndBackwards) {
    for (const float scale : {1.0F, 3.0F}) {
        for (const Mods mods : {Mods::none, Mods::shift}) {
            Shown shown(GetParam(), scale);
            std::set<ui::Id> reached;
            const std::size_t count = all_focusable(shown.ui).size();
            for (std::size_t i = 0; i < 2 * count + 2; ++i) {
                shown.ui.key(Key::tab, mods);
                reached.insert(shown.ui.ui().focus());
            }
            const std::set<ui::Id> wanted = all_focusable(shown.ui);
            for (const Node& node : shown.ui.ui().tree()) {
                if (wanted.contains(node.id) && !reached.contains(node.id))
                    ADD_FAILURE() << node.label << " is not reached at scale " << scale;
            }
        }
    }
}

TEST_P(EveryPage, ShowsWhatHasTheKeyboard) {
    for (const float scale : {1.0F, 3.0F}) {
        Shown shown(GetParam(), scale);
        const std::size_t count = all_focusable(shown.ui).size();
        for (std::size_t i = 0; i < count; ++i) {
            shown.ui.key(Key::tab);
            const Node* node = nullptr;
            for (const Node& each : shown.ui.ui().tree()) {
                if (each.id == shown.ui.ui().focus() && each.id != 0) node = &each;
            }
            ASSERT_NE(node, nullptr);
            EXPECT_FALSE(node->seen().empty()) << node->label << " has the keyboard and is not seen at scale " << scale;
        }
    }
}

TEST_P(EveryPage, GivesEveryWidgetRoom) {
    for (const float scale : scales) {
        Shown shown(GetParam(), scale);
        for (const Node& node : shown.ui.ui().tree()) {
            if (node.id == 0 || node.label.empty()) continue;
            EXPECT_GT(node.rect().w, 0) << node.label << " at scale " << scale;
            EXPECT_GT(node.rect().h, 0) << node.label << " at scale " << scale;
        }
    }
}

TEST_P(EveryPage, HasTargetsThatAreLargeEnough) {
    Shown shown(GetParam());
    for (const Node& node : shown.ui.ui().tree()) {
        if (!has(node.sense, Sense::focus) || !has(node.sense, Sense::press)) continue;
        EXPECT_GE(std::max(node.rect().w, node.rect().h), 24) << node.label;
    }
}

TEST_P(EveryPage, AllocatesNothingInSteadyFrames) {
    Shown shown(GetParam());
    shown.state.reduced_motion = true;
    for (int i = 0; i < 70; ++i) shown.ui.frame();
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 300; ++i) shown.ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

TEST_P(EveryPage, AsksForNoFrameWhenNothingHappens) {
    Shown shown(GetParam());
    shown.state.reduced_motion = true;
    shown.ui.frame().settle();
    shown.ui.frame();
    EXPECT_GE(shown.ui.output().wake_at, ui::never) << shown.ui.ui().wake_reasons().back().reason;
    EXPECT_FALSE(shown.ui.output().changed);
}

TEST(Gallery, FindsPagesByNameWhateverTheCase) {
    EXPECT_EQ(page_named("Overview"), 0);
    EXPECT_EQ(page_named("overview"), 0);
    EXPECT_EQ(page_named("BASIC"), 1);
    EXPECT_EQ(page_named("Overvie"), -1);
    EXPECT_EQ(page_named(""), -1);
}

TEST(Gallery, GoesToThePageThatIsClicked) {
    Shown shown(0);
    shown.ui.click("Pages/List/Text");
    EXPECT_EQ(shown.state.page, page_named("Text"));
    EXPECT_TRUE(shown.ui.is("Pages/List/Text", Is::selected));
    EXPECT_TRUE(shown.ui.exists("Page/Text"));
    EXPECT_FALSE(shown.ui.exists("Page/Overview"));
}

TEST(Gallery, SwitchesThemeMotionAndScale) {
    Shown shown(0);
    shown.ui.click("Switches/Light");
    EXPECT_EQ(&shown.ui.ui().theme(), &ui::light_theme());
    shown.ui.click("Switches/Reduced motion");
    EXPECT_TRUE(shown.ui.ui().options().reduced_motion);
    shown.ui.click("Switches/Larger");
    EXPECT_EQ(shown.state.scale, 1.25F);
}

TEST(Gallery, ShowsThePageAloneWhenBare) {
    Shown shown(1);
    shown.state.bare = true;
    shown.ui.frame();
    EXPECT_FALSE(shown.ui.exists("Pages"));
    EXPECT_TRUE(shown.ui.exists("Page/Basic/Buttons/enabled/Normal"));
}

TEST(Gallery, PlaysItsTimelineToTheEnd) {
    Shown shown(page_named("Graphs"));
    ui::TimelineState& time = shown.state.graphs.time;
    time.time = 11, time.has_range = false, time.loop = false;
    shown.ui.frame().click("**/Time/Play");
    EXPECT_LE(shown.ui.output().wake_at, shown.ui.time + 0.02);
    const double before = time.time;
    shown.ui.frame(0.05);
    EXPECT_NEAR(time.time, before + 0.05, 1e-9);
    time.time = 11.95;
    shown.ui.frame(0.1);
    EXPECT_EQ(time.time, 12);
    EXPECT_EQ(time.speed, 0);
    time.time = 11.95, time.loop = true, time.speed = 1;
    shown.ui.frame(0.1);
    EXPECT_EQ(time.time, 0);
}

TEST(Gallery, TellsTheButtonsOfTwoNarrowTabStripsApart) {
    constexpr std::string_view names[] = {"A long name", "Another long name", "A third one"};
    Harness harness(
        [&](ui::Ui& u) {
            const ui::Column column(u, {.width = ui::px(120)});
            ui::tab_strip(u, "Upper", 0, names);
            ui::tab_strip(u, "Lower", 0, names);
        },
        {400, 200});
    harness.settle();
    const auto tree = harness.ui().tree();
    EXPECT_EQ(std::count_if(tree.begin(), tree.end(), [](const Node& n) { return n.label == "All tabs"; }), 2);
    EXPECT_EQ(harness.ui().duplicates(), 0U);
}

}  // namespace
}  // namespace lapfx::gallery
