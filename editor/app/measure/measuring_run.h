// The measuring of one video on a thread of its own, which can rest at any frame and go on from there as if nothing had
// happened: whatever it has open and knows stays.
//
//     MeasuringRun run("operation.mp4", options, jobs);
//     run.go_on(jobs.open("Measuring operation.mp4", {}));   // job->cancel() lets it rest
//     each frame:  run.take(frames, counted);                      // those that have been measured since
//     if (run.ended()) show(run.found(), run.faults());
//
// UI thread; the thread closes the jobs that it was given.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/measure/counted_frames.h"
#include "lapfx/error.h"
#include "match/use/measure_video.h"

namespace lapfx::app {

class Job;
class Jobs;

class MeasuringRun {
  public:
    /// It rests at first. `jobs` must outlive it. `options.measured` is the run's own.
    MeasuringRun(std::filesystem::path file, match::MeasureOptions options, Jobs& jobs);
    ~MeasuringRun();  ///< waits for the frame that is being measured
    MeasuringRun(const MeasuringRun&) = delete;
    MeasuringRun& operator=(const MeasuringRun&) = delete;

    /// From the next frame on. The job before this one has been cancelled, or there was none.
    void go_on(std::shared_ptr<Job> job);
    double progress() const;  ///< 0..1, also while it rests
    /// Adds the frames that were measured since the last call, what is known of each alone, and what was counted in
    /// them.
    void take(std::vector<match::FrameAmounts>& frames, CountedFrames& counted);
    /// Nothing more comes.
    bool ended() const;
    /// Once it has ended; null: faults() say why.
    std::shared_ptr<const match::Measurement> found() const;
    std::vector<Fault> faults() const;
    /// Once there is found(): the video's colours.
    std::shared_ptr<const match::ColorsOverTime> colors() const;

  private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

}  // namespace lapfx::app
