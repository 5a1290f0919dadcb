// lapfx bench streaming, in parts: the clips it plays, the cases it measures, the paper's figures, FFmpeg beside it,
// the plot.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "commands/bench.h"
#include "lapfx/streaming.h"

namespace lapfx::commands {

/// One line of the paper's table 2: means per frame over all streams, ms unless said otherwise.
struct StreamingRow {
    std::string scheme;
    int streams = 0;
    double open = 0.0;      ///< initialisation of the streams, once
    double retrieve = 0.0;  ///< decoding, summed over the threads that decode
    double copy = 0.0;      ///< copying decoded frames into buffers, on the same threads
    double wait = 0.0;      ///< the render thread waiting for frames; the paper has it in its frames per second alone
    double upload = 0.0;    ///< "video streaming to GPU"
    double shading = 0.0;   ///< from the last draw call until all is drawn
    double gpu = 0.0;       ///< shading by timer queries, ms; 0 where the driver has none
    double total = 0.0;     ///< "total video processing": waiting, sending and issuing draw calls
    double frame = 0.0;     ///< total and shading
    double spread = 0.0;    ///< of `frame`: half of the distance between the quartiles
    double fps = 0.0;       ///< frames per second if nothing else is drawn; the paper's screen had 60 at most
    double resident = 0.0;  ///< share of frames in GPU memory
    double sent = 0.0;      ///< frames sent to the GPU in each cycle, of all streams
    double sending = 0.0;   ///< waiting and sending, of the round in which they took least
};

/// Table 2 of the paper: its "video streaming to GPU" by buffering is half of that by pipeline, with one clip (1.55 and
/// 0.78 ms) as with 15 (32.4 and 16.2 ms); retrieving and shading take the same. Two frames in one cycle and none in
/// the next send as many as one in each: what halves it is what the text says last, "consecutive video frames are
/// skipped for performance enhancement". GeForce 9800 GX2, quad core at 2.83 GHz; DivX 720x480, screen 1280x1024.
std::span<const StreamingRow> paper_table_2();

constexpr int bench_clip_frames = 60;
constexpr double bench_clip_fps = 30.0;

/// Smoke clips like the paper's, MPEG-4 part 2 ("DivX"), 720x480, made for the bench and taken away with it.
class BenchClips {
  public:
    /// Throws Error (runtime) when they cannot be made.
    /// `frames`: of each. Beyond `distinct` they are copies: another file each, but the same pictures.
    explicit BenchClips(int count, int frames = bench_clip_frames, int distinct = 15);
    ~BenchClips();
    BenchClips(const BenchClips&) = delete;
    BenchClips& operator=(const BenchClips&) = delete;

    std::filesystem::path folder() const { return folder_; }
    int frames() const { return frames_; }
    std::string name(int index) const { return "clip" + std::to_string(index) + ".avi"; }
    std::filesystem::path path(int index) const { return folder_ / name(index); }

  private:
    int frames_;
    std::filesystem::path folder_;
};

/// How the ffmpeg program lays clips over a 1280x1024 frame, keyed by luma.
enum class FfmpegGraph {
    each_scaled,  ///< every clip is scaled to the frame and laid over it
    scaled_once,  ///< the clips are laid over each other as large as they are, and what comes of it is scaled: the
                  ///< cheapest
    unscaled,     ///< the clips as large as they are: they cover a quarter of the frame
};
/// Whether frames are decoded while it is measured, or played in a loop from main memory.
enum class FfmpegInput { decoded, from_memory };
/// ms that FFmpeg takes for such a frame with the first `streams` clips; nothing where there is no ffmpeg.
std::optional<double> ffmpeg_overlay_ms(const BenchClips& clips, int streams, FfmpegGraph graph, FfmpegInput input);
/// Frames per second of `ffmpeg -f null` over the first `streams` clips.
std::optional<double> ffmpeg_decode_fps(const BenchClips& clips, int streams);

/// The table as text, ours beside the paper's.
std::string streaming_table(std::span<const StreamingRow> rows);
/// The four panels of the paper's figure 10 as PNG. Throws Error (runtime) when it cannot be written.
void plot_streaming(std::span<const StreamingRow> rows, const std::filesystem::path& path);

}  // namespace lapfx::commands
