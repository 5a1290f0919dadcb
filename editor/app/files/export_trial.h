// How long an export will take, before it begins: a few of its frames are drawn and written, small, where nobody sees
// them.
//
//     ExportTrial trial(scene, preset, options, loaded);
//     each frame:  trial.step();                             // some milliseconds
//     if (trial.done()) tell(trial.seconds(250));
//
// UI thread, context current.
#pragma once

#include <memory>

#include "lapfx/authoring/file.h"
#include "output/render_job.h"

namespace lapfx::app {

class ExportTrial {
  public:
    /// `options`: of the export. Throws Error when files cannot be written where temporary ones lie.
    ExportTrial(const Scene& scene, const Preset& preset, const output::RenderOptions& options,
                const output::Loaded& loaded);
    ~ExportTrial();
    ExportTrial(const ExportTrial&) = delete;
    ExportTrial& operator=(const ExportTrial&) = delete;

    void step();
    bool done() const { return !job_; }
    /// s that so many frames take; once it is done. `page`: pixels of what is written of a frame, over the frame's.
    double seconds(int frames, double page) const;

  private:
    std::unique_ptr<Beside> folder_;
    std::unique_ptr<output::RenderJob> job_;
    double ratio_ = 1;             ///< pixels of a frame, over those of one that is tried
    double first_ = 0;             ///< s of the first frame, which also loads
    double draw_ = 0, write_ = 0;  ///< s of one of the others
};

}  // namespace lapfx::app
