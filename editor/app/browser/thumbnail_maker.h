// Pictures of files, made beside the UI: this very program makes them in a child process, niced, one at a time, and
// they are kept in the cache folder. A file that hangs, crashes or wants all memory does that to the child.
//
//     ThumbnailMaker maker({.cache = folders.cache, .clip_folders = ..., .wake = [&] { ui.wake("thumbnail"); }});
//     maker.want({{.file = "presets/slow_ooze.json", .scene = "samples/lagb.scene.json", .time = 9},
//         {.file = "liver.glb"}});
//     for (ThumbnailMaker::Result& result : maker.take()) show(result);   // each frame
//
// A picture is found again by what it shows: the texts of preset and scene, their clips and organ, any other file by
// its name, size and time, and the program. One that is no longer wanted is not finished. UI thread; the work is on a
// thread of its own.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace lapfx::app {

class ThumbnailMaker {
  public:
    static constexpr glm::ivec2 standard_size{192, 154};
    static constexpr std::size_t most_kept = 300;  ///< files; those unused for longest are removed
    static constexpr std::uint64_t most_memory = std::uint64_t{4} << 30;  ///< bytes, of what makes a picture

    struct Options {
        std::filesystem::path cache{};                      ///< empty: nothing is kept, and so nothing is made
        std::vector<std::filesystem::path> clip_folders{};  ///< where bare clip names are looked up
        std::filesystem::path program = "/proc/self/exe";
        bool render = true;  ///< false: only what is in the cache is shown
        glm::ivec2 size = standard_size;
        std::chrono::seconds longest{60};  ///< then a child is ended
        int niceness = 10;  ///< of a child, 0 to 19: it disturbs nobody, and comes in minutes beside busy programs
        std::function<void()> wake{};  ///< any thread; a result has come
    };
    struct Request {
        std::filesystem::path file;
        std::filesystem::path scene = {};  ///< where `file` is a preset: it is shown on this one
        double time = 0;                   ///< s; of a preset, in that scene
        friend bool operator==(const Request&, const Request&) = default;
    };
    struct Result {
        std::filesystem::path file;
        glm::ivec2 size{0};  ///< Options::size; for what has a shape of its own, the largest one that fits into that
        std::vector<std::uint8_t> rgba{};  ///< empty: there is none
        std::string fault{};               ///< why, one line; empty where it was not to be rendered
    };

    explicit ThumbnailMaker(Options options);
    ~ThumbnailMaker();  ///< ends a child that runs; waits for no file system that hangs
    ThumbnailMaker(const ThumbnailMaker&) = delete;
    ThumbnailMaker& operator=(const ThumbnailMaker&) = delete;

    /// Sets all pictures that are wanted from now on, in this order. Work on those that are asked for again continues.
    void want(std::vector<Request> requests);
    std::vector<Result> take();
    bool busy() const;
    void finish();  ///< waits for all that is wanted

    /// Limits memory and processor time of the process that makes a picture, and its core dump, since it may run with
    /// nobody there to end it. 0: this process.
    static void limit_process(pid_t process);

  private:
    struct Work;
    std::shared_ptr<Work> work_;
    std::thread thread_;
};

}  // namespace lapfx::app
