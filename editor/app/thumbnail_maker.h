// Pictures of presets on a scene, made beside the UI: this very program renders them in a child process, niced, one at a time, and
// they are kept in the cache folder.
//
//     ThumbnailMaker maker({.cache = folders.cache, .clip_folders = ..., .wake = [&] { ui.wake("thumbnail"); }});
//     maker.want({{.preset = "presets/slow_ooze.json", .scene = "samples/lagb.scene.json", .time = 9}});
//     for (ThumbnailMaker::Result& result : maker.take()) show(result);   // each frame
//
// A picture is found again by what it shows: the texts of preset and scene, their clips and organ, and the program. One that is
// no longer wanted is not finished. UI thread; the work is on a thread of its own.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace lapfx::app {

class ThumbnailMaker {
  public:
    static constexpr glm::ivec2 size{192, 154};
    static constexpr std::size_t most_kept = 200;  ///< files; the longest unused go

    struct Options {
        std::filesystem::path cache{};                      ///< empty: nothing is kept, and so nothing is made
        std::vector<std::filesystem::path> clip_folders{};  ///< where bare clip names are looked up
        std::filesystem::path program = "/proc/self/exe";
        bool render = true;            ///< false: only what is in the cache is shown
        std::function<void()> wake{};  ///< any thread; a result has come
    };
    struct Request {
        std::filesystem::path preset, scene;
        double time = 0;  ///< s
        friend bool operator==(const Request&, const Request&) = default;
    };
    struct Result {
        std::filesystem::path preset;
        std::vector<std::uint8_t> rgba{};  ///< of `size`; empty: there is none
        std::string fault{};               ///< why, one line; empty where it was not to be rendered
    };

    explicit ThumbnailMaker(Options options);
    ~ThumbnailMaker();  ///< ends a child that runs
    ThumbnailMaker(const ThumbnailMaker&) = delete;
    ThumbnailMaker& operator=(const ThumbnailMaker&) = delete;

    /// All that is wanted from now on, in this order; what is asked for again goes on.
    void want(std::vector<Request> requests);
    std::vector<Result> take();
    bool busy() const;
    void finish();  ///< waits for all that is wanted

  private:
    void run();
    Result make(const Request& request);
    std::string render(const Request& request, const std::filesystem::path& file);
    bool unwanted(const Request& request);

    Options options_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Request> waiting_;
    Request now_;
    bool working_ = false, dropped_ = false, stopping_ = false;
    std::vector<Result> done_;
    std::thread thread_;
};

}  // namespace lapfx::app
