// Help: the sheet of keys and pointer gestures, and the text of About.
#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/base/layouts.h"
#include "editor/support/editor_test.h"
#include "support/folders.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

using ui::Key;

class HelpTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        if (IsSkipped()) return;
        editor().layouts().shown.close("View");
        ui().frame();
    }
    void expect_sheet_inside(glm::ivec2 size, float scale) {
        ui().size = size, ui().scale = scale;
        ui().key(Key::f1).frame().frame();
        const ui::Rect sheet = ui().rect("Keys");
        EXPECT_GE(sheet.x, 0) << size.x;
        EXPECT_LE(sheet.right(), static_cast<float>(size.x)) << size.x;
        EXPECT_GE(sheet.y, 0) << size.y;
        EXPECT_LE(sheet.bottom(), static_cast<float>(size.y)) << size.y;
        EXPECT_TRUE(ui().exists("**/All keys/Orbit"));
        ui().key(Key::escape).frame();
    }
};

TEST_F(HelpTest, TheSheetTellsWhatThePointerDoes) {
    ui().key(Key::f1).frame();
    EXPECT_EQ(ui().text("**/All keys/Orbit"), "drag");
    EXPECT_EQ(ui().text("**/All keys/Ten times finer"), "Shift+drag");
    EXPECT_EQ(ui().text("**/All keys/Menu: copy, lock, range"), "right click");
    EXPECT_EQ(ui().text("**/All keys/The other picture, while held"), "F");
    EXPECT_EQ(ui().text("**/All keys/All of it"), "F") << "in the timeline";
    EXPECT_EQ(ui().text("**/All keys/Undo"), "Ctrl+Z");
    EXPECT_EQ(ui().text("**/All keys/New folder"), "Ctrl+Shift+N");
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
    ui().key(Key::escape).frame();
    expect_sheet_inside({1440, 900}, 1);
    expect_sheet_inside({1280, 800}, 1);
    expect_sheet_inside({1440, 900}, 1.5F);
    expect_sheet_inside({600, 500}, 1);
}

TEST_F(HelpTest, AboutTellsVersionPaperAndLicences) {
    editor().commands.run("help.about");
    ui().frame().frame();
    std::ifstream file(source_folder() / "CMakeLists.txt");
    std::stringstream project;
    project << file.rdbuf();
    const std::string text = project.str(), mark = "project(lapfx VERSION ";
    const std::size_t at = text.find(mark) + mark.size();
    const std::string version = text.substr(at, text.find(' ', at) - at), told = ui().dump();
    EXPECT_NE(told.find("lapfx " + version), std::string::npos) << version;
    EXPECT_NE(told.find("doi:10.1002/rcs.353"), std::string::npos);
    EXPECT_NE(told.find("test (software)"), std::string::npos) << "the renderer";
    for (const char* library : {"FFmpeg", "OpenCV", "OpenMesh", "tinygltf", "meshoptimizer", "Draco", "GLM",
                                "nlohmann/json", "CLI11", "GLFW", "glad", "FreeType", "HarfBuzz", "fontconfig"})
        EXPECT_TRUE(ui().exists("About lapfx/What it is/" + std::string(library))) << library;
    ui().click("About lapfx/Copy").frame();
    EXPECT_EQ(ui().clipboard().text, "lapfx " + version + ", OpenGL: test (software)");
}

}  // namespace
}  // namespace lapfx::test
