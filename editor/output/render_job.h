// A scene as a picture, a numbered sequence or a video, a frame at a time: what `lapfx render` and the editor's exports
// run.
//
//     output::RenderJob job(scene, preset, {.size = {1280, 1024}, .fps = 25, .output = "out.mp4"});
//     while (!job.done()) job.step();
//
// It has a preview of its own, exact and seen through the scene's camera. Everything appears under its name in the last
// step, when it has been read back; dropped before, nothing is left. Render thread, context current.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lapfx/authoring/preview.h"
#include "lapfx/clip_cache.h"
#include "lapfx/prepared_organ.h"
#include "output/frame_files.h"
#include "output/kinds.h"

namespace lapfx::output {

struct RenderOptions {
    glm::ivec2 size{1280, 1024};    ///< px
    double fps = 25;                ///< of a sequence or video
    std::optional<double> at = {};  ///< s: one picture. Else frames `from` ..
    double from = 0;                ///< s: the first frame
    std::optional<double> to = {};  ///< s: the end, without a frame of its own; the scene's if not given
    Overlay overlay = Overlay::none;
    std::filesystem::path output{};   ///< kind_named() says what; empty: nothing is written (RenderJob::image)
    std::filesystem::path amounts{};  ///< CSV of what a trainee would be scored by, a line for each frame; empty: none
    std::vector<std::filesystem::path> clip_folders{};
};

/// What is wrong with them, of a scene that is `duration` s long. Places are the options of `lapfx render`: "--size",
/// "-o".
std::vector<Fault> check(const RenderOptions& options, double duration);
/// Times of the frames, s. Of options without a fault.
std::vector<double> frame_times(const RenderOptions& options, double duration);

/// What there is already of a scene and its clips; null: it is loaded.
struct Loaded {
    std::shared_ptr<const PreparedOrgan> organ;
    std::shared_ptr<ClipCache> clips;
};

class RenderJob {
  public:
    /// Loads the scene. Throws Error: what check() finds (bad_input), what cannot be loaded, where it cannot be written
    /// (runtime).
    RenderJob(const Scene& scene, const Preset& preset, RenderOptions options, const Loaded& loaded = {});
    ~RenderJob();
    RenderJob(const RenderJob&) = delete;
    RenderJob& operator=(const RenderJob&) = delete;

    /// Draws and writes one frame, reads one back, or gives all of them their names. Throws Error; then it is over, and
    /// nothing is left.
    void step();
    bool done() const { return done_; }
    int frames() const { return static_cast<int>(times_.size()); }
    int drawn() const { return static_cast<int>(drawn_); }
    /// 0..1 of all steps.
    double progress() const;
    /// The newest frame.
    const Image& image() const { return image_; }
    const RenderOptions& options() const { return options_; }
    const Preview& preview() const { return *preview_; }

  private:
    void draw();
    void publish();

    RenderOptions options_;
    std::vector<double> times_;
    std::unique_ptr<Preview> preview_;
    std::unique_ptr<FrameFiles> files_;
    std::string amounts_;
    Image image_;
    std::size_t drawn_ = 0, checked_ = 0;
    bool done_ = false;
};

}  // namespace lapfx::output
