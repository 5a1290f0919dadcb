// Tells which of some files have changed on disk. It sleeps until the system says so: idle it costs nothing.
//
//     FileWatch watch([&] { ui.wake("file"); });
//     watch.set({"presets/tuned.json", "shaders"});   // a file, or a folder with the files directly in it
//     for (const auto& path : watch.take()) reload(path);  // once a frame
//
// Changes are told when nothing more has happened for 150 ms, at the latest after a second: programs write in pieces,
// or beside the file and rename. Folders may vanish and come back. What a symbolic link points to is not watched.
//
// GIO's monitors are not used: they look for a missing folder only every few seconds, do not tell when a folder above a
// file is moved away or comes back, and waiting until a program has finished writing would still be code of ours.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace lapfx::app {

class FileWatch {
  public:
    using Paths = std::vector<std::filesystem::path>;

    /// `wake`: called on another thread when there is something to take. `clock`: s, asked there; empty: the machine's.
    explicit FileWatch(std::function<void()> wake, std::function<double()> clock = {});
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// Watches these in place of the former ones: absolute paths without "..". From one thread.
    void set(const Paths& paths);
    /// What has changed, appeared or gone since the last call, each once. Of a folder that is watched, the files in it.
    /// One thread.
    Paths take();
    /// False where the system has no more watches to give, or none at all.
    bool works() const { return queue_ >= 0; }
    /// Whether what set() has been given is watched already.
    bool armed() const { return armed_ == asked_; }
    /// Files that have changed and are not told yet: more may happen to them.
    std::size_t pending() const { return pending_count_; }

  private:
    void run();
    void arm(const Paths& paths);
    std::optional<int> watch(const std::filesystem::path& folder);
    void read_events();
    void note(const std::filesystem::path& path);
    void note_all_in(const std::filesystem::path& folder);
    int time_left() const;
    void publish();

    std::function<void()> wake_;
    std::function<double()> clock_;
    int queue_ = -1, signal_ = -1;  // inotify; eventfd: a new list, or the end

    std::mutex mutex_;
    std::optional<Paths> wanted_;  // asked for, and not yet watched
    std::set<std::filesystem::path> changed_;
    bool stopping_ = false;
    std::uint64_t asked_ = 0;               // calls of set()
    std::atomic<std::uint64_t> armed_ = 0;  // the one whose paths are watched
    std::atomic<std::size_t> pending_count_ = 0;

    // The thread's own.
    Paths paths_;
    std::set<std::filesystem::path> files_, folders_;         // what is watched
    std::map<int, std::set<std::filesystem::path>> watched_;  // a folder may have several paths
    std::set<std::filesystem::path> missing_;                 // folders that are not there
    std::set<std::filesystem::path> pending_;                 // changed, not yet told
    bool rearm_ = false;
    double first_ = 0, last_ = 0;  // s, of what is pending
    std::thread thread_;
};

}  // namespace lapfx::app
