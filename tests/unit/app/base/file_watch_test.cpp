#include "app/base/file_watch.h"

#include <gmock/gmock.h>

#include <chrono>
#include <condition_variable>
#include <fstream>

#include "unit/preset/support.h"

namespace lapfx::app {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

class FileWatching : public testing::Test {
  protected:
    /// Waits for reports, at most 5 s.
    FileWatch::Paths next() {
        std::unique_lock lock(mutex);
        woken.wait_for(lock, 5s, [&] { return std::exchange(told, false); });
        return watch.take();
    }
    /// Watches, and gives the watch time to begin.
    void set(const FileWatch::Paths& paths) {
        watch.set(paths);
        std::this_thread::sleep_for(100ms);
    }
    static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

    test::Folder folder;
    std::mutex mutex;
    std::condition_variable woken;
    bool told = false;
    FileWatch watch{[this] {
        const std::lock_guard lock(mutex);
        told = true;
        woken.notify_one();
    }};
};

TEST_F(FileWatching, AWrittenFileIsToldOnceAndOthersAreNot) {
    const fs::path mine = folder.write("mine.json", "1");
    set({mine});
    folder.write("other.json", "2");
    for (int i = 0; i < 5; ++i) write(mine, std::string(static_cast<std::size_t>(i) + 1, 'x'));
    EXPECT_THAT(next(), ElementsAre(mine));
    EXPECT_THAT(watch.take(), IsEmpty());
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
    EXPECT_THAT(next(), ElementsAre(inner / "a.frag", inner / "b.frag"));
}

TEST_F(FileWatching, FoldersMayVanishAndComeBack) {
    const fs::path inner = folder / "a" / "b", mine = inner / "mine.json";
    fs::create_directories(inner);
    write(mine, "1");
    set({mine});
    fs::rename(folder / "a", folder / "away");
    std::this_thread::sleep_for(100ms);
    fs::remove_all(folder / "away");
    std::this_thread::sleep_for(400ms);
    watch.take();
    {
        const std::lock_guard lock(mutex);
        told = false;
    }
    fs::create_directory(folder / "a");
    std::this_thread::sleep_for(100ms);
    fs::create_directory(inner);
    std::this_thread::sleep_for(100ms);
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
