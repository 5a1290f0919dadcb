// What is proposed from a frame of the reference: how the camera looks, how the video is meant to be shown, and where
// its round view lies. Nothing changes until a person takes it.
//
//     look.propose();   // after this frame, or when the frame is decoded: look.proposed(), look.notes()
//     look.take();      // one undo step
//
// UI thread, context current.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/reference/drawn_picture.h"
#include "document/document.h"
#include "document/steps.h"

namespace lapfx::app {

class PreviewHost;
class Reference;
class Screen;

class ReferenceLook {
  public:
    /// All must outlive it; it is a part of `reference`.
    ReferenceLook(Reference& reference, document::Document& document, PreviewHost& preview, Screen& screen);
    ~ReferenceLook();
    ReferenceLook(const ReferenceLook&) = delete;
    ReferenceLook& operator=(const ReferenceLook&) = delete;

    // --- the look ----------------------------------------------------------------------------------------------------
    /// After this frame, or when Reference::frame() is decoded: camera and look as that frame proposes them
    /// (match/explain/scene_look.h), against the preview at 0 s, without blood and smoke. Nothing changes until it is
    /// taken. None while the plate stands in for the organ: it is the reference itself.
    void propose();
    /// And neither taken nor left yet. It is left once the organ, camera, light, colours or the plate that it was made
    /// for are others, or the reference is.
    bool proposed() const { return proposed_ != nullptr; }
    void take();  ///< one undo step
    void leave();
    /// What the last proposal found and what not, a sentence each; of what was done they go when that is undone.
    const std::vector<std::string>& notes() const { return notes_; }
    void forget_notes() { say({}); }

    // --- the round view ----------------------------------------------------------------------------------------------
    /// An undo step: placed so that its round view lies on the preview's vignette, which is turned on; of a squeezed
    /// video with its proposed_aspect(). notes() say what was found.
    void take_circle();
    /// Width over height at which the round view of the video is round, where the scene has no aspect yet and the video
    /// is stored squeezed: looked for in its first frames that are shown. None: it looks right, or shows no round view,
    /// or that was left.
    const std::optional<double>& proposed_aspect() const { return proposed_aspect_; }
    void take_aspect();  ///< an undo step
    void leave_aspect();

    // --- the plate ---------------------------------------------------------------------------------------------------
    /// 0..1 while the plate is being made, negative where nobody knows; none: it is not.
    std::optional<double> plate_progress() const;

    // --- of the reference --------------------------------------------------------------------------------------------
    void forget();   ///< another video
    void update();   ///< once before each frame: leaves what holds no longer
    void look_at();  ///< another frame is shown
    /// Once after each frame, before the reference draws.
    void follow();

  private:
    void make();
    void leave_stale();
    void say(std::vector<std::string> notes, document::WatchedStep step = {});

    Reference& reference_;
    document::Document& document_;
    PreviewHost& preview_;
    Screen& screen_;
    bool proposes_ = false;
    DrawnPicture clean_;  ///< the preview at 0 s, for a proposal
    struct Proposed;
    std::shared_ptr<Proposed> proposed_;  ///< null: none is
    std::vector<std::string> notes_;
    document::WatchedStep noted_step_;  ///< that the notes tell of; none: of nothing that was done
    std::optional<double> proposed_aspect_;
    int looked_for_aspect_ = 0;  ///< in so many frames of this video
};

}  // namespace lapfx::app
