#include "app/files/export_trial.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double most_pixels = 350'000;  // a frame that is tried has no more
constexpr int tried_frames = 4;

double pixels_of(glm::ivec2 size) {
    return static_cast<double>(size.x) * size.y;
}

/// Even, as a video needs it.
glm::ivec2 small_size(glm::ivec2 size) {
    const double factor = std::sqrt(most_pixels / pixels_of(size));
    if (factor >= 1) return size;
    constexpr int least = 8;
    return 2 * glm::max(glm::ivec2(glm::dvec2(size) * factor / 2.0), glm::ivec2(least));
}

}  // namespace

ExportTrial::ExportTrial(const Scene& scene, const Preset& preset, const output::RenderOptions& options,
                         const output::Loaded& loaded)
    : folder_(std::make_unique<Beside>(fs::temp_directory_path() / "lapfx_trial", Beside::Kind::folder)) {
    output::RenderOptions tried = options;
    tried.size = small_size(options.size);
    ratio_ = pixels_of(options.size) / pixels_of(tried.size);
    const double end = options.from + (tried_frames - 0.5) / options.fps;
    tried.to = std::min(options.to.value_or(scene.duration), end);
    tried.output = folder_->path() / options.output.filename();
    tried.amounts.clear(), tried.layers.clear();
    job_ = std::make_unique<output::RenderJob>(scene, preset, std::move(tried), loaded);
}

ExportTrial::~ExportTrial() = default;

void ExportTrial::step() {
    if (done()) return;
    job_->step();
    const double draw = job_->drawing_seconds(), write = job_->writing_seconds();
    if (job_->drawn() == 1) {
        first_ = draw + write;
        draw_ = draw, write_ = write;
    }
    if (job_->drawn() < job_->frames()) return;
    if (const int others = job_->frames() - 1; others > 0) {
        draw_ = (draw - draw_) / others;
        write_ = (write - write_) / others;
    }
    job_.reset();
    folder_.reset();
}

double ExportTrial::seconds(int frames, double page) const {
    const double each = ratio_ * (draw_ + page * write_);
    return std::max(first_ - draw_ - write_, 0.0) + frames * each;
}

}  // namespace lapfx::app
