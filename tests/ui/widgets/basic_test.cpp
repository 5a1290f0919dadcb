#include "ui/widgets/basic.h"

#include "ui/core/node.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

struct BasicTest : testing::Test {
    float width = 600;
    Harness ui{[this](Ui& u) {
        Row row(u, {.width = px(width)});
        label(u, "Diffusion of carbonised tissue");
        label(u, "Diffusion of carbonised tissue");
        button(u, "As wide as it likes", {.width = px(width / 6)});
    }};
};

TEST_F(BasicTest, ALabelThatIsCutIsWholeInItsTooltip) {
    const auto label_node = [&]() -> const Node& {
        for (const Node& node : ui.ui().tree()) {
            if (node.role == Role::label) return node;
        }
        throw std::runtime_error("no label");
    };
    ui.frame();
    EXPECT_EQ(label_node().sense, Sense::none);
    width = 300;
    ui.frame().move(label_node().rect().center()).frame();
    EXPECT_EQ(label_node().tip, "Diffusion of carbonised tissue");
    EXPECT_EQ(ui.ui().duplicates(), 0U) << "two of them may read the same";
    ui.frame(1);
    const auto tree = ui.ui().tree();
    EXPECT_TRUE(std::any_of(tree.begin(), tree.end(), [](const Node& n) { return n.role == Role::tooltip; }));
    width = 600;
    ui.frame().frame();
    EXPECT_EQ(label_node().tip, "");
}

TEST_F(BasicTest, SoIsAButton) {
    ui.move_to("As wide as it likes").frame();
    EXPECT_EQ(ui.tip("As wide as it likes"), "As wide as it likes");
    width = 3000;
    ui.frame().frame();
    EXPECT_EQ(ui.tip("As wide as it likes"), "");
}

TEST(Basic, InARowALabelStandsAsHighAsWhatIsBesideIt) {
    for (const float scale : {1.0F, 1.25F, 1.5F, 1.75F, 2.0F, 3.0F}) {
        const auto build = [&](Ui& u) {
            Row row(u);
            label(u, "H");
            button(u, "H");
        };
        Harness ui(build, {640, 480}, scale);
        std::vector<float> tops;
        for (const Instance& instance : ui.output().list->instances) {
            if (instance.kind == InstanceKind::glyph) tops.push_back(instance.y);
        }
        ASSERT_EQ(tops.size(), 2U);
        EXPECT_EQ(tops[0], tops[1]) << scale;
    }
}

TEST(Basic, LabelsThatChangeAllTheTimeTakeNoMemory) {
    char digits[16] = {};
    int n = 1000;
    Harness ui([&](Ui& u) {
        std::snprintf(digits, sizeof digits, "%d", n);
        label(u, digits, {.number = true});
    });
    for (int i = 0; i < 100; ++i) ++n, ui.frame();
    const std::size_t before = ui.ui().memory_used();
    for (int i = 0; i < 5000; ++i) ++n, ui.frame();
    EXPECT_EQ(ui.ui().memory_used(), before);
}

}  // namespace
}  // namespace lapfx::ui
