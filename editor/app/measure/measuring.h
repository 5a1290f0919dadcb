// How much blood and smoke the reference shows over its whole length: measured in a job, as the scene's
// `reference.measure` says, and kept with what it was measured of.
//
//     measuring.start();
//     each frame:  measuring.update();
//     if (const match::Measurement* found = measuring.found()) plot(found->frames);
//
// UI thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "lapfx/error.h"
#include "match/measure.h"

namespace lapfx::app {

class Job;
class Jobs;
class Notices;
class Reference;

/// What the scene says, as the library takes it.
match::MeasureOptions measure_options(const ReferenceMeasure& measure);

/// What can be written of a measurement.
enum class MeasureFile : std::uint8_t { csv, json, png };

class Measuring {
  public:
    /// All must outlive it.
    Measuring(document::Document& document, const Reference& reference, Jobs& jobs, Notices& notices);

    /// Once before each frame.
    void update();
    /// Another document has been opened: its reference has not been measured.
    void forget();

    // --- measuring ---------------------------------------------------------------------------------------------------
    /// Measures the scene's reference as it is now; one that is under way is cancelled. Nothing without a reference
    /// that can be shown.
    void start();
    void cancel();
    const std::shared_ptr<Job>& running() const { return running_; }  ///< null: nothing is measured now
    const std::vector<Fault>& faults() const { return faults_; }      ///< of the last start()

    // --- found -------------------------------------------------------------------------------------------------------
    const match::Measurement* found() const { return found_.get(); }  ///< null: nothing was measured yet
    std::uint64_t version() const { return version_; }                ///< grows with every other found()
    const std::filesystem::path& file() const { return of_.file; }    ///< the video that found() is of
    /// found() is of another reference, or of other values of `reference.measure`.
    bool stale() const;
    /// Writes found(); a notice says so, or why not.
    void write(MeasureFile kind, const std::filesystem::path& path);

    // --- the baseline: undo steps ------------------------------------------------------------------------------------
    void use_frame();  ///< frame() of the reference, also while it is still being decoded
    void suggest();    ///< the clearest frame is looked for, now and in each measurement

  private:
    /// What is measured.
    struct Subject {
        std::filesystem::path file;
        std::weak_ptr<const VideoReader> opened;
        ReferenceMeasure measure;
    };
    Subject subject() const;

    document::Document& document_;
    const Reference& reference_;
    Jobs& jobs_;
    Notices& notices_;
    std::shared_ptr<Job> running_;
    std::vector<Fault> faults_;
    std::unique_ptr<const match::Measurement> found_;
    std::uint64_t version_ = 0;
    Subject of_;
};

/// Of the scene: the rows of `reference.measure`.
const Table& measure_table();

}  // namespace lapfx::app
