// A timeline: the present time, a range to play, clips and marks on tracks.
//
//     ui::TimelineEdit edit = ui::timeline(u, "Time", state, tracks, {.length = 12, .rate = 25});
//     if (edit.time.changed) player.seek(state.time);
//     state.time += state.speed * frame_time;  // time is the program's
//
// Pointer: the ruler scrubs, the wheel zooms at the pointer (Shift, or sideways: pans), the middle button pans. Clips:
// press selects (Shift: one more), drag moves all that are selected, their ends stretch; ends catch frames and, within
// 8 px, the playhead, the range and other clips, unless Ctrl is held. Esc and the other button give back what was
// before. Keys: J K L play backwards, stop, play (again: twice as fast, up to 8), space plays and stops, arrows step by
// a frame (Shift: ten), Home and End, I and O set the range, X drops it, F fits. On a clip arrows move it (Ctrl: its
// end), Delete erases what is selected. Ghosts are marks that are proposed: a click takes one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/canvas/axis.h"
#include "ui/core/ui.h"

namespace lapfx::ui {

enum class TimeUnit : std::uint8_t { frames, seconds, timecode };

/// "37", "1:01.480" or "00:01:01:12", which counts without drops: at 29.97 a second of it has 30 frames.
std::string_view format_position(std::span<char> buffer, double seconds, double rate, TimeUnit unit);

struct TimelineItem {
    std::string name;
    double start = 0, end = 0;  ///< s; a mark when both are the same
    int color = -1;             ///< 0 to 7, of the theme's series; -1: the number of the track
    bool selected = false;
    bool ghost = false;  ///< only proposed: it cannot be selected or moved; a click, Enter or space takes it
    friend bool operator==(const TimelineItem&, const TimelineItem&) = default;
};
struct TimelineTrack {
    std::string name;
    std::vector<TimelineItem> items;
};

/// What the program keeps.
struct TimelineState {
    double time = 0;   ///< s
    double speed = 0;  ///< 0: stands, 1: plays
    bool loop = false;
    bool has_range = false;
    Span range = {};  ///< s, in and out
    Span view = {};
    bool fitted = true;  ///< all is in sight, until it is zoomed
};

struct TimelineOptions {
    double length = 1, rate = 25;  ///< s and 1/s, above 0 (assert)
    TimeUnit unit = TimeUnit::timecode;
    Size width = {SizeKind::grow, 1};
    std::string_view tip = {};
};

struct TimelineEdit {
    Edit time, range;
    Edit items;  ///< moved, stretched, erased
    /// A ghost that was taken: the number of its track and its own; what that means is the program's.
    struct Taken {
        std::size_t track = 0, item = 0;
    };
    std::optional<Taken> taken = {};
};

/// `tracks` must outlive the frame.
TimelineEdit timeline(Ui& ui, std::string_view label, TimelineState& state, std::span<TimelineTrack> tracks,
                      const TimelineOptions& options = {});

}  // namespace lapfx::ui
