#include "ui/canvas/timeline.h"

#include <cassert>
#include <charconv>
#include <utility>

#include "ui/canvas/timeline_drawing.h"
#include "ui/canvas/timeline_rows.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {

using namespace timeline_drawing;

namespace {

constexpr float catch_distance = 8;  // px at scale 1
constexpr double fastest = 8;
constexpr double item_rim = 0.03;    // share of the whole, beyond items outside of the timeline
constexpr double fewest_frames = 4;  // that are visible

enum class TimelineHit : std::uint8_t { none, time, view, range_in, range_out, item, item_start, item_end };

struct Memory {
    struct Times {
        double start, end;
    };
    struct Built {
        Id id;
        std::size_t track, item;
    };
    TimelineHit drag = TimelineHit::none;
    bool began = false;
    float from = 0;  ///< px
    std::size_t track = 0, item = 0;
    TimelineState before;
    std::vector<Times> times;  ///< times of all items when the drag began
    std::vector<Built> built;  ///< nodes of the last build
    TimelineRows rows;         ///< of the track that is being built
    Id range_ids[2] = {};
};

double frames_of(double seconds, double rate) {
    return std::floor(seconds * rate + 1e-6);
}

/// From the start to the end, or to the items that lie outside.
Span whole_of(std::span<const TimelineTrack> tracks, const TimelineOptions& o) {
    Span whole{0, o.length};
    for (const TimelineTrack& track : tracks)
        for (const TimelineItem& item : track.items)
            whole = {std::min(whole.low, item.start), std::max(whole.high, item.end)};
    const double rim = item_rim * whole.length();  // so that these are not cut off
    return {whole.low < 0 ? whole.low - rim : whole.low, whole.high > o.length ? whole.high + rim : whole.high};
}

/// The view limited to the whole and a little around it.
Span kept(Span view, const Span& whole, const TimelineOptions& o) {
    const double most = whole.length() * 1.1, least = std::min(most, fewest_frames / o.rate);
    if (view.length() > most || view.length() < least)
        view.zoom(std::clamp(view.length(), least, most) / view.length(), (view.low + view.high) / 2);
    view.pan(std::max(0.0, whole.low - 0.05 * whole.length() - view.low));
    view.pan(std::min(0.0, whole.high + 0.05 * whole.length() - view.high));
    return view;
}

class Editing {
  public:
    Editing(Ui& ui, Id id, Memory& memory, TimelineState& state, std::span<TimelineTrack> tracks,
            const TimelineOptions& o, const Frame& frame)
        : ui_(ui), id_(id), m_(memory), s_(state), tracks_(tracks), o_(o), f_(frame) {
        const bool item = m_.drag >= TimelineHit::item;  // the program may have changed the item that is held
        if (item && (m_.times.size() != count() || !exists(m_.track, m_.item))) m_.drag = TimelineHit::none;
    }
    TimelineEdit edit;

    void ground(const Event& e) {
        switch (e.kind) {
            case EventKind::press:
                if (e.button == Button::middle) return start(TimelineHit::view, e);
                if (e.at.x < f_.ruler.x) return;
                if (f_.lanes.contains(e.at)) return has(e.mods, Mods::shift) ? void() : select_none();
                start(TimelineHit::time, e);
                return scrub(e.at.x);
            case EventKind::wheel:
                return wheel(e);
            case EventKind::key:
                return takes_keys() ? key(e) : void();
            default:
                return drag(e);
        }
    }
    void range_end(TimelineHit part, const Event& e) {
        if (e.kind == EventKind::press) return start(part, e);
        if (e.kind != EventKind::key) return drag(e);
        if (!takes_keys()) return;
        const double by = frame() * (has(e.mods, Mods::shift) ? 10 : 1);
        const double now = part == TimelineHit::range_in ? s_.range.low : s_.range.high;
        if (e.key != Key::left && e.key != Key::right) return key(e);
        if (set_range(part, now + (e.key == Key::left ? -by : by))) edit.range |= Edit::once();
    }
    void item(std::size_t track, std::size_t index, const Event& e) {
        if (tracks_[track].items[index].ghost) return ghost(track, index, e);
        if (e.kind == EventKind::press) return press_item(track, index, e);
        if (e.kind != EventKind::key) return drag(e);
        if (takes_keys()) item_key(track, index, e);
    }
    void fit() {
        s_.view = whole_of(tracks_, o_);
        s_.fitted = true;
    }
    TimelineHit part_at(const TimelineItem& item, float x) const {
        const float left = f_.x.px_of(item.start), right = f_.x.px_of(item.end), grip = ui_.em(0.5F);
        if (item.end <= item.start || right - left < 3 * grip) return TimelineHit::item;
        return x < left + grip ? TimelineHit::item_start : x > right - grip ? TimelineHit::item_end : TimelineHit::item;
    }

  private:
    double frame() const { return 1 / o_.rate; }
    /// Whether keys may edit now. There is one edit at a time: a drag that has changed something continues, and keys
    /// are ignored; one that has not changed anything ends.
    bool takes_keys() {
        const bool edits = m_.drag != TimelineHit::none && m_.drag != TimelineHit::view;
        if (edits && m_.began) return false;
        if (edits) m_.drag = TimelineHit::none;
        return true;
    }
    double on_frame(double t) const { return std::round(t * o_.rate) / o_.rate; }
    double inside(double t) const { return std::clamp(t, 0.0, o_.length); }
    bool exists(std::size_t track, std::size_t item) const {
        return track < tracks_.size() && item < tracks_[track].items.size();
    }
    std::size_t count() const {
        std::size_t all = 0;
        for (const TimelineTrack& track : tracks_) all += track.items.size();
        return all;
    }
    template <typename F>
    void each_item(F&& each) {
        for (TimelineTrack& track : tracks_) {
            for (TimelineItem& item : track.items) each(item);
        }
    }
    void select_none() {
        each_item([](TimelineItem& item) { item.selected = false; });
    }

    void start(TimelineHit part, const Event& e) {
        m_.drag = part, m_.began = false, m_.from = e.at.x;
        m_.before = s_;
        m_.times.clear();
        each_item([&](const TimelineItem& item) { m_.times.push_back({item.start, item.end}); });
    }
    Edit& edit_of(TimelineHit part) {
        if (part >= TimelineHit::item) return edit.items;
        return part == TimelineHit::time ? edit.time : edit.range;
    }
    void report(bool changed) {
        if (!changed) return;
        Edit& e = edit_of(m_.drag);
        if (!m_.began) e.began = true;
        m_.began = e.changed = true;
    }
    void drag(const Event& e) {
        if (m_.drag == TimelineHit::none) return;
        if (e.kind == EventKind::cancel) return cancel();
        if (e.kind != EventKind::pointer && e.kind != EventKind::release) return;
        const double by = (e.at.x - m_.from) / f_.x.scale();
        const bool catching = !has(e.mods, Mods::command);
        const bool moved = m_.began || std::abs(e.at.x - m_.from) > 3 * ui_.scale();
        if (m_.drag == TimelineHit::time) scrub(e.at.x);
        if (m_.drag == TimelineHit::view) {
            Span view = m_.before.view;
            view.pan(-by);
            show(view);
        }
        if (m_.drag == TimelineHit::range_in && moved) report(set_range(m_.drag, m_.before.range.low + by));
        if (m_.drag == TimelineHit::range_out && moved) report(set_range(m_.drag, m_.before.range.high + by));
        if (m_.drag == TimelineHit::item && moved) report(move_items(by, catching));
        if (m_.drag > TimelineHit::item && moved) report(stretch(by, catching));
        if (e.kind != EventKind::release) return;
        if (m_.began) edit_of(m_.drag).committed = true;
        m_.drag = TimelineHit::none;
    }
    void cancel() {
        if (m_.drag == TimelineHit::view) s_.view = m_.before.view, s_.fitted = m_.before.fitted;
        if (m_.began) {
            s_.time = m_.before.time, s_.range = m_.before.range;
            std::size_t i = 0;
            each_item([&](TimelineItem& item) { item.start = m_.times[i].start, item.end = m_.times[i++].end; });
            edit_of(m_.drag).changed = edit_of(m_.drag).cancelled = true;
        }
        m_.drag = TimelineHit::none;
    }

    // --- time, range and view ---
    bool set_time(double t) {
        t = inside(on_frame(t));
        return std::exchange(s_.time, t) != t;
    }
    void scrub(float x) { report(set_time(f_.x.value_at(x))); }
    void step_to(double t) {
        if (set_time(t)) edit.time |= Edit::once();
        if (s_.fitted || (s_.time >= s_.view.low && s_.time <= s_.view.high)) return;
        Span view = s_.view;  // moved only until the time is visible, a little inside
        view.pan(s_.time < view.low ? s_.time - 0.05 * view.length() - view.low
                                    : s_.time + 0.05 * view.length() - view.high);
        show(view);
    }
    bool set_range(TimelineHit part, double t) {
        t = inside(on_frame(t));
        const Span old = s_.range;
        if (part == TimelineHit::range_in) s_.range.low = std::min(t, s_.range.high - frame());
        if (part == TimelineHit::range_out) s_.range.high = std::max(t, s_.range.low + frame());
        return !(s_.range == old);
    }
    void set_end_here(bool in) {
        const Span old = s_.has_range ? s_.range : Span{0, o_.length};
        const bool had = std::exchange(s_.has_range, true);
        s_.range = in ? Span{s_.time, old.high} : Span{old.low, s_.time};
        if (s_.range.length() < frame()) s_.range = in ? Span{s_.time, o_.length} : Span{0, s_.time};
        if (s_.range.length() < frame()) s_.range = old, s_.has_range = had;  // at the very end of time
        if (!(s_.range == old) || s_.has_range != had) edit.range |= Edit::once();
    }
    void show(const Span& view) {
        if (!(view.length() > 0) || !std::isfinite(view.length())) return;
        s_.view = kept(view, whole_of(tracks_, o_), o_);
        s_.fitted = false;
    }
    void wheel(const Event& e) {
        Span view = s_.view;
        const float sideways = e.delta.x + (has(e.mods, Mods::shift) ? e.delta.y : 0.0F);
        if (sideways != 0) {
            view.pan(-sideways * 0.1 * view.length());
        } else {
            const double factor = zoom_of(e.delta.y);
            if (view.length() * factor < fewest_frames * frame() ||
                view.length() * factor > whole_of(tracks_, o_).length() * 1.1)
                return;
            view.zoom(factor, f_.x.value_at(ui_.pointer().x));
        }
        show(view);
    }
    void key(const Event& e) {
        const double by = frame() * (has(e.mods, Mods::shift) ? 10 : 1);
        if (e.key == Key::left) step_to(s_.time - by);
        if (e.key == Key::right) step_to(s_.time + by);
        if (e.key == Key::home) step_to(0);
        if (e.key == Key::end) step_to(o_.length);
        if (e.key == Key::del || e.key == Key::backspace) erase();
        if (e.key == Key::space) s_.speed = s_.speed == 0 ? 1 : 0;
        if (e.key == key_of('J')) s_.speed = s_.speed >= 0 ? -1 : std::max(-fastest, s_.speed * 2);
        if (e.key == key_of('K')) s_.speed = 0;
        if (e.key == key_of('L')) s_.speed = s_.speed <= 0 ? 1 : std::min(fastest, s_.speed * 2);
        if (e.key == key_of('I')) set_end_here(true);
        if (e.key == key_of('O')) set_end_here(false);
        if (e.key == key_of('F')) fit();
        if (e.key == key_of('X') && s_.has_range) s_.has_range = false, edit.range |= Edit::once();
    }

    // --- items ---
    void ghost(std::size_t track, std::size_t index, const Event& e) {
        const bool pressed = e.kind == EventKind::press && e.button == Button::left;
        const bool by_key = e.kind == EventKind::key && (e.key == Key::enter || e.key == Key::space);
        if (e.kind == EventKind::key && !by_key) return takes_keys() ? key(e) : void();
        if ((pressed || by_key) && m_.drag == TimelineHit::none) edit.taken = {track, index};
    }
    void press_item(std::size_t track, std::size_t index, const Event& e) {
        TimelineItem& item = tracks_[track].items[index];
        if (has(e.mods, Mods::shift)) {
            item.selected = !item.selected;
        } else if (!item.selected) {
            select_none();
            item.selected = true;
        }
        start(part_at(item, e.at.x), e);
        m_.track = track, m_.item = index;
    }
    void item_key(std::size_t track, std::size_t index, const Event& e) {
        TimelineItem& item = tracks_[track].items[index];
        if (e.key == Key::enter) item.selected = !item.selected;
        if (e.key == Key::del || e.key == Key::backspace) {
            if (!item.selected) select_none();
            item.selected = true;
            return erase();
        }
        if (e.key != Key::left && e.key != Key::right) return key(e);
        if (!item.selected) select_none();
        item.selected = true;
        m_.track = track, m_.item = index;
        m_.times.clear();
        each_item([&](const TimelineItem& i) { m_.times.push_back({i.start, i.end}); });
        const double by = frame() * (has(e.mods, Mods::shift) ? 10 : 1) * (e.key == Key::left ? -1 : 1);
        m_.drag = TimelineHit::item_end;
        const bool end = has(e.mods, Mods::command);
        if (end ? item.end > item.start && stretch(by, false) : move_items(by, false)) edit.items |= Edit::once();
        m_.drag = TimelineHit::none;
    }
    void erase() {
        std::size_t erased = 0;
        for (TimelineTrack& track : tracks_)
            erased += std::erase_if(track.items, [](const auto& i) { return i.selected; });
        if (erased == 0) return;
        m_.built.clear();
        m_.drag = TimelineHit::none;
        ui_.set_focus(id_, ui_.focus_ringed());
        edit.items |= Edit::once();
    }
    Memory::Times held_before() const {
        std::size_t i = m_.item;
        for (std::size_t t = 0; t < m_.track; ++t) i += tracks_[t].items.size();
        return m_.times[i];
    }
    /// How much farther than `by` one of these places has to move to be exactly on a mark; 0 where no mark is near.
    double to_catch(std::initializer_list<double> places, bool catching) {
        double best = 0, nearest = catching ? catch_distance * ui_.scale() / f_.x.scale() : 0;
        const auto offer = [&](double target) {
            for (const double place : places) {
                if (std::abs(target - place) < nearest) nearest = std::abs(target - place), best = target - place;
            }
        };
        offer(0), offer(o_.length), offer(s_.time);
        if (s_.has_range) offer(s_.range.low), offer(s_.range.high);
        each_item([&](const TimelineItem& item) {
            if (!item.selected && !item.ghost) offer(item.start), offer(item.end);
        });
        return best;
    }
    bool move_items(double by, bool catching) {
        const Memory::Times held = held_before();
        const double caught = to_catch({held.start + by, held.end + by}, catching);
        by = caught != 0 ? by + caught : on_frame(held.start + by) - held.start;
        std::size_t i = 0;
        double low = -1e300, high = 1e300;
        each_item([&](const TimelineItem& item) {
            const Memory::Times t = m_.times[i++];
            if (!item.selected) return;
            // One that lies outside may come in, and keeps no other from moving.
            low = std::max(low, std::min(0.0, -t.start)), high = std::min(high, std::max(0.0, o_.length - t.end));
        });
        by = std::clamp(by, low, high);
        bool changed = false;
        i = 0;
        each_item([&](TimelineItem& item) {
            const Memory::Times t = m_.times[i++];
            if (!item.selected) return;
            changed |= item.start != t.start + by;
            item.start = t.start + by, item.end = t.end + by;
        });
        return changed;
    }
    bool stretch(double by, bool catching) {
        TimelineItem& item = tracks_[m_.track].items[m_.item];
        const Memory::Times held = held_before();
        const bool at_start = m_.drag == TimelineHit::item_start;
        const double wish = (at_start ? held.start : held.end) + by, caught = to_catch({wish}, catching);
        const double t = inside(caught != 0 ? wish + caught : on_frame(wish));
        const double start_now = at_start ? std::min(t, held.end - frame()) : held.start;
        const double end_now = at_start ? held.end : std::max(t, held.start + frame());
        const bool changed = item.start != start_now || item.end != end_now;
        item.start = start_now, item.end = end_now;
        return changed;
    }

    Ui& ui_;
    Id id_;
    Memory& m_;
    TimelineState& s_;
    std::span<TimelineTrack> tracks_;
    const TimelineOptions& o_;
    const Frame& f_;
};

// --- nodes ---

/// The timeline's rectangle. If it has not been laid out yet, one with the right distances.
Rect known_rect(Ui& ui, Id id) {
    const Rect rect = ui.rect_before(id);
    return rect.empty() ? Rect{0, 0, ui.window().x, ui.window().y} : rect;
}

void put_item(Ui& ui, Memory& m, Editing& editing, const TimelineState& state, const TimelineItem& item,
              const TimelineOptions& o, const Frame& f, std::size_t track, std::size_t index) {
    const bool mark = item.end <= item.start;
    const Span view = state.view;
    ShortText unnamed;
    unnamed.add(mark ? "Mark " : "Clip ").add(static_cast<double>(index + 1), 0);
    Node& node = ui.leaf(
        Role::list_item, item.name.empty() ? unnamed.view() : item.name,
        Sense::hover | Sense::press | Sense::focus | Sense::arrows_x | Sense::extremes | Sense::erase | Sense::typing);
    node.typed = TypedKeys::timeline;
    m.built.push_back({node.id, track, index});
    const double low = std::max(item.start, view.low - view.length());
    const double high = std::min(item.end, view.high + view.length());
    const float least = mark ? ui.row_height() : ui.em(0.5F);
    const float width = static_cast<float>((high - low) * f.x.scale());
    node.placed = true;
    const auto [row, rows] = m.rows.of(index);
    const float height = 1.0F / static_cast<float>(rows);
    node.placement = ui.arena().make(
        Placement{.fraction = {static_cast<float>((low - view.low) / view.length()), height * static_cast<float>(row)},
                  .pivot = {mark ? 0.5F : 0.0F, 0}});
    node.size[0] = mark || width < least ? px(least) : fraction(static_cast<float>((high - low) / view.length()));
    node.size[1] = fraction(height);
    char from[32], to[32];
    const std::string_view start = format_position(from, item.start, o.rate, o.unit);
    node.text = mark ? ui.copy(start) : ui.join({start, " - ", format_position(to, item.end, o.rate, o.unit)});
    node.tip = ui.join({node.label, "\n", node.text, item.ghost ? "\nClick: take it" : ""});
    node.number = ui.number(item.start, 0, o.length, 1 / o.rate);
    node.is |= when(item.selected, Is::selected);
    const Response r = ui.respond(node);
    const bool end =
        m.drag > TimelineHit::item || (r.hovered && editing.part_at(item, r.pointer.x) != TimelineHit::item);
    if ((r.hovered || r.held) && !has(node.is, Is::disabled)) ui.set_cursor(end ? Cursor::resize_x : Cursor::move);
    const auto color = item.color >= 0 ? static_cast<std::size_t>(item.color) : track;
    ui.draw_with<draw_item>(node, ItemLook{ui.theme().series[color % 8], mark, item.ghost});
}

void put_tracks(Ui& ui, Memory& m, Editing& editing, const TimelineState& state, std::span<const TimelineTrack> tracks,
                const TimelineOptions& o, const Frame& f) {
    std::size_t kept = 0;  // items that are not visible but have the keyboard or are held
    for (std::size_t i = 0; i < m.built.size(); ++i) {
        if (m.built[i].id != 0 && (m.built[i].id == ui.focus() || m.built[i].id == ui.held()))
            m.built[kept++] = m.built[i];
    }
    const Memory::Built keep[2] = {kept > 0 ? m.built[0] : Memory::Built{}, kept > 1 ? m.built[1] : Memory::Built{}};
    m.built.clear();
    const Rect all = known_rect(ui, ui.parent().id);
    for (std::size_t t = 0; t < tracks.size(); ++t) {
        ShortText unnamed;
        unnamed.add("Track ").add(static_cast<double>(t + 1), 0);
        const float left = f.ruler.x - all.x, top = f.lanes.y - all.y + f.lane * static_cast<float>(t);
        Node& lane = ui.open(Role::row, tracks[t].name.empty() ? unnamed.view() : tracks[t].name, Axis::x);
        lane.placed = lane.clips = true;
        lane.placement = ui.arena().make(Placement{.offset = {left, top}});
        lane.size[0] = grow(), lane.size[1] = px(f.lane - 1);
        m.rows.place(tracks[t].items);
        for (std::size_t i = 0; i < tracks[t].items.size(); ++i) {
            const TimelineItem& item = tracks[t].items[i];
            const double margin = ui.row_height() / std::max(1e-9, f.x.scale());
            bool wanted = item.end >= state.view.low - margin && item.start <= state.view.high + margin;
            for (const Memory::Built& b : keep) wanted |= b.id != 0 && b.track == t && b.item == i;
            if (wanted) put_item(ui, m, editing, state, item, o, f, t, i);
        }
        ui.close();
    }
}

void put_range_end(Ui& ui, Memory& m, const TimelineState& state, const TimelineOptions& o, const Frame& f, bool in) {
    const double t = in ? state.range.low : state.range.high;
    m.range_ids[in ? 0 : 1] = 0;
    if (!state.has_range || t < state.view.low || t > state.view.high) return;
    Node& node = ui.leaf(Role::handle, in ? "In" : "Out", Sense::hover | Sense::press | Sense::focus | Sense::arrows_x);
    m.range_ids[in ? 0 : 1] = node.id;
    const Rect all = known_rect(ui, ui.parent().id);
    const float u = static_cast<float>((t - state.view.low) / state.view.length()), left = f.ruler.x - all.x;
    node.placed = true;
    node.placement = ui.arena().make(Placement{.fraction = {u, 0}, .offset = {left * (1 - u), 0}, .pivot = {0.5F, 0}});
    node.size[0] = px(ui.em(1)), node.size[1] = px(ui.row_height());
    char buffer[32];
    node.text = ui.copy(format_position(buffer, t, o.rate, o.unit));
    node.tip = ui.join({node.label, " ", node.text});
    node.number = ui.number(t, 0, o.length, 1 / o.rate);
    const Response r = ui.respond(node);
    if (r.hovered || r.held) ui.set_cursor(Cursor::resize_x);
    ui.draw_with<draw_range_end>(node, in);
}

void put_buttons(Ui& ui, TimelineState& state) {
    Node& row = ui.open(Role::none, {}, Axis::x);
    row.placed = true;
    row.placement = ui.arena().make(Placement{});
    row.size[1] = px(ui.row_height());
    bool playing = state.speed != 0;
    if (toggle(ui, "Play", playing,
               {.icon = playing ? Icon::pause : Icon::play, .tip = playing ? "Stop" : "Play", .quiet = true}))
        state.speed = playing ? 1 : 0;
    toggle(ui, "Loop", state.loop, {.icon = Icon::loop, .quiet = true});
    ui.close();
}

}  // namespace

std::string_view format_position(std::span<char> buffer, double seconds, double rate, TimeUnit unit) {
    if (unit == TimeUnit::seconds) return format_time(buffer, seconds, 3);
    const double frames = seconds < 0 ? -frames_of(-seconds, rate) : frames_of(seconds, rate);
    if (unit == TimeUnit::frames || !(std::abs(frames) < 1e12)) return format_number(buffer, frames, 0);
    const auto base = static_cast<std::int64_t>(std::max(1.0, std::round(rate)));
    auto left = static_cast<std::int64_t>(std::abs(frames));
    const std::int64_t figures[] = {left / base / 3600, left / base / 60 % 60, left / base % 60, left % base};
    char* at = buffer.data();
    char* const end = at + buffer.size();
    if (frames < 0 && at != end) *at++ = '-';
    for (int i = 0; i < 4; ++i) {
        if (i > 0 && at != end) *at++ = ':';
        if (figures[i] < 10 && at != end) *at++ = '0';
        at = std::to_chars(at, end, figures[i]).ptr;
    }
    return {buffer.data(), static_cast<std::size_t>(at - buffer.data())};
}

TimelineEdit timeline(Ui& ui, std::string_view label, TimelineState& state, std::span<TimelineTrack> tracks,
                      const TimelineOptions& options) {
    assert(options.length > 0 && options.rate > 0);
    Node& node = ui.open(Role::timeline, label, Axis::x,
                         Sense::hover | Sense::press | Sense::middle | Sense::focus | Sense::wheel | Sense::arrows_x |
                             Sense::extremes | Sense::erase | Sense::typing);
    node.typed = TypedKeys::timeline;
    const Id id = node.id;
    const float lanes = ui.em(1.9F) * static_cast<float>(std::max<std::size_t>(1, tracks.size()));
    node.size[0] = options.width;
    node.size[1] = px(ui.em(1.75F) + lanes);
    node.tip = ui.copy(options.tip);
    ui.respond(node);
    if (!std::isfinite(state.time)) state.time = 0;
    Memory& m = ui.memory<Memory>(id);
    const Span whole = whole_of(tracks, options);
    if (state.fitted && (m.drag < TimelineHit::item || state.view.length() <= 0)) state.view = whole;
    if (m.drag == TimelineHit::none && state.speed > 0 && state.time > state.view.high)  // a page further
        state.view = kept({state.time, state.time + state.view.length()}, whole, options);
    if (m.drag == TimelineHit::none && state.speed < 0 && state.time < state.view.low)
        state.view = kept({state.time - state.view.length(), state.time}, whole, options);
    const Frame f = frame_of(ui, ui.rect_before(id), state.view);
    Editing editing(ui, id, m, state, tracks, options, f);
    if (!f.ruler.empty()) {  // all events are handled before anything is built
        if (ui.has_events(id)) ui.events_of(id, [&](const Event& e) { editing.ground(e); });
        for (int end = 0; end < 2; ++end) {
            const TimelineHit part = end == 0 ? TimelineHit::range_in : TimelineHit::range_out;
            if (m.range_ids[end] != 0 && ui.has_events(m.range_ids[end]))
                ui.events_of(m.range_ids[end], [&](const Event& e) { editing.range_end(part, e); });
        }
        for (std::size_t i = 0; i < m.built.size(); ++i) {  // erasing empties the list
            const Memory::Built b = m.built[i];
            if (!ui.has_events(b.id) || b.track >= tracks.size() || b.item >= tracks[b.track].items.size()) continue;
            ui.events_of(b.id, [&](const Event& e) { editing.item(b.track, b.item, e); });
        }
    }
    put_buttons(ui, state);
    const Frame now = frame_of(ui, known_rect(ui, id), state.view);
    put_range_end(ui, m, state, options, now, true);
    put_range_end(ui, m, state, options, now, false);
    put_tracks(ui, m, editing, state, tracks, options, now);
    Node& me = ui.parent();
    char buffer[32];
    me.text = ui.copy(format_position(buffer, state.time, options.rate, options.unit));
    me.number = ui.number(state.time, 0, options.length, 1 / options.rate);
    ui.draw_with<draw_ground>(me, Look{state, options, tracks});
    me.draw_over = draw_front;
    ui.close();
    return editing.edit;
}

}  // namespace lapfx::ui
