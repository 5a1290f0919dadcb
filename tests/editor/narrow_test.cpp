// Large text and narrow windows: widgets that are next to each other do not overlap, and nothing is wider than its
// panel.
#include "app/base/layouts.h"
#include "app/measure/amounts.h"
#include "app/tuning/snapshots.h"
#include "editor/support/editor_test.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

class NarrowTest : public SampleTest {
  protected:
    NarrowTest() { begins.layout = "Compare"; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        editor().layouts().shown.close("Reference");
        editor().layouts().shown.close("View");
        editor().snapshots().keep(0);
        editor().document.change("Speed", [](document::Content& c) {
            c.preset.bleeding.speed = 9;
            c.preset.name = "A name that is longer than any panel is wide, and then some";
        });
        editor().snapshots().keep(1);
    }
    void shape(float scale, glm::ivec2 size) {
        ui().scale = scale;
        ui().size = size;
        ui().frame().frame().frame();
    }

    void show(std::string_view panel) {
        editor().layouts().shown.show(panel);
        ui().frame().frame();
    }

    struct Box {
        std::string path;
        ui::Rect rect;
    };
    /// The widgets of a panel that contain no other widgets.
    std::vector<Box> boxes(const std::string& panel) {
        const auto tree = ui().ui().tree();
        std::vector<bool> holds(tree.size(), false);
        for (const ui::Node& node : tree)
            if (node.parent != ui::no_node) holds[node.parent] = true;
        std::vector<Box> all;
        for (std::uint32_t i = 0; i < tree.size(); ++i) {
            const std::string path = ui::path_of(tree, i);
            if (holds[i] || tree[i].label.empty() || !path.starts_with("Workspace/" + panel + "/")) continue;
            if (path.find("/Differences/") != std::string::npos) continue;  // a table scrolls sideways
            if (path.find("scroll bar") == std::string::npos) all.push_back({path, tree[i].rect()});
        }
        return all;
    }
    void expect_apart(const std::string& panel) {
        const ui::Rect area = ui().rect("Workspace/" + panel);
        const std::vector<Box> all = boxes(panel);
        EXPECT_GE(all.size(), 4U) << panel;
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_GE(all[i].rect.x, area.x - 1) << all[i].path;
            EXPECT_LE(all[i].rect.right(), area.right() + 1) << all[i].path << ": wider than its panel";
            for (std::size_t k = i + 1; k < all.size(); ++k) {
                const ui::Rect both = intersect(all[i].rect, all[k].rect);
                EXPECT_FALSE(both.w > 1 && both.h > 1) << all[i].path << " and " << all[k].path << " overlap";
            }
        }
    }
    void expect_all_apart(float scale, glm::ivec2 size) {
        SCOPED_TRACE(std::to_string(size.x) + " px at scale " + std::to_string(scale));
        shape(scale, size);
        for (const char* const panel : {"Snapshots", "Amounts"}) {  // one lies behind the other in a small window
            show(panel);
            expect_apart(panel);
        }
    }
};

TEST_F(NarrowTest, SnapshotsAndAmountsDoNotOverlap) {
    for (const int of : {app::AmountsLook::in_view, app::AmountsLook::on_organ}) {
        editor().amounts().look.of = of;
        expect_all_apart(1, {1440, 900});
        expect_all_apart(1, {1280, 800});
        expect_all_apart(1.5F, {1440, 900});
        expect_all_apart(1, {800, 600});
        expect_all_apart(1, {600, 800});
        expect_all_apart(1.5F, {900, 700});
        expect_all_apart(2, {1280, 800});
    }
}

TEST_F(NarrowTest, PlotsKeepRoomForTheirCurves) {
    editor().amounts().look.of = app::AmountsLook::on_organ;
    shape(1, {600, 800});
    show("Amounts");
    const ui::Rect plot = ui().rect("**/All plots/Blood area");
    EXPECT_GT(plot.h, 80.0F);
    EXPECT_GT(plot.w, 120.0F);
    shape(1, {1440, 900});
    EXPECT_FALSE(ui().exists("**/All plots/vertical scroll bar"))
        << "all fit in a window of usual size: " << ui().dump();
}

TEST_F(NarrowTest, SnapshotsWorkWhenTheyAreIcons) {
    shape(1, {830, 800});  // a smaller one has all panels in one group, as wide as the window
    ASSERT_FALSE(editor().layouts().stacked());
    show("Snapshots");
    ASSERT_LT(ui().rect("**/Show A").w, ui().ui().em(2.5F)) << "an icon";
    ui().click("**/Show A").frame();
    EXPECT_TRUE(editor().snapshots().shown(0));
    ui().click("**/Keep C").frame();
    EXPECT_TRUE(editor().snapshots().at(2).has_value());
}

}  // namespace
}  // namespace lapfx::test
