// Tool samples (1 kHz) to tool contacts: what a scene keeps and what the models work on. Contacts are few where the tip
// stands or moves straight. One thread at a time.
//
// A contact goes on while samples touch with the same action, power and strength. It ends
// - when the tip lets go (at the time of the sample that says so), or when action, power or strength change;
// - when more than `longest_gap` s lie between two samples: at the last sample before the gap;
// - when the straight way from its start to here would leave the samples' path by more than `tolerance` mm (in space,
// at
//   the samples' times: so also when the tip stops or turns round), or a moving contact lasts longer than
//   `longest_move` s: it then goes on as another contact that starts at the time and place where the former ends.
//
// Samples are dropped, and counted in dropped(): not finite; a time beyond +-1e7 s or not after the sample before; a
// coordinate beyond +-1e5 mm; power or strength below 0. Power above 1 counts as 1.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/tool_queue.h"

namespace lapfx::tool {

class Recorder {
  public:
    static constexpr double longest_gap = 0.1;   ///< s
    static constexpr double tolerance = 0.2;     ///< mm
    static constexpr double longest_move = 0.1;  ///< s; so that a growing contact changes little of the past

    /// Takes the place of the log. A running contact is over, and time may begin anew.
    void set(std::span<const ToolContact> contacts);
    /// False when the sample was dropped.
    bool add(const ToolSample& sample);
    /// What happened so far; the last one grows while the tool touches.
    std::span<const ToolContact> contacts() const { return contacts_; }
    std::uint64_t dropped() const { return dropped_; }
    /// How many contacts, from the first on, are as they were at the call before.
    std::size_t take_same();
    /// Whether the contacts are other ones than at the last take_same(): samples that do not touch change nothing.
    bool changed() const { return same_ < contacts_.size() || shrunk_; }

  private:
    struct Point {
        double time;
        glm::dvec3 position;
    };
    void begin(const ToolSample& sample, const Point& from);
    void extend(const ToolSample& sample);
    bool straight_to(const Point& end) const;

    std::vector<ToolContact> contacts_;
    std::vector<Point> path_;  // samples of the running contact
    bool running_ = false;
    double last_time_ = 0.0;
    bool any_ = false;
    std::uint64_t dropped_ = 0;
    std::size_t same_ = 0;
    bool shrunk_ = false;
};

}  // namespace lapfx::tool
