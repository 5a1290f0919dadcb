// The parts of lapfx bench streaming: its clips, its cases, the paper's figures, FFmpeg for comparison, the plot.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/report.h"
#include "bench/scratch_folder.h"
#include "lapfx/streaming.h"

namespace lapfx::bench {

/// One line of the paper's table 2: means per frame over all streams, ms unless said otherwise.
struct StreamingRow {
    std::string scheme;
    int streams = 0;
    double open = 0.0;      ///< initialisation of the streams, once
    double retrieve = 0.0;  ///< decoding, summed over the threads that decode
    double copy = 0.0;      ///< copying decoded frames into buffers, on the same threads
    double wait = 0.0;     ///< the render thread waiting for frames; in the paper only its frames per second include it
    double upload = 0.0;   ///< "video streaming to GPU"
    double shading = 0.0;  ///< from the last draw call until all is drawn
    double gpu = 0.0;      ///< shading by timer queries, ms; 0 if the driver has none
    double total = 0.0;    ///< "total video processing": waiting, sending and issuing draw calls
    double frame = 0.0;    ///< total and shading
    double spread = 0.0;   ///< spread of `frame`: half of the distance between the quartiles
    double fps = 0.0;      ///< frames per second if nothing else is drawn; at most 60 on the paper's screen
    double resident = 0.0;  ///< share of frames in GPU memory
    double sent = 0.0;      ///< frames of all streams sent to the GPU in each cycle
    double sending = 0.0;   ///< waiting and sending in the round in which they took least
};

/// Table 2 of the paper: its "video streaming to GPU" by buffering is half of that by pipeline, with one clip (1.55 and
/// 0.78 ms) as with 15 (32.4 and 16.2 ms); retrieving and shading take the same. Two frames in one cycle and none in
/// the next are as many as one in each, so the half comes from the last words of the text: "consecutive video frames
/// are skipped for performance enhancement". GeForce 9800 GX2, quad core at 2.83 GHz; DivX 720x480, screen 1280x1024.
std::span<const StreamingRow> paper_table_2();

constexpr int bench_clip_frames = 60;
constexpr double bench_clip_fps = 30.0;

/// Smoke clips like the paper's, MPEG-4 part 2 ("DivX"), 720x480, made for the benchmark and removed after it.
class BenchClips {
  public:
    /// Throws Error (runtime) when they cannot be made. Each has `frames` frames. Beyond `distinct` they are copies:
    /// separate files with the same pictures.
    explicit BenchClips(int count, int frames = bench_clip_frames, int distinct = 15);

    std::filesystem::path folder() const { return folder_.path(); }
    int frames() const { return frames_; }
    std::string name(int index) const { return "clip" + std::to_string(index) + ".avi"; }
    std::filesystem::path path(int index) const { return folder() / name(index); }

  private:
    int frames_;
    ScratchFolder folder_;
};

/// How the ffmpeg program lays clips over a 1280x1024 frame, keyed by luma.
enum class FfmpegGraph {
    each_scaled,  ///< every clip is scaled to the frame and put over it
    scaled_once,  ///< the clips are put over each other at their own size, and the result is scaled: the cheapest way
    unscaled,     ///< the clips keep their size and cover a quarter of the frame
};
/// Whether frames are decoded while it is measured, or played in a loop from main memory.
enum class FfmpegInput { decoded, from_memory };
/// ms that FFmpeg takes for such a frame with the first `streams` clips; nothing without ffmpeg.
std::optional<double> ffmpeg_overlay_ms(const BenchClips& clips, int streams, FfmpegGraph graph, FfmpegInput input);
/// Frames per second of `ffmpeg -f null` over the first `streams` clips.
std::optional<double> ffmpeg_decode_fps(const BenchClips& clips, int streams);

/// The table as text, our figures next to the paper's.
std::string streaming_table(std::span<const StreamingRow> rows);
/// The four panels of the paper's figure 10 as PNG. Throws Error (runtime) when it cannot be written.
void plot_streaming(std::span<const StreamingRow> rows, const std::filesystem::path& path);

}  // namespace lapfx::bench
