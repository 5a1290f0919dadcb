#include "document/lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "document/hash.h"
#include "lapfx/error.h"

namespace lapfx::document {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, int code) {
    throw Error(Failure::runtime, Fault{file.string(), "", std::string("cannot be locked: ") + std::strerror(code)});
}

/// Whether the open file still has this name. The previous holder may have removed the file meanwhile, and then a lock
/// on it locks nothing.
bool still_there(int descriptor, const fs::path& file) {
    struct stat mine {
    }, named{};
    return ::fstat(descriptor, &mine) == 0 && ::stat(file.c_str(), &named) == 0 && mine.st_ino == named.st_ino &&
           mine.st_dev == named.st_dev;
}

void write_holder(int descriptor) {
    char host[256] = {};
    if (::gethostname(host, sizeof host - 1) != 0) std::strcpy(host, "unknown");
    const std::string text = "process " + std::to_string(::getpid()) + " on " + host + '\n';
    // The text is only for people to read: the lock holds without it, too.
    if (::ftruncate(descriptor, 0) != 0 || ::pwrite(descriptor, text.data(), text.size(), 0) < 0) return;
}

}  // namespace

std::optional<Lock> Lock::take(const fs::path& file) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    for (int attempt = 0; attempt < 100; ++attempt) {
        const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
        if (descriptor < 0) fail(file, errno);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int code = errno;
            ::close(descriptor);
            if (code == EWOULDBLOCK) return std::nullopt;
            if (code != EINTR) fail(file, code);
        } else if (still_there(descriptor, file)) {
            write_holder(descriptor);
            return Lock(descriptor, file);
        } else {
            ::close(descriptor);
        }
    }
    return std::nullopt;
}

Lock::Lock(Lock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)), file_(std::move(other.file_)) {}

Lock& Lock::operator=(Lock&& other) noexcept {
    if (this == &other) return *this;
    release();
    descriptor_ = std::exchange(other.descriptor_, -1);
    file_ = std::move(other.file_);
    return *this;
}

Lock::~Lock() {
    release();
}

void Lock::release() noexcept {
    if (descriptor_ < 0) return;
    if (still_there(descriptor_, file_)) ::unlink(file_.c_str());
    ::close(std::exchange(descriptor_, -1));
}

fs::path lock_file(const fs::path& state_folder, const fs::path& document) {
    std::error_code error;
    fs::path whole = fs::weakly_canonical(document, error);
    if (error) whole = fs::absolute(document).lexically_normal();
    return state_folder / "locks" / (hex_of(hash_of(whole.string())) + ".lock");
}

std::string holder_of(const fs::path& lock_file) {
    std::ifstream file(lock_file);
    std::string line;
    std::getline(file, line);
    constexpr std::size_t longest = 200;
    if (line.size() > longest) line.resize(longest);
    for (const char c : line)
        if (c < 0x20 || c > 0x7e) return {};  // lapfx did not write this
    return line;
}

}  // namespace lapfx::document
