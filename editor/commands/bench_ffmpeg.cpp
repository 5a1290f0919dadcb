// What the ffmpeg program takes for the same clips, by the wall clock: a short run is taken off a long one, so that
// starting and opening files do not count.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>

#include "commands/bench_streaming.h"

extern char** environ;

namespace lapfx::commands {

namespace {

/// s that a run takes; nothing when it cannot be run or fails.
std::optional<double> run(const std::vector<std::string>& arguments) {
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    for (const int stream : {0, 1, 2}) posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_RDWR, 0);
    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const bool started = posix_spawnp(&child, pointers[0], &quiet, nullptr, pointers.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&quiet);
    int status = 1;
    if (!started || waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return std::nullopt;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::string> begin(const BenchClips& clips, int streams) {
    std::vector<std::string> all{"ffmpeg", "-nostdin", "-v", "error"};
    for (int i = 0; i < streams; ++i) all.insert(all.end(), {"-stream_loop", "-1", "-i", clips.path(i).string()});
    return all;
}

/// s a frame, from a run of `few` frames and one of `many`.
template <class Run>
std::optional<double> seconds_a_frame(int few, int many, const Run& run_frames) {
    const auto low = run_frames(few), high = run_frames(many);
    if (!low || !high || *high <= *low) return std::nullopt;
    return (*high - *low) / (many - few);
}

}  // namespace

std::optional<double> ffmpeg_overlay_ms(const BenchClips& clips, int streams, bool scaled) {
    const std::string key = "format=yuva420p,lumakey=threshold=0.06:tolerance=0.06:softness=0.8" +
                            std::string(scaled ? ",scale=1280:1024:flags=bilinear" : "");
    std::string filter = "color=c=0x602020:s=1280x1024:r=30[b0]";
    for (int i = 0; i < streams; ++i) {
        const std::string n = std::to_string(i);
        filter +=
            ";[" + n + ":v]" + key + "[k" + n + "];[b" + n + "][k" + n + "]overlay[b" + std::to_string(i + 1) + "]";
    }
    const auto seconds = seconds_a_frame(20, 80, [&](int frames) {
        std::vector<std::string> all = begin(clips, streams);
        all.insert(all.end(), {"-filter_complex", filter, "-map", "[b" + std::to_string(streams) + "]", "-frames:v",
                               std::to_string(frames), "-f", "null", "-"});
        return run(all);
    });
    return seconds ? std::optional(1e3 * *seconds) : std::nullopt;
}

std::optional<double> ffmpeg_decode_fps(const BenchClips& clips, int streams) {
    const auto seconds = seconds_a_frame(60, 300, [&](int frames) {
        std::vector<std::string> all = begin(clips, streams);
        for (int i = 0; i < streams; ++i) all.insert(all.end(), {"-map", std::to_string(i) + ":v"});
        all.insert(all.end(), {"-frames:v", std::to_string(frames), "-f", "null", "-"});
        return run(all);
    });
    return seconds ? std::optional(streams / *seconds) : std::nullopt;
}

}  // namespace lapfx::commands
