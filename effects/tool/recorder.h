// Turns tool samples (1 kHz) into tool contacts, which scenes keep and models work on. There are few contacts where the
// tip stands or moves straight. One thread at a time.
//
// A contact continues while samples touch with the same action, power and strength. It ends
// - when the tip lets go (at the time of the sample that says so), or when action, power or strength change;
// - when two samples are more than `longest_gap` s apart: at the last sample before the gap;
// - when the straight line from its start to here would leave the path of the samples by more than `tolerance` mm (at
//   the times of the samples, so also when the tip stops or turns round), or when a moving contact lasts longer than
//   `longest_move` s. Another contact then starts at the time and place where it ends.
//
// A sample is dropped, and counted in dropped(), if it is not finite, if its time is beyond +-1e7 s or not after the
// sample before, if a coordinate is beyond +-1e5 mm, or if power or strength is below 0. Power above 1 counts as 1.
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

    /// Replaces the log. A running contact ends, and times may start again.
    void set(std::span<const ToolContact> contacts);
    /// False when the sample was dropped.
    bool add(const ToolSample& sample);
    /// What happened so far; the last one grows while the tool touches.
    std::span<const ToolContact> contacts() const { return contacts_; }
    std::uint64_t dropped() const { return dropped_; }
    /// `time`, or where its last contact still runs and ended less than `longest_gap` before, the last moment of that:
    /// what the tool does now, of which a sample has not come yet.
    double acting(double time) const;
    /// How many contacts, from the first on, are unchanged since the last call.
    std::size_t take_same();
    /// Whether the contacts have changed since the last take_same(); samples that do not touch change nothing.
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
