// A tool in the hand of a person who works on the preview: the preview shows what it does, the document does not know
// of it yet. Render thread.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "lapfx/authoring/preview.h"

namespace lapfx::app {

class HeldTool {
  public:
    bool on() const { return on_; }  ///< it touches the organ
    /// `first`: where and how it touches, from its time on.
    void put(Preview& preview, const ToolSample& first);
    void move(Preview& preview, double time, glm::dvec3 place);  ///< straight from where it was, at 100 Hz
    void take_off(Preview& preview, double time);
    /// What it has done since put(), once the preview has been drawn: contacts for the scene's events.
    std::vector<ToolContact> done(const Preview& preview) const;

  private:
    void push(Preview& preview, double time, glm::dvec3 place, bool touching);

    bool on_ = false;
    ToolSample last_;
    std::size_t contacts_before_ = 0;
};

}  // namespace lapfx::app
