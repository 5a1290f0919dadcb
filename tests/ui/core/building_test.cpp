// Ids from build to build: a widget keeps its id when its place changes.
#include "ui/core/building.h"

#include <gmock/gmock.h>

#include "ui/core/node.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

/// A column of buttons, with the place that each had in the frame before.
struct Buttons {
    std::vector<std::string> names;
    std::vector<Id> ids;
    std::vector<float> before;  ///< y; -1: it did not exist
    Harness ui{[this](Ui& u) {
        const Column column(u);
        ids.clear();
        const bool first = before.empty();  // build of this frame
        for (const std::string& name : names) {
            button(u, name);
            ids.push_back(u.last().id);
            const Node* node = u.before(u.last().id);
            if (first) before.push_back(node == nullptr ? -1 : node->rect().y);
        }
    }};
    Id id_of(std::string_view name) const {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == name) return ids[i];
        return 0;
    }
    void show(std::vector<std::string> next) {
        names = std::move(next);
        before.clear();
        ui.frame();
    }
};

TEST(Building, WidgetsKeepTheirIdsWhenOthersComeAndGo) {
    Buttons b;
    b.show({"A", "B", "C"});
    const Id a = b.id_of("A"), c = b.id_of("C");
    const float y = b.ui.rect("C").y;
    b.show({"New", "A", "C"});
    EXPECT_EQ(b.id_of("A"), a);
    EXPECT_EQ(b.id_of("C"), c);
    b.show({"C", "A"});
    EXPECT_EQ(b.id_of("A"), a);
    EXPECT_EQ(b.id_of("C"), c);
    EXPECT_LT(b.ui.rect("C").y, y);
}

TEST(Building, AWidgetKnowsWhereItWasThoughItStandsElsewhere) {
    Buttons b;
    b.show({"A", "B", "C"});
    const float a = b.ui.rect("A").y, c = b.ui.rect("C").y;
    b.show({"C", "D", "A"});
    EXPECT_THAT(b.before, testing::ElementsAre(c, -1, a));
    const float d = b.ui.rect("D").y;
    b.show({"D", "C"});
    EXPECT_THAT(b.before, testing::ElementsAre(d, a));  // C was at the place that A had
    b.show({"A"});
    EXPECT_THAT(b.before, testing::ElementsAre(-1)) << "it was not in the build before";
}

TEST(Building, TwoOfOneLabelHaveTwoIdsInEveryOrder) {
    Buttons b;
    b.show({"Other", "Same"});
    const Id same = b.id_of("Same");
    b.show({"Same", "Same"});  // the second is at the place of the only one before
    EXPECT_EQ(b.ids[0], same);
    EXPECT_NE(b.ids[1], same);
    EXPECT_EQ(b.ui.ui().duplicates(), 1U);
    const Id second = b.ids[1];
    for (int i = 0; i < 3; ++i) {
        b.show({"Same", "Same"});
        EXPECT_THAT(b.ids, testing::ElementsAre(same, second));
        EXPECT_EQ(b.ui.ui().duplicates(), 1U);
    }
    b.show({"Same", "Same", "Same"});
    EXPECT_EQ(b.ids[0], same);
    EXPECT_EQ(b.ids[1], second);
    EXPECT_NE(b.ids[2], second);
    b.show({"Other", "Same"});
    EXPECT_EQ(b.id_of("Same"), same);
    EXPECT_EQ(b.ui.ui().duplicates(), 0U);
}

TEST(Building, NamesThatNeverComeAgainTakeNoMemory) {
    Buttons b;
    const auto some = [](int round) {
        std::vector<std::string> names;
        for (int i = 0; i < 100; ++i) names.push_back(std::to_string(100 * round + i));
        return names;
    };
    for (int round = 0; round < 40; ++round) b.show(some(round));
    const std::size_t before = b.ui.ui().memory_used();
    for (int round = 40; round < 400; ++round) b.show(some(round));
    EXPECT_LE(b.ui.ui().memory_used(), before + 64 * 1024);
    EXPECT_EQ(b.ui.ui().duplicates(), 0U);
}

}  // namespace
}  // namespace lapfx::ui
