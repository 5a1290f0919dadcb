// Time in the scene: where it stands and how it plays. The state of the timeline's widget, with what the scene adds to
// it.
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
    explicit Timeline(const document::Document& document) : document_(document) { loop = true; }

    double play_speed = 1;  ///< that it plays with when it is started

    bool playing() const { return speed != 0; }
    double duration() const { return document_.scene().duration; }  ///< s, of the scene
    /// Goes to `to` s, or to the end of the scene that is nearest.
    void seek(double to);
    /// Advances the time by `seconds`. At the end, or at the end of the range, play starts again or stops; with
    /// `endless`, which a tool in use needs, it continues beyond the end.
    void advance(double seconds, bool endless);

  private:
    const document::Document& document_;
};

}  // namespace lapfx::app
