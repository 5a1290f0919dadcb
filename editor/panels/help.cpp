// Help: what the pointer does (the other half of the sheet of keys), and what lapfx is made of.
#include "panels/panels.h"
#include "panels/parts.h"
#include "ui/shell/dialog.h"
#include "ui/shell/key_editor.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/scroll.h"

namespace lapfx::panels {

namespace {

using ui::SheetLine;

constexpr SheetLine in_view[] = {
    {"Use the tool", "hold on organ"},         {"Orbit", "drag"},
    {"Pan", "Shift+drag, middle drag"},        {"Zoom at the pointer", "wheel"},
    {"Turn about this point", "double click"},
};
constexpr SheetLine on_numbers[] = {
    {"Change", "drag"},
    {"Ten times finer", "Shift+drag"},
    {"By steps", "Ctrl+drag"},
    {"One step", "Ctrl+wheel"},
    {"Type: 12/2, 0.5 cm", "double click"},
    {"Saved value", "double click name"},
    {"Menu: copy, lock, range", "right click"},
    {"Cancel a drag", "right press, Esc"},
};
constexpr SheetLine on_pictures[] = {
    {"Zoom at the pointer", "wheel"},
    {"Pan", "drag, middle drag"},
    {"Fit", "double click"},
    {"The other picture, while held", "F"},
};
constexpr SheetLine on_times[] = {
    {"Go to a time", "drag ruler"},         {"Zoom", "wheel"},
    {"Pan", "Shift+wheel, middle drag"},    {"Move an event", "drag it"},
    {"Stretch an event", "drag its end"},   {"Select one more event", "Shift+click"},
    {"Move without snapping", "Ctrl+drag"}, {"All of it", "F"},
};
constexpr SheetLine on_plots[] = {
    {"Pan", "drag"},
    {"Zoom to a box", "Shift+drag"},
    {"Fit", "double click, F"},
};
constexpr SheetLine in_file_dialogs[] = {
    {"Complete what is typed", "Tab"},
    {"Take a suggestion", "Up, Down, Enter"},
    {"Go to a name", "letters in the list"},
    {"Folder above", "Alt+Up"},
    {"New folder", "Ctrl+Shift+N"},
    {"Name or path", "Ctrl+L"},
    {"Hidden files", "Ctrl+H"},
    {"Read again", "F5"},
};
constexpr ui::SheetPart pointer_parts[] = {
    {"Mouse: view, looking freely", in_view},
    {"Mouse: numbers", on_numbers},
    {"Mouse: pictures", on_pictures},
    {"Mouse: timeline", on_times},
    {"Mouse: plots", on_plots},
    {"Keys: choosing files", in_file_dialogs},
};

constexpr std::string_view version = LAPFX_VERSION;
constexpr std::string_view paper =
    "T. Halic, G. Sankaranarayanan, S. De: GPU-based Efficient Realistic Techniques for Bleeding and Smoke "
    "Generation in Surgical Simulators. Int J Med Robot 6(4), 431-443, 2010. doi:10.1002/rcs.353";

struct Library {
    std::string_view name, use, licence;
};
constexpr Library libraries[] = {
    {"FFmpeg", "videos", "LGPL 2.1 or later, or GPL if built that way"},
    {"OpenCV", "images", "Apache 2.0"},
    {"tinygltf", "glTF", "MIT"},
    {"meshoptimizer", "packed glTF", "MIT"},
    {"Draco", "packed glTF", "Apache 2.0"},
    {"OpenMesh", "OFF", "BSD 3-clause"},
    {"GLM", "vectors", "MIT"},
    {"nlohmann/json", "JSON", "MIT"},
    {"CLI11", "command line", "BSD 3-clause"},
    {"GLFW", "window", "zlib"},
    {"glad", "OpenGL loader", "MIT"},
    {"FreeType", "glyphs", "FreeType License"},
    {"HarfBuzz", "text", "MIT"},
    {"fontconfig", "fonts", "MIT"},
    {"utf8proc", "characters", "MIT"},
    {"xxHash", "hashes", "BSD 2-clause"},
};

std::string graphics_of(const app::EditorOptions& options) {
    const std::string& name = options.renderer;
    return (name.empty() ? "unknown" : name) + (options.software ? " (software)" : "");
}

void about_line(ui::Ui& ui, std::string_view name, std::string_view text) {
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::start});
    ui::label(ui, name, {.tone = ui::Tone::dim, .width = ui::px(ui.em(8))});
    ui::label(ui, text, {.wrap = true, .width = ui::grow()});
}

}  // namespace

void keys_sheet(ui::Ui& ui, const ui::CommandTable& commands) {
    ui::cheat_sheet(ui, commands, pointer_parts);
}

void about_dialog(ui::Ui& ui, const app::EditorOptions& options) {
    ui::Dialog dialog(ui, "about", "About lapfx", {.width = 46, .height = 43});
    if (!dialog) return;
    const std::string graphics = graphics_of(options);
    {
        const ui::ScrollArea area(ui, "What it is", {.gap = 0.4F});
        ui::heading(ui, ui.join({"lapfx ", version}));
        ui::label(ui, "Bleeding and surgical smoke for laparoscopic simulators, and the editor that tunes both.",
                  {.wrap = true, .width = ui::grow()});
        about_line(ui, "OpenGL", ui.copy(graphics));
        about_line(ui, "Paper", paper);
        ui::separator(ui);
        ui::label(ui, "Libraries, each under its own licence", {.tone = ui::Tone::dim});
        for (const Library& library : libraries)
            about_line(ui, library.name, ui.join({library.licence, "  (", library.use, ")"}));
    }
    const auto pressed = dialog.buttons({{.label = "Copy", .tip = "Version and OpenGL, for a bug report"},
                                         {.label = "Close", .standard = true, .cancel = true}});
    if (pressed == 0 && ui.clipboard() != nullptr)
        ui.clipboard()->set("lapfx " + std::string(version) + ", OpenGL: " + graphics);
}

}  // namespace lapfx::panels
