// The time of the ffmpeg program for the same clips, by the wall clock: a short run is subtracted from a long one, so
// that starting and opening files do not count.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>

#include "bench/streaming/streaming.h"

extern char** environ;

namespace lapfx::bench {

namespace {

/// Time of a run, s; nothing when it cannot be run or fails.
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

/// s a frame, from a run of `few` frames and one of `many`.
template <class Run>
std::optional<double> seconds_a_frame(int few, int many, const Run& run_frames) {
    const auto low = run_frames(few), high = run_frames(many);
    if (!low || !high || *high <= *low) return std::nullopt;
    return (*high - *low) / (many - few);
}

/// Clips become [k0], [k1], ...: keyed.
std::string keyed(int streams, int frames, FfmpegInput input, const std::string& then) {
    std::string filter;
    for (int i = 0; i < streams; ++i) {
        const std::string n = std::to_string(i);
        filter += "[" + n + ":v]";
        if (input == FfmpegInput::from_memory) filter += "loop=loop=-1:size=" + std::to_string(frames) + ",";
        filter += "format=yuva420p,lumakey=threshold=0.06:tolerance=0.06:softness=0.8" + then + "[k" + n + "];";
    }
    return filter;
}

/// `on` [from] over it [k0] and so on, up to [out].
std::string laid_over(const std::string& on, int from, int streams) {
    std::string filter, below = on;
    for (int i = from; i < streams; ++i) {
        const std::string above = i + 1 == streams ? "out" : "b" + std::to_string(i);
        filter += "[" + below + "][k" + std::to_string(i) + "]overlay[" + above + "]" + (i + 1 == streams ? "" : ";");
        below = above;
    }
    return filter;
}

std::string graph_of(FfmpegGraph graph, int streams, int frames, FfmpegInput input) {
    const std::string scaling = "scale=1280:1024:flags=bilinear", frame = "color=c=0x602020:s=1280x1024:r=30[frame];";
    if (graph != FfmpegGraph::scaled_once)
        return frame + keyed(streams, frames, input, graph == FfmpegGraph::each_scaled ? "," + scaling : "") +
               laid_over("frame", 0, streams);
    // Over the first clip, which is transparent where it is keyed out, as overlay leaves it.
    if (streams == 1) return frame + keyed(1, frames, input, "," + scaling) + laid_over("frame", 0, 1);
    std::string smoke = laid_over("k0", 1, streams);
    smoke.replace(smoke.rfind("[out]"), 5, "[smoke]");
    return frame + keyed(streams, frames, input, "") + smoke + ";[smoke]" + scaling +
           "[scaled];[frame][scaled]overlay[out]";
}

}  // namespace

std::optional<double> ffmpeg_overlay_ms(const BenchClips& clips, int streams, FfmpegGraph graph, FfmpegInput input) {
    const std::string filter = graph_of(graph, streams, clips.frames(), input);
    // When playing from memory, both runs decode the first loop, so their difference does not include it.
    const int first = input == FfmpegInput::from_memory ? clips.frames() : 0;
    const auto seconds = seconds_a_frame(first + 20, first + 80, [&](int frames) {
        std::vector<std::string> all{"ffmpeg", "-nostdin", "-v", "error"};
        for (int i = 0; i < streams; ++i) {
            if (input == FfmpegInput::decoded) all.insert(all.end(), {"-stream_loop", "-1"});
            all.insert(all.end(), {"-i", clips.path(i).string()});
        }
        all.insert(all.end(), {"-filter_complex", filter, "-map", "[out]", "-frames:v", std::to_string(frames), "-f",
                               "null", "-"});
        return run(all);
    });
    return seconds ? std::optional(1e3 * *seconds) : std::nullopt;
}

std::optional<double> ffmpeg_decode_fps(const BenchClips& clips, int streams) {
    const auto seconds = seconds_a_frame(60, 300, [&](int frames) {
        std::vector<std::string> all{"ffmpeg", "-nostdin", "-v", "error"};
        for (int i = 0; i < streams; ++i) all.insert(all.end(), {"-stream_loop", "-1", "-i", clips.path(i).string()});
        for (int i = 0; i < streams; ++i) all.insert(all.end(), {"-map", std::to_string(i) + ":v"});
        all.insert(all.end(), {"-frames:v", std::to_string(frames), "-f", "null", "-"});
        return run(all);
    });
    return seconds ? std::optional(streams / *seconds) : std::nullopt;
}

}  // namespace lapfx::bench
