#include "app/measure/fit_reporting.h"

#include <utility>

#include "app/base/editor_options.h"
#include "app/base/jobs.h"
#include "app/base/not_opened.h"
#include "app/base/notices.h"
#include "app/base/screen.h"
#include "app/measure/drawn_curve.h"
#include "app/preview/preview_host.h"
#include "app/preview/scene_pace.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/video.h"
#include "match/report/report.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

match::ReportOf names_of(const FitFound& found) {
    return {.scene = found.of.scene,
            .reference = found.of.reference.filename().string(),
            .preset = found.of.preset,
            .seconds = found.seconds,
            .notes = found.of.notes};
}

}  // namespace

/// One report, on a thread of its own.
class FitReporting::Run {
  public:
    /// `beside`: else all of it is done here, at once. `tell`: UI thread, once it is written.
    Run(const FitFound& found, fs::path path, match::PreviewCurve& curve, RenderSteps& steps, Jobs& jobs,
        Notices& notices, std::function<void()> tell, bool beside)
        : of_(found.of),
          report_{.of = names_of(found), .found = found},
          path_(std::move(path)),
          curve_(curve),
          steps_(steps),
          job_(jobs.open("Writing " + path_.filename().string(),
                         [&notices](const std::vector<Fault>& faults) { notices.tell(faults); })) {
        job_->set_progress(0);
        const auto ended = [this, &jobs, tell = std::move(tell)] {
            jobs.close(job_, work_.result() ? tell : Jobs::Apply{}, work_.faults(path_.filename().string()));
        };
        work_.start([this](Job& job) { return write(job); }, {.ended = ended, .given_up = [&steps] { steps.stop(); }},
                    beside, job_);
    }

    const Job& job() const { return *job_; }
    bool ended() const { return work_.ended(); }
    void cancel() {
        if (ended()) return;
        work_.cancel();
        steps_.stop();
    }

  private:
    struct Written {};
    std::optional<Written> write(Job& job) {
        require_not_opened(path_);
        // A reader of its own: it looks at the moments of the report, beside the window, which shows another frame.
        VideoReader video(of_.reference, &job.stop());
        const auto goes_on = [&job](double share) {
            job.set_progress(share);
            return !job.cancelled();
        };
        if (!match::add_pictures(report_, video, of_.aspect, curve_, goes_on, &job.stop()) || !goes_on(1.0))
            return std::nullopt;
        write_file(path_, match::report_html(report_));
        return Written{};
    }

    const FitOf of_;
    match::FitReport report_;
    const fs::path path_;
    match::PreviewCurve& curve_;
    RenderSteps& steps_;
    const std::shared_ptr<Job> job_;
    ThreadWork<Written> work_;  // last: it uses all of the others
};

FitReporting::FitReporting(const Parts& parts) : parts_(parts) {}
FitReporting::~FitReporting() = default;

double FitReporting::progress() const {
    return run_ ? run_->job().progress() : 0.0;
}

void FitReporting::cancel() {
    if (run_) run_->cancel();
}

void FitReporting::write(const FitFound& found, const fs::path& path) {
    if (!found.result) return;
    run_.reset();
    steps_ = std::make_unique<RenderSteps>([this] { parts_.jobs.wake(); });
    curve_ = drawn_curve(found.fit.organ, parts_.preview, parts_.options.clip_folders,
                         parts_.options.exact ? nullptr : &steps_);
    run_ = std::make_unique<Run>(
        found, path, *curve_, *steps_, parts_.jobs, parts_.notices, [this, path] { tell(path); },
        !parts_.options.exact);
}

void FitReporting::tell(const fs::path& path) {
    std::error_code error;
    parts_.notices.add({.kind = ui::ToastKind::good,
                        .text = "Exported " + path.filename().string(),
                        .action = "Copy path",
                        .act = [this, file = fs::absolute(path, error).string()] {
                            if (ui::Clipboard* clipboard = parts_.screen.clipboard()) clipboard->set(file);
                        }});
}

void FitReporting::update(double now) {
    due_ = never;
    if (!run_) return;
    if (run_->job().cancelled()) run_->cancel();  // by whoever lists jobs
    if (parts_.options.software && !parts_.options.exact && parts_.pace.touched(now))
        due_ = now + look_again;
    else
        steps_->serve(frame_budget);
    if (!run_->ended()) return;
    run_.reset();
    curve_.reset();
    steps_.reset();
}

}  // namespace lapfx::app
