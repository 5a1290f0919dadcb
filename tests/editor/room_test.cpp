// In every layout, scale and size of the window the main picture stays large enough to work with, all its tools can be
// reached, and no texts overlap.
#include "app/base/layouts.h"
#include "editor/support/shaped_test.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

constexpr std::array<Shape, 8> shapes = {{{1, {1440, 900}},
                                          {1.5F, {1440, 900}},
                                          {2, {1440, 900}},
                                          {1, {1280, 800}},
                                          {2, {1280, 800}},
                                          {1, {500, 400}},
                                          {1.5F, {500, 400}},
                                          {2, {500, 400}}}};

class RoomTest : public ShapedTest {
  protected:
    /// The visible part of the largest picture of a panel.
    ui::Rect picture_in(const std::string& panel) {
        ui::Rect largest;
        const auto tree = ui().ui().tree();
        for (std::uint32_t i = 0; i < tree.size(); ++i) {
            const bool picture = tree[i].role == ui::Role::image || tree[i].role == ui::Role::canvas;
            if (!picture || !ui::path_of(tree, i).starts_with("Workspace/" + panel + "/")) continue;
            const ui::Rect seen = tree[i].seen();
            if (seen.w * seen.h > largest.w * largest.h) largest = seen;
        }
        return largest;
    }
    /// Expects the tool in the panel, fully visible, or in the menu of tools that have no room there.
    void expect_reachable(const std::string& panel, const std::string& menu, const std::string& name) {
        const std::string place = "Workspace/" + panel + "/";
        if (ui().exists(place + name)) {
            EXPECT_LE(ui().rect(place + name).right(), ui().rect("Workspace/" + panel).right() + 1) << name;
            EXPECT_GE(ui().rect(place + name).x, ui().rect("Workspace/" + panel).x) << name;
            return;
        }
        ASSERT_TRUE(ui().exists(place + "More...")) << name << " is nowhere: " << ui().dump();
        if (!ui().exists(menu)) ui().click(place + "More...").frame().frame();
        EXPECT_TRUE(ui().exists(menu + "/" + name)) << name << ": " << ui().dump();
        const ui::Rect rect = ui().rect(menu + "/" + name);
        EXPECT_LE(rect.right(), static_cast<float>(ui().size.x)) << name;
        EXPECT_LE(rect.bottom(), static_cast<float>(ui().size.y)) << name;
    }
};

TEST_F(RoomTest, TheMainPictureOfEveryLayoutIsLargeEnough) {
    for (const auto& [name, panel] : {std::pair<std::string, std::string>{"Tune", "View"},
                                      {"Key", "Keying"},
                                      {"Compare", "Reference"},
                                      {"Stage", "View"}}) {
        shape(shapes[0]);
        layout(name);
        for (const Shape& to : shapes) {
            shape(to);
            const ui::Rect picture = picture_in(panel);
            const float em = ui().ui().em(1);
            const std::string what = name + " at " + std::to_string(to.scale) + ", " + std::to_string(to.size.x) +
                                     " x " + std::to_string(to.size.y);
            EXPECT_GE(picture.w, 11 * em) << what;
            EXPECT_GE(picture.h, 4.5F * em) << what;
        }
    }
}

TEST_F(RoomTest, EveryToolOfTheViewCanBeReached) {
    editor().tool.action = ToolAction::cauterise;
    editor().looking.endoscope = false;
    for (const std::string name : {"Tune", "Key"}) {
        shape(shapes[0]);
        layout(name);
        for (const Shape& to : shapes) {
            SCOPED_TRACE(name + " at " + std::to_string(to.scale) + ", " + std::to_string(to.size.x));
            shape(to);
            if (!ui().exists("Workspace/View")) continue;  // a tab that is not in front
            for (const std::string tool :
                 {"Tool", "Power", "Strength", "Overlay", "Endoscope view", "Use view as endoscope", "Frame the organ"})
                expect_reachable("View", "View tools", tool);
            if (ui().exists("View tools")) ui().key(ui::Key::escape).frame();
        }
    }
}

TEST_F(RoomTest, ASmallWindowHasOneGroupOfTabsAndALargeOneItsLayoutAgain) {
    layout("Compare");
    const ui::DockLayout before = editor().layouts().shown;
    for (const glm::ivec2 small : {glm::ivec2(500, 400), {800, 600}, {600, 400}}) {
        shape({1, small});
        EXPECT_TRUE(editor().layouts().stacked()) << small.x;
    }
    EXPECT_EQ(editor().layouts().shown.nodes.size(), 1U);
    EXPECT_EQ(editor().layouts().arranged(), before) << "what the settings keep";
    EXPECT_TRUE(editor().layouts().seen("Reference"));
    shape({1, {1440, 900}});
    EXPECT_EQ(editor().layouts().shown, before);
    shape({1, {500, 400}});
    editor().layouts().shown.show("Snapshots");
    editor().layouts().shown.close("Curves");
    EXPECT_LT(editor().layouts().arranged().find("Curves"), 0) << "what the settings keep has it closed at once";
    EXPECT_EQ(editor().layouts().arranged().nodes.size(), before.nodes.size());
    shape({1, {1440, 900}});
    EXPECT_TRUE(editor().layouts().seen("Snapshots")) << "what was brought to the front stays there";
    EXPECT_LT(editor().layouts().shown.find("Curves"), 0) << "and what was closed is closed";
    EXPECT_EQ(editor().layouts().shown.nodes.size(), before.nodes.size());
}

}  // namespace
}  // namespace lapfx::test
