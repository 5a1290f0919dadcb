#include "app/base/file_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double quiet = 0.15, longest = 1.0;  // s
constexpr std::uint32_t gone = IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED | IN_UNMOUNT;
constexpr std::uint32_t interesting =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

/// A file that was created is told when it has been written; a link is whole at once.
bool is_whole_at_once(const fs::path& path) {
    struct stat found {};
    return ::lstat(path.c_str(), &found) == 0 && (S_ISLNK(found.st_mode) || found.st_nlink > 1);
}

}  // namespace

FileWatch::FileWatch(std::function<void()> wake, std::function<double()> clock)
    : wake_(std::move(wake)),
      clock_(clock ? std::move(clock) : std::function<double()>(seconds)),
      queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)),
      signal_(eventfd(0, EFD_CLOEXEC)) {
    if (queue_ >= 0 && signal_ >= 0) thread_ = std::thread([this] { run(); });
}

FileWatch::~FileWatch() {
    if (thread_.joinable()) {
        {
            const std::lock_guard lock(mutex_);
            stopping_ = true;
        }
        eventfd_write(signal_, 1);
        thread_.join();
    }
    if (queue_ >= 0) ::close(queue_);
    if (signal_ >= 0) ::close(signal_);
}

void FileWatch::set(const Paths& paths) {
    {
        const std::lock_guard lock(mutex_);
        wanted_ = paths;
        ++asked_;
    }
    if (signal_ >= 0) eventfd_write(signal_, 1);
}

FileWatch::Paths FileWatch::take() {
    const std::lock_guard lock(mutex_);
    Paths taken(changed_.begin(), changed_.end());
    changed_.clear();
    return taken;
}

void FileWatch::run() {
    std::array<pollfd, 2> sources{pollfd{queue_, POLLIN, 0}, pollfd{signal_, POLLIN, 0}};
    while (true) {
        ::poll(sources.data(), sources.size(), time_left());
        if ((sources[1].revents & POLLIN) != 0) {
            eventfd_t count = 0;
            eventfd_read(signal_, &count);
            std::optional<Paths> wanted;
            std::uint64_t asked = 0;
            {
                const std::lock_guard lock(mutex_);
                if (stopping_) return;
                wanted.swap(wanted_);
                asked = asked_;
            }
            if (wanted) arm(*wanted);
            armed_ = asked;
        }
        if ((sources[0].revents & POLLIN) != 0) read_events();
        if (rearm_) arm(Paths(paths_));
        if (time_left() == 0) publish();
    }
}

/// ms until what is pending is told; -1: nothing is.
int FileWatch::time_left() const {
    if (pending_.empty()) return -1;
    const double due = std::min(last_ + quiet, first_ + longest);
    return static_cast<int>(std::ceil(std::max(0.0, due - clock_()) * 1000));
}

void FileWatch::publish() {
    {
        const std::lock_guard lock(mutex_);
        changed_.merge(pending_);
    }
    pending_.clear();
    pending_count_ = 0;
    if (wake_) wake_();
}

/// Watches the folders of all files; for a folder that does not exist, the nearest one above it, to see it appear.
void FileWatch::arm(const Paths& paths) {
    rearm_ = false;
    paths_ = paths;
    files_.clear();
    folders_.clear();
    std::set<fs::path> wanted;
    for (const fs::path& path : paths) {
        const bool folder = is_folder(path);
        (folder ? folders_ : files_).insert(path);
        wanted.insert(folder ? path : path.parent_path());
    }
    const std::set<fs::path> were_missing = std::exchange(missing_, {});
    std::map<int, std::set<fs::path>> armed;
    for (const fs::path& folder : wanted) {
        fs::path nearest = folder;
        std::optional<int> descriptor = watch(nearest);
        if (!descriptor) missing_.insert(folder);
        while (!descriptor && nearest.has_relative_path()) {
            nearest = nearest.parent_path();
            descriptor = watch(nearest);
        }
        if (descriptor) armed[*descriptor].insert(nearest);
        if (nearest == folder && were_missing.contains(folder)) note_all_in(folder);
    }
    for (const auto& [descriptor, of] : watched_)
        if (!armed.contains(descriptor)) inotify_rm_watch(queue_, descriptor);
    watched_ = std::move(armed);
}

std::optional<int> FileWatch::watch(const fs::path& folder) {
    const int descriptor = inotify_add_watch(queue_, folder.c_str(), interesting);
    return descriptor < 0 ? std::nullopt : std::optional(descriptor);
}

void FileWatch::note(const fs::path& path) {
    if (!files_.contains(path) && !folders_.contains(path.parent_path())) return;
    last_ = clock_();
    if (pending_.empty()) first_ = last_;
    pending_.insert(path);
    pending_count_ = pending_.size();
}

void FileWatch::note_all_in(const fs::path& folder) {
    for (const fs::path& file : std::set<fs::path>(files_))
        if (file.parent_path() == folder) note(file);
}

void FileWatch::read_events() {
    alignas(inotify_event) std::array<char, 16384> bytes;
    const ssize_t size = ::read(queue_, bytes.data(), bytes.size());
    for (ssize_t at = 0; at + static_cast<ssize_t>(sizeof(inotify_event)) <= size;) {
        const auto& event = *reinterpret_cast<const inotify_event*>(bytes.data() + at);
        at += static_cast<ssize_t>(sizeof(inotify_event) + event.len);
        if ((event.mask & IN_Q_OVERFLOW) != 0) {  // events were lost: anything may have changed
            for (const fs::path& file : files_) note(file);
            continue;
        }
        const auto found = watched_.find(event.wd);
        if (found == watched_.end()) continue;
        const std::set<fs::path> folders = found->second;
        if ((event.mask & gone) != 0) {
            rearm_ = true;
            for (const fs::path& folder : folders) note_all_in(folder);
            if ((event.mask & IN_MOVE_SELF) != 0) inotify_rm_watch(queue_, event.wd);
            watched_.erase(event.wd);
            continue;
        }
        // A folder that appears may be one that was missing, or contain it.
        if ((event.mask & IN_ISDIR) != 0 || !missing_.empty()) rearm_ = true;
        if (event.len == 0) continue;
        for (const fs::path& folder : folders) {
            const fs::path path = folder / event.name;
            if ((event.mask & IN_CREATE) == 0 || is_whole_at_once(path)) note(path);
        }
    }
}

}  // namespace lapfx::app
