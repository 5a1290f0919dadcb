#include "ui/widgets/dock_layout.h"

#include <gmock/gmock.h>

#include <random>
#include <set>

namespace lapfx::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view all[] = {"View", "Parameters", "Scopes", "Presets", "Log"};

DockLayout standard() {
    return dock_split(Axis::x, 0.7F, dock_tabs({"View"}),
                      dock_split(Axis::y, 0.5F, dock_tabs({"Parameters", "Scopes"}), dock_tabs({"Presets", "Log"})));
}

std::vector<std::string> tabs_with(const DockLayout& layout, std::string_view panel) {
    return layout.nodes[static_cast<std::size_t>(layout.find(panel))].tabs;
}

/// Expects that the layout has every panel once, that each node has one parent, and that no leaf is empty.
void expect_sound(const DockLayout& layout) {
    std::multiset<std::string> panels(layout.closed.begin(), layout.closed.end());
    std::vector<int> reached(layout.nodes.size());
    for (std::size_t i = 0; i < layout.nodes.size(); ++i) {
        const DockNode& node = layout.nodes[i];
        panels.insert(node.tabs.begin(), node.tabs.end());
        if (node.leaf()) {
            ASSERT_FALSE(node.tabs.empty());
            ASSERT_GE(node.active, 0);
            ASSERT_LT(node.active, static_cast<int>(node.tabs.size()));
            continue;
        }
        ASSERT_TRUE(node.tabs.empty());
        for (const int child : {node.first, node.second}) {
            ASSERT_GT(child, static_cast<int>(i));
            ++reached[static_cast<std::size_t>(child)];
        }
    }
    ASSERT_EQ(reached[0], 0);
    for (std::size_t i = 1; i < reached.size(); ++i) ASSERT_EQ(reached[i], 1);
    ASSERT_EQ(panels, std::multiset<std::string>(std::begin(all), std::end(all)));
}

TEST(DockLayout, MovesAPanelOntoAnotherGroup) {
    DockLayout layout = standard();
    layout.move("Scopes", layout.find("Presets"), DockSide::center, 1);
    EXPECT_THAT(tabs_with(layout, "Scopes"), ElementsAre("Presets", "Scopes", "Log"));
    EXPECT_EQ(layout.nodes[static_cast<std::size_t>(layout.find("Scopes"))].active, 1);
    EXPECT_THAT(tabs_with(layout, "Parameters"), ElementsAre("Parameters"));
    layout.move("Parameters", layout.find("Presets"), DockSide::center);
    EXPECT_THAT(tabs_with(layout, "Log"), ElementsAre("Presets", "Scopes", "Log", "Parameters"));
    EXPECT_EQ(layout.nodes.size(), 3U) << "the group that is empty has gone, and its split";
    expect_sound(layout);
}

TEST(DockLayout, MovesAPanelToASideOfAGroup) {
    for (const auto& [side, axis, before] :
         {std::tuple(DockSide::left, Axis::x, true), std::tuple(DockSide::right, Axis::x, false),
          std::tuple(DockSide::top, Axis::y, true), std::tuple(DockSide::bottom, Axis::y, false)}) {
        DockLayout layout = standard();
        layout.move("Log", layout.find("View"), side);
        const DockNode& split = layout.nodes[static_cast<std::size_t>(layout.nodes[0].first)];
        ASSERT_FALSE(split.leaf());
        EXPECT_EQ(split.axis, axis);
        EXPECT_EQ(layout.find("Log"), before ? split.first : split.second);
        EXPECT_EQ(layout.find("View"), before ? split.second : split.first);
        expect_sound(layout);
    }
}

TEST(DockLayout, SplitsAGroupOffItself) {
    DockLayout layout = standard();
    layout.move("Scopes", layout.find("Scopes"), DockSide::bottom);
    EXPECT_THAT(tabs_with(layout, "Parameters"), ElementsAre("Parameters"));
    EXPECT_THAT(tabs_with(layout, "Scopes"), ElementsAre("Scopes"));
    expect_sound(layout);
    const DockLayout before = layout;
    layout.move("Scopes", layout.find("Scopes"), DockSide::left);
    EXPECT_EQ(layout, before) << "alone it cannot be split off";
}

TEST(DockLayout, ReordersWithinAGroup) {
    DockLayout layout = dock_tabs({"View", "Parameters", "Scopes", "Presets", "Log"});
    layout.move("View", 0, DockSide::center, 2);  // between Parameters and Scopes; the index counts View
    EXPECT_THAT(layout.nodes[0].tabs, ElementsAre("Parameters", "View", "Scopes", "Presets", "Log"));
    layout.move("Log", 0, DockSide::center, 0);
    EXPECT_THAT(layout.nodes[0].tabs, ElementsAre("Log", "Parameters", "View", "Scopes", "Presets"));
    EXPECT_EQ(layout.nodes[0].active, 0);
}

TEST(DockLayout, ClosesAndShowsAgain) {
    DockLayout layout = standard();
    layout.close("View");
    EXPECT_THAT(layout.closed, ElementsAre("View"));
    EXPECT_EQ(layout.nodes.size(), 3U);
    expect_sound(layout);
    layout.show("View");
    EXPECT_TRUE(layout.closed.empty());
    EXPECT_THAT(tabs_with(layout, "View"), ElementsAre("Parameters", "Scopes", "View"));
    EXPECT_EQ(layout.nodes[static_cast<std::size_t>(layout.find("View"))].active, 2);
    layout.show("Log");
    EXPECT_EQ(layout.nodes[static_cast<std::size_t>(layout.find("Log"))].active, 1);
    for (const std::string_view panel : all) layout.close(panel);
    EXPECT_EQ(layout.closed.size(), 4U) << "the last one stays";
    expect_sound(layout);
}

TEST(DockLayout, StaysSoundWhateverIsDoneToIt) {
    std::mt19937 random(7);
    const auto any = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    DockLayout layout = standard();
    for (int i = 0; i < 20000; ++i) {
        const std::string_view panel = all[any(5)];
        const std::size_t what = any(4);
        if (what == 0) layout.close(panel);
        if (what == 1) layout.show(panel);
        const std::size_t leaf = any(layout.nodes.size());
        if (what >= 2 && layout.nodes[leaf].leaf())
            layout.move(panel, static_cast<int>(leaf), static_cast<DockSide>(any(5)), static_cast<int>(any(6)) - 1);
        ASSERT_NO_FATAL_FAILURE(expect_sound(layout));
        if (i % 100 == 0) {
            const NamedLayout named{"Now", layout};
            ASSERT_EQ(read_layouts(write_layouts({&named, 1}), all).front().layout, layout);
        }
    }
}

TEST(DockLayout, DropsUnknownPanelsAndTakesInMissingOnes) {
    const std::string text = R"({"version": 1, "layouts": [{"name": "Old", "closed": ["Log", "Gone"],
        "root": {"split": "x", "fraction": 7.5, "first": {"tabs": ["Ancient"]},
            "second": {"split": "y", "fraction": 0.25, "first": {"tabs": ["Ancient 2", "View", "View"], "active": 1},
                "second": {"tabs": ["Scopes"], "active": 99}}}}]})";
    const DockLayout layout = read_layouts(text, all).front().layout;
    expect_sound(layout);
    EXPECT_THAT(layout.nodes[1].tabs, ElementsAre("View", "Parameters", "Presets"));
    EXPECT_EQ(layout.nodes[1].active, 0) << "View is in front still";
    EXPECT_THAT(layout.nodes[2].tabs, ElementsAre("Scopes"));
    EXPECT_EQ(layout.nodes[2].active, 0);
    EXPECT_FLOAT_EQ(layout.nodes[0].fraction, 0.25F);
    EXPECT_THAT(layout.closed, ElementsAre("Log"));
}

TEST(DockLayout, PanelsOfAnotherNameKeepTheirPlaces) {
    const std::string text = R"({"version": 1, "layouts": [{"name": "Old", "closed": ["Journal"],
        "root": {"split": "x", "fraction": 0.7, "first": {"tabs": ["View"]},
            "second": {"tabs": ["Scopes", "Samples", "Parameters"], "active": 1}}}]})";
    const RenamedPanel renamed[] = {{.before = "Samples", .now = "Presets"}, {.before = "Journal", .now = "Log"}};
    const DockLayout layout = read_layouts(text, all, renamed).front().layout;
    expect_sound(layout);
    EXPECT_THAT(layout.nodes[1].tabs, ElementsAre("View"));
    EXPECT_THAT(layout.nodes[2].tabs, ElementsAre("Scopes", "Presets", "Parameters"));
    EXPECT_EQ(layout.nodes[2].active, 1) << "it is in front still";
    EXPECT_THAT(layout.closed, ElementsAre("Log"));
}

TEST(DockLayout, AFileWithNothingInItHoldsEverything) {
    const auto layouts = read_layouts(R"({"version": 1, "layouts": [{"name": "Empty"}]})", all);
    EXPECT_EQ(layouts.front().layout.nodes[0].tabs.size(), 5U);
    const auto shut = read_layouts(
        R"({"version": 1,
            "layouts": [{"name": "Shut", "closed": ["View", "Parameters", "Scopes", "Presets", "Log"]}]})",
        all);
    expect_sound(shut.front().layout);
    EXPECT_EQ(shut.front().layout.closed.size(), 4U);
}

TEST(DockLayout, SaysWhatIsWrongWithAText) {
    const auto fault = [](const std::string& text) -> std::string {
        try {
            read_layouts(text, all);
        } catch (const std::invalid_argument& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_THAT(fault("{"), HasSubstr("layouts: "));
    EXPECT_THAT(fault(R"({"version": 9, "layouts": []})"), HasSubstr("version 9"));
    EXPECT_THAT(fault(R"({"version": 1, "layouts": [{"name": "A", "root": {"split": "z"}}]})"),
                HasSubstr("allowed are x, y"));
    EXPECT_THAT(fault(R"({"version": 1, "layouts": [{"name": "A", "root": {"tabs": 3}}]})"), HasSubstr("layouts: "));
    std::string deep;
    for (int i = 0; i < 1000; ++i) deep += R"({"split": "x", "fraction": 0.5, "second": {"tabs": []}, "first": )";
    EXPECT_THAT(fault(R"({"version": 1, "layouts": [{"name": "A", "root": )" + deep + R"({"tabs": []})" +
                      std::string(1000, '}') + "}]}"),
                HasSubstr("too deep"));
}

}  // namespace
}  // namespace lapfx::ui
