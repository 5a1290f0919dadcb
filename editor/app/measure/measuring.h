// How much blood and smoke the reference shows over its whole length: measured beside the UI while somebody looks, as
// the scene's `reference.measure` says, and kept with what it was measured of. What is stopped, or is of an earlier
// state of the scene, goes on from where it was when it is wanted again.
//
//     measuring.want();                               // in each build that shows it: it begins by itself
//     each frame:  measuring.update(now);
//     plot(measuring.frames());                       // those that have been measured so far
//     if (const match::Measurement* found = measuring.found()) tell(found->blood);
//
// UI thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/settling.h"
#include "app/measure/counted_frames.h"
#include "app/measure/measured_videos.h"
#include "document/document.h"
#include "lapfx/error.h"
#include "match/video/measure.h"
#include "match/video/peak_colors.h"

namespace lapfx::app {

class Job;
class Jobs;
class MeasuringRun;
class Notices;
class Reference;

/// What can be written of a measurement.
enum class MeasureFile : std::uint8_t { csv, json, png };

class Measuring {
  public:
    static constexpr std::size_t kept = 4;  ///< measurements, of as many states of the scene

    /// `known`: null, or what others have measured too. `by_itself`: it begins when want() is called. All references
    /// must outlive it.
    Measuring(document::Document& document, const Reference& reference, std::shared_ptr<MeasuredVideos> known,
              Jobs& jobs, Notices& notices, bool by_itself);
    ~Measuring();
    Measuring(const Measuring&) = delete;
    Measuring& operator=(const Measuring&) = delete;

    /// They are looked at in this frame.
    void want() { wanted_ = true; }
    /// Once before each frame. `now`: s, the clock of the UI.
    void update(double now);
    /// A panel that shows them wants another frame then: the measuring is to begin, or its curve has grown. Infinity:
    /// none.
    double due() const { return due_; }
    /// Another document has been opened: its reference has not been measured.
    void forget();

    // --- measuring ---------------------------------------------------------------------------------------------------
    /// Measures the scene's reference as it is now, from where that was stopped; once it is complete, anew. What is
    /// known from an earlier document is taken, with the next update(). Nothing without a reference that can be shown.
    void start();
    /// It rests, and does not begin by itself again until something else is to be measured.
    void cancel();
    const std::shared_ptr<Job>& running() const { return running_; }  ///< null: nothing is measured now
    bool cancelled() const { return stopped_ && is_now(*stopped_); }  ///< what is to be measured now, or it failed
    bool begun() const;                                               ///< and not complete: start() goes on
    double progress() const;                                          ///< 0..1, while begun()
    const std::vector<Fault>& faults() const { return faults_; }      ///< of the last start()

    // --- found -------------------------------------------------------------------------------------------------------
    /// The last that is complete; null: there is none yet.
    const match::Measurement* found() const { return found_ ? found_->found.get() : nullptr; }
    const match::ColorsOverTime* colors() const { return found_ ? found_->colors.get() : nullptr; }
    const std::filesystem::path& file() const { return of_.file; }  ///< the video that found() is of
    /// found() is of another reference, or of other values of `reference.measure`.
    bool stale() const;
    /// While begun(), what has been measured so far of the reference as it is now; else those of found(). Ascending
    /// times.
    std::span<const match::FrameAmounts> frames() const;
    /// Grows with every change of frames().
    std::uint64_t version() const { return version_; }
    /// Another number for each measurement that frames() are of.
    std::uint64_t serial() const;
    /// What was counted in the frame of this time, s of the reference as it is now, as far as that has been measured:
    /// the same number as long as the same would be drawn, 0 where there is nothing. It is drawn over `picture`, that
    /// frame, unless that is null.
    std::uint64_t counted(double time, Image* picture = nullptr) const;
    std::size_t memory() const;  ///< bytes of what was counted
    /// Writes found(); a notice says so, or why not.
    void write(MeasureFile kind, const std::filesystem::path& path);

    // --- the baseline: undo steps ------------------------------------------------------------------------------------
    void use_frame();  ///< frame() of the reference, also while it is still being decoded
    void suggest();    ///< a clear frame is looked for (find_shots), now and in each measurement

  private:
    /// What is measured.
    struct Subject {
        std::filesystem::path file;
        std::weak_ptr<const VideoReader> opened;
        std::optional<std::filesystem::file_time_type> written;  ///< nothing: several files, or none
        ReferenceMeasure measure;
    };
    /// The measuring of one subject.
    struct Measured {
        std::uint64_t serial = 0;
        Subject of;
        std::unique_ptr<MeasuringRun> run;        ///< null: it came to its end
        std::vector<match::FrameAmounts> frames;  ///< while there is a run
        CountedFrames counted;                    ///< while there is a run
        std::shared_ptr<const MeasuredVideo> found;
    };
    Subject subject() const;
    bool is_now(const Subject& of) const;
    Measured* of_now() const;
    Measured& begin();
    std::shared_ptr<const MeasuredVideo> known(const Subject& of) const;
    void follow(double now);
    void rest();
    void take(Measured& measured);
    void end(Measured& measured);

    document::Document& document_;
    const Reference& reference_;
    const std::shared_ptr<MeasuredVideos> known_;
    Jobs& jobs_;
    Notices& notices_;
    bool by_itself_;
    bool wanted_ = false;
    std::weak_ptr<const VideoReader> dated_;  ///< the reference that written_ is of
    std::optional<std::filesystem::file_time_type> written_;
    std::optional<Subject> followed_, stopped_;  ///< the last that was seen; the one that is not to begin by itself
    Settling settling_{0.6};
    double due_ = Settling::never;
    std::vector<std::unique_ptr<Measured>> all_;  ///< the one that was wanted last at the end
    std::shared_ptr<Job> running_;
    std::vector<Fault> faults_;
    std::shared_ptr<const MeasuredVideo> found_;
    Subject of_;                                    ///< what found_ is of
    std::uint64_t found_serial_ = 0, serials_ = 0;  ///< the number of found_, and how many measurements there were
    std::uint64_t version_ = 0;
};

/// The table has the rows of `reference.measure` of the scene.
const Table& measure_table();

}  // namespace lapfx::app
