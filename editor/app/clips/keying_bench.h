// A frame of a clip on its way to smoke: source, matte, keyed, composite; and what of it is counted. It follows the
// clip that is selected (ClipShelf::selected), its keying, and the bench's own time or the timeline's.
//
//     bench.update(now);                               // once before each frame
//     bench.show();                                    // by the panel: the pictures are wanted
//     ui::image_view(ui, "Matte", bench.picture(BenchView::matte), view);
//
// Frames are read by a job and never waited for: pictures come a little later, and the newest request is the next that
// is met. Once a frame has been read, a changed threshold is seen in the next frame of the window. In exact mode
// everything is done at once. UI thread.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/clips/clip_shelf.h"
#include "document/document.h"
#include "lapfx/authoring/suggest.h"
#include "ui/canvas/image_view.h"
#include "ui/canvas/scope.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class BenchWork;
class Notices;
class PreviewHost;
class ScenePace;
class Timeline;

enum class BenchView { source, matte, keyed, composite };
inline constexpr std::array<std::string_view, 4> view_titles = {"Source", "Matte", "Keyed", "Composite"};
inline constexpr std::size_t bench_views = view_titles.size();
enum class Behind { grey, checker, tissue, preview };
inline constexpr std::array<std::string_view, 4> behind_titles = {"Grey", "Checker", "Tissue", "Preview"};

/// How one looks at it; no part of the document.
struct BenchLook {
    bool grid = true;  ///< all four views, else `view`
    int view = 1;
    bool follow = false;         ///< the timeline's time, from the clip's in point on, else `time`
    std::optional<double> time;  ///< s of the clip; none: 40 % of it, where most clips show smoke
    Behind behind = Behind::tissue;
    bool waveform = false;  ///< in place of the vectorscope
    bool eyedropper = false;
    bool shapes = true;       ///< source, crop and masks as handles on the source picture
    bool draws_mask = false;  ///< the next drag on it makes a mask
    int sample_box = 3;       ///< pixels a side
    bool log_counts = true;
    float scopes = 0.64F;  ///< share of the panel that the views have
    ui::ViewState state;
};

/// Code values of a picture, for readouts.
struct BenchPixels : ui::PickSource {
    Image image;
    glm::vec4 pixel(glm::ivec2 at) const override;
};

class KeyingBench {
  public:
    /// All must outlive it. `pace`: what was drawn coarsely is no backdrop.
    KeyingBench(ClipShelf& shelf, document::Document& document, const PreviewHost& preview, const Timeline& timeline,
                const ScenePace& pace, Jobs& jobs, ui::ImageStore& images, Notices& notices, bool exact);
    ~KeyingBench();
    /// Once before each frame. `now`: s.
    void update(double now);

    BenchLook look;

    /// While the UI is built: update() makes the pictures from now on, as long as this is called.
    void show() { wanted_ = true; }
    bool shown() const { return shown_; }
    /// Another frame has to come: what is shown is not what was asked for last, and no job will wake the UI.
    bool stale() const;

    /// The source picture comes into sight with it.
    void set_eyedropper(bool on);

    // --- what is shown -----------------------------------------------------------------------------------------------
    bool ready() const { return frames_ > 0; }
    ui::Picture picture(BenchView view) const;
    std::span<const std::uint32_t> histogram() const { return bins_; }  ///< of luma; of 255 - luma for dark smoke
    ui::ImageHandle vectors() const { return vectors_.handle(); }
    ui::ImageHandle waves() const { return waves_.handle(); }
    double standing_at() const;  ///< s of the clip, without following
    int frame() const { return frame_; }
    int frames() const { return frames_; }
    double time() const { return time_; }    ///< s of the clip, of the frame shown
    bool broken() const { return broken_; }  ///< the frame cannot be decoded; the one before is shown
    const std::vector<Fault>& faults() const { return faults_; }

    // --- keying ------------------------------------------------------------------------------------------------------
    const SmokeClip* clip() const;  ///< null: none is selected
    /// What holds for the clip: its own keying, or the preset's.
    const KeyingParameters& keying() const;
    static const KeyingParameters& keying_of(const SmokeParameters& smoke, std::size_t clip);
    static KeyingParameters& keying_of(document::Content& content, std::size_t clip);

    /// Thresholds out of the clip, by a job; one undo step, with polarity, crop and masks. They are for this clip: it
    /// gets a keying of its own, unless it is the only one. For all: into the keying that clips share, and the clip
    /// shares it.
    enum class For { clip, all };
    void suggest(For whose = For::clip);
    /// What has been suggested for the selected clip, for all of them. One undo step.
    void suggest_for_all();
    const std::shared_ptr<Job>& suggesting() const { return suggesting_; }
    void cancel_suggesting();

    /// Finds the place where the clip's smoke starts, in a job; this is one undo step.
    void find_source();
    const std::shared_ptr<Job>& finding_source() const { return finding_source_; }
    void cancel_finding_source();
    /// The suggestion for the selected clip, until another clip is selected.
    const std::optional<KeyingSuggestion>& suggestion() const { return suggestion_; }
    static constexpr double sure_from = 0.5;  ///< confidence below which a person should look first
    /// What it changed, and for whom: "For this clip only: Luma low from 16 to 31". Empty once the document has changed
    /// again.
    std::string_view suggestion_changes() const;
    /// The document is as the suggestion left it: undo takes it back.
    bool suggestion_undoes() const { return suggestion_undoes_ && !suggestion_changes().empty(); }
    /// How many clips have no keying of their own.
    std::size_t sharing() const;
    const std::vector<Fault>& suggestion_faults() const { return suggestion_faults_; }
    void forget_suggestion();

    void take_backdrop() { backdrop_time_ = -1; }  ///< the preview as it is now, for Behind::preview

  private:
    friend class BenchWork;
    struct Request;
    struct Result;
    const Request& request() const;  ///< the one that would show what is wanted now
    void follow_backdrop();
    void let_go();
    void start(const Request& request);
    void take(Result& result);
    void show_pictures(Result& result);
    void put_suggestion(const KeyingSuggestion& found, std::size_t number, For whose);
    static std::string clip_changes(const SmokeClip& before, const SmokeClip& after);
    void tell_suggestion(const KeyingSuggestion& found, const std::string& file);

    ClipShelf& shelf_;
    document::Document& document_;
    const PreviewHost& preview_;
    const Timeline& timeline_;
    const ScenePace& pace_;
    Jobs& jobs_;
    ui::ImageStore& images_;
    Notices& notices_;
    bool exact_;
    bool wanted_ = false, shown_ = false;
    std::shared_ptr<BenchWork> work_;
    std::shared_ptr<Job> job_;
    std::unique_ptr<Request> asked_;      ///< the last one that was asked for
    std::unique_ptr<Request> requested_;  ///< made by request(); kept, so that its texts are not allocated again
    std::shared_ptr<const Image> backdrop_;
    double backdrop_time_ = -1, time_before_ = -1;

    std::array<BenchPixels, bench_views> pixels_;
    std::array<ui::ImageHandle, bench_views> handles_{};
    std::array<std::uint32_t, 256> bins_{};
    ui::ScopeImage vectors_, waves_;
    int frame_ = 0, frames_ = 0;
    double time_ = 0;
    bool broken_ = false;
    std::vector<Fault> faults_;

    std::shared_ptr<Job> suggesting_, finding_source_;
    std::optional<KeyingSuggestion> suggestion_;
    std::vector<Fault> suggestion_faults_;
    std::string suggestion_changes_;
    std::uint64_t suggestion_version_ = 0;  ///< the changes led to this version of the document
    bool suggestion_undoes_ = false;
    std::string suggested_for_;  ///< the clip's file
    std::size_t suggested_clip_ = 0;
};

}  // namespace lapfx::app
