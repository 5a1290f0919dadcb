#include "ui/shell/palette.h"

#include <gmock/gmock.h>

#include "ui/core/node.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;

class PaletteTest : public testing::Test {
  protected:
    PaletteTest() {
        const auto add = [&](const char* id, const char* group, const char* title, Chord chord = {}) {
            table.add({.id = id,
                       .title = title,
                       .group = group,
                       .chord = chord,
                       .run = [this, id] { ran.push_back(id); },
                       .enabled = [this] { return can_run; }});
        };
        add("open", "File", "Open", {key_of('O'), Mods::command});
        add("save", "File", "Save", {key_of('S'), Mods::command});
        add("scale", "View", "Scale all");
        for (int i = 0; i < 40; ++i) {
            const std::string number = std::to_string(i);
            table.add({.id = "n" + number, .title = "Number " + number, .run = [this, i] {
                           ran.push_back("n" + std::to_string(i));
                       }});
        }
        table.add({.id = "palette", .title = "Palette", .chord = {key_of('P'), Mods::command}, .run = [this] {
                       open_palette(ui.ui());
                   }});
    }
    /// Titles of the rows, from the top.
    std::vector<std::string> rows() {
        std::vector<std::string> all;
        for (const Node& node : ui.ui().tree()) {
            if (node.role == Role::list_item) all.emplace_back(node.label);
        }
        return all;
    }
    PaletteTest& open() {
        ui.key('P', Mods::command);
        return *this;
    }
    CommandTable table;
    std::vector<std::string> ran;
    bool can_run = true;
    Harness ui{[this](Ui& u) {
                   button(u, "Field");
                   palette(u, table);
               },
               {640, 480},
               1,
               &table};
};

TEST_F(PaletteTest, TypedLettersFindAndEnterRunsAndCloses) {
    ui.focus("Field");
    open();
    EXPECT_EQ(ui.focused(), "Command palette/Command");
    ui.type("sa");
    ASSERT_GE(rows().size(), 2U);
    EXPECT_EQ(rows()[0], "File: Save");
    EXPECT_TRUE(ui.is("**/File: Save", Is::selected));
    EXPECT_EQ(ui.text("**/File: Save"), "Ctrl+S");
    ui.key(Key::enter);
    EXPECT_THAT(ran, ElementsAre("save"));
    EXPECT_FALSE(ui.exists("Command palette"));
    EXPECT_EQ(ui.focused(), "Field");
}

TEST_F(PaletteTest, ArrowsGoRoundAndPagesToTheEnds) {
    open();
    EXPECT_TRUE(ui.is("**/File: Open", Is::selected));
    ui.key(Key::down);
    EXPECT_TRUE(ui.is("**/File: Save", Is::selected));
    ui.key(Key::up).key(Key::up).frame();
    EXPECT_TRUE(ui.is("**/Palette", Is::selected)) << "round, and scrolled to";
    ui.key(Key::page_up).key(Key::page_up).key(Key::page_up).key(Key::page_up).frame();
    EXPECT_TRUE(ui.is("**/File: Open", Is::selected));
    ui.key(Key::page_down).key(Key::enter);
    EXPECT_THAT(ran, ElementsAre("n8"));
}

class PaletteItems : public PaletteTest {
  protected:
    std::vector<PaletteItem> items{
        {.title = "Bleeding: Speed", .note = "bleeding.speed", .words = "bleeding: speed blood fast", .tip = "Speed"},
        {.title = "Haze: Suction", .note = "haze.suction", .words = "haze: suction fog vacuum"}};
    std::vector<std::size_t> chosen;
    Harness list{[this](Ui& u) { palette(u, table, items, [this](std::size_t item) { chosen.push_back(item); }); },
                 {640, 480}};
};

TEST_F(PaletteItems, AreFoundByTheirWordsAndChosen) {
    open_palette(list.ui());
    list.frame().frame();
    EXPECT_FALSE(list.exists("**/Bleeding: Speed")) << "with nothing typed there are commands only";
    list.type("fog");
    EXPECT_TRUE(list.is("**/Haze: Suction", Is::selected));
    EXPECT_EQ(list.text("**/Haze: Suction"), "haze.suction");
    EXPECT_FALSE(list.exists("**/Bleeding: Speed"));
    list.key(Key::enter);
    EXPECT_THAT(chosen, ElementsAre(1U));
    EXPECT_FALSE(list.exists("Command palette"));
    open_palette(list.ui());
    list.frame().frame().type("sa");  // letters of "Save" that no item has
    EXPECT_FALSE(list.exists("**/Haze: Suction"));
    list.key(Key::enter);
    EXPECT_THAT(ran, ElementsAre("save"));
    EXPECT_EQ(chosen.size(), 1U);
}

TEST_F(PaletteTest, OnlyWhatIsInSightIsBuilt) {
    open();
    EXPECT_LE(rows().size(), 13U);
    EXPECT_GE(rows().size(), 12U);
}

TEST_F(PaletteTest, WhatWasRunComesFirstNextTime) {
    open();
    ui.type("scale").key(Key::enter);
    open();
    EXPECT_EQ(rows()[0], "View: Scale all");
    EXPECT_EQ(ui.text("Command palette/Command"), "") << "with an empty field";
    ui.type("number 7").key(Key::enter);
    open();
    EXPECT_EQ(rows()[0], "Number 7");
    EXPECT_EQ(rows()[1], "View: Scale all");
    EXPECT_THAT(ran, ElementsAre("scale", "n7"));
}

TEST_F(PaletteTest, AClickRunsAndAPressOutsideCloses) {
    open();
    ui.click("**/File: Save");
    EXPECT_THAT(ran, ElementsAre("save"));
    open();
    ui.send({.kind = EventKind::press, .at = {5, 470}});
    EXPECT_FALSE(ui.exists("Command palette"));
    open();
    ui.key(Key::escape);
    EXPECT_FALSE(ui.exists("Command palette"));
    EXPECT_THAT(ran, ElementsAre("save"));
}

TEST_F(PaletteTest, WhatIsDisabledIsDimAndStays) {
    can_run = false;
    open();
    EXPECT_TRUE(ui.is("**/File: Open", Is::disabled));
    ui.key(Key::up);
    EXPECT_TRUE(ui.is("**/View: Scale all", Is::selected)) << "it can be gone to";
    ui.key(Key::enter).click("**/File: Open");
    EXPECT_TRUE(ui.exists("Command palette"));
    EXPECT_TRUE(ran.empty());
}

TEST_F(PaletteTest, TheFirstThatCanRunIsChosen) {
    can_run = false;
    open();
    EXPECT_EQ(rows()[0], "File: Open") << "as it is listed with all that can run";
    EXPECT_TRUE(ui.is("**/Number 0", Is::selected));
    EXPECT_FALSE(ui.is("**/File: Open", Is::selected));
    ui.key(Key::page_down).key(Key::page_down).key(Key::page_down).frame();
    ui.type("n").frame();  // "Open" has that letter, too
    EXPECT_TRUE(ui.exists("**/Number 0")) << "from its beginning on";
    ui.key(Key::enter);
    EXPECT_EQ(ran.size(), 1U);
    EXPECT_TRUE(ran.front().starts_with("n")) << ran.front();
    ran.clear();
    open();
    ui.type("save");
    EXPECT_TRUE(ui.is("**/File: Save", Is::selected)) << "none can";
    ui.key(Key::enter);
    EXPECT_TRUE(ran.empty());
}

TEST_F(PaletteTest, NothingFoundIsSaid) {
    open();
    ui.type("xyzzy").key(Key::enter).key(Key::down);
    EXPECT_TRUE(rows().empty());
    EXPECT_TRUE(ui.exists("**/No command of this name"));
}

TEST_F(PaletteTest, AnOpenPaletteAllocatesNothing) {
    open();
    ui.type("n").frame(1).frame(1);
    const auto steady = [](Harness& each) {
        const std::size_t before = test::allocations_so_far();
        for (int i = 0; i < 50; ++i) each.frame();
        return test::allocations_so_far() - before;
    };
    EXPECT_EQ(steady(ui), 0U);
}

}  // namespace
}  // namespace lapfx::ui
