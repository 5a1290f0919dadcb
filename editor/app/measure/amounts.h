// The core's own amounts over the scene's time, worked out beside the UI whenever what they depend on has settled, and
// only while somebody looks at them.
//
//     amounts.want();                                     // in each build that shows them
//     if (const AmountSeries* scene = amounts.scene()) plot(scene->times, scene->of(&Amounts::haze));
//
// UI thread.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <memory>
#include <vector>

#include "app/base/settling.h"
#include "document/document.h"
#include "lapfx/amounts.h"
#include "lapfx/error.h"

namespace lapfx::app {

class Job;
class Jobs;
class PreviewHost;

/// An amount that has a plot of its own.
struct PlottedAmount {
    AmountMember member;
    int decimals = 0;  ///< of the value beside the plot: more would say nothing

    constexpr const AmountRow& row() const {
        return *std::find_if(std::begin(amount_rows), std::end(amount_rows),
                             [this](const AmountRow& row) { return row.member == member; });
    }
};
/// In the order of the plots.
inline constexpr std::array plotted_amounts = {PlottedAmount{&Amounts::blood_area},
                                               PlottedAmount{&Amounts::blood_volume}, PlottedAmount{&Amounts::haze, 2},
                                               PlottedAmount{&Amounts::bleeding_wounds}};
static_assert(std::all_of(plotted_amounts.begin(), plotted_amounts.end(),
                          [](const PlottedAmount& plotted) {
                              return std::any_of(std::begin(amount_rows), std::end(amount_rows),
                                                 [&](const AmountRow& row) { return row.member == plotted.member; });
                          }),
              "each has a row in the table of amounts");

/// The plotted amounts over a scene's time.
struct AmountSeries {
    std::vector<double> times;  ///< s, ascending
    std::array<std::vector<double>, plotted_amounts.size()> values;

    /// `member`: of an amount that has a plot.
    const std::vector<double>& of(AmountMember member) const {
        const auto row = std::find_if(plotted_amounts.begin(), plotted_amounts.end(),
                                      [&](const PlottedAmount& plotted) { return plotted.member == member; });
        assert(row != plotted_amounts.end());
        return values[static_cast<std::size_t>(row - plotted_amounts.begin())];
    }
    void add(double time, const Amounts& amounts);
};

/// Which amounts are looked at; no part of the document.
struct AmountsLook {
    enum Of : int { in_view, on_organ };
    int of = in_view;
};

class AmountsOverTime {
  public:
    /// `exact`: nothing waits for changes to settle. All must outlive it.
    AmountsOverTime(const document::Document& document, const PreviewHost& preview, Jobs& jobs, bool exact);
    ~AmountsOverTime();
    AmountsOverTime(const AmountsOverTime&) = delete;
    AmountsOverTime& operator=(const AmountsOverTime&) = delete;

    AmountsLook look;

    /// They are looked at in this frame.
    void want() { wanted_ = true; }
    /// Once a frame, by the editor. `now`: s, the clock of the UI.
    void update(double now);
    /// When update() wants to be called next, s; infinity: whenever.
    double due() const { return due_; }

    /// Null while nothing is known yet; while stale(), those of an older state of the document.
    const AmountSeries* scene() const { return scene_ ? scene_.get() : nullptr; }
    bool stale() const;
    bool stopped() const { return stopped_; }  ///< a person has stopped it; again() or a change goes on
    void again() { known_ = 0, stopped_ = false; }
    /// A panel that shows them wants another frame, at due(): nothing else would make what it shows new.
    bool wants_frame() const { return stale() && (!busy() || exact_); }
    bool has_organ() const { return !document_.scene().organ.file.empty(); }  ///< without an organ there are no amounts
    bool busy() const { return job_ != nullptr; }  ///< a job works them out; its end wakes the UI
    /// Why they cannot be worked out.
    const std::vector<Fault>& faults() const { return faults_; }

    /// Changes when scene() does.
    std::uint64_t version() const { return version_; }

  private:
    struct Model;
    void follow(double now);
    void start();
    void without_organ();

    const document::Document& document_;
    const PreviewHost& preview_;
    Jobs& jobs_;
    bool exact_;
    bool wanted_ = false, stopped_ = false;
    bool held_ = false;                            // the model may hold something
    std::uint64_t followed_ = 0;                   // version of the document
    std::uint64_t organ_ = 0;                      // the preview's organ had this version
    std::shared_ptr<const document::Content> of_;  // what the last job is of; null: there was none
    std::uint64_t wanted_content_ = 0;             // counts contents that the amounts are wanted of
    std::uint64_t known_ = 0, asked_ = 0;          // that count, for scene_ or its faults, and for the job
    Settling settling_{0.15};                      // a drag does not start a job for each of its steps
    double due_ = Settling::never;
    std::shared_ptr<Model> model_;  // used by one job after the other
    std::shared_ptr<Job> job_;
    std::shared_ptr<const AmountSeries> scene_;
    std::vector<Fault> faults_;
    std::uint64_t version_ = 1;
};

}  // namespace lapfx::app
