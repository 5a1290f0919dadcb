// Saving or exporting to a disk that is full or read-only: older files stay, the document still counts as not saved,
// and a message names the file and the reason.
#include <gmock/gmock.h>
#include <sys/mount.h>

#include <fstream>
#include <optional>

#include "app/files/exports.h"
#include "app/files/files.h"
#include "editor/support/editor_test.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "support/file_limit.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;
using ui::Mods;

const auto no_room = AnyOf(HasSubstr("No space left on device"), HasSubstr("File too large"));

/// A small file system, if this user may mount one. Otherwise a folder: when it has been filled, write() sets a
/// FileLimit.
class SmallDisk {
  public:
    explicit SmallDisk(fs::path folder) : folder_(std::move(folder)) {
        fs::create_directory(folder_);
        mounted_ = ::mount("none", folder_.c_str(), "tmpfs", 0, "size=256k") == 0;
    }
    ~SmallDisk() {
        if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    const fs::path& folder() const { return folder_; }
    void fill(std::size_t leave = 0) {
        if (!mounted_) {
            limit_ = leave;
            return;
        }
        const std::string page(4096, 'x');
        std::ofstream filler(folder_ / "filler", std::ios::binary);
        while (filler.write(page.data(), static_cast<std::streamsize>(page.size())).flush()) {
        }
        filler.close();
        fs::resize_file(folder_ / "filler", fs::file_size(folder_ / "filler") - leave);
    }
    /// Calls `writing`, which writes to the disk.
    template <typename Writing>
    void write(Writing&& writing) const {
        std::optional<FileLimit> limit;
        if (limit_) limit.emplace(*limit_);
        writing();
    }
    /// Returns false if this user may not do that.
    bool make_read_only() {
        return mounted_ && ::mount("none", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=256k") == 0;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder_))
            if (entry.path().filename() != "filler") all.push_back(entry.path().filename().string());
        return all;
    }

  private:
    fs::path folder_;
    bool mounted_ = false;
    std::optional<rlim_t> limit_;  ///< bytes
};

class FullDisk : public SampleTest {
  protected:
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        disk_ = std::make_unique<SmallDisk>(folder() / "disk");
    }
    void TearDown() override {
        disk_.reset();
        EditorTest::TearDown();
    }
    SmallDisk& disk() { return *disk_; }
    void change() {
        editor().document.change("Change", [](document::Content& c) {
            c.preset.bleeding.speed = 7.5;
            c.scene.duration = 9;
        });
        ui().frame();
    }
    /// Saves the preset and the scene as the person's own files on that disk.
    void save_both() {
        editor().document.save_preset(disk().folder() / "own.json");
        editor().document.save_scene(disk().folder() / "own.scene.json");
        for (const char* name : {"own.json", "own.scene.json"})
            before_[name] = read_file(disk().folder() / name, 1 << 20);
    }
    void expect_as_before() {
        for (const auto& [name, text] : before_) EXPECT_EQ(read_file(disk().folder() / name, 1 << 20), text) << name;
        EXPECT_THAT(disk().names(), testing::UnorderedElementsAre("own.json", "own.scene.json")) << "and no parts";
        EXPECT_TRUE(editor().document.preset_unsaved());
        EXPECT_TRUE(editor().document.scene_unsaved());
        EXPECT_EQ(editor().document.preset().bleeding.speed, 7.5);
    }
    /// Exports over an old file of this name while so many bytes are free, and expects that the old file stays.
    void expect_export_leaves(const std::string& name, output::OutputKind kind, std::size_t room,
                              const testing::Matcher<std::string>& reason) {
        const fs::path file = disk().folder() / name;
        // A preset replaces nothing but another one.
        const std::string old = kind == output::OutputKind::preset ? write_preset(Preset{}) : "old";
        std::ofstream(file) << old;
        disk().fill(room);
        export_to(kind, file);
        EXPECT_EQ(read_file(file, 1 << 20), old);
        EXPECT_THAT(disk().names(), testing::ElementsAre(name));
        EXPECT_THAT(ui().dump(), testing::AllOf(HasSubstr(name + ": "), reason));
    }
    void expect_told(const std::string& file, const testing::Matcher<std::string>& reason) {
        ui().frame();
        ASSERT_NE(editor().files().question(), nullptr);
        EXPECT_EQ(editor().files().question()->title, '"' + file + "\" was not saved");
        ASSERT_EQ(editor().files().question()->lines.size(), 1U);
        EXPECT_THAT(editor().files().question()->lines[0], testing::AllOf(HasSubstr(file + ": "), reason));
        ui().key(ui::Key::escape).frame();
    }
    void press_save(ui::Mods mods) {
        disk().write([&] { ui().key('S', mods).frame(); });
    }
    void export_to(output::OutputKind kind, const fs::path& file) {
        app::Exports& exports = editor().exports();
        exports.propose(kind);
        exports.form.file() = file.string();
        exports.form.size = 5;
        exports.form.to = 0.4;
        ASSERT_TRUE(exports.faults().empty()) << exports.faults().front().text();
        disk().write([&] {
            exports.start();
            EXPECT_TRUE(wait_until([&] { return !exports.running(); }, [&] { ui().frame(); }));
        });
        ASSERT_FALSE(exports.running());
        ui().frame();
    }

  private:
    std::unique_ptr<SmallDisk> disk_;
    std::map<std::string, std::string> before_;
};

TEST_F(FullDisk, PresetAndSceneStayUnsavedAndTheirFilesWhole) {
    save_both();
    change();
    disk().fill();
    press_save(Mods::command);
    expect_told("own.json", no_room);
    press_save(Mods::command | Mods::alt);
    expect_told("own.scene.json", no_room);
    expect_as_before();
}

TEST_F(FullDisk, OneThatIsReadOnlyIsToldAsThat) {
    save_both();
    change();
    if (!disk().make_read_only()) GTEST_SKIP() << "this user may not mount a disk";
    press_save(Mods::command);
    expect_told("own.json", HasSubstr("Read-only file system"));
    press_save(Mods::command | Mods::alt);
    expect_told("own.scene.json", HasSubstr("Read-only file system"));
    expect_as_before();
    app::Exports& exports = editor().exports();
    exports.propose(output::OutputKind::picture);
    exports.form.file() = (disk().folder() / "out.png").string();
    EXPECT_EQ(exports.fault_at("-o"), disk().folder().string() + " cannot be written to");
}

/// This replaces a test of a folder without permissions, because root has all permissions.
TEST_F(FullDisk, AFolderThatHasBecomeAFileIsTold) {
    const fs::path sub = folder() / "sub";
    fs::create_directory(sub);
    editor().document.save_preset(sub / "own.json");
    change();
    fs::remove_all(sub);
    std::ofstream(sub) << "a file";
    ui().key('S', Mods::command).frame();
    expect_told("own.json", HasSubstr("Not a directory"));
    EXPECT_TRUE(editor().document.preset_unsaved());
}

TEST_F(FullDisk, APresetExportedLeavesTheOldOne) {
    expect_export_leaves("old.json", output::OutputKind::preset, 0, no_room);
}

TEST_F(FullDisk, APictureLeavesTheOldOne) {
    expect_export_leaves("out.png", output::OutputKind::picture, 16384, no_room);
}

TEST_F(FullDisk, AVideoLeavesTheOldOneAndSaysWhy) {
    expect_export_leaves("out.mp4", output::OutputKind::video, 8192, HasSubstr("is the disk full?"));
}

TEST_F(FullDisk, AVideoWithNoRoomAtAllSaysWhyToo) {
    disk().fill();
    export_to(output::OutputKind::video, disk().folder() / "out.mp4");
    EXPECT_THAT(disk().names(), testing::IsEmpty());
    EXPECT_THAT(ui().dump(), testing::AllOf(HasSubstr("out.mp4: writing failed: "), no_room));
}

}  // namespace
}  // namespace lapfx::test
