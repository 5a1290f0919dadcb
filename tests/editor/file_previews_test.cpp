// Pictures in the file dialog: which files the program itself makes pictures of, and what happens with files that are
// broken or on which it hangs.
#include "app/browser/file_previews.h"
#include "app/base/file_chooser.h"

#include <fstream>

#include "app/base/layouts.h"
#include "editor/support/editor_test.h"
#include "output/files.h"
#include "support/folders.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;

class FilePreviewsTest : public SampleTest {
  protected:
    FilePreviewsTest() { begins.view = false; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        fs::create_directories(files());
    }
    fs::path files() const { return folder() / "files"; }
    fs::path write(const std::string& name, const std::string& text) {
        std::ofstream(files() / name, std::ios::binary) << text;
        return files() / name;
    }
    fs::path copy(const fs::path& from) {
        fs::copy_file(source_folder() / from, files() / from.filename());
        return files() / from.filename();
    }
    fs::path program() const { return build_folder() / "lapfx"; }
    fs::path script(const std::string& lines) {
        const fs::path file = folder() / "make.sh";
        std::ofstream(file) << "#!/bin/sh\n" << lines << '\n';
        fs::permissions(file, fs::perms::owner_all);
        return file;
    }
    void make_with(const fs::path& by) { editor().file_previews().make_with(by); }
    void choose_from_files() {
        editor().chooser().ask({.title = "Look", .folder = files().string()}, [](const auto&) {});
        ui().frame().frame();
    }
    /// Selects the file, waits until its picture has been made or has failed, and gives the preview's text.
    std::string look(const std::string& name) {
        ui().click("Look/Files/" + name);
        return shown();
    }
    /// The same for the file that is selected.
    std::string shown() {
        ui().frame(app::FilePreviews::rests + 0.01);
        EXPECT_TRUE(wait_until([&] { return !ui().is("Look/Preview", ui::Is::busy); }, [&] { ui().frame(); }));
        return ui().text("Look/Preview");
    }
    bool says(const std::string& text) { return ui().dump().find(text) != std::string::npos; }
    std::size_t kept() const {
        std::error_code error;
        std::size_t count = 0;
        for (const auto& each : fs::directory_iterator(folder() / "cache" / "thumbnails", error))
            count += each.path().extension() == ".png" ? 1U : 100U;
        return count;
    }
};

TEST_F(FilePreviewsTest, EveryKindOfFileHasItsPicture) {
    if (!fs::exists(program())) GTEST_SKIP() << program() << " is not built";
    make_with(program());
    copy("tests/golden/cut.png");
    copy("presets/slow_ooze.json");
    write("organ.obj", "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nf 1 2 3\n");
    fs::path clip;
    for (const auto& each : fs::directory_iterator(source_folder() / "samples" / "clips"))
        if (app::has_picture(each.path().string())) clip = each.path();
    ASSERT_FALSE(clip.empty());
    fs::copy_file(clip, files() / ("clip" + clip.extension().string()));
    write("notes.txt", "nothing to see");
    choose_from_files();
    for (const std::string& name : {std::string("cut.png"), std::string("slow_ooze.json"), std::string("organ.obj"),
                                    "clip" + clip.extension().string()})
        EXPECT_EQ(look(name), "a picture") << name << ui().dump();
    EXPECT_EQ(kept(), 4U);
    EXPECT_EQ(look("notes.txt"), "no picture");
    EXPECT_FALSE(says("The picture is being made"));
    EXPECT_EQ(kept(), 4U) << "and nothing else is left there";
}

TEST_F(FilePreviewsTest, ABrokenFileShowsWhyInOneLine) {
    if (!fs::exists(program())) GTEST_SKIP() << program() << " is not built";
    make_with(program());
    write("broken.glb", "not a mesh");
    write("text.mp4", "not a video");
    write("cut.json", R"({"format": "lapfx.preset", "vers)");
    choose_from_files();
    EXPECT_EQ(look("broken.glb"), "no picture");
    EXPECT_TRUE(ui().exists("Look"));
    EXPECT_EQ(look("text.mp4"), "no picture");
    EXPECT_TRUE(says("is a text, but not")) << ui().dump();
    EXPECT_FALSE(says("lapfx: ")) << "the reason alone";
    EXPECT_EQ(look("cut.json"), "no picture");
    EXPECT_EQ(kept(), 0U);
}

TEST_F(FilePreviewsTest, OneThatHangsHoldsUpNothing) {
    make_with(script("exec sleep 100000"));
    write("a.mp4", "x");
    write("b.txt", "x");
    choose_from_files();
    ui().click("Look/Files/a.mp4").frame(1);
    EXPECT_TRUE(editor().file_previews().busy());
    for (int i = 0; i < 10; ++i) ui().frame();
    EXPECT_TRUE(ui().is("Look/Preview", ui::Is::busy)) << "frames have gone on meanwhile";
    ui().click("Look/Files/b.txt").frame();
    const auto ends = [&] {
        return wait_until([&] { return !editor().file_previews().busy(); }, [&] { ui().frame(); });
    };
    EXPECT_TRUE(ends()) << "what nobody looks at is not finished";
    ui().click("Look/Files/a.mp4").frame(1);
    EXPECT_TRUE(editor().file_previews().busy());
    ui().click("Look/Cancel");
    EXPECT_TRUE(ends()) << "nor once the dialog is closed";
}

TEST_F(FilePreviewsTest, FilesThatArePassedByAreNotBegun) {
    make_with(script("echo run >> '" + (folder() / "runs").string() + "'; exit 1"));
    for (int i = 0; i < 9; ++i) write("take " + std::to_string(i) + ".mp4", "x");
    choose_from_files();
    ui().focus("Look/Files");
    for (int i = 0; i < 9; ++i) ui().key(ui::Key::down).frame(0.05);
    EXPECT_FALSE(fs::exists(folder() / "runs"));
    EXPECT_EQ(look("take 8.mp4"), "no picture");
    std::ifstream runs(folder() / "runs");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(runs), {}), "run\n");
    EXPECT_EQ(look("take 8.mp4"), "no picture");
    ui().frame(1).frame(1);
    std::ifstream again(folder() / "runs");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(again), {}), "run\n") << "what failed is not tried again";
}

TEST_F(FilePreviewsTest, SeenFilesAreKeptUntilTheyChange) {
    make_with(script("echo run >> '" + (folder() / "runs").string() + "'; exit 1"));
    const auto runs = [&] {
        std::ifstream file(folder() / "runs");
        return std::string(std::istreambuf_iterator<char>(file), {}).size() / 4;
    };
    write("a.mp4", "x");
    write("b.mp4", "x");
    choose_from_files();
    look("a.mp4"), look("b.mp4"), look("a.mp4");
    EXPECT_EQ(runs(), 2U);
    write("a.mp4", "longer");
    ui().click("Look/Read again");
    look("a.mp4");
    EXPECT_EQ(runs(), 3U) << "another file by now";
    ui().click("Look/Cancel").frame().frame();
    choose_from_files();
    look("a.mp4");
    EXPECT_EQ(runs(), 4U) << "what failed is tried again when it is come back to";
}

TEST_F(FilePreviewsTest, NeverMoreThanAFewPicturesAreInMemory) {
    const std::string picture = (folder() / "small.png").string();
    output::write_png(picture, {.width = 4, .height = 4, .pixels = std::vector<std::uint8_t>(64, 200), .name = ""});
    make_with(script("for last; do :; done; cp '" + picture + "' \"$last\""));
    constexpr std::size_t files_there = app::FilePreviews::most_kept + 4;
    for (std::size_t i = 0; i < files_there; ++i) write("take " + std::to_string(100 + i) + ".mp4", "x");
    const auto images = [&] {
        const auto all = editor().images.all();
        return std::count_if(all.begin(), all.end(), [](const ui::StoredImage& each) { return each.serial != 0; });
    };
    choose_from_files();
    const auto before = images();
    ui().focus("Look/Files");
    for (std::size_t i = 0; i < files_there; ++i) {
        ui().key(ui::Key::down);
        ASSERT_EQ(shown(), "a picture") << i << ui().dump();
    }
    EXPECT_EQ(images() - before, static_cast<std::ptrdiff_t>(app::FilePreviews::most_kept));
    ui().click("Look/Cancel").frame().frame();
    choose_from_files();
    EXPECT_EQ(images(), before) << "the next dialog looks anew";
}

TEST_F(FilePreviewsTest, APresetIsShownOnTheSceneThatIsOpen) {
    make_with(script("echo \"$@\" >> '" + (folder() / "calls").string() + "'; exit 1"));
    copy("presets/slow_ooze.json");
    choose_from_files();
    look("slow_ooze.json");
    const auto calls = [&] {
        std::ifstream file(folder() / "calls");
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_NE(calls().find("render "), std::string::npos) << calls();
    const auto lines = [&] {
        const std::string all = calls();
        return std::count(all.begin(), all.end(), '\n');
    };
    EXPECT_EQ(lines(), 1);
    ui().frame().frame();
    EXPECT_EQ(lines(), 1);
    editor().document.change("Longer", [](document::Content& content) { content.scene.duration *= 2; });
    ui().frame(app::FilePreviews::rests + 0.01);
    EXPECT_EQ(shown(), "no picture");
    EXPECT_EQ(lines(), 2) << "at another time of it";
}

TEST(FilePreviews, AreOfKindsThatTheProgramReads) {
    EXPECT_TRUE(app::has_picture("/a/B.MP4"));
    EXPECT_TRUE(app::has_picture("/a/b.Glb"));
    EXPECT_FALSE(app::has_picture("/a/b.txt"));
    EXPECT_FALSE(app::has_picture("/a.mp4/b"));
}

}  // namespace
}  // namespace lapfx::test
