// For the eye: LAPFX_UI_LOOK=/tmp lapfx_ui_tests --gtest_filter=FieldsLook* writes a picture of each.
#include <cstdlib>

#include "ui/gl/renderer.h"
#include "ui/support/gl_context.h"
#include "ui/support/harness.h"
#include "ui/support/picture.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/gradient.h"
#include "ui/widgets/text_area.h"
#include "ui/widgets/text_field.h"

namespace lapfx::ui {
namespace {

struct FieldsLook : test::GlTest {
    std::string text = "a longer name that does not fit into its field at all", empty,
                notes =
                    "First line of the notes, which is so long that it has to be wrapped.\n\nThen a second one.\n"
                    "And more\nand more\nof them",
                search = "smoke";
    int chosen = 1, view = 0, mode = 2;
    Color key = rgb(0x2f9e44);
    std::vector<GradientStop> stops{{0, rgb(0x14122b)}, {0.35F, rgb(0xc2483f)}, {1, {255, 230, 160, 90}}};
    Eyedropper dropper;

    void SetUp() override {
        if (std::getenv("LAPFX_UI_LOOK") == nullptr) GTEST_SKIP() << "LAPFX_UI_LOOK is not set";
        test::GlTest::SetUp();
    }
    void build(Ui& u) {
        static constexpr std::string_view views[] = {"Colour", "Matte", "False colour"};
        static constexpr std::string_view modes[] = {"Normal", "Screen", "Add", "Multiply", "Overlay"};
        static const std::vector<std::string> names = [] {
            std::vector<std::string> made;
            for (int i = 0; i < 300; ++i) made.push_back("plate_" + std::to_string(i) + ".exr");
            return made;
        }();
        static const std::vector<std::string_view> plates(names.begin(), names.end());
        const Panel panel(u, "Fields");
        text_field(u, "Name", text, {.caption = true});
        text_field(u, "Empty", empty, {.placeholder = "Nothing yet", .caption = true});
        text_field(u, "Wrong", search, {.caption = true, .invalid = true});
        search_field(u, "Search", search);
        combo(u, "Mode", mode, modes, {.caption = true});
        combo(u, "Plate", chosen, plates, {.caption = true});
        segmented(u, "View", view, views);
        radio(u, "Views", view, views);
        color_field(u, "Key colour", key, {.alpha = true, .caption = true, .eyedropper = &dropper});
        gradient_bar(u, "Tint", stops, {.alpha = true});
        text_area(u, "Notes", notes, {.lines = 4});
        u.push_disabled(true);
        text_field(u, "Off", text, {.caption = true});
        combo(u, "Off mode", mode, modes, {.caption = true});
        segmented(u, "Off view", view, views);
        u.pop_disabled();
    }
    static void show(Harness& ui, const std::string& name) {
        ui.frame();
        const test::Canvas canvas(ui.size);
        Renderer renderer;
        renderer.draw(*ui.output().list, Harness::fonts(), &ui.images(), canvas.framebuffer());
        test::write_png(canvas.read(), std::string(std::getenv("LAPFX_UI_LOOK")) + "/fields_" + name + ".png");
    }
};

TEST_F(FieldsLook, AllOfThem) {
    Harness ui([&](Ui& u) { build(u); }, {420, 640});
    ui.focus("Fields/Name").key(Key::left, Mods::command | Mods::shift);
    show(ui, "all");
    ui.click("Fields/Notes").key('A', Mods::command);
    ui.ui().set_theme(light_theme());
    show(ui, "light");
}

TEST_F(FieldsLook, WhatDropsDown) {
    Harness ui([&](Ui& u) { build(u); }, {420, 640});
    ui.click("Fields/Plate").type("1");
    show(ui, "combo");
    ui.key(Key::escape).click("Fields/Key colour");
    show(ui, "picker");
    Harness large([&](Ui& u) { build(u); }, {840, 1280}, 2);
    large.click("Fields/Key colour");
    show(large, "picker2");
}

}  // namespace
}  // namespace lapfx::ui
