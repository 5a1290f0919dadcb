// Time, and what the tools do in it: the scene's events, moved, stretched and typed.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor.h"
#include "app/measure/proposed_marks.h"
#include "app/preview/events.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/compare.h"
#include "panels/event_form.h"
#include "panels/panels.h"
#include "panels/table_rows.h"
#include "panels/titles.h"
#include "ui/canvas/timeline.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using ui::Mods;

constexpr double frame_rate = 25;  // 1/s, of steps and of timecode
constexpr double new_event_length = 1;
constexpr float narrow_below = 52;                                    // em
constexpr float speed_width = 5, unit_width = 7, duration_width = 9;  // em
constexpr float room_for_both = 12, room_for_both_narrow = 15;        // em of height: tools, ruler, a track, form
struct Speed {
    std::string_view title;
    double factor;
};
constexpr Speed speeds[] = {{"0.1x", 0.1}, {"0.25x", 0.25}, {"0.5x", 0.5}, {"1x", 1}, {"2x", 2}, {"4x", 4}};
constexpr auto speed_names = titles_of(speeds);
constexpr std::array<std::string_view, 3> unit_names = {"Frames", "Seconds", "Timecode"};

/// The tracks of the timeline, made from the document; during a gesture the widget changes them.
struct TimelineMemory {
    std::uint64_t version = 0;
    std::vector<std::size_t> selected;
    std::vector<app::Stroke> strokes;
    std::vector<ui::TimelineTrack> tracks;  ///< of strokes, and last that of the reference's marks, if there are any
    std::vector<std::vector<std::size_t>> shown;  ///< for each item of each track of strokes its stroke
    std::vector<const Parameter*> marks;          ///< for each of the first items of the last track its row
    std::vector<const Parameter*> ghosts;         ///< for each item after them; both empty: no such track
    ReferenceMarks proposed;                      ///< what the ghosts were made of
    ui::TimeUnit unit = ui::TimeUnit::timecode;
};

double mark_time(const Parameter& row, const SceneReference& reference) {
    return std::get<double>(row.get(&reference.marks));
}

/// A stroke that burns nothing and opens no wound, as a fit leaves those that the reference does not show.
bool is_silenced(const app::Stroke& stroke, std::span<const ToolContact> events) {
    return std::ranges::all_of(stroke.events, [&](std::size_t i) {
        const ToolContact& event = events[i];
        return (event.hot() || divides(event.action)) && (!event.hot() || event.power <= 0.0) &&
               (!divides(event.action) || event.strength <= 0.0);
    });
}

/// Items of a track are told apart by their names. `number`: of the stroke within its track, from 1.
std::string item_name(const std::string& track, std::size_t number, const app::Stroke& stroke,
                      std::span<const ToolContact> events) {
    return track + ' ' + std::to_string(number) + (is_silenced(stroke, events) ? " (silenced)" : "");
}

/// Those that are set, at their times in the scene; after them those that are proposed.
void add_marks(TimelineMemory& memory, const SceneReference& reference) {
    memory.marks.clear();
    memory.ghosts.clear();
    ui::TimelineTrack track{.name = "Reference", .items = {}};
    int color = 0;
    for (const Parameter& row : app::Reference::mark_table().rows) {
        const double time = mark_time(row, reference) - reference.offset;
        if (mark_time(row, reference) >= 0) {
            track.items.push_back({.name = std::string(row.name), .start = time, .end = time, .color = color});
            memory.marks.push_back(&row);
        }
        ++color;
    }
    color = 0;
    for (const Parameter& row : app::Reference::mark_table().rows) {
        const double proposed = std::get<double>(row.get(&memory.proposed));
        if (proposed >= 0 && mark_time(row, reference) < 0) {
            const double time = proposed - reference.offset;
            track.items.push_back(
                {.name = std::string(row.name) + '?', .start = time, .end = time, .color = color, .ghost = true});
            memory.ghosts.push_back(&row);
        }
        ++color;
    }
    if (!track.items.empty()) memory.tracks.push_back(std::move(track));
}

std::vector<const Parameter*> selected_marks(const TimelineMemory& memory) {
    std::vector<const Parameter*> selected;
    if (memory.marks.empty()) return selected;
    for (const ui::TimelineItem& item : memory.tracks.back().items)
        for (const Parameter* row : memory.marks)
            if (item.selected && item.name == row->name) selected.push_back(row);
    return selected;
}

void select_marks(TimelineMemory& memory, const std::vector<const Parameter*>& selected) {
    for (std::size_t i = 0; i < memory.marks.size(); ++i)
        memory.tracks.back().items[i].selected = std::ranges::find(selected, memory.marks[i]) != selected.end();
}

/// Marks stay selected until other events are.
void make_tracks(TimelineMemory& memory, const document::Document& document, const std::vector<std::size_t>& selected) {
    const bool same = memory.selected == selected;
    const std::vector<const Parameter*> marks = same ? selected_marks(memory) : std::vector<const Parameter*>();
    memory.version = document.version();
    memory.selected = selected;
    memory.strokes = app::strokes_of(document.scene().events);
    memory.tracks.clear();
    memory.shown.clear();
    for (const ToolActionRow& row : tool_actions) {
        ui::TimelineTrack track{.name = std::string(row.title), .items = {}};
        std::vector<std::size_t> shown;
        for (std::size_t i = 0; i < memory.strokes.size(); ++i) {
            const app::Stroke& stroke = memory.strokes[i];
            if (stroke.action != row.action) continue;
            shown.push_back(i);
            track.items.push_back({.name = item_name(track.name, shown.size(), stroke, document.scene().events),
                                   .start = stroke.start,
                                   .end = stroke.end,
                                   .color = row.color,
                                   .selected = is_selected(selected, stroke)});
        }
        if (shown.empty()) continue;
        memory.tracks.push_back(std::move(track));
        memory.shown.push_back(std::move(shown));
    }
    add_marks(memory, document.scene().reference);
    select_marks(memory, marks);
}

std::vector<std::size_t> selected_events(const TimelineMemory& memory) {
    std::vector<std::size_t> selected;
    for (std::size_t t = 0; t < memory.shown.size(); ++t)
        for (std::size_t i = 0; i < memory.tracks[t].items.size(); ++i) {
            if (!memory.tracks[t].items[i].selected) continue;
            const app::Stroke& stroke = memory.strokes[memory.shown[t][i]];
            selected.insert(selected.end(), stroke.events.begin(), stroke.events.end());
        }
    std::sort(selected.begin(), selected.end());
    return selected;
}

std::size_t item_count(const std::vector<ui::TimelineTrack>& tracks) {
    std::size_t count = 0;
    for (const ui::TimelineTrack& track : tracks) count += track.items.size();
    return count;
}

/// What an edit of the tracks means for the events, and for the marks of the reference.
class ItemEdits {
  public:
    ItemEdits(document::Document& document, std::vector<std::size_t>& selected, TimelineMemory& memory)
        : document_(document), selected_(selected), memory_(memory) {}

    void take(const ui::Edit& edit, std::size_t items_before) {
        if (item_count(memory_.tracks) < items_before) return erase();
        if (edit.began) name_ = stretched() ? "Stretch event" : moved() ? "Move event" : "Move mark";
        document_.take(edit, name_, [&](document::Content& c) {
            apply(c.scene.events);
            apply_marks(c.scene.reference);
        });
        memory_.version = edit.committed || edit.cancelled ? 0 : document_.version();
    }

  private:
    template <typename F>
    void each(F&& f) {
        for (std::size_t t = 0; t < memory_.shown.size(); ++t)
            for (std::size_t i = 0; i < memory_.tracks[t].items.size(); ++i)
                f(memory_.tracks[t].items[i], memory_.strokes[memory_.shown[t][i]]);
    }
    static bool longer(const ui::TimelineItem& item, const app::Stroke& stroke) {
        return std::abs((item.end - item.start) - (stroke.end - stroke.start)) > 1e-9;
    }
    bool stretched() {
        bool any = false;
        each([&](const ui::TimelineItem& item, const app::Stroke& stroke) { any |= longer(item, stroke); });
        return any;
    }
    bool moved() {
        bool any = false;
        each([&](const ui::TimelineItem& item, const app::Stroke& stroke) { any |= item.start != stroke.start; });
        return any;
    }
    void apply_marks(SceneReference& reference) {
        if (memory_.marks.empty()) return;
        const std::vector<ui::TimelineItem>& items = memory_.tracks.back().items;
        for (std::size_t i = 0; i < memory_.marks.size(); ++i) {
            const double time = std::max(0.0, std::round((items[i].start + reference.offset) * 1e4) / 1e4);
            if (std::abs(time - mark_time(*memory_.marks[i], reference)) > 1e-4)
                memory_.marks[i]->set(&reference.marks, time);
        }
    }
    /// Marks whose items are gone.
    std::vector<const Parameter*> marks_gone() const {
        std::vector<const Parameter*> gone;
        for (const Parameter* row : memory_.marks) {
            const auto& left = memory_.tracks.back().items;
            if (std::none_of(left.begin(), left.end(), [&](const auto& item) { return item.name == row->name; }))
                gone.push_back(row);
        }
        return gone;
    }
    void apply(std::vector<ToolContact>& events) {
        each([&](const ui::TimelineItem& item, app::Stroke& stroke) {
            if (longer(item, stroke))
                app::stretch_stroke(events, stroke, item.start, item.end);
            else if (item.start != stroke.start)
                app::move_stroke(events, stroke, item.start);
            stroke.start = item.start, stroke.end = item.end;
        });
    }
    /// Removes the events whose items the widget has removed.
    void erase() {
        std::vector<std::size_t> gone;
        for (std::size_t t = 0; t < memory_.shown.size(); ++t) {
            const auto& left = memory_.tracks[t].items;
            for (std::size_t i = 0; i < memory_.shown[t].size(); ++i) {
                const app::Stroke& stroke = memory_.strokes[memory_.shown[t][i]];
                const std::string name = item_name(memory_.tracks[t].name, i + 1, stroke, document_.scene().events);
                const bool there =
                    std::any_of(left.begin(), left.end(), [&](const auto& item) { return item.name == name; });
                if (!there) gone.insert(gone.end(), stroke.events.begin(), stroke.events.end());
            }
        }
        const std::vector<const Parameter*> marks = marks_gone();
        const bool none = gone.empty() && marks.empty();
        if (!none)
            document_.change(gone.empty() ? "Delete mark" : "Delete events", [&](document::Content& c) {
                app::erase_events(c.scene.events, gone);
                for (const Parameter* row : marks) row->set(&c.scene.reference.marks, -1.0);
            });
        if (!gone.empty()) selected_.clear();
        memory_.version = 0;
    }

  public:
    static void erase_selected(document::Document& document, std::vector<std::size_t>& selected,
                               const std::vector<std::size_t>& gone) {
        if (gone.empty()) return;
        document.change("Delete events", [&](document::Content& c) { app::erase_events(c.scene.events, gone); });
        selected.clear();
    }

  private:
    document::Document& document_;
    std::vector<std::size_t>& selected_;
    TimelineMemory& memory_;
    std::string name_ = "Move event";
};

/// The place for a new event: the tool's last place before the present time, else the one at the middle of the view.
glm::dvec3 place_for_new(const TimelineParts& on) {
    const ToolContact* last = nullptr;
    for (const ToolContact& event : on.edited.document.scene().events)
        if (event.time <= on.timeline.time && (last == nullptr || event.time > last->time)) last = &event;
    if (last != nullptr) return last->to;
    const Preview* const preview = on.preview.preview();
    const glm::ivec2 size = on.preview.size();
    if (preview != nullptr && size.x > 0)
        if (const auto hit = preview->pick(glm::dvec2(size) / 2.0, size)) return hit->position;
    return on.looking.through(on.edited.document.scene().camera).target;
}

bool room_for(const TimelineParts& on, std::size_t more) {
    if (on.edited.document.scene().events.size() + more <= app::most_events) return true;
    on.toasts.add({.kind = ui::ToastKind::error, .text = "A scene has at most 4096 events; delete some first"});
    return false;
}

void add_events(const TimelineParts& on, const char* name, const std::vector<ToolContact>& made) {
    if (made.empty() || !room_for(on, made.size())) return;
    const std::size_t there = on.edited.document.scene().events.size();
    on.edited.document.change(name, [&](document::Content& c) {
        for (const ToolContact& event : made) {
            c.scene.events.push_back(event);
            c.scene.duration = std::max(c.scene.duration, std::min(event.end(), app::last_event_time));
        }
    });
    on.selected.clear();
    for (std::size_t i = 0; i < made.size(); ++i) on.selected.push_back(there + i);
}

void add_event(const TimelineParts& on) {
    const glm::dvec3 place = place_for_new(on);
    const ToolAction action = on.tool.action.value_or(ToolAction::cauterise);
    const Preview* const preview = on.preview.preview();
    const double here = preview == nullptr ? 1 : app::strength_here(action, preview->tissue(place));
    add_events(on, "Add event",
               {{.action = action,
                 .time = std::round(on.timeline.time * 1e4) / 1e4,
                 .duration = new_event_length,
                 .position = place,
                 .to = place,
                 .power = row_of(action).hot ? on.tool.power : 1.0,
                 .strength = divides(action) ? on.tool.strength * here : 1.0}});
}

/// Copies them to the playhead; where they are there already, behind themselves.
void duplicate_events(const TimelineParts& on) {
    const std::vector<ToolContact>& events = on.edited.document.scene().events;
    std::vector<ToolContact> made;
    for (const std::size_t i : on.selected)
        if (i < events.size()) made.push_back(events[i]);
    if (made.empty()) return;
    double start = made.front().time, end = made.front().end();
    for (const ToolContact& event : made) start = std::min(start, event.time), end = std::max(end, event.end());
    const double now = on.timeline.time, to = now < start || now > end ? now : end + 1 / frame_rate;
    for (ToolContact& event : made) event.time += to - start;
    add_events(on, "Duplicate event", made);
}

class TimelinePanel {
  public:
    TimelinePanel(ui::Ui& ui, const TimelineParts& on)
        : ui_(ui), on_(on), memory_(ui.memory<TimelineMemory>(ui.id_of("timeline memory"))) {
        const ReferenceMarks proposed = app::marks_to_take(on.measuring, on.edited.document);
        const bool others = !equal(app::Reference::mark_table(), &proposed, &memory_.proposed);
        if (!on.edited.document.in_gesture()) memory_.proposed = proposed;
        if (on.edited.document.scene_changes_since(memory_.version) != 0 || memory_.selected != on.selected ||
            (others && !on.edited.document.in_gesture()))
            make_tracks(memory_, on.edited.document, on.selected);
    }

    void build() {
        // Where there is room for both, the form stays below the tracks, and only these scroll; else all of it scrolls.
        const float height = ui_.rect_before(ui_.parent().id).h;
        ui_.follow_size(ui_.parent());
        const ui::Column column(ui_, {.width = ui::grow(), .height = ui::grow(), .gap = 0.4F, .padding = 0.3F});
        const float width = ui_.rect_before(ui_.id_of("Events")).w;
        narrow_ = width > 0 && width < ui_.em(narrow_below);
        tool_bar(width);
        const bool below = height >= ui_.em(narrow_ ? room_for_both_narrow : room_for_both);
        {
            const ui::ScrollArea area(ui_, "Events", {.gap = 0.5F});
            timeline();
            if (!below) event_form(ui_, on_.edited, on_.selected, memory_.strokes, narrow_);
        }
        if (below) event_form(ui_, on_.edited, on_.selected, memory_.strokes, narrow_);
    }

  private:
    /// `room`: px.
    void tool_bar(float room) {
        enum : std::size_t { first, back, on, pace, time_unit, length, add, copy, erase, count };
        std::array<ui::ToolItem, count> items;
        items[first] = items[back] = items[on] = {.width = ui_.row_height()};
        items[pace] = {.width = ui_.em(speed_width), .rank = 1};
        items[time_unit] = {.width = narrow_ ? 0 : ui_.em(unit_width), .rank = 4};
        items[length] = {.width = ui_.em(duration_width), .rank = 3};
        items[add] = {.width = ui::tool_width(ui_, "Add event", true), .rank = 2, .end = true};
        items[copy] = {.width = ui::tool_width(ui_, "Duplicate", true), .rank = 3};
        items[erase] = {.width = ui::tool_width(ui_, "Delete", true), .rank = 2};
        ui::toolbar(ui_, "Timeline tools", room, items, [&](std::size_t item) {
            if (item == first) ui::command_button(ui_, on_.commands, "play.start", true);
            if (item == back) ui::command_button(ui_, on_.commands, "play.frame_back", true);
            if (item == on) ui::command_button(ui_, on_.commands, "play.frame_on", true);
            if (item == pace) speed();
            if (item == time_unit) unit();
            if (item == length) duration();
            if (item >= add) event_tool(item - add);
        });
    }

    void unit() {
        int unit = static_cast<int>(memory_.unit);
        if (ui::combo(ui_, "Unit", unit, unit_names,
                      {.tip = "How times are written", .width = ui::px(ui_.em(unit_width))}))
            memory_.unit = static_cast<ui::TimeUnit>(unit);
    }

    /// Add, duplicate, delete.
    void event_tool(std::size_t which) {
        if (which == 0) {
            if (ui::button(
                    ui_, "Add event",
                    {.icon = ui::Icon::plus,
                     .tip = "At the current time, where the tool last was, otherwise in the middle of the view"}))
                add_event(on_);
            return;
        }
        ui_.push_disabled(on_.selected.empty());
        if (which == 1 && ui::button(ui_, "Duplicate",
                                     {.icon = ui::Icon::copy, .tip = "Copies the selected events to the current time"}))
            duplicate_events(on_);
        if (which == 2 &&
            ui::button(ui_, "Delete", {.icon = ui::Icon::cross, .tip = "Removes the selected events (Delete)"}))
            ItemEdits::erase_selected(on_.edited.document, on_.selected, std::vector(on_.selected));
        ui_.pop_disabled();
    }

    void speed() {
        int chosen = 0;
        for (std::size_t i = 0; i < std::size(speeds); ++i)
            if (std::abs(speeds[i].factor - on_.timeline.play_speed) <
                std::abs(speeds[static_cast<std::size_t>(chosen)].factor - on_.timeline.play_speed))
                chosen = static_cast<int>(i);
        if (!ui::combo(ui_, "Speed", chosen, speed_names,
                       {.tip = "How fast the scene plays", .width = ui::px(ui_.em(speed_width))}))
            return;
        on_.timeline.play_speed = speeds[static_cast<std::size_t>(chosen)].factor;
        if (on_.timeline.playing() && !on_.hold.on()) on_.timeline.speed = on_.timeline.play_speed;
    }

    void duration() {
        double value = on_.edited.document.scene().duration;
        const Parameter& row = *scene_table().find_row("duration");
        ui::ParamOptions options = param_options(row);
        options.maximum = 60;
        options.standard = on_.edited.saved.content().scene.duration;
        options.initial = Scene{}.duration;
        options.width = ui::px(ui_.em(duration_width));
        const ui::Edit edit = ui::number_field(ui_, "Duration", value, ui::seconds(options));
        on_.edited.document.take(edit, "Duration", [&](document::Content& c) { c.scene.duration = value; });
    }

    /// The ghost becomes a mark. `item`: of the last track.
    void take_ghost(std::size_t item) {
        const std::size_t ghost = item - memory_.marks.size();
        if (item < memory_.marks.size() || ghost >= memory_.ghosts.size()) return;
        const Parameter& row = *memory_.ghosts[ghost];
        ReferenceMarks one;
        row.set(&one, row.get(&memory_.proposed));
        app::take_marks(on_.edited.document, one);
        memory_.version = 0;
    }

    void timeline() {
        const double speed_before = on_.timeline.speed;
        const std::size_t items_before = item_count(memory_.tracks);
        double length = std::max(on_.timeline.duration(), on_.timeline.time);
        for (const app::Stroke& stroke : memory_.strokes) length = std::max(length, stroke.end);
        const ui::TimelineEdit edit = ui::timeline(ui_, "Time", on_.timeline, memory_.tracks,
                                                   {.length = length, .rate = frame_rate, .unit = memory_.unit});
        on_.timeline.take_range(edit.range);
        if (speed_before == 0 && on_.timeline.speed == 1) on_.timeline.speed = on_.timeline.play_speed;
        if (edit.items.began || edit.items.changed || edit.items.committed || edit.items.cancelled)
            ItemEdits(on_.edited.document, on_.selected, memory_).take(edit.items, items_before);
        if (edit.taken) take_ghost(edit.taken->item);
        if (memory_.version == 0) return make_tracks(memory_, on_.edited.document, on_.selected);
        std::vector<std::size_t> selected = selected_events(memory_);
        if (selected == memory_.selected) return;
        memory_.selected = selected;
        on_.selected = std::move(selected);
        ui_.build_again();
    }

    ui::Ui& ui_;
    const TimelineParts& on_;
    TimelineMemory& memory_;
    bool narrow_ = false;
};

}  // namespace

void timeline_panel(ui::Ui& ui, const TimelineParts& parts) {
    TimelinePanel(ui, parts).build();
}

void add_play_commands(app::Editor& editor) {
    const auto step = [&editor](double frames) {
        editor.timeline.speed = 0;
        editor.timeline.seek((std::round(editor.timeline.time * frame_rate) + frames) / frame_rate);
    };
    const char* const in_use = "the tool is in use";
    const auto free = [&editor] { return !editor.hold.on(); };
    editor.commands.add(
        {.id = "play.toggle",
         .title = "Play/pause",
         .group = "Play",
         .chord = {ui::Key::space, Mods::none},
         .icon = ui::Icon::play,
         .run = [&editor] { editor.timeline.speed = editor.timeline.playing() ? 0 : editor.timeline.play_speed; },
         .enabled = free,
         .checked = [&editor] { return editor.timeline.playing(); },
         .tip = "Starts where it is, at the speed set on the timeline",
         .missing = in_use});
    editor.commands.add({.id = "play.frame_back",
                         .title = "One frame back",
                         .group = "Play",
                         .chord = {ui::key_of(','), Mods::none},
                         .icon = ui::Icon::chevron_left,
                         .run = [step] { step(-1); },
                         .enabled = free,
                         .tip = "Pauses at the frame before",
                         .missing = in_use});
    editor.commands.add({.id = "play.frame_on",
                         .title = "One frame forward",
                         .group = "Play",
                         .chord = {ui::key_of('.'), Mods::none},
                         .icon = ui::Icon::chevron_right,
                         .run = [step] { step(1); },
                         .enabled = free,
                         .tip = "Pauses at the next frame",
                         .missing = in_use});
    editor.commands.add(
        {.id = "play.start",
         .title = "To the start",
         .group = "Play",
         .chord = {ui::Key::home, Mods::command},
         .icon = ui::Icon::step_back,
         .run = [&editor] { editor.timeline.seek(editor.timeline.has_range ? editor.timeline.range.low : 0); },
         .enabled = free,
         .tip = "Of the scene, or of the part that plays",
         .missing = in_use});
    editor.commands.add({.id = "play.loop",
                         .title = "Loop",
                         .group = "Play",
                         .chord = {ui::key_of('L'), Mods::command},
                         .icon = ui::Icon::loop,
                         .run = [&editor] { editor.timeline.loop = !editor.timeline.loop; },
                         .checked = [&editor] { return editor.timeline.loop; },
                         .tip = "Plays the scene, or the part between In and Out, again and again"});
    editor.commands.add({.id = "play.range_in",
                         .title = "Loop range from here",
                         .group = "Play",
                         .chord = {ui::key_of('I'), Mods::none},
                         .run = [&editor] { editor.timeline.begin_range_here(); },
                         .tip = "The part that plays begins at the current time; it is kept in the scene"});
    editor.commands.add({.id = "play.range_out",
                         .title = "Loop range to here",
                         .group = "Play",
                         .chord = {ui::key_of('O'), Mods::none},
                         .run = [&editor] { editor.timeline.end_range_here(); },
                         .tip = "The part that plays ends at the current time; it is kept in the scene"});
    editor.commands.add({.id = "play.range_drop",
                         .title = "No loop range",
                         .group = "Play",
                         .run = [&editor] { editor.timeline.drop_range(); },
                         .enabled = [&editor] { return editor.timeline.has_range; },
                         .tip = "All of the scene plays",
                         .missing = "all of the scene plays"});
    editor.commands.add({.id = "event.add",
                         .title = "Add event at the current time",
                         .group = "Play",
                         .icon = ui::Icon::plus,
                         .run = [&editor] { add_event(timeline_parts(editor)); },
                         .enabled = free,
                         .tip = "Where the tool last was, otherwise in the middle of the view",
                         .missing = in_use});
    editor.commands.add({.id = "event.duplicate",
                         .title = "Duplicate events",
                         .group = "Play",
                         .icon = ui::Icon::copy,
                         .run = [&editor] { duplicate_events(timeline_parts(editor)); },
                         .enabled = [&editor] { return !editor.selected.empty(); },
                         .tip = "Copies the selected events to the current time",
                         .missing = "no event is selected"});
}

}  // namespace lapfx::panels
