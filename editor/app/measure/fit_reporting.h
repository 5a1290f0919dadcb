// Writes the report of what a fit has found, as lapfx fit --report does: a thread beside the UI reads the reference and
// asks the render thread for each picture of the scene.
//
//     reporting.write(*fitting.found(), "operation_fit.html");
//     each frame:  reporting.update(now);
//
// UI thread, context current.
#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "app/measure/fitting_run.h"
#include "lapfx/error.h"

namespace lapfx::app {

class Notices;
class PreviewHost;
class ScenePace;
class Screen;
struct EditorOptions;

class FitReporting {
  public:
    /// All must outlive it.
    struct Parts {
        const PreviewHost& preview;
        const ScenePace& pace;
        Jobs& jobs;
        Notices& notices;
        Screen& screen;  ///< its clipboard takes the path
        const EditorOptions& options;
    };
    explicit FitReporting(const Parts& parts);
    ~FitReporting();
    FitReporting(const FitReporting&) = delete;
    FitReporting& operator=(const FitReporting&) = delete;

    /// `found`: with a result. A notice says that it is written, or why not. One that is being written is given up.
    void write(const FitFound& found, const std::filesystem::path& path);
    /// Once before each frame. `now`: s, the clock of the UI.
    void update(double now);
    /// s: when update() wants to be called next; infinity: whenever.
    double due() const { return due_; }

    bool busy() const { return run_ != nullptr; }
    double progress() const;  ///< 0..1
    void cancel();            ///< nothing is written

  private:
    class Run;
    void tell(const std::filesystem::path& path);

    const Parts parts_;
    double due_ = std::numeric_limits<double>::infinity();
    std::unique_ptr<RenderSteps> steps_;
    std::unique_ptr<match::PreviewCurve> curve_;
    std::unique_ptr<Run> run_;
};

}  // namespace lapfx::app
