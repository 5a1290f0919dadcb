// Files that are written next to their place. A lock shows whether the process that wrote one still runs. A pid would
// not: pids are used again, mean other processes in another container, and nothing on another machine.
#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <random>

#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/error.h"

namespace lapfx {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".lapfx-part-";
constexpr std::size_t random_digits = 8;
constexpr int most_attempts = 100;

bool same_file(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

std::string random_word() {
    static thread_local std::random_device device;
    constexpr std::string_view digits = "0123456789abcdef";
    std::string word;
    for (std::uint32_t bits = device(); word.size() < random_digits; bits >>= 4U) word += digits[bits & 15U];
    return word;
}

/// ".lapfx-part-1234-0f5a7bc9.mp4"
bool is_ours(std::string_view name) {
    if (!name.starts_with(prefix)) return false;
    name.remove_prefix(prefix.size());
    const std::size_t dash = name.find_first_not_of("0123456789");
    if (dash == 0 || dash == std::string_view::npos || name[dash] != '-') return false;
    const std::size_t end = std::min(name.find_first_not_of("0123456789abcdef", dash + 1), name.size());
    return end - dash - 1 == random_digits;
}

/// Locks the file unless somebody else has it. On a file system without locks nobody can find out either whether a file
/// was left behind.
bool take(int descriptor) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
    struct stat found {};
    return ::fstat(descriptor, &found) == 0 && found.st_nlink > 0;
}

/// An open file, closed at the end of the scope.
struct Descriptor {
    int number = -1;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

/// Removes a file of ours that no process holds any more. It follows no link and touches nothing of other users.
void drop_if_left(int folder, const fs::path& path) {
    const std::string name = path.filename().string();
    constexpr int flags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    Descriptor opened{
        ::openat(folder, name.c_str(), O_RDWR | flags)};  // network file systems lock only what can be written
    if (opened.number < 0) opened.number = ::openat(folder, name.c_str(), O_RDONLY | flags);
    struct stat held {
    }, named{};
    if (opened.number < 0 || ::fstat(opened.number, &held) != 0 || held.st_uid != ::geteuid()) return;
    if (!S_ISREG(held.st_mode) && !S_ISDIR(held.st_mode)) return;
    if (::flock(opened.number, LOCK_EX | LOCK_NB) != 0) return;
    // Its owner may have renamed it, and released the lock, since it was opened.
    if (::fstatat(folder, name.c_str(), &named, AT_SYMLINK_NOFOLLOW) != 0 || !same_file(held, named)) return;
    std::error_code ignored;
    S_ISDIR(held.st_mode) ? (void)fs::remove_all(path, ignored) : (void)::unlinkat(folder, name.c_str(), 0);
}

void drop_left_behind(const fs::path& folder) {
    if (is_ours(folder.filename().string())) return;  // the contents of a folder that is being made
    DIR* entries = ::opendir(folder.c_str());
    if (entries == nullptr) return;
    while (const dirent* entry = ::readdir(entries))
        if (is_ours(entry->d_name)) drop_if_left(::dirfd(entries), folder / entry->d_name);
    ::closedir(entries);
}

/// The open file, or -1, and errno says why.
int make(const fs::path& path, Beside::Kind kind) {
    if (kind == Beside::Kind::file) return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (::mkdir(path.c_str(), 0700) != 0) return -1;
    return ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

}  // namespace

Beside::Beside(const fs::path& target, Kind kind, std::string_view extension) {
    require_not_read(target);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    drop_left_behind(folder);
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        path_ =
            folder / (std::string(prefix) + std::to_string(::getpid()) + '-' + random_word() + std::string(extension));
        descriptor_ = make(path_, kind);
        if (descriptor_ < 0 && errno == EEXIST) continue;
        if (descriptor_ < 0) break;
        if (take(descriptor_)) return;
        ::close(descriptor_);  // another process that tidies up was faster
        descriptor_ = -1;
    }
    throw Error(Failure::runtime,
                Fault{target.string(), "", std::string("cannot be written: ") + std::strerror(errno)});
}

Beside::~Beside() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace lapfx
