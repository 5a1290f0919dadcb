// The preset panel is made from the parameter table. These tests check its rows and their effect on the preview.
#include <array>

#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/clips/clip_shelf.h"
#include "app/tuning/tuning.h"
#include "editor/support/editor_test.h"
#include "panels/panels.h"
#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"

namespace lapfx::test {
namespace {

using app::parameters;
using ui::Key;
using ui::Mods;

class PresetPanel : public SampleTest {
  protected:
    PresetPanel() { begins.view = false; }
    const Preset& preset() { return editor().document.preset(); }
    std::string text() { return write_preset(preset()); }
    /// Opens all sections. At first all of them except Bleeding are folded.
    void unfold_all() {
        for (const app::ParameterGroup& group : parameters().groups())
            if (!group.key.empty() && group.key != "bleeding") ui().click("**/Parameters/" + group.name + "/header");
    }
    /// Drags a row of the favourites. The preview has to change in the next frame, and undo has to bring the same
    /// pixels back.
    void expect_live(const std::string& row, float px, double time) {
        const std::string before_text = text();
        const Image before = picture(time);
        const std::size_t steps = editor().document.done();
        ui().drag("**/Favourites/" + row, {px, 0});
        EXPECT_NE(text(), before_text) << row;
        EXPECT_GT(differing(before, picture(time)), 50U) << row;
        ASSERT_EQ(editor().document.done(), steps + 1) << row << ": one gesture is one step";
        editor().document.undo();
        EXPECT_EQ(text(), before_text) << row;
        EXPECT_EQ(differing(before, picture(time), 0), 0U) << row;
    }
};

TEST_F(PresetPanel, WhatThePaperTunesIsListedFirstAndLive) {
    editor().layouts().shown.show("View");
    ui().frame().frame();
    expect_live("Bleeding: Speed", -12, 6);
    expect_live("Bleeding: Level extent", 30, 6);
    expect_live("Bleeding: Noise scale", -60, 6);
    expect_live("Keying: Luma/Low", 40, 6);
    expect_live("Keying: Luma/High", -60, 6);
}

void expect_rows(ui::Harness& ui, const Table& table, int& count) {
    for (const Parameter& row : table.rows) {
        std::string name(row.name);
        if (table.find_row("luma_low") != nullptr || table.find_row("fat_low") != nullptr) {  // bounds share a row
            if (name.ends_with(" low")) name.replace(name.size() - 4, 4, "/Low");
            if (name.ends_with(" high")) name.replace(name.size() - 5, 5, "/High");
        }
        const std::string section = table.key.empty() ? "Parameters" : std::string(table.name);
        EXPECT_TRUE(ui.exists("**/" + section + "/" + name)) << section << "/" << name;
        ++count;
    }
    for (const Table& child : table.tables)
        if (child.list == nullptr) expect_rows(ui, child, count);
}

TEST_F(PresetPanel, TheLevelExtentTellsHowFarBloodGetsHere) {
    editor().document.change("Extent", [](document::Content& c) {
        BleedingParameters& b = c.preset.bleeding;
        b.max_extent = 21, b.noise_strength = b.threshold = 0, b.gravity_bias = 0.35, b.crease_bias = 0.5;
    });
    ui().frame();
    EXPECT_NE(ui().dump().find("up to 21 mm level, 32 downhill,"), std::string::npos) << ui().dump();
    EXPECT_NE(ui().dump().find("31 in folds, 65 down a fold"), std::string::npos);
    const float below = ui().rect("**/Parameters/Bleeding/Threshold").y;
    for (const double extent : {1.0, 200.0}) {
        editor().document.change("Extent", [&](document::Content& c) { c.preset.bleeding.max_extent = extent; });
        ui().frame();
        EXPECT_EQ(ui().rect("**/Parameters/Bleeding/Threshold").y, below) << extent << ": no row moves";
    }
}

TEST_F(PresetPanel, EveryRowOfTheTableIsThere) {
    unfold_all();
    int count = 0;
    expect_rows(ui(), preset_table(), count);
    EXPECT_EQ(count, static_cast<int>(parameters().entries().size()));
    EXPECT_GT(count, 75);
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
}

TEST_F(PresetPanel, TooltipsTellWhatIsAllowedAndTheKey) {
    const std::string tip = ui().tip("**/Bleeding/Speed");
    EXPECT_NE(tip.find("In the paper: the bleeding speed"), std::string::npos) << tip;
    EXPECT_NE(tip.find("A number from 0 to 60 mm/s; 4 by default\nbleeding.speed"), std::string::npos) << tip;
}

TEST_F(PresetPanel, SearchFindsByNameKeyAndHelp) {
    ui().key('F', Mods::command).type("luma");
    EXPECT_EQ(ui().text("**/Preset/Search"), "luma");
    EXPECT_TRUE(ui().exists("**/Keying/Luma/Low")) << "its section is open while one searches";
    EXPECT_FALSE(ui().exists("**/Bleeding/Speed"));
    ui().key(Key::escape);
    EXPECT_TRUE(ui().exists("**/Bleeding/Speed"));
    EXPECT_FALSE(ui().exists("**/Keying/Luma")) << "folded as it was";
    ui().key('F', Mods::command).type("figure 7b");
    EXPECT_TRUE(ui().exists("**/Bleeding/Noise strength"));
    EXPECT_FALSE(ui().exists("**/Bleeding/Noise octaves"));
    ui().key(Key::escape).type("no such thing");
    EXPECT_TRUE(ui().exists("**/No parameter has this name"));
}

TEST_F(PresetPanel, EscInFindGoesBackToWhereOneWas) {
    ui().focus("**/Bleeding/Gloss");
    ui().key('F', Mods::command).type("luma").key(Key::escape);
    EXPECT_TRUE(ui().focused().ends_with("Preset/Search")) << "the first empties the field: " << ui().focused();
    ui().key(Key::escape).frame();
    EXPECT_TRUE(ui().focused().ends_with("Bleeding/Gloss")) << ui().focused();
    editor().layouts().shown.show("Clips");
    ui().frame().key('F', Mods::command).frame().key(Key::escape).frame();
    EXPECT_TRUE(ui().focused().ends_with("Preset/Search")) << "what had it is not there: " << ui().focused();
}

TEST_F(PresetPanel, ChangedValuesAreCountedListedAndReset) {
    EXPECT_FALSE(ui().is("**/Bleeding/Speed", ui::Is::changed));
    ui().click("**/Bleeding/Gloss", {.clicks = 2}).type("0.1").key(Key::enter);
    EXPECT_DOUBLE_EQ(preset().bleeding.gloss, 0.1);
    EXPECT_TRUE(ui().is("**/Bleeding/Gloss", ui::Is::changed));
    EXPECT_EQ(ui().text("**/Bleeding/header"), "Bleeding, 1 changed");
    ui().click("**/Preset/Changed only");
    EXPECT_TRUE(ui().exists("**/Bleeding/Gloss"));
    EXPECT_FALSE(ui().exists("**/Bleeding/Speed"));
    EXPECT_FALSE(ui().exists("**/Haze"));
    ui().move_to("**/Bleeding/Gloss").key(Key::backspace);
    EXPECT_DOUBLE_EQ(preset().bleeding.gloss, editor().tuning().standard().bleeding.gloss);
    EXPECT_TRUE(ui().exists("**/Nothing differs from the saved preset"));
}

TEST_F(PresetPanel, SavedValuesAreTheNewStandard) {
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    ui().frame();
    EXPECT_TRUE(ui().is("**/Bleeding/Speed", ui::Is::changed));
    std::filesystem::create_directories(folder());
    editor().document.save_preset(folder() / "mine.json");
    editor().document.change("Gloss", [](document::Content& c) { c.preset.bleeding.gloss = 0.2; });
    ui().frame();
    EXPECT_FALSE(ui().is("**/Bleeding/Speed", ui::Is::changed));
    EXPECT_TRUE(ui().is("**/Bleeding/Gloss", ui::Is::changed));
}

TEST_F(PresetPanel, FaultsAreToldBelowTheirRow) {
    editor().document.change("Luma", [](document::Content& c) { c.preset.smoke.keying.luma_low = 235; });
    ui().frame();
    EXPECT_TRUE(ui().exists("**/Favourites/luma_low: 235 is not below luma_high (235)"));
    ui().drag("**/Favourites/Keying: Luma/Low", {-40, 0});
    EXPECT_FALSE(ui().exists("**/Favourites/luma_low: 235 is not below luma_high (235)"));
}

TEST_F(PresetPanel, WhatTheShownClipDoesNotTakeSaysSoAndLeadsToWhatItTakes) {
    const std::string note = "**/Favourites/Clip 1: change its own keying";
    EXPECT_FALSE(ui().exists(note));
    editor().document.change("Own keying", [](document::Content& c) { c.preset.smoke.clips[0].own_keying = true; });
    ui().frame();
    ASSERT_TRUE(ui().exists(note)) << "Suggest gives a clip its own keying, and these rows act on others alone";
    EXPECT_NE(ui().tip(note).find("for the clips without one"), std::string::npos) << ui().tip(note);
    ui().click("**/Parameters/Keying/header");
    EXPECT_TRUE(ui().exists("**/Parameters/Keying/Clip 1: change its own keying"));
    editor().clips().selected = 1;
    ui().frame();
    EXPECT_FALSE(ui().exists(note)) << "the second clip takes them";
    editor().clips().selected = 0;
    editor().document.change("Own keying", [](document::Content& c) {
        for (SmokeClip& clip : c.preset.smoke.clips) clip.own_keying = true;
    });
    ui().frame();
    EXPECT_NE(ui().tip(note).find("changes nothing"), std::string::npos) << ui().tip(note);
    EXPECT_FALSE(editor().layouts().seen("Keying"));
    ui().click(note);
    EXPECT_TRUE(editor().layouts().seen("Keying"));
}

TEST_F(PresetPanel, ColoursChoicesAndTextsAreEdited) {
    unfold_all();
    ui().click("**/Cautery/Heat model/Choice/bioheat");
    EXPECT_EQ(preset().cautery.model, HeatModel::bioheat);
    EXPECT_TRUE(ui().is("**/Cautery/Heat model", ui::Is::changed));
    ui().clipboard().text = "#102030";
    ui().ui().set_focus(ui().node("**/Bleeding/Thin colour/Colour").id, true);
    ui().frame().key('V', Mods::command);
    EXPECT_EQ(
        app::text_of(*parameters()[parameters().find("bleeding.color_thin")].row, Value(preset().bleeding.color_thin)),
        "#102030");
    ui().key(Key::backspace);
    EXPECT_EQ(preset().bleeding.color_thin, editor().tuning().standard().bleeding.color_thin) << "back to the file's";
    editor().document.undo();
    ui().frame().click("**/Bleeding/Thin colour/name", {.clicks = 2});
    EXPECT_EQ(preset().bleeding.color_thin, editor().tuning().standard().bleeding.color_thin);
    ui().click("**/Parameters/Tags/Text").key('A', Mods::command).type("odd, \"quoted\"").key(Key::enter);
    EXPECT_EQ(preset().tags, "odd, \"quoted\"");
    EXPECT_EQ(editor().document.steps().back().name, "Tags");
}

TEST_F(PresetPanel, TheMenuOfARowCopiesLocksAndMarks) {
    ui().right_click("**/Bleeding/Deep colour/name").click("**/Deep colour menu/Copy");
    EXPECT_EQ(ui().clipboard().text, "#380405");
    ui().clipboard().text = "no colour";
    const std::string before = text();
    ui().right_click("**/Bleeding/Deep colour/name").click("**/Deep colour menu/Paste");
    EXPECT_EQ(text(), before);
    EXPECT_NE(ui().dump().find("\"no colour\" is not"), std::string::npos) << "told, with what is allowed";
    ui().right_click("**/Bleeding/Speed").click("**/Speed menu/Lock");
    EXPECT_TRUE(editor().tuning().locked(parameters().find("bleeding.speed")));
    EXPECT_TRUE(ui().is("**/Bleeding/Speed", ui::Is::locked));
    ui().right_click("**/Bleeding/Rivulets").click("**/Rivulets menu/Favourite");
    EXPECT_TRUE(ui().exists("**/Favourites/Bleeding: Rivulets"));
    EXPECT_EQ(editor().settings().favourites.back(), "bleeding.rivulets");
    ui().right_click("**/Favourites/Bleeding: Rivulets").click("**/Bleeding: Rivulets menu/Favourite");
    EXPECT_FALSE(ui().exists("**/Favourites/Bleeding: Rivulets"));
}

TEST_F(PresetPanel, AGroupIsCopiedAsTextAndPasted) {
    ui().click("**/Parameters/Bleeding/More").click("**/Bleeding menu/Copy group");
    const std::string copied = ui().clipboard().text, before = text();
    EXPECT_TRUE(copied.starts_with("{\n  \"bleeding\": {\n    \"speed\": 6")) << copied;
    EXPECT_EQ(copied.find("haze"), std::string::npos);
    editor().document.change("Speed", [](document::Content& c) {
        c.preset.bleeding.speed = 1;
        c.preset.bleeding.color_deep = {0, 0, 0};
        c.preset.smoke.haze.suction = 3;
    });
    ui().frame();
    ui().click("**/Parameters/Bleeding/More").click("**/Bleeding menu/Paste group");
    EXPECT_EQ(preset().bleeding.speed, 6);
    EXPECT_EQ(preset().smoke.haze.suction, 3) << "of another group";
    EXPECT_EQ(editor().document.steps().back().name, "Paste Bleeding");
    editor().document.undo();
    editor().document.undo();
    EXPECT_EQ(text(), before);
}

TEST_F(PresetPanel, WhatCannotBePastedIsTold) {
    const std::string before = text();
    const auto told = [&](const std::string& clipboard) {
        editor().toasts.clear();
        ui().clipboard().text = clipboard;
        ui().key('V', Mods::command | Mods::alt);
        EXPECT_EQ(text(), before) << clipboard;
        return ui().dump();
    };
    EXPECT_NE(told("speed 4").find("clipboard: this is not JSON"), std::string::npos);
    EXPECT_NE(told("{\"bleeding\": {\"speed\": -3}}").find("clipboard: /bleeding/speed: -3 is below"),
              std::string::npos);
    EXPECT_NE(told("{\"bleeding\": {\"sped\": 3}}").find("/bleeding/sped: unknown key; nearest is"), std::string::npos);
    EXPECT_NE(told("{\"smoke\": {\"keying\": {\"luma_low\": 250}}}").find("250 is not below luma_high"),
              std::string::npos);
    EXPECT_NE(told("[1, 2]").find("not a JSON object"), std::string::npos);
    EXPECT_NE(told(std::string(100000, '[')).find("clipboard: "), std::string::npos);
    EXPECT_NE(told("{\"bleeding\": {\"speed\": 1e999}}").find("clipboard: "), std::string::npos);
    editor().toasts.clear();
    ui().clipboard().text = "{\"vessels\": {\"region\": 3}}";
    ui().click("**/Parameters/Bleeding/More").click("**/Bleeding menu/Paste group");
    EXPECT_NE(ui().dump().find("\"bleeding\" is not in the text; it contains vessels"), std::string::npos);
    EXPECT_EQ(text(), before);
}

TEST_F(PresetPanel, RandomisingKeepsWhatIsLockedAndTheRules) {
    app::Tuning& tuning = editor().tuning();
    tuning.lock(parameters().group("smoke.keying"), true);
    tuning.lock(parameters().find("bleeding.speed"), true);
    tuning.strength = 1;
    const Preset before = preset();
    const std::string before_text = text();
    ui().key('R', Mods::command);
    EXPECT_EQ(preset().bleeding.speed, before.bleeding.speed);
    EXPECT_EQ(preset().smoke.keying.luma_low, before.smoke.keying.luma_low);
    EXPECT_NE(preset().bleeding.max_extent, before.bleeding.max_extent);
    EXPECT_EQ(preset().name, before.name);
    EXPECT_EQ(editor().document.steps().size(), 1U);
    editor().document.undo();
    EXPECT_EQ(text(), before_text);

    tuning.lock(parameters().group("smoke.keying"), false);
    for (int i = 0; i < 300; ++i) {
        tuning.strength = std::array{0.01, 0.1, 1.0}[static_cast<std::size_t>(i % 3)];
        tuning.randomise(nullptr);
        ASSERT_EQ(editor().document.preset_faults().size(), 0U)
            << i << ": " << editor().document.preset_faults().front().text();
        ASSERT_NO_THROW(parse_preset(text(), "randomised"));
    }
}

TEST_F(PresetPanel, RandomisingIsSeededAndGoesAsFarAsIsAsked) {
    app::Tuning& tuning = editor().tuning();
    tuning.seed = 42;
    const double before = preset().bleeding.max_extent;
    EXPECT_GT(tuning.randomise(&parameters().group("bleeding")), 15);
    const std::string once = text();
    EXPECT_LE(std::abs(preset().bleeding.max_extent - before), 20.0) << "a tenth of 200 mm";
    EXPECT_EQ(preset().smoke.haze.suction, editor().tuning().standard().smoke.haze.suction);
    EXPECT_EQ(editor().document.steps().back().name, "Randomise Bleeding");
    editor().document.undo();
    EXPECT_NE((tuning.randomise(&parameters().group("bleeding")), text()), once);
    editor().document.undo();
    tuning.seed = 42;
    tuning.randomise(&parameters().group("bleeding"));
    EXPECT_EQ(text(), once);
}

TEST_F(PresetPanel, TheDiceAsksHowFar) {
    const std::string before = text();
    ui().click("**/Preset/Randomise").frame();
    EXPECT_EQ(text(), before) << "nothing changes before one has seen how far";
    EXPECT_EQ(ui().value("**/Randomise box/Strength"), 10.0);
    ui().click("**/Randomise box/Strength", {.clicks = 2}).type("2").key(Key::enter);
    ui().click("**/Randomise box/Seed", {.clicks = 2}).type("77").key(Key::enter);
    EXPECT_EQ(editor().tuning().strength, 0.02);
    const Preset was = preset();
    ui().click("**/Randomise box/Randomise all").frame();
    EXPECT_EQ(editor().document.done(), 1U);
    EXPECT_NE(text(), before);
    EXPECT_LE(std::abs(preset().bleeding.max_extent - was.bleeding.max_extent), 4.0) << "2 % of 200 mm";
    EXPECT_LE(std::abs(preset().bleeding.opacity - was.bleeding.opacity), 0.02 + 1e-9);
    EXPECT_EQ(ui().value("**/Randomise box/Seed"), 78.0) << "the next one is another";
    const std::string once = text();
    ui().key(Key::escape).key('Z', Mods::command);
    EXPECT_EQ(text(), before);
    editor().tuning().seed = 77;
    ui().key('R', Mods::command);
    EXPECT_EQ(text(), once) << "at once, with the same strength";
    ui().click("**/Parameters/Bleeding/More");
    EXPECT_TRUE(ui().exists("**/Bleeding menu/Randomise by 2 %"));
    ui().click("**/Bleeding menu/Strength and seed...").frame();
    EXPECT_TRUE(ui().exists("**/Randomise box/Strength"));
}

TEST_F(PresetPanel, OfAGroupTheDiceAsksForThatGroup) {
    ui().click("**/Parameters/Bleeding/More");
    ui().click("**/Bleeding menu/Strength and seed...").frame();
    EXPECT_FALSE(ui().exists("**/Randomise box/Randomise all"));
    const Preset was = preset();
    ui().click("**/Randomise box/Randomise Bleeding").frame();
    EXPECT_EQ(editor().document.done(), 1U);
    EXPECT_NE(preset().bleeding.speed, was.bleeding.speed);
    EXPECT_EQ(preset().cautery.heat_rate, was.cautery.heat_rate);
    EXPECT_EQ(preset().smoke.plume.size, was.smoke.plume.size);
    ui().key(Key::escape);
    ui().click("**/Preset/Randomise").frame();
    EXPECT_TRUE(ui().exists("**/Randomise box/Randomise all")) << "the dice above is for all";
}

TEST_F(PresetPanel, TipsHaveTheKeysAsTheyAreBound) {
    ui::CommandTable& commands = editor().commands;
    commands.bind(commands.index_of("preset.find"), {ui::key_of('J'), Mods::command});
    commands.bind(commands.index_of("preset.randomise"), {});
    ui().frame();
    EXPECT_TRUE(ui().tip("**/Preset/Search").ends_with(" (Ctrl+J)")) << ui().tip("**/Preset/Search");
    EXPECT_EQ(ui().tip("**/Preset/Randomise"), "Randomises what is not locked; asks how far");
}

TEST_F(PresetPanel, TheClipsAreOnePressAway) {
    ui().click("**/Parameters/3 clips: edit in Clips");
    EXPECT_TRUE(ui().exists("Workspace/Clips"));
}

TEST_F(PresetPanel, AStillPanelAllocatesNothing) {
    app::Editor& e = editor();
    const auto build = [&e](ui::Ui& u) {
        panels::preset_panel(u, e.tuning(), panels::edited_in(e), e.commands, e.layouts(), e.toasts, e.clips(),
                             e.looking);
    };
    ui::Harness panel(
        [&](ui::Ui& u) {
            e.set_ui(u);
            build(u);
        },
        {420, 900});
    for (const app::ParameterGroup& group : parameters().groups())
        if (!group.key.empty() && group.key != "bleeding") panel.click("Parameters/" + group.name + "/header");
    for (int i = 0; i < 5; ++i) panel.frame();
    const std::size_t before = allocations_so_far();
    for (int i = 0; i < 10; ++i) panel.ui().frame({.size = {420, 900}, .scale = 1, .time = panel.time + i}, build);
    EXPECT_EQ(allocations_so_far() - before, 0U);
    editor().set_ui(ui().ui());
}

TEST_F(PresetPanel, RandomiseSaysWhatItDidAndTakesItBack) {
    editor().tuning().seed = 7;
    const std::string before = text();
    ui().key('R', Mods::command).frame();
    ASSERT_NE(text(), before);
    ASSERT_EQ(editor().toasts.log().size(), 1U);
    const std::string told = editor().toasts.log().back().text;
    EXPECT_NE(told.find(" values changed by up to 10 % (seed 7): "), std::string::npos) << told;
    EXPECT_NE(told.find(" more"), std::string::npos) << told;
    ui().click("Notices/" + told + "/Undo").frame();
    EXPECT_EQ(text(), before);
}

TEST_F(PresetPanel, ANoticesUndoSaysWhenItCannot) {
    ui().key('R', Mods::command).frame();
    const std::string told = editor().toasts.log().back().text;
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    const std::string now = text();
    ui().frame().click("Notices/" + told + "/Undo").frame();
    EXPECT_EQ(text(), now) << "the other change is not taken back";
    EXPECT_EQ(editor().toasts.log().back().text,
              "Not undone: other changes were made after it. The History panel can go back to it");
}

TEST_F(PresetPanel, ShiftBackspaceAndTheMenuGoToTheDefaultOfBothEnds) {
    static const Preset initial;
    editor().document.change("Values", [](document::Content& c) {
        c.preset.bleeding.gloss = 0.15;
        c.preset.smoke.keying.luma_low = 50, c.preset.smoke.keying.luma_high = 100;
    });
    std::filesystem::create_directories(folder());
    editor().document.save_preset(folder() / "mine.json");
    ui().frame();
    ui().click("**/Bleeding/Gloss", {.clicks = 2}).type("0.1").key(Key::enter);
    ui().move_to("**/Bleeding/Gloss").key(Key::backspace, Mods::shift);
    EXPECT_DOUBLE_EQ(preset().bleeding.gloss, initial.bleeding.gloss);
    ui().move_to("**/Bleeding/Gloss").key(Key::backspace);
    EXPECT_DOUBLE_EQ(preset().bleeding.gloss, 0.15) << "without Shift what was saved";
    const std::size_t steps = editor().document.done();
    ui().click("**/Favourites/Keying: Luma", {.button = ui::Button::right, .at = {0.1F, 0.5F}});
    ui().click("**/Keying: Luma menu/Default value").frame();
    EXPECT_EQ(preset().smoke.keying.luma_low, initial.smoke.keying.luma_low);
    EXPECT_EQ(preset().smoke.keying.luma_high, initial.smoke.keying.luma_high);
    EXPECT_EQ(editor().document.done(), steps + 1);
    editor().document.undo();
    EXPECT_EQ(preset().smoke.keying.luma_low, 50.0);
    EXPECT_EQ(preset().smoke.keying.luma_high, 100.0);
}

TEST_F(PresetPanel, FavouritesAreAllCalledAlike) {
    const auto names = [&] {
        std::vector<std::string> all;
        const auto tree = ui().ui().tree();
        for (std::uint32_t i = 0; i < tree.size(); ++i) {
            const std::string path = ui::path_of(tree, i), in = "/Favourites/";
            const std::size_t at = path.find(in);
            if (at == std::string::npos || path.find('/', at + in.size()) != std::string::npos) continue;
            if (tree[i].role == ui::Role::slider || tree[i].role == ui::Role::range)
                all.push_back(path.substr(at + in.size()));
        }
        return all;
    };
    const std::vector<std::string> wide = names();
    ASSERT_EQ(wide.size(), 4U);
    for (const std::string& name : wide) EXPECT_NE(name.find(": "), std::string::npos) << name;
    ui().size.x = 1150;
    ui().frame().frame();
    const std::vector<std::string> narrow = names();
    ASSERT_EQ(narrow.size(), 4U);
    for (const std::string& name : narrow) EXPECT_EQ(name.find(": "), std::string::npos) << name;
    for (const std::string& fault : ui::faults_of(ui().ui().tree()))
        EXPECT_EQ(fault.find("Favourites"), std::string::npos) << fault;
}

}  // namespace
}  // namespace lapfx::test
