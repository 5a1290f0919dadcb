// A tool held on the organ: time runs while it works there, and what it did becomes events of the scene, in one undo
// step.
//
//     if (pressed && hit) hold.begin(tool, hit->position);
//     if (hold.on() && hit) hold.move(hit->position);
//     if (released) hold.end();   // or cancel(): as if nothing had been
//
// UI thread. The editor calls update() once a frame.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "document/document.h"
#include "lapfx/tissue.h"
#include "lapfx/tool.h"

namespace lapfx::app {

class Notices;
class PreviewHost;
class Timeline;

/// What the left button does on the organ.
struct ToolInHand {
    std::optional<ToolAction> action;  ///< none: it looks around
    double power = 1, strength = 1;
};

/// A factor on the strength of new wounds. A hot tool closes what it divides, except vessels; an organ without colours
/// shows none, and would be flooded at each stroke. It then bleeds as a stroke over the sample organ does on the whole,
/// where a fifth of the surface has vessels. The factor goes into the event: the core takes that as it is.
inline double strength_here(ToolAction action, const TissueSample& tissue) {
    constexpr double vessels_unknown = 0.15;
    return row_of(action).hot && !tissue.known ? vessels_unknown : 1.0;
}

class ToolHold {
  public:
    /// All must outlive it. `selected`: of the scene's events; those that the tool has made are, afterwards.
    ToolHold(document::Document& document, PreviewHost& preview, Timeline& timeline, std::vector<std::size_t>& selected,
             Notices& notices)
        : document_(document), preview_(preview), timeline_(timeline), selected_(selected), notices_(notices) {}

    bool on() const { return on_; }
    /// Nothing happens without an action, or where events may not begin any more.
    void begin(const ToolInHand& tool, const glm::dvec3& place);
    /// The same, and it ends by itself after `seconds`.
    void begin_for(const ToolInHand& tool, const glm::dvec3& place, double seconds);
    void move(const glm::dvec3& place);
    void end();
    void cancel();
    /// `held`: whether a button is still down.
    void update(bool held);

  private:
    void stop();

    document::Document& document_;
    PreviewHost& preview_;
    Timeline& timeline_;
    std::vector<std::size_t>& selected_;
    Notices& notices_;
    bool on_ = false;
    double began_ = 0, speed_before_ = 0;
    double until_ = 0;  ///< s; 0: as long as the button is down
    glm::dvec3 place_{0.0};
};

}  // namespace lapfx::app
