// For the eye: LAPFX_UI_LOOK=/tmp lapfx_ui_tests --gtest_filter=ShellLook* writes a picture of each.
#include <cstdlib>

#include "ui/gl/renderer.h"
#include "ui/shell/commands.h"
#include "ui/shell/dialog.h"
#include "ui/shell/file_dialog.h"
#include "ui/shell/key_editor.h"
#include "ui/shell/menu.h"
#include "ui/shell/palette.h"
#include "ui/shell/progress.h"
#include "ui/shell/status_bar.h"
#include "ui/shell/toast.h"
#include "ui/support/gl_context.h"
#include "ui/support/harness.h"
#include "ui/support/picture.h"

namespace lapfx::ui {
namespace {

class ShellLook : public test::GlTest {
  protected:
    void SetUp() override {
        if (std::getenv("LAPFX_UI_LOOK") == nullptr) GTEST_SKIP() << "LAPFX_UI_LOOK is not set";
        test::GlTest::SetUp();
    }
    static void show(Harness& ui, const std::string& name) {
        ui.frame();
        const test::Canvas canvas(ui.size);
        Renderer renderer;
        renderer.draw(*ui.output().list, Harness::fonts(), &ui.images(), canvas.framebuffer());
        test::write_png(canvas.read(), std::string(std::getenv("LAPFX_UI_LOOK")) + "/shell_" + name + ".png");
    }
};

TEST_F(ShellLook, MenusNoticesAndTheStatusBar) {
    Toasts toasts;
    toasts.add({.kind = ToastKind::good, .text = "Exported 240 frames", .action = "Show"});
    toasts.add({.kind = ToastKind::error,
                .text = "plate_0012.exr cannot be read: the file ends in the middle of a line of pixels"});
    Harness ui([&](Ui& u) {
        {
            MenuBar bar(u);
            if (BarMenu file(u, "File"); file) {
                menu_item(u, "Open", {.icon = Icon::folder, .shortcut = "Ctrl+O"});
                menu_item(u, "Save", {.icon = Icon::file, .shortcut = "Ctrl+S", .enabled = false});
                menu_separator(u);
                if (Submenu recent(u, "Recent"); recent) {
                    menu_item(u, "sparkler.json");
                    menu_item(u, "smoke.json", {.checked = true});
                }
                menu_item(u, "Quit", {.shortcut = "Ctrl+Q"});
            }
            if (BarMenu view(u, "View"); view) menu_item(u, "Grid");
        }
        {
            Panel panel(u, "Panel");
            progress(u, "Decoding", 0.42, {.seconds_left = 80, .cancellable = true, .text = "100 of 240"});
            progress(u, "Reading", -1);
        }
        StatusBar bar(u);
        status_text(u, "State", "plate_0012.exr, 2048 x 1152", {.icon = Icon::image});
        spacer(u);
        status_text(u, "Frame", "8.1 ms", {.number = true});
        toasts.build(u);
    });
    ui.focus("Menu bar/File").key(Key::enter).type("r").key(Key::right);
    show(ui, "menus");
}

TEST_F(ShellLook, AQuestion) {
    Harness ui([&, first = true](Ui& u) mutable {
        {
            Panel panel(u, "Panel");
            button(u, "Below");
        }
        if (std::exchange(first, false)) open_dialog(u, "q");
        ask(u, "q", "Save the changes?",
            "\"sparkler.json\" has changes that are not saved. Without saving they are lost.",
            {{.label = "Discard"}, {.label = "Cancel", .cancel = true}, {.label = "Save", .standard = true}},
            Tone::warning);
    });
    show(ui, "question");
}

CommandTable some_commands() {
    CommandTable table;
    const auto add = [&](const char* id, const char* group, const char* title, Chord chord, Icon icon = Icon::none) {
        table.add({.id = id, .title = title, .group = group, .chord = chord, .icon = icon, .run = [] {}});
    };
    add("open", "File", "Open", {key_of('O'), Mods::command}, Icon::folder);
    add("save", "File", "Save", {key_of('S'), Mods::command}, Icon::file);
    add("save as", "File", "Save as", {key_of('S'), Mods::command | Mods::shift});
    add("play", "Timeline", "Play", {key_of('K'), Mods::none}, Icon::play);
    add("next", "Timeline", "Next frame", {Key::right, Mods::none}, Icon::step_forward);
    add("scopes", "View", "Show scopes", {});
    add("grid", "View", "Grid", {key_of('G'), Mods::none});
    return table;
}

TEST_F(ShellLook, ThePaletteAndTheKeys) {
    CommandTable table = some_commands();
    Harness ui([&](Ui& u) {
        {
            Panel panel(u, "Keys of commands");
            key_editor(u, table);
        }
        palette(u, table);
        cheat_sheet(u, table);
    });
    ui.frame().click("**/Keys of View: Grid").key('S', Mods::command);
    show(ui, "key_editor");
    open_palette(ui.ui());
    ui.frame().type("s");
    show(ui, "palette");
    ui.key(Key::escape);
    toggle_cheat_sheet(ui.ui());
    show(ui.frame(), "cheat_sheet");
}

TEST_F(ShellLook, TheFileDialog) {
    FileDialog dialog(system_files());
    Harness ui([&](Ui& u) { dialog.build(u); }, {1000, 640});
    dialog.set_recent({"/usr/include", "/usr/lib"});
    dialog.open(ui.ui(), {.task = FileTask::open,
                          .title = "Open a plate",
                          .folder = LAPFX_SOURCE_DIR,
                          .filters = {{"Text", {".md", ".txt"}}}});
    ui.frame().click("**/README.md");
    show(ui, "file_dialog");
}

}  // namespace
}  // namespace lapfx::ui
