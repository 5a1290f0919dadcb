// The closed lists of the core (lapfx/tool.h, lapfx/view.h): each row belongs to its enumerator, and everything that it
// names exists.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "gl/generated_shaders.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"
#include "lapfx/view.h"
#include "support/folders.h"

namespace lapfx {
namespace {

TEST(ToolActions, RowsFollowTheEnumeratorsAndAreToldApart) {
    std::set<std::string_view> keys, titles;
    std::set<char> shortcuts;
    std::set<int> colors;
    for (std::size_t i = 0; i < tool_action_count; ++i) {
        const ToolActionRow& row = tool_actions[i];
        EXPECT_EQ(row.action, static_cast<ToolAction>(i)) << row.key;
        EXPECT_EQ(&row_of(row.action), &row);
        EXPECT_TRUE(keys.insert(row.key).second && titles.insert(row.title).second) << row.key;
        EXPECT_TRUE(shortcuts.insert(row.shortcut).second) << row.shortcut;
        EXPECT_TRUE(colors.insert(row.color).second) << row.key;
        EXPECT_TRUE(row.color >= 0 && row.color < 8) << row.key;
        EXPECT_FALSE(row.help.empty() || row.help.ends_with('.')) << row.key;
        EXPECT_EQ(ToolContact{.action = row.action}.hot(), row.hot);
        EXPECT_EQ(divides(row.action), row.divides);
        EXPECT_TRUE(row.divides || row.hot || row.clears != nullptr || row.sets_clip) << row.key << " does nothing";
        EXPECT_TRUE(row.divides || (row.strength == 1.0 && !row.frays)) << row.key << " opens no wounds";
        EXPECT_TRUE(row.hot || !row.gentle) << row.key << " has no heat";
        EXPECT_TRUE(row.clears != nullptr || !row.rinses) << row.key << " clears nothing";
        Preset preset;
        const FoundParameter reach = find_parameter(preset_table(), &preset, row.reach);
        EXPECT_EQ(reach.row->unit, "mm") << row.reach;
        if (row.clears != nullptr) {
            preset.bleeding.*row.clears = 7.25;
            EXPECT_EQ(std::get<double>(reach.row->get(&preset.bleeding)), 7.25) << row.reach;
        }
    }
}

TEST(ToolActions, SceneFilesTakeTheirKeysAndHelp) {
    const Parameter& row = *scene_table().find("events")->find_row("action");
    ASSERT_EQ(row.choices.size(), tool_action_count);
    for (const ToolActionRow& action : tool_actions) {
        EXPECT_EQ(row.choices[static_cast<std::size_t>(action.action)], action.key);
        const std::string told = std::string(action.key) + ": " + std::string(action.help) + '.';
        EXPECT_NE(row.help.find(told), std::string_view::npos) << row.help;
    }
    EXPECT_TRUE(row.help.ends_with('.')) << row.help;
}

TEST(Overlays, RowsFollowTheEnumeratorsAndTheShadersKnowThem) {
    const std::string text = gl::generated_text("overlays.glsl").value();
    std::set<std::string_view> keys;
    for (std::size_t i = 0; i < std::size(overlays); ++i) {
        EXPECT_EQ(overlays[i].overlay, static_cast<Overlay>(i)) << overlays[i].key;
        EXPECT_TRUE(keys.insert(overlays[i].key).second) << overlays[i].key;
        EXPECT_EQ(overlays[i].command.empty(), overlays[i].shortcut == 0) << overlays[i].key;
    }
    EXPECT_EQ(text,
              "const int OVERLAY_NONE = 0;\nconst int OVERLAY_VESSELS = 1;\nconst int OVERLAY_FAT = 2;\n"
              "const int OVERLAY_BLEED = 3;\n");
    EXPECT_EQ(gl::generated_text("overlay.glsl"), std::nullopt) << "a file";
}

TEST(Overlays, TheShaderAsksForEachByName) {
    std::ifstream file(test::source_folder() / "shaders" / "overlay.glsl");
    const std::string shader(std::istreambuf_iterator<char>(file), {});
    std::istringstream names(gl::generated_text("overlays.glsl").value());
    int rows = 0;
    for (std::string line; std::getline(names, line); ++rows) {
        const std::string name = line.substr(10, line.find(" =") - 10);  // const int NAME = 0;
        EXPECT_TRUE(shader.find("== " + name + ")") != shader.npos || shader.find("!= " + name + ")") != shader.npos)
            << name << " would be drawn as another overlay";
    }
    EXPECT_EQ(rows, static_cast<int>(std::size(overlays)));
}

}  // namespace
}  // namespace lapfx
