// Files written next to their place: they are removed together with their process, also when it is killed, and never
// while it writes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "lapfx/authoring/file.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class BesideTest : public testing::Test {
  protected:
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder.path()))
            found.push_back(entry.path().filename().string());
        return found;
    }
    /// Another process that is in the middle of writing.
    pid_t writer(Beside::Kind kind) const {
        int ready[2];
        EXPECT_EQ(::pipe(ready), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            const Beside part(folder / "out.mp4", kind, ".mp4");
            if (kind == Beside::Kind::folder) std::ofstream(part / "frame.png") << "half";
            if (::write(ready[1], "x", 1) == 1) ::pause();
            ::_exit(1);
        }
        char byte = 0;
        EXPECT_EQ(::read(ready[0], &byte, 1), 1);
        ::close(ready[0]);
        ::close(ready[1]);
        return child;
    }
    static void end(pid_t child) {
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
    }
    test::Folder folder;
};

TEST_F(BesideTest, GoesWithWhatHoldsIt) {
    {
        const Beside file(folder / "a.txt", Beside::Kind::file), made(folder / "b", Beside::Kind::folder);
        EXPECT_EQ(file.path().parent_path(), folder.path());
        std::ofstream(made / "in.txt") << "x";
        EXPECT_EQ(names().size(), 2U);
        write_file(folder / "c.txt", "c");
        EXPECT_EQ(names().size(), 3U) << "what is held stays";
    }
    EXPECT_THAT(names(), ElementsAre("c.txt"));
    EXPECT_THAT(test::faults_of([&] { Beside(folder / "gone/a.txt", Beside::Kind::file); }, Failure::runtime),
                ElementsAre((folder / "gone/a.txt").string() + ": cannot be written: No such file or directory"));
}

TEST_F(BesideTest, WhatAKilledProcessLeftGoesWithTheNextWrite) {
    for (const Beside::Kind kind : {Beside::Kind::file, Beside::Kind::folder}) {
        const pid_t child = writer(kind);
        write_file(folder / "a.txt", "1");
        EXPECT_EQ(names().size(), 2U) << "it runs";
        end(child);
        EXPECT_EQ(names().size(), 2U) << "killed, nobody could tidy up";
        write_file(folder / "a.txt", "2");
        EXPECT_THAT(names(), ElementsAre("a.txt"));
    }
}

TEST_F(BesideTest, NothingElseIsTouched) {
    folder.write("mine.txt", "mine");
    fs::create_directory(folder / "kept");
    folder.write(".lapfx-part-notes", "mine");
    folder.write(".lapfx-part-1-0123abc", "mine");
    folder.write(".lapfx-1-0.tmp", "mine");
    fs::create_symlink(folder / "mine.txt", folder / ".lapfx-part-1-0123abcd.tmp");
    fs::create_directory_symlink(folder / "kept", folder / ".lapfx-part-2-0123abcd");
    ASSERT_EQ(::mkfifo((folder / ".lapfx-part-3-0123abcd").c_str(), 0600), 0);
    const auto before = names();
    write_file(folder / "mine.txt", "still");
    EXPECT_THAT(names(), testing::UnorderedElementsAreArray(before));
    folder.write(".lapfx-part-4-0123abcd.mp4", "left by a process that was killed");
    write_file(folder / "mine.txt", "still");
    EXPECT_THAT(names(), testing::UnorderedElementsAreArray(before));
    EXPECT_TRUE(fs::exists(folder / "kept"));
}

TEST_F(BesideTest, ManyWritersOfOneFolderKeepTheirOwn) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([this, t] {
            for (int i = 0; i < 200; ++i) write_file(folder / (std::to_string(t) + ".txt"), std::to_string(i));
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_THAT(names(), UnorderedElementsAre("0.txt", "1.txt", "2.txt", "3.txt"));
    for (int t = 0; t < 4; ++t) EXPECT_EQ(test::read_text(folder / (std::to_string(t) + ".txt")), "199");
}

}  // namespace
}  // namespace lapfx
