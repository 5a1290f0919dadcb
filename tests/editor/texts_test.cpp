// In every layout, scale and size of the window no texts overlap, and none is cut so that it cannot be read. What
// a person has written may end in an ellipsis where there is no room; labels, numbers and the program's texts may not.
#include "ui/support/texts.h"
#include <gmock/gmock.h>

#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/files/organ_choice.h"
#include "app/reference/reference.h"
#include "editor/support/shaped_test.h"

namespace lapfx::test {
namespace {

using testing::IsEmpty;

constexpr std::array<Shape, 6> shapes = {
    {{1, {1440, 900}}, {1.5F, {1440, 900}}, {2, {1440, 900}}, {1, {800, 600}}, {1, {500, 400}}, {2, {3840, 2160}}}};

class TextsTest : public ShapedTest {
  protected:
    void expect_readable(const std::string& what) {
        const float em = ui().ui().em(1);
        const auto texts = ui::texts_seen(*ui().output().list, ui::Harness::fonts(), em);
        EXPECT_GE(texts.size(), 10U) << what;
        EXPECT_THAT(ui::texts_over_texts(ui().ui().tree(), texts, em), IsEmpty()) << what;
        EXPECT_THAT(ui::cut_texts(ui().ui().tree(), texts, em), IsEmpty()) << what;
    }
    /// Checks the panels whose tabs are in front, then brings each of the others to the front and checks it.
    void expect_readable_everywhere(const std::string& name) {
        for (const Shape& to : shapes) {
            char text[64];
            std::snprintf(text, sizeof text, " at %.1f, %d x %d", static_cast<double>(to.scale), to.size.x, to.size.y);
            shape(to);
            expect_readable(name + text);
            for (const std::string_view panel : editor().layouts().panels()) {
                if (editor().layouts().seen(panel) || editor().layouts().shown.find(panel) < 0) continue;
                editor().layouts().shown.show(panel);
                ui().frame().frame();
                expect_readable(name + text + ", " + std::string(panel) + " in front");
            }
        }
    }
};

TEST_F(TextsTest, NoneLiesOverAnotherOrIsCut) {
    namespace fs = std::filesystem;
    const fs::path tool = folder() / "a folder of some depth/with instruments of all kinds/hook_electrode_long.glb";
    fs::create_directories(tool.parent_path());
    fs::copy_file(shipped() / "samples/hook_cautery.glb", tool);
    editor().document.change("Values", [&](document::Content& c) {
        c.scene.camera.eye = {-73.456, 118.275, -204.125};
        c.scene.tool.port = {-73.456, 118.275, -204.125};
        c.scene.tool.file = tool.string();
    });
    for (const std::string_view name : {"Tune", "Key", "Compare", "Stage"}) {
        shape(shapes[0]);
        layout(name);
        expect_readable_everywhere(std::string(name));
    }
}

TEST_F(TextsTest, ToolsThatPlaceTheReferenceAreReadable) {
    shape(shapes[0]);
    layout("Compare");
    editor().reference().choose_sample();
    ui().frame().frame();
    editor().document.change("Place", [](document::Content& c) {
        c.scene.reference.placement = {.right = -1.8125, .up = -1.9375, .scale = 0.125, .rotation = -179.5};
    });
    editor().reference().comparison().placing = true;
    for (const Shape& to : shapes) {
        char text[64];
        std::snprintf(text, sizeof text, "Place at %.1f, %d x %d", static_cast<double>(to.scale), to.size.x, to.size.y);
        shape(to);
        editor().layouts().shown.show("Reference");
        ui().frame().frame();
        EXPECT_TRUE(ui().exists("**/Reference/Right")) << text;
        expect_readable(text);
    }
}

TEST_F(TextsTest, DialogsAreReadableAndTheirButtonsSideBySide) {
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    const auto check = [&](const std::string& name) {
        ui().frame().frame();
        const float em = ui().ui().em(1);
        const auto texts = ui::texts_seen(*ui().output().list, ui::Harness::fonts(), em);
        auto cut = ui::cut_texts(ui().ui().tree(), texts, em);
        std::erase_if(cut, [](const std::string& one) { return one.starts_with("Workspace/"); });  // lies under it
        EXPECT_THAT(cut, IsEmpty()) << name;
        if (name.starts_with("help.keys")) return;  // without buttons
        const auto tree = ui().ui().tree();
        std::uint32_t dialog = ui::no_node;
        for (std::uint32_t i = 0; i < tree.size(); ++i)
            if (tree[i].role == ui::Role::dialog) dialog = i;
        ASSERT_NE(dialog, ui::no_node) << name;
        // The buttons below its content.
        std::vector<ui::Rect> buttons;
        float wide = 0;
        for (std::uint32_t i = 0; i < tree.size(); ++i)
            if (tree[i].role == ui::Role::button && tree[i].parent != ui::no_node &&
                tree[tree[i].parent].parent == dialog)
                buttons.push_back(tree[i].rect()), wide += tree[i].extent[0] + 0.5F * em;
        EXPECT_FALSE(buttons.empty()) << name;
        if (wide + 2 * em > static_cast<float>(ui().size.x)) return;
        for (const ui::Rect& button : buttons) EXPECT_EQ(button.y, buttons.front().y) << name << ": a row of their own";
    };
    for (const Shape& to : shapes) {
        shape(to);
        char text[64];
        std::snprintf(text, sizeof text, " at %.1f, %d x %d", static_cast<double>(to.scale), to.size.x, to.size.y);
        for (const char* const command :
             {"window.settings", "help.about", "help.keys", "window.layouts", "export.open", "file.new"}) {
            editor().commands.run(command);
            ui().frame().frame();
            check(command + std::string(text));
            ui().key(ui::Key::escape).frame().frame();
        }
        editor().organ_choice().open(shipped() / "samples/liver_lobe.glb");
        check("organ" + std::string(text));
        ui().key(ui::Key::escape).frame().frame();
    }
}

TEST_F(TextsTest, PlotsAndCurvesHaveRoom) {
    for (const std::string_view name : {"Tune", "Key", "Compare", "Stage"})
        for (const Shape& to : {shapes[0], shapes[3], shapes[5]}) {
            shape(to);
            layout(name);
            for (const std::string_view panel : editor().layouts().panels()) {
                if (editor().layouts().shown.find(panel) < 0) continue;
                editor().layouts().shown.show(panel);
                ui().frame().frame();
                const auto tree = ui().ui().tree();
                const float em = ui().ui().em(1);
                for (std::uint32_t i = 0; i < tree.size(); ++i) {
                    if (tree[i].role != ui::Role::plot && tree[i].role != ui::Role::curve) continue;
                    const ui::Rect rect = tree[i].rect();
                    EXPECT_GE(rect.w, 8 * em) << ui::path_of(tree, i) << " in " << name << " at " << to.size.x;
                    EXPECT_GE(rect.h, 5 * em) << ui::path_of(tree, i) << " in " << name << " at " << to.size.x;
                }
            }
        }
}

}  // namespace
}  // namespace lapfx::test
