// Menus offer nothing that does not work: each command does something that a person can see, or is disabled and says
// what is missing. Each entry of a menu is such a command, or says why it is disabled.
#include <gmock/gmock.h>

#include <set>

#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/clips/clip_shelf.h"
#include "app/clips/keying_bench.h"
#include "app/files/files.h"
#include "app/measure/fitting.h"
#include "app/reference/reference.h"
#include "app/tuning/snapshots.h"
#include "app/tuning/tuning.h"
#include "editor/support/editor_test.h"
#include "ui/core/node.h"

namespace lapfx::test {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;
using ui::Key;

class CommandsTest : public EditorTest {
  protected:
    CommandsTest() { begins.window = {900, 640}; }
    ui::CommandTable& commands() { return editor().commands; }

    /// What a person sees or would notice: the tree of widgets, the document, what is on or off, notices.
    std::string state() {
        ui().frame().frame();
        const app::Editor& e = editor();
        std::string text = ui().dump() + "focus " + ui().focused();
        for (std::size_t i = 0; i < commands().size(); ++i) text += commands().checked(i) ? '1' : '0';
        const auto add = [&](auto value) { text += ' ' + std::to_string(value); };
        add(e.document.version());
        add(e.timeline.time);
        add(e.looking.camera.eye.x);
        add(e.toasts.log().size());
        add(editor().files().closed());
        return text + ui().clipboard().text;
    }

    /// Creates everything that commands work on: changes to undo and to redo, clips, snapshots, a held reference, a
    /// selected event and a selected parameter, a notice. What is on in one variant is off in the other.
    void prepare(int variant) {
        app::Editor& e = editor();
        for (int i = 0; i < 4; ++i) ui().key(Key::escape);
        e.toasts.clear();
        e.document.open(content_, scene_file_, preset_file_);
        e.forget_document();
        e.document.change("Marks", [](document::Content& c) {
            c.scene.reference.marks.smoke_starts = 1;
            c.scene.reference.loop = {.from = 1, .to = 2};
            c.scene.reference.measure.baseline = 1;
        });
        if (variant == 1)
            e.document.change("Paint blood", [](document::Content& c) {
                c.scene.reference.measure.strokes = {{.time = 1, .points = {{0.5, 0.5}}}};
            });
        for (const double speed : {5.0, 6.0, 7.0})
            e.document.change("Speed", [&](document::Content& c) { c.preset.bleeding.speed = speed; });
        e.document.undo();
        for (std::size_t slot = 0; slot < app::Snapshots::count; ++slot)
            if (!e.snapshots().at(slot)) e.snapshots().keep(slot);
        e.document.change("Speed", [&](document::Content& c) { c.preset.bleeding.speed = 8; });
        e.document.change("Speed", [&](document::Content& c) { c.preset.bleeding.speed = 9 + variant; });
        e.document.undo();
        e.clips().selected = 1;
        e.selected = {0};
        e.timeline.speed = 0;
        e.timeline.seek(3.3);
        e.tuning().current = app::parameters().find("bleeding.speed");
        e.tuning().search.clear();
        e.fitting().look.keys.clear();  // it says so at once; what a fit finds is looked at in fit_panel_test
        e.tuning().changed_only = false;
        e.tool.action.reset();
        if (variant == 1) e.tool.action = ToolAction::tear;
        e.looking.endoscope = false;
        e.looking.camera.eye.x += 10;
        e.settings().half_resolution = true;
        e.settings().hint_seen = true;
        ui().clipboard().text = "{}";
        e.layouts().choose(variant == 0 ? "Key" : "Tune");
        if (variant == 1)
            for (const char* panel : {"Reference", "Library", "Snapshots"}) e.layouts().bring_to_front(panel);
        ui().frame().frame();
        e.reference().hold(30);
        e.toasts.add({.text = "A notice", .seconds = 0});
        ui().frame().frame();
    }

    void open_all() {
        open_sample();
        editor().reference().choose_sample();
        ui().frame().frame().frame();
        content_ = editor().document.content();
        scene_file_ = editor().document.scene_file();
        preset_file_ = editor().document.preset_file();
        ASSERT_FALSE(content_.scene.reference.file.empty());
        ASSERT_GE(content_.preset.smoke.clips.size(), 3U);
    }

    /// Whether the command does something. It must be enabled.
    bool does_something(std::size_t command) {
        const std::string before = state();
        EXPECT_EQ(before, state()) << commands()[command].id << ": something changes by itself";
        commands().run(command);
        return state() != before;
    }

  private:
    document::Content content_;
    std::filesystem::path scene_file_, preset_file_;
};

TEST_F(CommandsTest, EachDoesSomethingWhereItIsOn) {
    open_all();
    std::set<std::string> idle, off;
    for (std::size_t i = 0; i < commands().size(); ++i) {
        const std::string id = commands()[i].id;
        bool does = false, on = false;
        for (int variant = 0; variant < 2 && !does; ++variant) {
            prepare(variant);
            if (!commands().enabled(i)) continue;
            on = true;
            does = does_something(i);
        }
        if (!on) off.insert(id);
        if (on && !does) idle.insert(id);
    }
    EXPECT_THAT(idle, IsEmpty());
    EXPECT_THAT(off, UnorderedElementsAre("clip.copy", "fit.leave", "fit.report", "fit.take", "measure.export_csv",
                                          "measure.export_json", "measure.export_png", "measure.larger_brush",
                                          "measure.smaller_brush", "measure.take_marks", "reference.leave_look",
                                          "reference.take_look"))
        << "copy_clips_test has clips that lie elsewhere, measure_panel_test measures and paints, fit_panel_test fits, "
           "regions_test takes and leaves a look, which goes with the scene that it was made for";
}

TEST_F(CommandsTest, WhatIsOffSaysWhatIsMissing) {
    for (const bool opened : {false, true}) {
        if (opened) open_sample();
        ui().frame().frame();
        std::size_t off = 0;
        for (std::size_t i = 0; i < commands().size(); ++i) {
            const ui::Command& command = commands()[i];
            EXPECT_FALSE(command.tip.empty()) << command.id << " is not explained";
            EXPECT_EQ(static_cast<bool>(command.enabled), !command.missing.empty())
                << command.id << ": what can be off says what is missing then, and nothing else does";
            if (commands().enabled(i)) continue;
            ++off;
            EXPECT_NE(commands().tip(ui().ui(), i).find("\nNot now: " + command.missing), std::string_view::npos);
        }
        EXPECT_GE(off, 5U) << (opened ? "the sample" : "an empty editor");
    }
}

TEST_F(CommandsTest, WhatIsOffDoesNothing) {
    ui().frame();
    for (std::size_t i = 0; i < commands().size(); ++i) {
        if (commands().enabled(i)) continue;
        const std::string before = state();
        EXPECT_FALSE(commands().run(i)) << commands()[i].id;
        EXPECT_EQ(state(), before) << commands()[i].id;
    }
}

/// The entries of the open menu by their labels.
std::map<std::string, const ui::Node*> entries(const ui::Ui& ui) {
    std::map<std::string, const ui::Node*> found;
    for (const ui::Node& node : ui.tree())
        if (node.role == ui::Role::menu_item) found[std::string(node.shown)] = &node;
    return found;
}

TEST_F(CommandsTest, PanelsThatAreSeenHaveAMark) {
    layout("Tune");
    const auto marked = [&](const std::string& id) {
        return editor().commands.checked(editor().commands.index_of(id));
    };
    EXPECT_TRUE(marked("window.show_view"));
    EXPECT_FALSE(marked("window.show_keying")) << "a tab behind another";
    editor().commands.run("window.show_keying");
    EXPECT_TRUE(marked("window.show_keying"));
    EXPECT_FALSE(marked("window.show_preset"));
    EXPECT_EQ(editor().commands[editor().commands.index_of("window.settings")].group, "Edit");
}

TEST_F(CommandsTest, EachIsInTheMenuOfItsGroup) {
    open_sample();
    std::set<std::string> groups;
    for (std::size_t i = 0; i < commands().size(); ++i) groups.insert(commands()[i].group);
    std::size_t seen = 0;
    for (const std::string& group : groups) {
        ui().click("Menu bar/" + group).frame();
        const auto shown = entries(ui().ui());
        for (std::size_t i = 0; i < commands().size(); ++i) {
            if (commands()[i].group != group) continue;
            const auto entry = shown.find(commands()[i].title);
            ASSERT_NE(entry, shown.end()) << commands()[i].id;
            EXPECT_EQ(has(entry->second->is, ui::Is::disabled), !commands().enabled(i)) << commands()[i].id;
            EXPECT_EQ(entry->second->tip, commands().tip(ui().ui(), i)) << commands()[i].id;
            ++seen;
        }
        ui().key(Key::escape).frame();
    }
    EXPECT_EQ(seen, commands().size());
}

TEST_F(CommandsTest, EntriesOfOtherMenusThatAreOffSayWhy) {
    open_sample();
    std::size_t off = 0;
    const auto look = [&](const std::string& menu) {
        ui().frame();
        const auto shown = entries(ui().ui());
        EXPECT_GE(shown.size(), 3U) << menu;
        for (const auto& [label, node] : shown) {
            if (!has(node->is, ui::Is::disabled)) continue;
            ++off;
            EXPECT_FALSE(node->tip.empty()) << menu << ": " << label;
        }
        ui().key(Key::escape).frame();
    };
    ui().click("Workspace/Preset/More");
    look("preset");
    ui().click("Workspace/Preset/Parameters/Bleeding/More");
    look("group");
    editor().layouts().bring_to_front("Library");
    ui().frame().frame();
    ui().click("Workspace/Library/Filter/More");
    look("presets");
    ui().right_click("Workspace/Library/Presets/Heavy haze");
    look("preset file");
    EXPECT_GE(off, 2U) << "nothing is changed: nothing can be reset";
}

}  // namespace
}  // namespace lapfx::test
