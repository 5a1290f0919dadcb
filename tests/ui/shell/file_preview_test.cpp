#include "ui/shell/file_preview.h"

#include <array>
#include <ctime>

#include "ui/shell/file_dialog_fixture.h"
#include "ui/support/count_allocations.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using State = FilePicture::State;

struct MadeUpPictures : FilePictures {
    std::map<std::string, FilePicture> of;
    std::vector<std::string> asked;
    FilePicture picture(Ui&, const std::string& path, const FileEntry& file) override {
        if (asked.empty() || asked.back() != path) asked.push_back(path);
        bytes = file.size;
        const auto found = of.find(path);
        return found == of.end() ? FilePicture{} : found->second;
    }
    std::uint64_t bytes = 0;
};

class FilePreview : public FileDialogTest {
  protected:
    FilePreview() {
        dialog.show_pictures(&pictures);
        const std::vector<std::uint8_t> grey(4 * 4 * 4, 128);
        image = ui.images().add({4, 4}, grey);
    }
    MadeUpPictures pictures;
    ImageHandle image = 0;
};

/// In local time: west of Greenwich the first second is of the year before.
std::string day_of(std::time_t time) {
    std::array<char, 11> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", std::localtime(&time));
    return text.data();
}

TEST_F(FilePreview, IsAskedForWhatIsSelectedAndNothingElse) {
    open(request(FileTask::open_many));
    EXPECT_EQ(ui.text("Plates/Preview"), "nothing is selected");
    EXPECT_THAT(pictures.asked, ElementsAre());
    ui.click("**/plates");
    EXPECT_EQ(ui.text("Plates/Preview"), "a folder");
    EXPECT_THAT(pictures.asked, ElementsAre()) << "a folder has none";
    ui.click("**/shot 9.exr").click("**/shot 10.exr", {.mods = Mods::command});
    EXPECT_THAT(pictures.asked, ElementsAre("/home/u/shot 9.exr", "/home/u/shot 10.exr")) << "the last of several";
    EXPECT_EQ(pictures.bytes, 2'000'000U);
    EXPECT_TRUE(says("2.0 MB, " + day_of(0)));
    ui.click("Plates/Computer");
    EXPECT_EQ(ui.text("Plates/Preview"), "nothing is selected") << "another folder";
}

TEST_F(FilePreview, ShowsWhatComes) {
    auto& picture = pictures.of["/home/u/shot 9.exr"];
    picture = {.state = State::coming};
    open(request(FileTask::open));
    ui.click("**/shot 9.exr");
    EXPECT_TRUE(ui.is("Plates/Preview", Is::busy));
    EXPECT_TRUE(says("The picture is being made"));
    picture = {.state = State::there, .image = image, .size = {4, 4}};
    ui.frame();
    EXPECT_FALSE(ui.is("Plates/Preview", Is::busy));
    EXPECT_EQ(ui.text("Plates/Preview"), "a picture");
    const std::vector<Batch>& all = ui.output().list->batches;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Batch& batch) { return batch.images[0] == image; }));
    const std::string long_fault = "is no mesh " + std::string(4000, 'x');
    picture = {.state = State::failed, .image = 0, .size = {}, .fault = long_fault};
    ui.frame();
    EXPECT_EQ(ui.text("Plates/Preview"), "no picture");
    EXPECT_TRUE(says("is no mesh xxx"));
    EXPECT_LE(ui.rect("Plates/Cancel").bottom(), 700) << "however long the reason is";
}

TEST_F(FilePreview, MakesRoomForNamesInANarrowWindowAndForFolders) {
    open(request(FileTask::open));
    EXPECT_TRUE(ui.exists("Plates/Preview"));
    ui.size = {500, 400};
    ui.frame().frame();
    EXPECT_FALSE(ui.exists("Plates/Preview"));
    ui.size = {1000, 700};
    ui.key(Key::escape);
    open(request(FileTask::folder));
    EXPECT_FALSE(ui.exists("Plates/Preview"));
}

TEST_F(FilePreview, AStillFrameAllocatesNothing) {
    pictures.of["/home/u/shot 9.exr"] = {.state = State::there, .image = image, .size = {4, 4}};
    open(request(FileTask::open));
    ui.click("**/shot 9.exr").frame(30).frame(30);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 20; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

}  // namespace
}  // namespace lapfx::ui
