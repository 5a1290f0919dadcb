// Time in the scene: where it stands and how it plays. The state of the timeline's widget, with what the scene adds to
// it: its length, and the part that plays, which is kept with the reference (SceneReference::loop).
//
//     timeline.speed = timeline.play_speed;  // plays
//     timeline.advance(seconds, false);      // once a frame
#pragma once

#include "document/document.h"
#include "ui/canvas/timeline.h"

namespace lapfx::app {

class Timeline : public ui::TimelineState {
  public:
    /// `document` must outlive it.
    explicit Timeline(document::Document& document) : document_(document) { loop = true; }

    double play_speed = 1;  ///< that it plays with when it is started

    bool playing() const { return speed != 0; }
    double duration() const { return document_.scene().duration; }  ///< s, of the scene
    /// Goes to `to` s, or to the end of the scene that is nearest.
    void seek(double to);
    /// Advances the time by `seconds`. At the end, or at the end of the range, play starts again or stops; with
    /// `endless`, which a tool in use needs, it continues beyond the end.
    void advance(double seconds, bool endless);

    // --- the part that plays -----------------------------------------------------------------------------------------
    /// Takes it from the scene where that has changed. Once a frame, and when another document has been opened.
    void follow();
    /// What the widget has done to it goes into the scene: a gesture is an undo step.
    void take_range(const ui::Edit& edit);
    /// Undo steps: it begins, or ends, at the present time; it is all of the scene.
    void begin_range_here() { end_range_at(true); }
    void end_range_here() { end_range_at(false); }
    void drop_range();

  private:
    void end_range_at(bool in);
    void put_range(document::Content& content) const;

    document::Document& document_;
    std::uint64_t followed_ = 0;  ///< version of the document
};

}  // namespace lapfx::app
