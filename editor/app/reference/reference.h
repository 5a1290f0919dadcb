// The surgery video that is to be matched: the scene names it; here it is opened, and follows the timeline. How it is
// shown, compared with the preview, and what is proposed from it are its parts.
//
//     reference.choose("operation.mp4");  // the scene's reference from now on: an undo step
//     ...
//     while the panel is built:  reference.follow();  ui::image_view(u, "Video", reference.shown().whole(),
//         reference.comparison().state.view);
//
// UI thread; what decodes is beside it (video_feed.h), but with EditorOptions::exact.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/editor_options.h"
#include "app/reference/reference_comparison.h"
#include "app/reference/reference_look.h"
#include "app/reference/reference_picture.h"
#include "app/reference/video_feed.h"
#include "app/tuning/snapshot_previews.h"
#include "document/document.h"
#include "ui/canvas/axis.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class Job;
class Screen;
class Settings;
class Timeline;

class Reference {
  public:
    /// s: a sum of time and offset may fall just short of a frame's own time.
    static constexpr double frame_slack = 5e-4;

    /// All must outlive it.
    Reference(document::Document& document, const Timeline& timeline, PreviewHost& preview, SnapshotPreviews& snapshots,
              Jobs& jobs, Settings& settings, ui::ImageStore& images, Screen& screen, const EditorOptions& options);
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;

    // --- which ------------------------------------------------------------------------------------------------------
    /// Opens the file in a job and then, as one undo step, makes it the scene's reference, from its first frame on. If
    /// it cannot be opened, refused() says why and the present reference stays. One of several numbered images stands
    /// for all of them.
    void choose(const std::filesystem::path& file);
    /// What was wrong in the last choose(), until another reference comes.
    const std::vector<Fault>& refused() const { return refused_; }
    void forget_refused() { refused_.clear(); }
    /// Another document has been opened: what is being opened is not for that one.
    void give_up_choosing();
    void choose_sample();
    void remove();
    bool named() const { return !file_.empty(); }                ///< the scene names one
    const std::filesystem::path& file() const { return file_; }  ///< where it is
    bool opening() const { return feed_.opening() || choosing_; }
    const std::filesystem::path& opens() const { return choosing_ ? chosen_ : file_; }  ///< while opening()
    const VideoReader* video() const { return feed_.video().get(); }  ///< null: none that can be shown
    /// The same; another one with every opening, also of the same file.
    const std::shared_ptr<const VideoReader>& opened() const { return feed_.video(); }
    const std::vector<Fault>& faults() const { return feed_.faults(); }

    // --- when -------------------------------------------------------------------------------------------------------
    /// s in the reference: the scene's time and the offset, or of the frame that is held. May be outside of it.
    double time() const;
    int frame() const;  ///< the one for that time; -1 without video()
    /// Keeps to this frame whatever the timeline does: to find what belongs to a moment of the scene.
    void hold(int frame);
    void step(int frames) { hold(frame() + frames); }
    void let_go() { held_.reset(); }
    bool held() const { return held_.has_value(); }
    /// An undo step: the offset with which the frame that is held belongs to the scene's time as it is; it is let go.
    void align();
    /// An undo step: what the row of `marks` means happens at time(). Nothing outside of the video.
    void mark(const Parameter& row);
    void clear_marks();                ///< the same: nothing is marked any more
    bool any_mark() const;             ///< something is marked
    static const Table& mark_table();  ///< of ReferenceMarks: a row for each mark
    /// s of the scene, from the reference's first frame to its end; nothing without video().
    std::optional<ui::Span> span() const;

    // --- shown ------------------------------------------------------------------------------------------------------
    /// Called by the panel in every build: asks for the frame of the present time.
    void follow();
    const Image& image() const { return feed_.image(); }  ///< the newest frame that has come, as the file has it
    /// image(), for who keeps it: it stays what it is.
    const std::shared_ptr<const Image>& shared_image() const { return feed_.shared_image(); }
    int shown_frame() const { return feed_.frame(); }  ///< its number; -1: none has come
    bool good() const { return feed_.good(); }         ///< the file could give it
    /// That frame as it is shown.
    ReferencePicture& shown() { return shown_; }
    const ReferencePicture& shown() const { return shown_; }
    /// It beside the preview and snapshots.
    ReferenceComparison& comparison() { return comparison_; }
    const ReferenceComparison& comparison() const { return comparison_; }
    /// What is proposed from it.
    ReferenceLook& look() { return look_; }
    const ReferenceLook& look() const { return look_; }

    // --- of the editor -----------------------------------------------------------------------------------------------
    void set_wake(std::function<void()> wake) { feed_.set_wake(std::move(wake)); }
    /// Once before each frame. `now`: s.
    void update(double now);
    /// Once after each frame: proposes, and draws what is compared. Gives whether that differs. `scale`: Shot::scale.
    bool draw(double scale);

  private:
    void take(const std::filesystem::path& file, std::shared_ptr<VideoReader> reader);
    void follow_scene(std::shared_ptr<VideoReader> reader = nullptr);
    void show_newest();

    document::Document& document_;
    const Timeline& timeline_;
    Jobs& jobs_;
    Settings& settings_;
    std::filesystem::path data_folder_;
    VideoFeed feed_;
    std::filesystem::path file_;
    std::shared_ptr<Job> choosing_;  ///< opens `chosen_`
    std::filesystem::path chosen_;
    std::vector<Fault> refused_;
    std::uint64_t followed_ = 0;  ///< version of the document
    std::optional<int> held_;
    ReferencePicture shown_;
    ReferenceComparison comparison_;
    ReferenceLook look_;
};

/// "frame_%04d.png" for "frame_0012.png" where more of them are numbered on beside it; else the file itself.
std::filesystem::path whole_sequence(const std::filesystem::path& file);

}  // namespace lapfx::app
