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
          before_(found.start),
          report_(match::report_of(found, names_of(found))),
          path_(std::move(path)),
          curve_(curve),
          steps_(steps),
          jobs_(jobs),
          tell_(std::move(tell)),
          job_(jobs.open("Writing " + path_.filename().string(),
                         [&notices](const std::vector<Fault>& faults) { notices.tell(faults); })) {
        job_->set_progress(0);
        if (beside)
            thread_ = std::thread([this] { work(); });
        else
            work();
    }
    ~Run() {
        cancel();
        if (thread_.joinable()) thread_.join();
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    const Job& job() const { return *job_; }
    bool ended() const { return ended_; }
    void cancel() {
        if (ended_) return;
        job_->cancel();
        steps_.stop();
    }

  private:
    void work() {
        std::vector<Fault> faults;
        Jobs::Apply apply;
        try {
            if (write()) apply = tell_;
        } catch (const Error& error) {
            faults = error.faults();
        } catch (const std::exception& error) {
            faults = {{.file = path_.filename().string(), .place = "", .reason = error.what()}};
        }
        ended_ = true;
        jobs_.close(job_, std::move(apply), std::move(faults));
    }
    bool write() {
        require_not_opened(path_);
        VideoReader video(of_.reference, &job_->stop());
        const auto goes_on = [this](double share) {
            job_->set_progress(share);
            return !job_->cancelled();
        };
        if (!match::add_pictures(report_, video, of_.aspect, before_, curve_, goes_on, &job_->stop()) || !goes_on(1.0))
            return false;
        write_file(path_, match::report_html(report_));
        return true;
    }

    const FitOf of_;
    const document::Content before_;
    match::FitReport report_;
    const fs::path path_;
    match::PreviewCurve& curve_;
    RenderSteps& steps_;
    Jobs& jobs_;
    const std::function<void()> tell_;
    const std::shared_ptr<Job> job_;
    std::atomic<bool> ended_ = false;
    std::thread thread_;
};

FitReporting::FitReporting(const Parts& parts)
    : host_(parts.preview),
      pace_(parts.pace),
      jobs_(parts.jobs),
      notices_(parts.notices),
      screen_(parts.screen),
      clip_folders_(parts.options.clip_folders),
      exact_(parts.options.exact),
      software_(parts.options.software) {}
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
    steps_ = std::make_unique<RenderSteps>([this] { jobs_.wake(); });
    curve_ = drawn_curve(found.organ, host_, clip_folders_, exact_ ? nullptr : &steps_);
    run_ = std::make_unique<Run>(
        found, path, *curve_, *steps_, jobs_, notices_, [this, path] { tell(path); }, !exact_);
}

void FitReporting::tell(const fs::path& path) {
    std::error_code error;
    notices_.add({.kind = ui::ToastKind::good,
                  .text = "Exported " + path.filename().string(),
                  .action = "Copy path",
                  .act = [this, file = fs::absolute(path, error).string()] {
                      if (ui::Clipboard* clipboard = screen_.clipboard()) clipboard->set(file);
                  }});
}

void FitReporting::update(double now) {
    due_ = never;
    if (!run_) return;
    if (run_->job().cancelled()) run_->cancel();  // by whoever lists jobs
    if (software_ && !exact_ && pace_.touched(now))
        due_ = now + look_again;
    else
        steps_->serve(frame_budget);
    if (!run_->ended()) return;
    run_.reset();
    curve_.reset();
    steps_.reset();
}

}  // namespace lapfx::app
