// The timeline and the scene panel: events are moved, stretched and typed in. Rows of the scene; the unit of an organ.
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "app/base/layouts.h"
#include "app/files/open.h"
#include "app/files/organ_choice.h"
#include "editor/support/editor_test.h"
#include "lapfx/prepared_organ.h"
#include "ui/core/node.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

class TimelinePanelTest : public SampleTest {
  protected:
    TimelinePanelTest() { begins.layout = "Stage"; }
    const std::vector<ToolContact>& events() { return editor().document.scene().events; }
    const std::string& last_step() { return editor().document.steps().back().name; }
    /// Writes a box of this size, in units of its file.
    std::string box(const std::string& name, double x, double y, double z) {
        const std::filesystem::path file = folder() / name;
        std::ofstream out(file);
        for (int i = 0; i < 8; ++i)
            out << "v " << (i & 1 ? x : 0) << ' ' << (i & 2 ? y : 0) << ' ' << (i & 4 ? z : 0) << '\n';
        out << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
        return file.string();
    }
};

TEST_F(TimelinePanelTest, AnEventIsDraggedAndItsTimeTyped) {
    const double before = events()[1].time;
    ui().drag("**/Cauterise 2", {40, 0});
    EXPECT_GT(events()[1].time, before);
    EXPECT_NEAR(events()[1].duration, 3, 1e-9);
    EXPECT_EQ(events()[0].time, 0.8) << "the other stays";
    EXPECT_EQ(last_step(), "Move event");
    EXPECT_EQ(editor().document.steps().size(), 1U);
    EXPECT_EQ(editor().selected, std::vector<std::size_t>{1});
}

TEST_F(TimelinePanelTest, AfterAClickOnTheTimelineKeysGoOnAsTheProgramsKeys) {
    for (const char* const place : {"Workspace/Timeline/Events/Time", "**/Cauterise 2"}) {
        ui().click(place).move_to("**/View/Preview");
        editor().tool.action.reset();
        ui().key('2');
        EXPECT_EQ(editor().tool.action, ToolAction::cut) << place;
        const bool underlay = editor().looking.underlay;
        ui().key(ui::key_of('U'));
        EXPECT_NE(editor().looking.underlay, underlay) << place;
        ui().key(ui::key_of('L'));
        EXPECT_TRUE(editor().timeline.playing()) << "its own key, " << place;
        ui().key(ui::key_of('K'));
    }
}

TEST_F(TimelinePanelTest, AnEventThatDoesNothingIsNamedSo) {
    editor().document.change("Silence event", [](document::Content& content) {
        content.scene.events[1].power = content.scene.events[1].strength = 0.0;
    });
    ui().frame().click("**/Cauterise 2 (silenced)");
    EXPECT_EQ(editor().selected, std::vector<std::size_t>{1});
    const std::size_t before = events().size();
    ui().click("**/Cauterise 1").key(ui::Key::del);
    ASSERT_EQ(events().size(), before - 1) << "the one that does nothing stays";
    EXPECT_EQ(events()[0].power, 0.0);
}

TEST_F(TimelinePanelTest, ASelectedEventIsTyped) {
    ui().click("**/Cauterise 1");
    ASSERT_EQ(editor().selected, std::vector<std::size_t>{0});
    ui().click("**/Power", {.clicks = 2}).type("0.4").key(ui::Key::enter);
    EXPECT_DOUBLE_EQ(events()[0].power, 0.4);
    ui().click("**/Start", {.clicks = 2}).type("2.5").key(ui::Key::enter);
    EXPECT_DOUBLE_EQ(events()[0].time, 2.5);
    EXPECT_EQ(last_step(), "Event time");
    editor().document.undo();
    EXPECT_DOUBLE_EQ(events()[0].time, 0.8);
}

TEST_F(TimelinePanelTest, BackspaceGoesBackToWhatWasSavedOfEventsAndDuration) {
    document::Document& document = editor().document;
    document.change("Saved", [](document::Content& c) { c.scene.duration = 17, c.scene.events[0].power = 0.7; });
    document.save_scene(folder() / "mine.scene.json");
    ui().frame();
    document.change("Edited", [](document::Content& c) { c.scene.duration = 21, c.scene.events[0].power = 0.4; });
    editor().selected = {0};
    ui().frame().frame();
    ui().move_to("**/Event/Power").key(ui::Key::backspace);
    EXPECT_DOUBLE_EQ(events()[0].power, 0.7);
    ui().move_to("**/Event/Power").key(ui::Key::backspace, ui::Mods::shift);
    EXPECT_DOUBLE_EQ(events()[0].power, 1.0) << "with Shift the default";
    layout("Tune");  // its timeline has room for the row
    ui().move_to("Workspace/Timeline/Duration").key(ui::Key::backspace);
    EXPECT_DOUBLE_EQ(document.scene().duration, 17.0);
    ui().move_to("Workspace/Timeline/Duration").key(ui::Key::backspace, ui::Mods::shift);
    EXPECT_DOUBLE_EQ(document.scene().duration, Scene{}.duration);
}

TEST_F(TimelinePanelTest, EventsAreAddedDoubledAndDeleted) {
    editor().timeline.seek(10.8);
    ui().frame();
    ui().click("**/Add event");
    ASSERT_EQ(events().size(), 4U);
    EXPECT_EQ(events()[3].time, 10.8);
    EXPECT_EQ(events()[3].position, events()[2].to) << "where the tool last was";
    editor().timeline.seek(12);
    ui().frame();
    if (!ui().exists("**/Duplicate")) ui().click("Workspace/Timeline/More...").frame().frame();
    ui().click("**/Duplicate").frame().key(ui::Key::escape).frame();  // leaves the menu, if there is one
    ASSERT_EQ(events().size(), 5U);
    EXPECT_EQ(events()[4].time, 12);
    ui().click("**/Delete");
    EXPECT_EQ(events().size(), 4U);
    EXPECT_EQ(last_step(), "Delete events");
    ui().click("**/Cauterise 1").key(ui::Key::del);
    EXPECT_EQ(events().size(), 3U);
    editor().document.undo();
    EXPECT_EQ(events().size(), 4U);
    EXPECT_EQ(events()[0].time, 0.8);
}

TEST_F(TimelinePanelTest, APathMovesWhole) {
    editor().document.change("Path", [](document::Content& c) {
        c.scene.events = {
            {.action = ToolAction::cut, .time = 1, .duration = 1, .position = {0, 0, 0}, .to = {5, 0, 0}},
            {.action = ToolAction::cut, .time = 2, .duration = 1, .position = {5, 0, 0}, .to = {5, 5, 0}}};
    });
    ui().frame().frame();
    EXPECT_FALSE(ui().exists("**/Cut 2"));
    ui().drag("**/Cut 1", {50, 0});
    EXPECT_GT(events()[0].time, 1.2);
    EXPECT_NEAR(events()[1].time, events()[0].end(), 1e-9);
    EXPECT_EQ(editor().selected, (std::vector<std::size_t>{0, 1}));
}

TEST_F(TimelinePanelTest, ItPlaysStepsAndGoesToTheStart) {
    editor().timeline.seek(4);
    ui().key(ui::key_of('.'));
    EXPECT_NEAR(editor().timeline.time, 4.04, 1e-9);
    ui().key(ui::key_of(',')).key(ui::key_of(','));
    EXPECT_NEAR(editor().timeline.time, 3.96, 1e-9);
    ui().key(ui::Key::home, ui::Mods::command);
    EXPECT_EQ(editor().timeline.time, 0);
    ui().key(ui::Key::space);
    EXPECT_TRUE(editor().timeline.playing());
}

TEST_F(TimelinePanelTest, TheSceneHasItsRows) {
    ui().click("**/Seed", {.clicks = 2}).type("7").key(ui::Key::enter);
    EXPECT_EQ(editor().document.scene().seed, 7);
    const Image before = picture(3);
    ui().drag("**/Light/Intensity", {60, 0});
    EXPECT_GT(editor().document.scene().light.intensity, 1.0);
    EXPECT_EQ(last_step(), "Light: Intensity");
    editor().document.undo();
    EXPECT_EQ(editor().document.scene().light.intensity, 1.0);
    EXPECT_EQ(differing(before, picture(3), 0), 0U);
}

TEST_F(TimelinePanelTest, AnOrganInMetresIsPutRightInTheDialog) {
    const std::size_t steps = editor().document.steps().size();
    open({box("metres.obj", 0.25, 0.1, 0.15)});
    ui().frame().frame();
    ASSERT_TRUE(editor().organ_choice().ready());
    EXPECT_NEAR(editor().organ_choice().size().x, 0.25, 1e-6);
    ui().key(ui::Key::enter).frame();
    EXPECT_TRUE(editor().organ_choice().ready())
        << "a size that no organ has is not loaded by Enter: it takes the unit";
    EXPECT_NEAR(editor().organ_choice().size().x, 250, 1e-3);
    editor().organ_choice().set_rotation({-90, 0, 0});
    EXPECT_NEAR(editor().organ_choice().size().y, 150, 1e-3) << "z is up";
    ui().frame();
    ui().click("**/Load");
    EXPECT_EQ(editor().document.steps().size(), steps + 1);
    EXPECT_EQ(last_step(), "Load organ");
    EXPECT_EQ(editor().document.scene().organ.scale, 1000);
    EXPECT_TRUE(events().empty());
    ui().frame().frame();
    ASSERT_TRUE(editor().preview.organ_faults().empty());
    EXPECT_NEAR(editor().looking.camera.target.x, 125, 1e-3) << "it is seen whole";
    editor().document.undo();
    EXPECT_EQ(editor().document.scene().organ.file, "lagb.glb");
    EXPECT_EQ(events().size(), 3U);
}

TEST_F(TimelinePanelTest, AnOrganThatIsOpenedWithoutTheDialogIsOfferedInAnotherUnit) {
    const std::string file = box("named.obj", 9.6, 6, 6.6);
    app::Opened opened;
    app::open_files(opened, {file});
    ASSERT_TRUE(opened.unit.has_value());
    EXPECT_EQ(opened.unit->scale, 10);
    EXPECT_NEAR(opened.unit->organ.maximum.x, 96, 1e-4);
    // With another file there is no dialog, and neither is there one for the command line.
    open({file, (shipped() / "presets/brisk_bleed.json").string()});
    ui().frame().frame();
    EXPECT_FALSE(editor().organ_choice().ready());
    EXPECT_EQ(editor().document.scene().organ.scale, 0) << "as the file says";
    EXPECT_NEAR(editor().looking.camera.target.x, 4.8, 1e-3);
    EXPECT_NE(ui().dump().find("named.obj: 9.6 mm is small for an organ"), std::string::npos) << ui().dump();
    ui().click("**/Use cm").frame().frame();
    EXPECT_EQ(editor().document.scene().organ.scale, 10);
    EXPECT_NEAR(editor().looking.camera.target.x, 48, 1e-3) << "it is seen whole";
    EXPECT_NEAR(editor().document.scene().camera.target.x, 48, 1e-3);
    EXPECT_EQ(last_step(), "Organ in another unit");
    editor().document.undo();
    EXPECT_EQ(editor().document.scene().organ.scale, 0);
    app::Opened usual;
    app::open_files(usual, {box("usual.obj", 96, 60, 66)});
    EXPECT_FALSE(usual.unit.has_value());
}

TEST_F(TimelinePanelTest, TheDialogOfTheScenesOrganKnowsItsTexture) {
    const std::string file = box("textured.obj", 96, 60, 66);
    std::ofstream(file, std::ios::app) << "mtllib textured.mtl\n";
    std::ofstream(folder() / "textured.mtl") << "newmtl skin\nmap_Kd missing.png\n";
    const cv::Mat skin(8, 8, CV_8UC3, cv::Scalar(40, 40, 160));
    ASSERT_TRUE(cv::imwrite((folder() / "skin.png").string(), skin));
    const auto texture_warnings = [&] {
        std::size_t count = 0;
        for (const std::string& warning : editor().organ_choice().warnings())
            count += warning.find("missing.png") != std::string::npos ? 1 : 0;
        return count;
    };
    open({file});
    ui().frame().frame();
    EXPECT_TRUE(ui().exists("**/Its texture missing.png is missing."));
    EXPECT_EQ(texture_warnings(), 0U) << "it is told once";
    EXPECT_LT(ui().rect("**/About it/Use skin.png").bottom(), ui().rect("**/About it/Organ").y) << "above all else";
    ui().click("**/Load").frame().frame().settle();
    EXPECT_TRUE(ui().exists("Workspace/View/Missing texture/Use skin.png")) << "and where one looks afterwards";
    ui().click("Workspace/View/Missing texture/Leave it").frame();
    EXPECT_FALSE(ui().exists("Workspace/View/Missing texture"));
    open({file});
    ui().frame().frame();
    ui().click("**/About it/Use skin.png").frame();
    EXPECT_NE(ui().dump().find("Its texture is skin.png"), std::string::npos);
    ui().click("**/Load").frame();
    EXPECT_NE(editor().document.scene().organ.texture.find("skin.png"), std::string::npos);
    open({file});
    ui().frame().frame();
    ASSERT_TRUE(editor().organ_choice().ready());
    EXPECT_EQ(texture_warnings(), 0U) << "another picture stands for it";
    EXPECT_NE(ui().dump().find("Its texture is skin.png"), std::string::npos);
    ui().click("**/Load").frame();
    EXPECT_NE(editor().document.scene().organ.texture.find("skin.png"), std::string::npos) << "and stays";
    open({box("other.obj", 96, 60, 66)});
    ui().frame().frame();
    EXPECT_EQ(ui().dump().find("Its texture is"), std::string::npos);
}

TEST_F(TimelinePanelTest, ASmallOrganIsOfferedInTheUnitThatMakesItUsual) {
    open({box("centimetres.obj", 9.6, 6, 6.6)});
    ui().frame().frame().frame();
    ASSERT_TRUE(ui().exists("**/Use cm"));
    EXPECT_EQ(ui().ui().focus(), ui().node("**/Use cm").id) << "not Cancel";
    EXPECT_EQ(editor().organ_choice().reason(),
              "9.6 mm is small for an organ (5 to 600 mm are possible). If the unit is cm, its longest side is 96 mm, "
              "nearest to a liver's 200 mm.");
    ui().key(ui::Key::enter).frame();
    EXPECT_EQ(editor().organ_choice().scale(), 10);
    EXPECT_FALSE(ui().exists("**/Use cm"));
    ui().click("**/Cancel").frame();
    open({box("usual.obj", 96, 60, 66)});
    ui().frame().frame().frame();
    EXPECT_FALSE(ui().exists("**/Use cm"));
    EXPECT_NE(ui().ui().focus(), ui().node("**/Cancel").id);
}

TEST_F(TimelinePanelTest, AMissingTextureIsToldAndTheLikelyFileIsTaken) {
    std::ofstream(folder() / "liver.mtl") << "newmtl m\nmap_Kd diffuse.png\n";
    std::ofstream(folder() / "liver_light.obj")
        << "mtllib liver.mtl\nv 0 0 0\nv 90 0 0\nv 0 60 10\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n";
    std::filesystem::create_directory(folder() / "textures");
    cv::imwrite((folder() / "textures/Liver_texture.jpg").string(), cv::Mat(32, 32, CV_8UC3, cv::Scalar(30, 40, 150)));
    open({(folder() / "liver_light.obj").string()});
    ui().frame().frame().frame();
    ui().click("**/Load").frame().frame().frame();
    editor().layouts().bring_to_front("Scene");
    ui().frame().frame();
    EXPECT_NE(ui().dump().find("Its texture diffuse.png is missing: it is shown without one."), std::string::npos)
        << ui().dump();
    const std::size_t steps = editor().document.done();
    ui().click("**/Scene rows/Organ/Use Liver_texture.jpg").frame().frame();
    EXPECT_EQ(editor().document.done(), steps + 1);
    EXPECT_TRUE(editor().document.scene().organ.texture.ends_with("textures/Liver_texture.jpg"));
    const auto organ = editor().preview.organ_of(editor().document.scene());
    ASSERT_NE(organ, nullptr);
    ASSERT_EQ(organ->organ().images.size(), 1U);
    EXPECT_EQ(organ->organ().images[0].name, "Liver_texture.jpg");
    EXPECT_FALSE(ui().exists("**/Scene rows/Organ/Use Liver_texture.jpg"));
    editor().document.undo();
    ui().frame().frame();
    EXPECT_TRUE(ui().exists("**/Scene rows/Organ/Use Liver_texture.jpg"));
}

TEST_F(TimelinePanelTest, AMissingTextureIsToldWhereNoPictureIsNear) {
    const std::string file = box("alone.obj", 96, 60, 66);
    std::ofstream(file, std::ios::app) << "mtllib alone.mtl\n";
    std::ofstream(folder() / "alone.mtl") << "newmtl skin\nmap_Kd b.png\n";
    open({file});
    ui().frame().frame();
    EXPECT_TRUE(ui().exists("**/About it/Its texture b.png is missing."));
    ui().click("**/Load").frame().frame().settle();
    const std::string bar = "Workspace/View/Missing texture";
    EXPECT_TRUE(ui().exists(bar + "/Its texture b.png is missing: it is shown without one.")) << ui().dump();
    const std::filesystem::path elsewhere = folder() / "far/away";
    std::filesystem::create_directories(elsewhere);
    const cv::Mat skin(8, 8, CV_8UC3, cv::Scalar(40, 40, 160));
    ASSERT_TRUE(cv::imwrite((elsewhere / "skin.png").string(), skin));
    ui().click(bar + "/Choose...").frame().frame();
    ui().click("Choose a file/Name").key('A', ui::Mods::command).type((elsewhere / "skin.png").string());
    ui().key(ui::Key::enter).frame().settle();
    EXPECT_TRUE(editor().document.scene().organ.texture.ends_with("far/away/skin.png"));
    EXPECT_EQ(last_step(), "Organ: Texture");
    EXPECT_FALSE(ui().exists(bar));
    editor().document.undo();
    ui().frame().frame();
    EXPECT_TRUE(ui().exists(bar));
    ui().click(bar + "/Leave it").frame();
    EXPECT_FALSE(ui().exists(bar));
}

TEST_F(TimelinePanelTest, TheDialogShowsTheOrganWithABarOfTenMillimetres) {
    open({box("box.obj", 9.6, 6, 6.6)});
    ui().frame().frame().frame();
    ASSERT_TRUE(ui().exists("**/About it/Organ"));
    // 9.6 units over nine tenths of 320 px, or 6 over nine tenths of 160.
    const double units = std::max(9.6 / 288, 6.0 / 144);
    EXPECT_NEAR(editor().organ_choice().picture_pixel(), units, 1e-9);
    ui().click("**/Use cm").frame();
    EXPECT_NEAR(editor().organ_choice().picture_pixel(), 10 * units, 1e-9);
    EXPECT_EQ(ui().text("**/About it/Organ"), "10 mm");
}

TEST_F(TimelinePanelTest, WhereNoColourTellsTheDensityTheReadoutSaysSo) {
    open({box("box.obj", 250, 100, 150)});
    ui().frame().frame();
    ui().click("**/Load").frame().frame();
    editor().document.change("Colour", [](document::Content& c) { c.scene.organ.color = {0.8, 0.3, 0.3}; });
    editor().looking.overlay = Overlay::vessels;
    ui().frame().frame();
    ui().move(ui().node("Workspace/View/Preview").rect().center()).frame();
    ASSERT_TRUE(ui().exists("**/Under the pointer"));
    EXPECT_EQ(ui().text("**/Under the pointer").find("vessels and fat not known"), 0U)
        << ui().text("**/Under the pointer");
}

TEST_F(TimelinePanelTest, TheColourStaysWithItsOrgan) {
    const glm::dvec3 colour(0.9, 0.5, 0.4);
    editor().document.change("Colour", [&](document::Content& c) { c.scene.organ.color = colour; });
    open({(editor().document.scene().folder / "lagb.glb").string()});
    ui().frame().frame();
    ui().click("**/Load");
    EXPECT_EQ(last_step(), "Load organ");
    EXPECT_EQ(editor().document.scene().organ.color, colour) << "the same organ once more";
    EXPECT_EQ(events().size(), 3U);
    open({box("box.obj", 250, 100, 150)});
    ui().frame().frame();
    ui().click("**/Load");
    EXPECT_EQ(editor().document.scene().organ.color, glm::dvec3(1)) << "another one has its own";
    editor().document.undo();
    EXPECT_EQ(editor().document.scene().organ.color, colour);
}

TEST_F(TimelinePanelTest, ABrokenOrganIsToldInTheDialogAndNothingChanges) {
    const std::string file = (folder() / "broken.obj").string();
    std::ofstream(file) << "v 1 2\nf 1 2 9\n";
    open({file});
    ui().frame().frame();
    EXPECT_FALSE(editor().organ_choice().ready());
    ASSERT_FALSE(editor().organ_choice().faults().empty());
    EXPECT_TRUE(ui().exists("**/Choose another..."));
    ui().click("**/Cancel");
    EXPECT_FALSE(editor().document.can_undo());
    EXPECT_EQ(editor().document.scene().organ.file, "lagb.glb");
}

/// Makes one event of every kind.
void of_every_kind(document::Content& c) {
    c.scene.events.clear();
    for (const ToolActionRow& row : tool_actions)
        c.scene.events.push_back(
            {.action = row.action, .time = 1.0 + static_cast<double>(c.scene.events.size()), .duration = 0.5});
}

TEST_F(TimelinePanelTest, TheFormStaysInSightWhateverTracksThereAre) {
    editor().document.change("Events", of_every_kind);
    for (const char* name : {"Tune", "Stage", "Compare"}) {
        layout(name);
        editor().selected = {0};
        ui().frame().frame();
        const ui::Rect panel = ui().rect("Workspace/Timeline");
        for (const char* row : {"**/Event/Action", "**/Event/Power", "**/Event/Position"}) {
            const ui::Rect place = ui().rect(row);
            EXPECT_GE(place.y, panel.y) << name << ": " << row;
            EXPECT_LE(place.bottom(), panel.bottom() + 0.5F) << name << ": " << row;
        }
        const ui::Rect tracks = ui().rect("Workspace/Timeline/Events");
        EXPECT_GE(tracks.h, ui().ui().em(3.5F)) << name << ": and a track or two above it";
        EXPECT_LE(tracks.bottom(), ui().rect("**/Event/Action").y) << name;
        EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{}) << name;
    }
}

TEST_F(TimelinePanelTest, ASelectionThatIsStaleDoesNoHarm) {
    editor().document.change("Events", of_every_kind);
    ui().frame();
    editor().selected = {4, 5};
    ui().frame();
    ASSERT_EQ(editor().selected, (std::vector<std::size_t>{4, 5}));
    ASSERT_TRUE(editor().layouts().choose("Tune"));
    editor().layouts().shown.show("Amounts");  // the timeline is not visible
    ui().frame().frame();
    ASSERT_FALSE(ui().exists("Workspace/Timeline"));
    editor().document.undo();
    ui().frame();
    EXPECT_EQ(events().size(), 3U);
    EXPECT_TRUE(editor().selected.empty()) << "they were places among other events";
    EXPECT_FALSE(editor().commands.run("event.duplicate"));
    EXPECT_EQ(events().size(), 3U);
    editor().document.redo();
    ui().frame();
    editor().selected = {1};
    ui().frame();
    editor().document.change("Fewer", [](document::Content& c) { c.scene.events.erase(c.scene.events.begin()); });
    ui().frame();
    EXPECT_TRUE(editor().selected.empty()) << "or another event would be doubled or deleted";
    ui().click("**/Timeline").frame();
    ui().frame();
    editor().selected = {9};
    ui().frame();
    EXPECT_TRUE(editor().selected.empty()) << "out of range";
    editor().commands.run("event.add");
    ui().frame();
    EXPECT_EQ(editor().selected, std::vector{tool_action_count - 1}) << "what was made is selected";
}

TEST_F(TimelinePanelTest, CauteryOfAnOrganWithoutColoursBleedsLittle) {
    open({box("plain.obj", 96, 60, 66)});
    ui().frame().frame();
    ui().click("**/Load").frame().frame();
    ASSERT_TRUE(events().empty());
    const auto held = [&](char tool) {
        ui().key(tool).press("Workspace/View/Preview");
        for (int i = 0; i < 30; ++i) ui().frame();
        ui().release();
        return events().empty() ? -1.0 : events().back().strength;
    };
    EXPECT_NEAR(held('1'), 0.15, 1e-9) << "its vessels are not known, and cautery closes what it divides";
    EXPECT_NE(ui().text("**/Under the pointer").find("would bleed 0.15"), std::string::npos)
        << ui().text("**/Under the pointer");
    EXPECT_EQ(held('2'), 1) << "a cut without heat bleeds";
    editor().tool.action = ToolAction::cauterise;
    ui().frame().click("**/Add event");
    EXPECT_NEAR(events().back().strength, 0.15, 1e-9);
    open_sample();
    ui().frame();
    EXPECT_EQ(held('1'), 1) << "where vessels are seen they decide";
}

}  // namespace
}  // namespace lapfx::test
