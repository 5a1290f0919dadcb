#include "lapfx/authoring/file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "unit/preset/support.h"

namespace lapfx {

namespace {

using test::faults_of;
using test::Folder;
using testing::ElementsAre;
namespace fs = std::filesystem;

std::vector<std::string> read_faults(const fs::path& path, std::size_t longest = 10) {
    return faults_of([&] { read_file(path, longest); });
}

std::vector<std::string> write_faults(const fs::path& path) {
    return faults_of([&] { write_file(path, "new"); }, Failure::runtime);
}

std::size_t count_entries(const Folder& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), {}));
}

/// Becomes an ordinary user who owns the folder and its files, for a scope, because permissions do not apply to root.
class OrdinaryUser {
  public:
    explicit OrdinaryUser(const Folder& folder) : before_(::geteuid()) {
        if (before_ != 0) return;
        constexpr uid_t nobody = 65534;
        for (const auto& entry : fs::directory_iterator(folder.path())) change_owner(entry.path(), nobody);
        change_owner(folder.path(), nobody);
        EXPECT_EQ(::seteuid(nobody), 0);
    }
    ~OrdinaryUser() { EXPECT_EQ(::seteuid(before_), 0); }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;

  private:
    uid_t before_;

    static void change_owner(const fs::path& path, uid_t user) {
        EXPECT_EQ(::chown(path.c_str(), user, static_cast<gid_t>(-1)), 0);
    }
};

TEST(ReadFile, ReadsUpToItsLimit) {
    const Folder folder;
    EXPECT_EQ(read_file(folder.write("a", "0123456789"), 10), "0123456789");
    EXPECT_EQ(read_file(folder.write("b", std::string("a\0b", 3)), 10), std::string("a\0b", 3));
    const fs::path longer = folder.write("c", "0123456789x");
    EXPECT_THAT(read_faults(longer), ElementsAre(longer.string() + ": 11 bytes; at most 10 are read"));
}

TEST(ReadFile, NamesWhatIsNoPlainFile) {
    const Folder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    fs::create_symlink("nowhere", folder / "dangling");
    const std::string at = folder.path().string();
    EXPECT_THAT(read_faults(folder.path()), ElementsAre(at + ": not a plain file but a folder"));
    EXPECT_THAT(read_faults(pipe), ElementsAre(at + "/pipe: not a plain file but a pipe"));
    EXPECT_THAT(read_faults("/dev/null"), ElementsAre("/dev/null: not a plain file but a device or socket"));
    EXPECT_THAT(read_faults(folder / "missing"),
                ElementsAre(at + "/missing: cannot be read: No such file or directory"));
    EXPECT_THAT(read_faults(folder / "dangling"),
                ElementsAre(at + "/dangling: cannot be read: No such file or directory"));
    EXPECT_THAT(read_faults(folder.write("empty", "")), ElementsAre(at + "/empty: the file is empty"));
    EXPECT_THAT(read_faults(""), ElementsAre("no file name"));
}

TEST(ReadFile, NamesWhatMayNotBeRead) {
    const Folder folder;
    const fs::path path = folder.write("a", "x");
    fs::permissions(path, fs::perms::none);
    const OrdinaryUser user(folder);
    EXPECT_THAT(read_faults(path), ElementsAre(path.string() + ": cannot be read: Permission denied"));
}

TEST(ReadFile, FollowsASymbolicLinkToAPlainFile) {
    const Folder folder;
    folder.write("a", "text");
    fs::create_symlink("a", folder / "link");
    EXPECT_EQ(read_file(folder / "link", 10), "text");
}

TEST(WriteFile, WritesAndReplacesAndLeavesNothingBeside) {
    const Folder folder;
    write_file(folder / "a", "first");
    EXPECT_EQ(test::read_text(folder / "a"), "first");
    fs::permissions(folder / "a", fs::perms::owner_read | fs::perms::owner_write);
    write_file(folder / "a", "second");
    EXPECT_EQ(test::read_text(folder / "a"), "second");
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(count_entries(folder), 1u);
}

TEST(WriteFile, NewFilesObeyTheUmask) {
    const Folder folder;
    const mode_t before = ::umask(027);
    write_file(folder / "a", "x");
    ::umask(before);
    struct stat found {};
    ASSERT_EQ(::stat((folder / "a").c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777, 0640u);
}

TEST(WriteFile, WritesIntoTheWorkingFolder) {
    const Folder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    write_file("bare", "x");
    fs::current_path(before);
    EXPECT_EQ(test::read_text(folder / "bare"), "x");
}

TEST(WriteFile, RefusesASymbolicLinkAndKeepsBothEnds) {
    const Folder folder;
    folder.write("a", "old");
    fs::create_symlink("a", folder / "link");
    EXPECT_THAT(write_faults(folder / "link"),
                ElementsAre((folder / "link").string() + ": not written: it is a symbolic link"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(test::read_text(folder / "a"), "old");
}

TEST(WriteFile, RefusesWhatIsNoPlainFile) {
    const Folder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(write_faults(folder.path()), ElementsAre(folder.path().string() + ": not written: it is a folder"));
    EXPECT_THAT(write_faults(folder / "pipe"), ElementsAre((folder / "pipe").string() + ": not written: it is a pipe"));
    EXPECT_THAT(write_faults(""), ElementsAre("no file name"));
    EXPECT_EQ(count_entries(folder), 1u);
}

TEST(WriteFile, MissingFolderIsNamed) {
    const Folder folder;
    EXPECT_THAT(write_faults(folder / "no/a"),
                ElementsAre((folder / "no/a").string() + ": cannot be written: No such file or directory"));
}

TEST(WriteFile, ReadOnlyFolderKeepsTheOldFile) {
    const Folder folder;
    const fs::path path = folder.write("a", "old");
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    const OrdinaryUser user(folder);
    EXPECT_THAT(write_faults(path), ElementsAre(path.string() + ": cannot be written: Permission denied"));
    EXPECT_EQ(test::read_text(path), "old");
    EXPECT_EQ(count_entries(folder), 1u);
}

TEST(WriteFile, WriteProtectedFileIsKept) {
    const Folder folder;
    const fs::path path = folder.write("a", "old");
    fs::permissions(path, fs::perms::owner_read);
    const OrdinaryUser user(folder);
    EXPECT_THAT(write_faults(path), ElementsAre(path.string() + ": cannot be written: Permission denied"));
    EXPECT_EQ(test::read_text(path), "old");
}

/// In a separate process: tries to write more than the system permits, and exits with 7 when the result is right.
[[noreturn]] void write_beyond_the_limit(const Folder& folder) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100, 100};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
        write_file(folder / "a", std::string(1000, 'x'));
    } catch (const Error& error) {
        const bool kept = test::read_text(folder / "a") == "old" && count_entries(folder) == 1;
        std::_Exit(kept && error.failure() == Failure::runtime ? 7 : 8);
    }
    std::_Exit(9);
}

TEST(WriteFile, FullDiskIsNamedAndLeavesNothing) {
    // A limit on the size of files simulates the full disk.
    const Folder folder;
    folder.write("a", "old");
    EXPECT_EXIT(write_beyond_the_limit(folder), testing::ExitedWithCode(7), "");
}

}  // namespace

}  // namespace lapfx
