// Renders a scene as a picture, a numbered sequence or a video, one frame at a time. `lapfx render` and the editor's
// exports use it.
//
//     output::RenderJob job(scene, preset, {.size = {1280, 1024}, .fps = 25, .output = "out.mp4"});
//     while (!job.done()) job.step();
//
// It has a preview of its own, which is exact and uses the scene's camera. All files appear under their names in the
// last step, after they have been read back. If the job is destroyed before, nothing is left. Render thread, context
// current.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lapfx/authoring/preview.h"
#include "lapfx/clip_cache.h"
#include "lapfx/prepared_organ.h"
#include "output/codecs.h"
#include "output/frame_files.h"
#include "output/frame_page.h"
#include "output/kinds.h"
#include "output/layer_files.h"

namespace lapfx::output {

struct RenderOptions {
    glm::ivec2 size{1280, 1024};    ///< px
    double fps = 25;                ///< frame rate of a sequence or video
    std::optional<double> at = {};  ///< s: the time of one picture; none: frames from `from` to `to`
    double from = 0;                ///< s: time of the first frame
    std::optional<double> to = {};  ///< s: the end, at which there is no frame any more; none: the scene's end
    Overlay overlay = Overlay::none;
    std::filesystem::path output{};   ///< kind_named() says what; empty: nothing is written (RenderJob::image)
    Codec codec = Codec::h264;        ///< of a video
    Quality quality = Quality::good;  ///< of a video whose codec is not lossless
    std::filesystem::path amounts{};  ///< CSV of the amounts that score a trainee, a line for each frame; empty: none
    /// Folder of what is in each frame, exactly (Preview::layers): amounts.csv as `lapfx measure` writes it, and
    /// pictures of each layer; made unless it is there. Empty: none.
    std::filesystem::path layers{};
    std::vector<std::filesystem::path> clip_folders{};
};

/// Why a frame cannot have this size, pixels; empty: it can. A frame keeps 60 bytes of a pixel in memory.
std::string size_fault(glm::ivec2 size);
/// What is wrong with the options for a scene that is `duration` s long. Places are the options of `lapfx render`:
/// "--size", "-o".
std::vector<Fault> check(const RenderOptions& options, double duration);
/// Times of the frames, s. The options must be without a fault.
std::vector<double> frame_times(const RenderOptions& options, double duration);

/// Parts of a scene that are loaded already. The job loads those that are null.
struct Loaded {
    std::shared_ptr<const PreparedOrgan> organ;
    std::shared_ptr<ClipCache> clips;
};

class RenderJob {
  public:
    /// Loads the scene. Throws Error for what check() finds (bad_input), for files that cannot be loaded, and when the
    /// output cannot be written (runtime). `page`: what is written of each frame of `options.size`; null: the frame.
    RenderJob(const Scene& scene, const Preset& preset, RenderOptions options, const Loaded& loaded = {},
              std::unique_ptr<FramePage> page = nullptr);
    ~RenderJob();
    RenderJob(const RenderJob&) = delete;
    RenderJob& operator=(const RenderJob&) = delete;

    /// Draws and writes one frame, reads one back, or gives all files their names. Throws Error; the job has then ended
    /// and leaves nothing.
    void step();
    bool done() const { return done_; }
    int frames() const { return static_cast<int>(times_.size()); }
    int drawn() const { return static_cast<int>(drawn_); }
    /// The share of all steps that is done, 0..1.
    double progress() const;
    /// s that drawing the frames, and making and writing their files, have taken so far by this computer's clock.
    double drawing_seconds() const { return drawing_seconds_; }
    double writing_seconds() const { return writing_seconds_; }
    /// The newest frame, without its page.
    const Image& image() const { return image_; }
    const RenderOptions& options() const { return options_; }
    const Preview& preview() const { return *preview_; }

  private:
    void draw();
    void publish();

    RenderOptions options_;
    std::vector<double> times_;
    std::unique_ptr<Preview> preview_;
    std::unique_ptr<FramePage> page_;
    std::unique_ptr<FrameFiles> files_;
    std::unique_ptr<LayerFiles> layers_;
    std::string amounts_;
    Image image_;
    std::size_t drawn_ = 0, checked_ = 0;
    double drawing_seconds_ = 0, writing_seconds_ = 0;
    bool done_ = false;
};

}  // namespace lapfx::output
