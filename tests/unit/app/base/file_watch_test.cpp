#include "app/base/file_watch.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <fstream>

#include "support/wait_until.h"
#include "unit/preset/support.h"

namespace lapfx::app {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

/// The watch's clock stands still except in next(), so that a busy machine does not part what belongs together.
class FileWatching : public testing::Test {
  protected:
    void set(const FileWatch::Paths& paths) {
        watch.set(paths);
        ASSERT_TRUE(test::wait_until([&] { return watch.armed(); }));
    }
    /// The next report, which is of `count` files.
    FileWatch::Paths next(std::size_t count = 1) {
        EXPECT_TRUE(test::wait_until([&] { return watch.pending() >= count; }));
        now = now + 0.2;
        EXPECT_TRUE(test::wait_until([&] { return told > heard; }));
        heard = told;
        return watch.take();
    }
    static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

    test::Folder folder;
    std::atomic<int> told = 0;
    int heard = 0;
    std::atomic<double> now = 1000;  // s
    FileWatch watch{[this] { ++told; }, [this] { return now.load(); }};
};

TEST_F(FileWatching, AWrittenFileIsToldOnceAndOthersAreNot) {
    const fs::path mine = folder.write("mine.json", "1"), last = folder / "z last.json";
    set({mine, last});
    folder.write("other.json", "2");
    for (int i = 0; i < 5; ++i) write(mine, std::string(static_cast<std::size_t>(i) + 1, 'x'));
    write(last, "after all of them");
    EXPECT_THAT(next(2), ElementsAre(mine, last));
    EXPECT_THAT(watch.take(), IsEmpty());
    EXPECT_EQ(told, 1);
}

TEST_F(FileWatching, WhatGoesOnIsToldAfterASecond) {
    FileWatch::Paths files;
    for (const char name : {'0', '1', '2', '3', '4', '5', '6', '7'}) files.push_back(folder / std::string(1, name));
    set(files);
    for (std::size_t i = 0; i < files.size(); ++i) {
        write(files[i], "1");
        ASSERT_TRUE(test::wait_until([&] { return watch.pending() == i + 1; }));
        EXPECT_EQ(told, 0) << "something has happened an eighth of a second ago";
        now = now + 0.125;
    }
    EXPECT_TRUE(test::wait_until([&] { return told == 1; }));
    EXPECT_EQ(watch.take(), files);
}

TEST_F(FileWatching, WrittenBesideAndRenamed) {
    const fs::path mine = folder.write("mine.json", "1");
    set({mine});
    fs::rename(folder.write("mine.json.part", "2"), mine);
    EXPECT_THAT(next(), ElementsAre(mine));
    fs::remove(mine);
    EXPECT_THAT(next(), ElementsAre(mine)) << "a file that vanishes";
    write(mine, "3");
    EXPECT_THAT(next(), ElementsAre(mine)) << "and comes back";
}

TEST_F(FileWatching, AFolderTellsOfAllThatIsInIt) {
    const fs::path inner = folder / "shaders";
    fs::create_directory(inner);
    set({inner});
    write(inner / "a.frag", "1");
    write(inner / "b.frag", "1");
    EXPECT_THAT(next(2), ElementsAre(inner / "a.frag", inner / "b.frag"));
}

TEST_F(FileWatching, FoldersMayVanishAndComeBack) {
    const test::Folder elsewhere;
    const fs::path inner = folder / "a" / "b", mine = inner / "mine.json", beside = elsewhere / "beside.json";
    fs::create_directories(inner);
    write(mine, "1");
    set({mine, beside});
    // When what happens beside it afterwards is told, the watch knows of all before.
    const auto let_it_know = [&](const char* text) {
        write(beside, text);
        EXPECT_TRUE(test::wait_until([&] {
            now = now + 0.2;
            const FileWatch::Paths paths = watch.take();
            return std::find(paths.begin(), paths.end(), beside) != paths.end();
        }));
    };
    fs::rename(folder / "a", folder / "away");
    let_it_know("1");
    fs::remove_all(folder / "away");
    let_it_know("2");
    fs::create_directory(folder / "a");
    let_it_know("3");
    fs::create_directory(inner);
    let_it_know("4");
    heard = told;
    write(mine, "2");
    EXPECT_THAT(next(), ElementsAre(mine));
}

TEST_F(FileWatching, AnotherListTakesTheFormerOnesPlace) {
    const fs::path one = folder.write("one", "1"), other = folder.write("other", "1");
    set({one});
    set({other});
    write(one, "2");
    write(other, "2");
    EXPECT_THAT(next(), ElementsAre(other));
}

}  // namespace
}  // namespace lapfx::app
