#include "lapfx/authoring/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "lapfx/error.h"

namespace lapfx {

namespace {

/// An open file, closed at the end of the scope.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return number_; }
    bool close() { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

[[noreturn]] void fail(Failure failure, const std::filesystem::path& path, std::string reason) {
    throw Error(failure, Fault{path.string(), "", std::move(reason)});
}

std::string system_reason(const std::string& what) {
    return what + ": " + std::strerror(errno);
}

const char* type_name(mode_t mode) {
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISLNK(mode)) return "a symbolic link";
    if (S_ISFIFO(mode)) return "a pipe";
    return "a device or socket";
}

/// The mode for the new file: that of the file it replaces, or 0.
mode_t check_target(const std::filesystem::path& path) {
    struct stat found {};
    if (::lstat(path.c_str(), &found) != 0) {
        if (errno == ENOENT) return 0;
        fail(Failure::runtime, path, system_reason("cannot be written"));
    }
    // Renaming would replace the link and leave its target unchanged, which nobody wants.
    if (!S_ISREG(found.st_mode))
        fail(Failure::runtime, path, std::string("not written: it is ") + type_name(found.st_mode));
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        fail(Failure::runtime, path, system_reason("cannot be written"));
    return found.st_mode & 07777;
}

/// Empty, or why it failed.
std::string write_all(Descriptor& file, std::string_view text, mode_t mode) {
    while (!text.empty()) {
        const ssize_t written = ::write(file.get(), text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return system_reason("writing failed");
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (mode != 0 && ::fchmod(file.get(), mode) != 0) return system_reason("its permissions cannot be kept");
    if (::fsync(file.get()) != 0 || !file.close()) return system_reason("writing failed");
    return {};
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t longest) {
    if (path.empty()) fail(Failure::bad_input, path, "no file name");
    // Not blocking: opening a pipe would wait for its writer.
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.get() < 0) fail(Failure::bad_input, path, system_reason("cannot be read"));
    struct stat found {};
    if (::fstat(file.get(), &found) != 0) fail(Failure::bad_input, path, system_reason("cannot be read"));
    if (!S_ISREG(found.st_mode))
        fail(Failure::bad_input, path, std::string("not a plain file but ") + type_name(found.st_mode));
    std::string text;
    const auto check_size = [&](std::size_t size) {
        if (size > longest)
            fail(Failure::bad_input, path,
                 std::to_string(size) + " bytes; at most " + std::to_string(longest) + " are read");
    };
    check_size(static_cast<std::size_t>(found.st_size));
    for (char buffer[1 << 16];;) {
        const ssize_t got = ::read(file.get(), buffer, sizeof buffer);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(Failure::bad_input, path, system_reason("cannot be read"));
        if (got == 0) break;
        text.append(buffer, static_cast<std::size_t>(got));
        check_size(text.size());  // it may have grown, and files under /proc have no size
    }
    if (text.empty()) fail(Failure::bad_input, path, "the file is empty");
    return text;
}

void write_file(const std::filesystem::path& path, std::string_view text) {
    if (path.empty()) fail(Failure::runtime, path, "no file name");
    const mode_t mode = check_target(path);
    const Beside beside(path, Beside::Kind::file);
    // Closing also reports faults; a file that stays open keeps its lock until it is renamed.
    Descriptor file(::fcntl(beside.descriptor(), F_DUPFD_CLOEXEC, 0));
    if (file.get() < 0) fail(Failure::runtime, path, system_reason("cannot be written"));
    std::string reason = write_all(file, text, mode);
    if (reason.empty() && ::rename(beside.path().c_str(), path.c_str()) != 0)
        reason = system_reason("cannot be replaced");
    if (!reason.empty()) fail(Failure::runtime, path, reason);
    // The rename reaches the disk when the folder is flushed. Not every file system can do that, but the text is safe.
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)); opened.get() >= 0)
        ::fsync(opened.get());
}

}  // namespace lapfx
