#include "document/keep.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "lapfx/authoring/file.h"

namespace lapfx::document {
namespace {

namespace fs = std::filesystem;

class KeptWork : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "lapfx-keep-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    void TearDown() override {
        std::error_code error;
        fs::remove_all(folder_, error);
    }
    static Kept kept(double speed, std::int64_t time = 1000) {
        Kept k;
        k.time = time;
        k.content.preset.bleeding.speed = speed;
        k.content.preset.name = "kept";
        k.content.scene.events = {{.time = 2, .position = {1, 2, 3}}};
        k.content.scene.folder = "/some/where";
        k.preset_file = "/some/where/p.json";
        k.preset_disk = {.exists = true, .hash = 0xfedcba9876543210ULL};
        k.preset_unsaved = true;
        k.snapshots = {{.slot = 2, .time = 77, .preset = k.content.preset}};
        return k;
    }
    /// Another process that keeps something and is ended by `signal`, or lives until the pipe is closed.
    pid_t editor_that_keeps(double speed, int ready, int stay) const {
        const pid_t child = ::fork();
        if (child != 0) return child;
        KeepFolder folder(folder_);
        folder.write(kept(speed));
        char byte = 'x';
        if (::write(ready, &byte, 1) != 1) ::_exit(2);
        if (stay >= 0 && ::read(stay, &byte, 1) < 0) ::_exit(3);
        ::_exit(0);  // nothing is tidied up: a crash
    }

    fs::path folder_;
};

TEST_F(KeptWork, IsReadBackAsItWas) {
    Kept k = kept(6);
    k.content.preset.smoke.keying.luma_low = 250;  // above luma_high: out of order, but work
    std::ofstream(folder_ / "a.json") << write_kept(k);
    std::vector<std::string> told;
    const Kept back = read_kept(folder_ / "a.json", told);
    EXPECT_TRUE(told.empty());
    EXPECT_TRUE(same(back.content, k.content));
    EXPECT_EQ(back.content.scene.folder, k.content.scene.folder);
    EXPECT_EQ(back.preset_file, k.preset_file);
    EXPECT_EQ(back.preset_disk, k.preset_disk);
    EXPECT_FALSE(back.scene_disk.exists);
    EXPECT_TRUE(back.preset_unsaved);
    EXPECT_FALSE(back.scene_unsaved);
    EXPECT_EQ(back.time, 1000);
    ASSERT_EQ(back.snapshots.size(), 1U);
    EXPECT_EQ(back.snapshots[0].slot, 2U);
    EXPECT_EQ(write_preset(back.snapshots[0].preset), write_preset(kept(6).content.preset));
}

TEST_F(KeptWork, BrokenFilesAreRefusedWithAReason) {
    for (const char* text : {"", "{", "[]", R"({"format": "lapfx.autosave", "version": 2})",
                             R"({"format": "lapfx.autosave", "version": 1, "scene": 3, "preset": {}})"}) {
        std::ofstream(folder_ / "a.json") << text;
        std::vector<std::string> told;
        EXPECT_THROW(read_kept(folder_ / "a.json", told), Error) << text;
    }
    std::ofstream(folder_ / "a.json") << R"({"format": "lapfx.autosave", "version": 1, "scene": {"file": 3,
        "content": {"seed": "no"}}, "preset": {"content": 5}, "snapshots": [1, {"slot": -1}, {"slot": 9}]})";
    std::vector<std::string> told;
    const Kept back = read_kept(folder_ / "a.json", told);
    EXPECT_TRUE(back.scene_file.empty());
    EXPECT_TRUE(back.snapshots.empty());
    EXPECT_EQ(told.size(), 2U);
}

TEST_F(KeptWork, ARunningEditorsIsNobodyElses) {
    KeepFolder editor(folder_);
    EXPECT_TRUE(find_left_behind(folder_).empty());
    editor.write(kept(5));
    EXPECT_TRUE(find_left_behind(folder_).empty());
    editor.remove();
    EXPECT_TRUE(fs::is_empty(folder_));
    editor.write(kept(5));
    editor.write(kept(6));
    EXPECT_FALSE(fs::is_empty(folder_));
}

TEST_F(KeptWork, ACrashedEditorsIsOfferedToOneAtATime) {
    int ready[2], stay[2];
    ASSERT_EQ(::pipe(ready), 0);
    ASSERT_EQ(::pipe(stay), 0);
    const pid_t child = editor_that_keeps(9, ready[1], stay[0]);
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    EXPECT_TRUE(find_left_behind(folder_).empty()) << "it runs";
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    for (const int end : {ready[0], ready[1], stay[0], stay[1]}) ::close(end);

    std::vector<LeftBehind> left = find_left_behind(folder_);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_TRUE(find_left_behind(folder_).empty()) << "one editor holds it already";
    std::vector<std::string> told;
    EXPECT_EQ(read_kept(left[0].files[0], told).content.preset.bleeding.speed, 9);
    left.clear();  // kept for later
    left = find_left_behind(folder_);
    ASSERT_EQ(left.size(), 1U);
    discard(std::move(left[0]));
    left.clear();
    EXPECT_TRUE(find_left_behind(folder_).empty());
    EXPECT_TRUE(fs::is_empty(folder_));
}

std::size_t count(const fs::path& folder) {
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) files += entry.path().extension() == ".json";
    return files;
}

TEST_F(KeptWork, IsRotated) {
    KeepFolder mine(folder_);
    for (int i = 0; i < 8; ++i) mine.write(kept(i));
    EXPECT_EQ(count(mine.folder()), KeepFolder::most_files);
    std::vector<std::string> told;
    EXPECT_EQ(read_kept(mine.folder() / "00000008.json", told).content.preset.bleeding.speed, 7);
    // 30 of editors that have ended.
    for (int i = 0; i < 15; ++i) {
        const fs::path old = folder_ / ("old-" + std::to_string(10 + i));
        fs::create_directory(old);
        for (const char* name : {"00000001.json", "00000002.json"}) {
            std::ofstream(old / name) << write_kept(kept(1));
            fs::last_write_time(old / name, fs::file_time_type::clock::now() - std::chrono::hours(100 - i));
        }
    }
    mine.write(kept(50));
    EXPECT_EQ(count(folder_), KeepFolder::most_in_all);
    EXPECT_EQ(count(mine.folder()), KeepFolder::most_files);
    EXPECT_TRUE(fs::exists(folder_ / "old-24" / "00000002.json")) << "the newest of each goes last";
    EXPECT_FALSE(fs::exists(folder_ / "old-24" / "00000001.json"));
    EXPECT_TRUE(fs::exists(folder_ / "old-10" / "00000002.json"));
}

TEST_F(KeptWork, FoldersOfOthersThatCannotBeLockedOrAreEmptyAreInNobodysWay) {
    for (int i = 10; i < 12; ++i) {
        const fs::path old = folder_ / ("old-" + std::to_string(i));
        fs::create_directory(old);
        for (int number = 1; number <= 20; ++number) {
            const fs::path file = old / (std::to_string(100 + number) + ".json");
            std::ofstream(file) << write_kept(kept(1));
            fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(100 - i));
        }
    }
    fs::create_symlink(folder_ / "nowhere", folder_ / "old-11" / "lock");  // a lock is never opened through a link
    KeepFolder mine(folder_);
    mine.write(kept(50));
    EXPECT_TRUE(fs::exists(mine.folder() / "00000001.json"));
    EXPECT_EQ(count(folder_ / "old-11"), 20U) << "left alone";
    EXPECT_FALSE(fs::exists(folder_ / "old-10")) << "what is empty goes";
}

TEST_F(KeptWork, AFolderThatCannotBeWrittenIsAFaultAndTriedAgain) {
    std::ofstream(folder_ / "file") << "x";
    KeepFolder nowhere(folder_ / "file" / "autosave");
    EXPECT_THROW(nowhere.write(kept(1)), Error);
    fs::remove(folder_ / "file");
    nowhere.write(kept(2));
    EXPECT_TRUE(fs::exists(nowhere.folder() / "lock"));
    fs::remove_all(folder_ / "file");  // removed by somebody
    nowhere.write(kept(3));
    EXPECT_TRUE(find_left_behind(folder_ / "file" / "autosave").empty());
}

TEST_F(KeptWork, LocksHoldAgainstOthersAndEndWithTheirProcess) {
    const fs::path document = folder_ / "a" / "preset.json";
    fs::create_directory(folder_ / "a");
    std::ofstream(document) << "{}";
    fs::create_directory_symlink(folder_ / "a", folder_ / "b");
    const fs::path file = lock_file(folder_, document);
    EXPECT_EQ(lock_file(folder_, folder_ / "b" / ".." / "b" / "preset.json"), file) << "the same file by another name";
    EXPECT_NE(lock_file(folder_, folder_ / "a" / "other.json"), file);
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto lock = Lock::take(file);
        if (::write(ready[1], "x", 1) != 1) ::_exit(1);
        for (;;) ::pause();
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    EXPECT_FALSE(Lock::take(file).has_value());
    EXPECT_THAT(holder_of(file), testing::StartsWith("process " + std::to_string(child) + " on "));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    {
        const auto lock = Lock::take(file);
        ASSERT_TRUE(lock.has_value());
        EXPECT_FALSE(Lock::take(file).has_value());
    }
    EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace lapfx::document
