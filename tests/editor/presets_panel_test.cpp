// The preset browser: which presets it finds, how it shows them, and what opening one does to the document.
#include <fstream>

#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/browser/browser.h"
#include "editor/support/editor_test.h"
#include "panels/panels.h"
#include "support/folders.h"
#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using ui::Key;

class PresetsPanel : public SampleTest {
  protected:
    PresetsPanel() { begins.view = false; }
    void SetUp() override {
        SampleTest::SetUp();
        if (!IsSkipped()) begin();
    }
    void begin() {
        editor().layouts().shown.show("Library");
        settle();
    }
    void settle() {
        for (int i = 0; i < 4; ++i) ui().frame();
    }
    app::Browser& browser() { return editor().browser(); }
    std::vector<std::string> names() {
        std::vector<std::string> all;
        for (const std::size_t i : browser().found()) all.push_back(browser().files()[i].name);
        return all;
    }
    void write(const std::string& name, const std::string& text) {
        fs::create_directories(folder() / "more");
        std::ofstream(folder() / "more" / name) << text;
    }
    using Names = std::vector<std::string>;
};

constexpr std::size_t shipped_presets = 8;

TEST_F(PresetsPanel, TheShippedPresetsAreFoundByNameTextAndTag) {
    const Names all{"Brisk bleed", "Cleared haze",       "Fast haze", "Gastric banding",
                    "Heavy haze",  "Hook cautery plume", "Slow ooze", "Sudden burst"};
    EXPECT_EQ(names(), all);
    for (const std::string& name : all) EXPECT_TRUE(ui().exists("Workspace/Library/Presets/" + name)) << name;
    ui().click("Workspace/Library/Filter/Search").type("VEIL");
    EXPECT_EQ(names(), Names{"Heavy haze"}) << "a word of its description";
    ui().key(Key::escape);
    ui().click("Workspace/Library/Filter/bleeding");
    EXPECT_EQ(names(), (Names{"Brisk bleed", "Gastric banding", "Slow ooze"}));
    ui().click("Workspace/Library/Filter/venous");
    EXPECT_EQ(names(), (Names{"Gastric banding", "Slow ooze"})) << "with both tags";
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
}

TEST_F(PresetsPanel, WithoutAStarThePanelSaysHowToGiveOne) {
    ui().click("Workspace/Library/Filter/Starred only");
    EXPECT_EQ(names(), Names{});
    const std::string told =
        "Workspace/Library/No preset is starred yet. The star on a preset's picture, or Star in its menu, marks it";
    ASSERT_TRUE(ui().exists(told));
    EXPECT_LT(ui().rect(told).bottom(), ui().rect("Workspace/Library/Presets").bottom()) << "above the empty grid";
    EXPECT_EQ(editor().settings().preset_stars.size(), 0U);
}

TEST_F(PresetsPanel, StarsAreKeptInTheSettings) {
    ui().click("Workspace/Library/Presets/Heavy haze/star");
    ASSERT_EQ(editor().settings().preset_stars.size(), 1U);
    EXPECT_TRUE(editor().settings().preset_stars[0].ends_with("presets/heavy_haze.json"));
    ui().click("Workspace/Library/Filter/Starred only");
    EXPECT_EQ(names(), Names{"Heavy haze"});
}

TEST_F(PresetsPanel, FoldersAreAddedAndBrokenFilesSayWhy) {
    Preset mine;
    mine.name = "Mine";
    write("good.json", write_preset(mine));
    write("broken.json", R"({"format": "lapfx.preset", "version": 1, "bleeding": {"speed": -3}})");
    write("cut.json", "{\"format\": \"lapfx.pre");
    write("scene.json", R"({"format": "lapfx.scene", "version": 1, "organ": {"file": "o.ply"}})");
    write("notes.txt", "no preset");
    browser().add_folder(folder() / "more");
    settle();
    EXPECT_EQ(browser().files().size(), shipped_presets + 3);
    EXPECT_TRUE(ui().exists("Workspace/Library/Presets/Mine"));
    const std::string broken = "Workspace/Library/Presets/\u26A0 broken";
    EXPECT_NE(ui().tip(broken).find("/bleeding/speed: -3 is below the minimum"), std::string::npos) << ui().tip(broken);
    const std::string before = write_preset(editor().document.preset());
    ui().click(broken, {.clicks = 2});
    EXPECT_EQ(write_preset(editor().document.preset()), before);
    EXPECT_NE(ui().dump().find("-3 is below the minimum"), std::string::npos) << "told";
    browser().remove_folder(editor().settings().preset_folders.at(0));
    settle();
    EXPECT_EQ(browser().files().size(), shipped_presets);
}

TEST_F(PresetsPanel, ADoubleClickOpens) {
    ui().click("Workspace/Library/Presets/Slow ooze", {.clicks = 2});
    EXPECT_EQ(editor().document.preset().name, "Slow ooze");
    EXPECT_EQ(editor().document.preset_file().filename(), "slow_ooze.json");
    EXPECT_FALSE(editor().document.preset_unsaved());
}

TEST_F(PresetsPanel, WhatIsNotSavedIsNotLost) {
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    ui().frame();
    const auto ask = [&] { ui().click("Workspace/Library/Presets/Slow ooze", {.clicks = 2}).frame(); };
    ask();
    ui().click("**/Open preset/Cancel");
    EXPECT_EQ(editor().document.preset().bleeding.speed, 9);
    ask();
    ui().click("**/Open preset/Take its values");
    EXPECT_EQ(editor().document.preset().name, "Gastric banding") << "it is another's values only";
    EXPECT_EQ(editor().document.preset().bleeding.speed,
              load_preset(source_folder() / "presets" / "slow_ooze.json").bleeding.speed);
    EXPECT_EQ(editor().document.steps().back().name, "Values of Slow ooze");
    editor().document.undo();
    EXPECT_EQ(editor().document.preset().bleeding.speed, 9);
    ask();
    ui().click("**/Open preset/Open, discard changes");
    EXPECT_EQ(editor().document.preset().name, "Slow ooze");
}

TEST_F(PresetsPanel, AStillPanelAllocatesNothing) {
    app::Editor& e = editor();
    const auto build = [&e](ui::Ui& u) {
        panels::presets_panel(u, e.browser(), e.document, e.files(), e.chooser(), e.toasts);
    };
    ui::Harness panel(
        [&](ui::Ui& u) {
            e.set_ui(u);
            build(u);
        },
        {1000, 300});
    for (int i = 0; i < 5; ++i) panel.frame();
    ASSERT_TRUE(panel.exists("Presets/Slow ooze"));
    const std::size_t before = allocations_so_far();
    for (int i = 0; i < 10; ++i) panel.ui().frame({.size = {1000, 300}, .scale = 1, .time = panel.time + i}, build);
    EXPECT_EQ(allocations_so_far() - before, 0U);
    editor().set_ui(ui().ui());
}

TEST_F(PresetsPanel, ThumbnailsAreRenderedOnceAndKept) {
    const fs::path program = build_folder() / "lapfx";
    if (!fs::exists(program)) GTEST_SKIP() << program << " is not built";
    own_shipped = folder() / "shipped";  // with few presets: each is rendered by a process of its own
    fs::create_directories(own_shipped / "presets");
    for (const char* name : {"samples", "shaders"}) fs::create_symlink(light_folder() / name, own_shipped / name);
    for (const char* name : {"brisk_bleed.json", "heavy_haze.json"})
        fs::copy_file(light_folder() / "presets" / name, own_shipped / "presets" / name);
    start();
    editor().layouts().shown.close("View");
    open_sample();
    begin();
    for (const app::PresetFile& file : browser().files()) EXPECT_EQ(file.image, 0U) << "pictures do not wait for them";
    browser().render_with(program);
    browser().reload();
    settle();
    ASSERT_EQ(browser().files().size(), 2U);
    std::vector<const ui::StoredImage*> images;
    for (const app::PresetFile& file : browser().files()) {
        ASSERT_NE(file.image, 0U) << file.name << ": " << file.tip;
        images.push_back(editor().images.find(file.image));
        ASSERT_NE(images.back(), nullptr);
        EXPECT_EQ(images.back()->size, app::ThumbnailMaker::standard_size);
    }
    EXPECT_NE(images[0]->pixels, images[1]->pixels) << "another preset is another picture";
    std::size_t kept = 0;
    for (const auto& entry : fs::directory_iterator(folder() / "cache" / "thumbnails"))
        kept += entry.path().extension() == ".png" ? 1U : 100U;
    EXPECT_EQ(kept, 2U) << "and nothing else is left there";
}

}  // namespace
}  // namespace lapfx::test
