// For the eye: LAPFX_UI_LOOK=/tmp lapfx_ui_tests --gtest_filter=BoxesLook* writes a picture.
#include <cstdlib>

#include "ui/gl/renderer.h"
#include "ui/support/gl_context.h"
#include "ui/support/harness.h"
#include "ui/support/picture.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/dock.h"
#include "ui/widgets/section.h"
#include "ui/widgets/table.h"
#include "ui/widgets/thumbnails.h"
#include "ui/widgets/tree_view.h"

namespace lapfx::ui {
namespace {

class BoxesLook : public test::GlTest {
  protected:
    void SetUp() override {
        if (std::getenv("LAPFX_UI_LOOK") == nullptr) GTEST_SKIP() << "LAPFX_UI_LOOK is not set";
        test::GlTest::SetUp();
    }
};

void parameters(Ui& u) {
    ScrollArea area(u, "List", {.gap = 0.4F});
    constexpr SectionButton buttons[] = {{Icon::reset, "Reset"}};
    if (Section section(u, "Bleeding", {.changed = 3, .buttons = buttons}); section) {
        for (int i = 0; i < 9; ++i) label(u, "Parameter##" + std::to_string(i));
    }
    if (Section section(u, "Smoke", {.open = false}); section) label(u, "Speed");
    if (Section section(u, "Light"); section) {
        for (int i = 0; i < 9; ++i) label(u, "Parameter##" + std::to_string(i));
    }
}

TEST_F(BoxesLook, ADeskWithEverythingOnIt) {
    constexpr std::string_view all[] = {"Presets", "Parameters", "Scopes", "Clips", "Parts"};
    DockLayout layout =
        dock_split(Axis::x, 0.65F, dock_split(Axis::y, 0.55F, dock_tabs({"Presets"}), dock_tabs({"Clips"})),
                   dock_split(Axis::y, 0.6F, dock_tabs({"Parameters", "Scopes"}), dock_tabs({"Parts"})));
    Selection preset;
    preset.only(2);
    TableState clips;
    clips.sort_column = 1;
    clips.selection.only(1);
    TreeState parts;
    parts.selection.only(2);
    const TableColumn columns[] = {{"Name", 14}, {"Length", 6, Align::end}, {"State", 8}};
    const TreeItem items[] = {{"Liver", 0, Icon::folder, Icon::eye},
                              {"Left lobe", 1, Icon::folder, Icon::eye},
                              {"Segment 2", 2, Icon::image, Icon::eye},
                              {"Segment 3", 2, Icon::image, Icon::eye_off, "", true},
                              {"Gallbladder", 0, Icon::image, Icon::eye}};
    const auto build = [&](std::size_t panel, Ui& u) {
        if (panel == 0)
            thumbnails(u, "Grid", preset, 20, [](std::size_t i) {
                return Thumbnail{
                    .label = i == 1 ? "A preset with a long name" : "Preset", .star = i == 0, .changed = i == 3};
            });
        if (panel == 1) parameters(u);
        if (panel == 3)
            table(u, "Clips", clips, columns, 100, [](std::size_t, std::size_t column) {
                if (column == 1) return TableCell{.text = "12.5 s", .number = true};
                if (column == 2) return TableCell{.text = "ready", .icon = Icon::check, .tone = Tone::good};
                return TableCell{.text = "plate_0012.exr", .icon = Icon::file};
            });
        if (panel == 4) tree_view(u, "Tree", parts, items);
    };
    Harness ui([&](Ui& u) { dock(u, "Desk", layout, all, [&](std::size_t panel) { build(panel, u); }); }, {1100, 760});
    const auto show = [&](const std::string& name) {
        const test::Canvas canvas(ui.size);
        Renderer renderer;
        renderer.draw(*ui.output().list, Harness::fonts(), &ui.images(), canvas.framebuffer());
        test::write_png(canvas.read(), std::string(std::getenv("LAPFX_UI_LOOK")) + "/boxes_" + name + ".png");
    };
    ui.focus("**/Grid").key(Key::right);
    show("desk");
    ui.press("Desk/tabs/Scopes", {0.3F, 0.5F}).move({500, 300});
    show("drag");
}

}  // namespace
}  // namespace lapfx::ui
